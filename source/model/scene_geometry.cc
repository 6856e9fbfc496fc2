#include <wheelrail/base/errors.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/model/scene_irregularities.h>
#include <wheelrail/profiles/measured_profiles.h>
#include <wheelrail/profiles/note_lines.h>

#include <utility>

namespace wheelrail
{
  namespace
  {
    /// Reads a file and makes the profile of it; messages and notes get the name of the entry in front.
    template <typename Make>
    auto
    from_file(const std::string        &entry,
              const std::string        &path,
              const ProfileFileOptions &options,
              const Make               &make,
              std::vector<std::string> &notes)
    {
      try
        {
          MeasuredProfile measured = read_profile_file(path, options);
          auto            profile  = make(measured, measured.notes);
          for (const std::string &note : note_lines(measured.notes))
            notes.push_back(entry + " = " + path + ": " + note);
          return profile;
        }
      catch (const InputError &error)
        {
          throw InputError(entry + ": " + error.what());
        }
    }

    /// The entry that names a profile: of the left-hand wheel of a wheelset by itself where it differs.
    std::string
    entry_of(const Scene &scene, const std::string &name, const std::string &path, const std::string &left)
    {
      return "Profiles/" + name + (scene.left_wheel && path == left ? " left" : "");
    }

    WheelProfile
    read_wheel(const Scene &scene, std::vector<std::string> &notes)
    {
      if (!is_file_name(scene.wheel_profile))
        return wheel_profile(scene.wheel_profile);
      ProfileFileOptions options = scene.wheel_file;
      options.placed             = scene.wheel_origin == WheelOrigin::running_circle;
      return from_file(
        entry_of(scene, "Wheel", scene.wheel_profile, scene.left_wheel_profile),
        scene.wheel_profile,
        options,
        [&](const MeasuredProfile &measured, std::vector<std::string> &more) {
          return measured_wheel(measured, scene.wheel.rim_width, more, scene.wheel_origin);
        },
        notes);
    }

    RailProfile
    read_rail(const Scene &scene, std::vector<std::string> &notes)
    {
      if (!is_file_name(scene.rail_profile))
        return rail_profile(scene.rail_profile);
      return from_file(
        entry_of(scene, "Rail", scene.rail_profile, scene.left_rail_profile),
        scene.rail_profile,
        scene.rail_file,
        [&](const MeasuredProfile &measured, std::vector<std::string> &more) {
          return measured_rail(measured, scene.rail_body, more);
        },
        notes);
    }
  } // namespace


  SceneProfiles
  read_profiles(const Scene &scene)
  {
    SceneProfiles profiles;
    profiles.wheel = read_wheel(scene, profiles.notes);
    profiles.rail  = read_rail(scene, profiles.notes);
    return profiles;
  }


  SceneGeometry
  make_geometry(const Scene &scene, SceneProfiles profiles)
  {
    SceneGeometry geometry{
      touching_profiles(
        std::move(profiles.rail), std::move(profiles.wheel), scene.track, wheelset_pose(scene)),
      std::move(profiles.notes)};
    add_irregularities(scene, geometry);
    return geometry;
  }


  SceneGeometry
  make_geometry(const Scene &scene)
  {
    return make_geometry(scene, read_profiles(scene));
  }
} // namespace wheelrail
