#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/model/rail_slices.h>
#include <wheelrail/profiles/measured_profiles.h>
#include <wheelrail/profiles/note_lines.h>
#include <wheelrail/profiles/slices_file.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  Slices
  turned_slices(const ProfileSettings &scene, const std::string &path)
  {
    Slices slices = read_slices_file(path, scene.rail_file.unit);
    if (slices.wheel)
      throw InputError(path + ": slices of a wheel; a rail has them in a file that ends in .slcs");
    for (Slices::Slice &slice : slices.slices)
      for (Point2 &p : slice.points)
        p = {(scene.rail_file.mirror == ProfileMirror::yes ? -1 : 1) * p.x,
             (scene.rail_file.turn == ProfileMirror::yes ? -1 : 1) * p.y};
    return slices;
  }


  const Slices::Slice &
  slice_of_start(const ProfileSettings &scene, const Slices &slices)
  {
    return *std::min_element(
      slices.slices.begin(), slices.slices.end(), [&](const Slices::Slice &a, const Slices::Slice &b) {
        return std::abs(a.along - scene.rail_place) < std::abs(b.along - scene.rail_place);
      });
  }


  Range
  gap_of_rails(const Scene &scene, const Slices &slices)
  {
    const double first = slices.slices.front().along, end = slices.slices.back().along,
                 begin = scene.rail_place, stop = begin + scene.mesh_distance();
    double last = end;
    Range  gap{HUGE_VAL, HUGE_VAL};
    if (scene.second_rail != "none")
      {
        const Slices second = turned_slices(scene, scene.second_rail);
        gap                 = {end, second.slices.front().along};
        last                = second.slices.back().along;
        if (!(gap.s1 > gap.s0))
          throw InputError("Profiles/Second rail = " + scene.second_rail + ": it begins at " + in_mm(gap.s1) +
                           ", before the end of Profiles/Rail at " + in_mm(gap.s0) +
                           "; a mesh has two rails one behind the other, as at a joint: rails beside each "
                           "other, as wing and nose, are for --places of geometry and halfspace");
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
        throw InputError(entry + ": " + error.what());
      }
  }


  void
  read_sliced_rail(const Scene &scene, SceneProfiles &profiles)
  {
    const std::string entry = "Profiles/Rail", &path = scene.rail_profile;
    try
      {
        const Slices slices = turned_slices(scene, path);
        gap_of_rails(scene, slices);
        const Slices::Slice &slice   = slice_of_start(scene, slices);
        ProfileFileOptions   options = scene.rail_file;
        options.placed               = true;
        options.turn                 = // z points down in slices
          scene.rail_file.turn == ProfileMirror::yes ? ProfileMirror::no : ProfileMirror::yes;
        if (options.mirror == ProfileMirror::automatic)
          options.mirror = ProfileMirror::no;
        profiles.files.rail          = read_profile_file(slice.file, options);
        std::vector<std::string> &of = profiles.files.rail->notes;
        profiles.rail                = measured_rail(*profiles.files.rail, scene.rail_body, of);
        profiles.rail.name           = path;
        of.insert(of.begin(), "the section of the mesh is that of the slice at " + in_mm(slice.along));
        for (const std::string &note : note_lines(of))
          profiles.notes.push_back(entry + " = " + path + ": " + note);
      }
    catch (const InputError &error)
      {
        const std::string text = error.what();
        throw InputError(text.rfind("Profiles/", 0) == 0 ? text : entry + ": " + text);
      }
  }
} // namespace wheelrail
