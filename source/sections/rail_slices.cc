#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/model/sliced_rails.h>
#include <wheelrail/profiles/measured_profiles.h>
#include <wheelrail/profiles/note_lines.h>
#include <wheelrail/profiles/smoothing_spline.h>
#include <wheelrail/sections/crossing_surface.h>
#include <wheelrail/sections/rail_slices.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace wheelrail
{
  namespace
  {
    /// A message with the entry in front, unless it names one.
    std::string
    with_entry(const std::string &entry, const std::string &message)
    {
      return message.rfind("Profiles/", 0) == 0 ? message : entry + ": " + message;
    }

    /// Throws InputError where no slice has its top between its ends: z points up, or is depth.
    void
    refuse_upside_down(const Slices &slices, const std::string &path)
    {
      const auto hangs = [](const Slices::Slice &slice) {
        const auto top = std::max_element(slice.points.begin(),
                                          slice.points.end(),
                                          [](const Point2 &a, const Point2 &b) { return a.y < b.y; });
        return top == slice.points.begin() || top + 1 == slice.points.end();
      };
      if (std::all_of(slices.slices.begin(), slices.slices.end(), hangs))
        throw InputError(path +
                         ": the highest point of all slices is one of their ends: z points down; set "
                         "Profiles/Rail upside down = yes for slices whose z points up");
    }

    /// Throws InputError where the widest slice is no rail: the unit is another.
    void
    refuse_wrong_unit(const Slices &slices, const std::string &path)
    {
      constexpr double narrow = 3e-3, wide = 400e-3; // also two rails drawn as one
      double           widest = 0;
      for (const Slices::Slice &slice : slices.slices)
        {
          const auto [low, high] =
            std::minmax_element(slice.points.begin(),
                                slice.points.end(),
                                [](const Point2 &a, const Point2 &b) { return a.x < b.x; });
          widest = std::max(widest, high->x - low->x);
        }
      if (widest < narrow || widest > wide)
        throw InputError(path + ": its widest slice is " + in_mm(widest) +
                         " wide, and those of rails are 3 mm to 400 mm; set Profiles/Rail unit to that of "
                         "its files, mm, m or inch");
    }

    Slices
    turned_slices_of(const ProfileSettings &scene, const std::string &path)
    {
      Slices slices = read_slices_file(path, scene.rail_file.unit);
      if (slices.wheel)
        throw InputError(path + ": slices of a wheel; a rail has them in a file that ends in .slcs");
      refuse_wrong_unit(slices, path);
      for (Slices::Slice &slice : slices.slices)
        for (Point2 &p : slice.points)
          p = {(scene.rail_file.mirror == ProfileMirror::yes ? -1 : 1) * p.x,
               (scene.rail_file.turn == ProfileMirror::yes ? -1 : 1) * p.y};
      refuse_upside_down(slices, path);
      return slices;
    }
  } // namespace


  Slices
  turned_slices(const ProfileSettings &scene, const std::string &path)
  {
    try
      {
        return turned_slices_of(scene, path);
      }
    catch (const InputError &error)
      {
        throw InputError(
          with_entry(path == scene.second_rail ? "Profiles/Second rail" : "Profiles/Rail", error.what()));
      }
  }


  const Slices::Slice &
  slice_of_start(const ProfileSettings &scene, const Slices &slices)
  {
    return *std::min_element(
      slices.slices.begin(), slices.slices.end(), [&](const Slices::Slice &a, const Slices::Slice &b) {
        return std::abs(a.along - scene.rail_place) < std::abs(b.along - scene.rail_place);
      });
  }


  double
  least_distance(const std::vector<Slices::Slice> &slices)
  {
    double least = HUGE_VAL;
    for (std::size_t k = 1; k < slices.size(); ++k)
      least = std::min(least, slices[k].along - slices[k - 1].along);
    return least;
  }


  double
  step_along(const double least)
  {
    return std::clamp(least / 4, 0.5e-3, 5e-3);
  }


  namespace
  {
    bool
    lie_beside(const Slices &first, const Slices &second)
    {
      return second.slices.front().along <= first.slices.back().along;
    }
  } // namespace


  bool
  rails_beside(const ProfileSettings &scene, const Slices &slices)
  {
    return scene.second_rail != "none" && lie_beside(slices, turned_slices(scene, scene.second_rail));
  }


  bool
  is_crossing(const ProfileSettings &scene)
  {
    return rails_beside(scene, turned_slices(scene, scene.rail_profile));
  }


  Range
  gap_of_rails(const Scene &scene, const Slices &slices)
  {
    double       first = slices.slices.front().along, end = slices.slices.back().along, last = end;
    const double begin = scene.rail_place, stop = begin + scene.mesh_distance();
    Range        gap{HUGE_VAL, HUGE_VAL};
    if (scene.second_rail != "none")
      {
        const Slices second = turned_slices(scene, scene.second_rail);
        last                = std::max(end, second.slices.back().along);
        if (lie_beside(slices, second))
          {
            first = std::min(first, second.slices.front().along);
            end   = last;
          }
        else
          gap = {end, second.slices.front().along};
      }
    if (begin < first || stop > last || begin > end)
      throw InputError("Profiles/Rail place: the path from " + in_mm(begin) + " to " + in_mm(stop) +
                       " along the rail " +
                       (begin > end && stop <= last
                          ? "begins behind the end of Profiles/Rail at " + in_mm(end)
                          : "leaves the slices, which reach from " + in_mm(first) + " to " + in_mm(last)) +
                       "; begin it elsewhere, or roll a shorter Run/Rolling distance");
    return gap;
  }


  SectionsSurface
  read_rail_slices(const ProfileSettings    &scene,
                   const std::string        &entry,
                   const std::string        &path,
                   const Placement          &placement,
                   std::vector<std::string> &notes)
  {
    if (!is_slices_file(path))
      throw InputError(entry + " = " + path + ": slices are needed, a file that ends in .slcs");
    try
      {
        SectionsSurface rail(turned_slices(scene, path),
                             placement,
                             scene.rail_file.noise,
                             path,
                             0.5e-3,
                             scene.second_rail != "none");
        for (const SectionsSurface::Jump &jump : rail.jumps())
          notes.push_back(path + ": the arc length jumps from " + in_mm(jump.before) + " to " +
                          in_mm(jump.behind) + " between slices " + std::to_string(jump.slice) + " and " +
                          std::to_string(jump.slice + 1) + ": no surface lies between them");
        return rail;
      }
    catch (const InputError &error)
      {
        throw InputError(with_entry(entry, error.what()));
      }
  }


  SectionsSurface
  drawn_rail_slices(const ProfileSettings &scene,
                    const SectionsSurface &rail,
                    const Placement       &placement,
                    const unsigned int     draw)
  {
    std::mt19937_64                  random(draw);
    std::normal_distribution<double> normal(0, 1);
    Slices                           slices = turned_slices(scene, rail.path());
    for (Slices::Slice &slice : slices.slices)
      {
        const double off = rail.noise() * normal(random);
        for (Point2 &p : slice.points)
          p.y += off;
      }
    return {slices, placement, scene.rail_file.noise, rail.path(), 0.5e-3, scene.second_rail != "none"};
  }


  namespace
  {
    /// The section of the slice nearest to the start.
    RailProfile
    rail_of_slice(const Scene              &scene,
                  const Slices             &slices,
                  SceneProfiles            &profiles,
                  std::vector<std::string> &notes)
    {
      const Slices::Slice &slice   = slice_of_start(scene, slices);
      ProfileFileOptions   options = scene.rail_file;
      options.placed               = true;
      options.turn                 = // z points down in slices
        scene.rail_file.turn == ProfileMirror::yes ? ProfileMirror::no : ProfileMirror::yes;
      if (options.mirror == ProfileMirror::automatic)
        options.mirror = ProfileMirror::no;
      profiles.files.rail = read_profile_file(slice.file, options);
      notes               = profiles.files.rail->notes;
      RailProfile rail    = measured_rail(*profiles.files.rail, scene.rail_body, notes);
      notes.insert(notes.begin(), "the section of the mesh is that of the slice at " + in_mm(slice.along));
      return rail;
    }

    /// The surface of two rails beside each other where the path begins.
    RailProfile
    rail_of_crossing(const Scene &scene, const WheelProfile &wheel, std::vector<std::string> &notes)
    {
      std::vector<std::string>  told; // again where the surface rises
      const CrossingSurface     surface(scene, wheel, told);
      const std::vector<Point2> points = surface.section_of_start();
      MeasuredProfile           section;
      section.file   = scene.rail_profile;
      section.placed = true;
      section.curve  = Curve(smoothing_spline(points, {}, std::vector<double>(points.size(), 0.)));
      notes.push_back("the section of the mesh is what both rails have where the path begins, filled up to " +
                      in_mm(CrossingSurface::below) + " below the wheel");
      return wide_rail(section, scene.rail_body == "auto" ? "54E1" : scene.rail_body, notes);
    }
  } // namespace


  void
  read_sliced_rail(const Scene &scene, SceneProfiles &profiles)
  {
    const std::string entry = "Profiles/Rail", &path = scene.rail_profile,
                      given = entry + " = " + path + ": ";
    try
      {
        const Slices slices = turned_slices(scene, path);
        gap_of_rails(scene, slices);
        std::vector<std::string> of;
        profiles.rail      = rails_beside(scene, slices) ? rail_of_crossing(scene, profiles.wheel, of)
                                                         : rail_of_slice(scene, slices, profiles, of);
        profiles.rail.name = path;
        for (const std::string &note : note_lines(of))
          profiles.notes.push_back(given + note);
      }
    catch (const InputError &error)
      {
        throw InputError(with_entry(entry, error.what()));
      }
  }
} // namespace wheelrail
