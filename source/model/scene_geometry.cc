#include <wheelrail/base/errors.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/model/scene_irregularities.h>
#include <wheelrail/model/sliced_rails.h>
#include <wheelrail/profiles/measured_profiles.h>
#include <wheelrail/profiles/note_lines.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// Reads a file into `measured` and makes the profile of it; messages and notes get the name of the entry
    /// in front.
    template <typename Make>
    auto
    from_file(const std::string              &entry,
              const std::string              &path,
              const ProfileFileOptions       &options,
              const Make                     &make,
              std::optional<MeasuredProfile> &measured,
              std::vector<std::string>       &notes)
    {
      try
        {
          measured     = read_profile_file(path, options);
          auto profile = make(*measured, measured->notes);
          for (const std::string &note : note_lines(measured->notes))
            notes.push_back(std::string(entry).append(" = ").append(path).append(": ").append(note));
          return profile;
        }
      catch (const InputError &error)
        {
          throw InputError(entry + ": " + error.what());
        }
    }

    /// The entry that names a profile: of the left-hand wheel of a wheelset by itself where it differs.
    std::string
    entry_of(const WheelsetSettings &scene,
             const std::string      &name,
             const std::string      &path,
             const std::string      &left)
    {
      return "Profiles/" + name + (scene.left_wheel && path == left ? " left" : "");
    }

    WheelProfile
    wheel_of(const Scene &scene, const MeasuredProfile &measured, std::vector<std::string> &notes)
    {
      return measured_wheel(measured, scene.wheel.rim_width, notes, scene.wheel_origin);
    }

    /// The rail below the other wheel of the wheelset where that of the scene is a crossing, whose section is
    /// filled up to the wheel at its own shift; nothing for other rails, which are alike on both sides.
    std::optional<RailProfile>
    rail_opposite(const Scene &scene)
    {
      if (!scene.rail_by_slices() || !is_crossing(scene))
        return {};
      return rail_profile(scene.rail_body == "auto" ? "54E1" : scene.rail_body);
    }

    RailProfile
    rail_of(const ProfileSettings &scene, const MeasuredProfile &measured, std::vector<std::string> &notes)
    {
      return measured_rail(measured, scene.rail_body, notes);
    }

    void
    read_wheel(const Scene &scene, SceneProfiles &profiles)
    {
      ProfileFileOptions options = scene.wheel_file;
      options.placed             = scene.wheel_origin == WheelOrigin::running_circle;
      if (!is_file_name(scene.wheel_profile))
        profiles.wheel = wheel_profile(scene.wheel_profile);
      else
        profiles.wheel = from_file(
          entry_of(scene, "Wheel", scene.wheel_profile, scene.left_wheel_profile),
          scene.wheel_profile,
          options,
          [&](const auto &measured, auto &notes) { return wheel_of(scene, measured, notes); },
          profiles.files.wheel,
          profiles.notes);
    }

    void
    read_rail(const Scene &scene, SceneProfiles &profiles)
    {
      if (scene.second_rail != "none")
        throw InputError("Profiles/Second rail = " + scene.second_rail +
                         ": a second rail stands beside one by slices (.slcs); Profiles/Rail is " +
                         scene.rail_profile);
      if (!is_file_name(scene.rail_profile))
        profiles.rail = rail_profile(scene.rail_profile);
      else
        profiles.rail = from_file(
          entry_of(scene, "Rail", scene.rail_profile, scene.left_rail_profile),
          scene.rail_profile,
          scene.rail_file,
          [&](const auto &measured, auto &notes) { return rail_of(scene, measured, notes); },
          profiles.files.rail,
          profiles.notes);
    }
  } // namespace


  SceneProfiles
  read_wheel_profile(const Scene &scene)
  {
    SceneProfiles profiles;
    read_wheel(scene, profiles);
    return profiles;
  }


  SceneProfiles
  read_profiles(const Scene &scene)
  {
    if (scene.rail_by_slices())
      throw InputError("Profiles/Rail = " + scene.rail_profile +
                       ": slices along the track are for run, compare, and --places of geometry and "
                       "halfspace; give a rail of one section");
    return read_mesh_profiles(scene);
  }


  SceneProfiles
  read_mesh_profiles(const Scene &scene)
  {
    SceneProfiles profiles = read_wheel_profile(scene);
    if (scene.rail_by_slices())
      read_sliced_rail(scene, profiles);
    else
      read_rail(scene, profiles);
    return profiles;
  }


  SceneGeometry
  smooth_geometry(const Scene &scene, SceneProfiles profiles)
  {
    const WheelsetPose               pose     = wheelset_pose(scene);
    const std::optional<RailProfile> opposite = rail_opposite(scene);
    if (!opposite)
      return {touching_profiles(std::move(profiles.rail), std::move(profiles.wheel), scene.track, pose),
              std::move(profiles.notes),
              std::move(profiles.files)};
    const WheelOnRail other{*opposite, profiles.wheel};
    ContactGeometry   contact  = find_contact(profiles.rail, profiles.wheel, scene.track, pose, &other);
    RunningSurfaces   surfaces = running_surfaces(profiles.rail.head, profiles.wheel.tread, contact);
    return {{std::move(profiles.rail), std::move(profiles.wheel), std::move(contact), std::move(surfaces)},
            std::move(profiles.notes),
            std::move(profiles.files)};
  }


  SceneGeometry
  make_geometry(const Scene &scene, SceneProfiles profiles)
  {
    SceneGeometry geometry = smooth_geometry(scene, std::move(profiles));
    add_irregularities(scene, geometry);
    return geometry;
  }


  SceneGeometry
  drawn(const Scene &scene, const SceneGeometry &geometry, const unsigned int draw)
  {
    SceneGeometry again = geometry;
    if (geometry.files.rail || geometry.files.wheel)
      {
        std::vector<std::string> notes;
        RailProfile              rail  = geometry.rail;
        WheelProfile             wheel = geometry.wheel;
        if (geometry.files.rail)
          rail = rail_of(scene, drawn(*geometry.files.rail, 2 * draw), notes);
        if (geometry.files.wheel)
          wheel = wheel_of(scene, drawn(*geometry.files.wheel, 2 * draw + 1), notes);
        again = {touching_profiles(std::move(rail), std::move(wheel), scene.track, wheelset_pose(scene)),
                 {},
                 geometry.files};
      }
    again.surfaces.rail.draw_irregularities(geometry.surfaces.rail, draw);
    again.surfaces.wheel.draw_irregularities(geometry.surfaces.wheel, draw);
    return again;
  }


  bool
  draws_irregularities(const SceneGeometry &geometry)
  {
    const auto measured = [](const RunningSurface &surface) {
      const Irregularities &all = surface.irregularities();
      return std::any_of(all.begin(), all.end(), [](const Irregularity &one) { return bool(one.drawn); });
    };
    return measured(geometry.surfaces.rail) || measured(geometry.surfaces.wheel);
  }


  SceneGeometry
  standing(SceneGeometry geometry, const double place, const double pitch)
  {
    const double radius = geometry.contact.rolling_radius;
    geometry.surfaces.rail.take_irregularities(geometry.surfaces.rail, place);
    geometry.surfaces.wheel.take_irregularities(geometry.surfaces.wheel, -radius * pitch);
    return geometry;
  }


  SceneGeometry
  make_geometry(const Scene &scene)
  {
    return make_geometry(scene, read_mesh_profiles(scene));
  }


  Scene
  wheel_of_wheelset(const Scene &scene, const bool left)
  {
    Scene wheel      = scene;
    wheel.left_wheel = left;
    if (!left || !scene.both_wheels)
      return wheel;
    if (scene.left_wheel_profile != "as right")
      wheel.wheel_profile = scene.left_wheel_profile;
    if (scene.left_rail_profile != "as right")
      wheel.rail_profile = scene.left_rail_profile;
    if (std::isfinite(scene.left_friction))
      wheel.friction = wheel.friction.with_rest(scene.left_friction);
    return wheel;
  }


  WheelsetProfiles
  read_wheelset_profiles(const Scene &scene)
  {
    const Scene      right = wheel_of_wheelset(scene, false), left = wheel_of_wheelset(scene, true);
    WheelsetProfiles profiles{read_profiles(right), {}};
    const bool alike = left.wheel_profile == right.wheel_profile && left.rail_profile == right.rail_profile;
    profiles.left    = alike ? profiles.right : read_profiles(left);
    return profiles;
  }
} // namespace wheelrail
