#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/planned_strip.h>
#include <wheelrail/run/passage_list.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// A wheel of the list before its contact is known.
    using NamedScene = std::pair<std::string, Scene>;

    /// Whether the rail, or what it is divided into, depends on an entry.
    bool
    of_rail(const Entry &entry)
    {
      const std::string path   = entry.path();
      const auto        begins = [&](const char *with) { return path.rfind(with, 0) == 0; };
      return begins("Rail material/") || begins("Track/") ||
             (begins("Profiles/") && !begins("Profiles/Wheel")) ||
             (begins("Mesh/") && path != "Mesh/Wheel element") || path == "Wheelset/Nominal rolling radius" ||
             path == "Wheelset/Flange back distance" || path == "Wheelset/Side";
    }

    /// A scene file of the list over the rail of `family`, whose passages and outputs are its own.
    Scene
    scene_over_rail(const std::string &path, const Scene &family)
    {
      Scene      one        = read_scene(path, {}).scene;
      const auto other_rail = [&](const std::string &entry, const std::string &value) {
        return InputError(path + ": " + entry +
                          ": that is another rail than that of the scene whose Run/Passage list has this "
                          "file, where it is " +
                          value + "; wheels, loads, shifts and friction may differ");
      };
      if (one.path() != family.path())
        throw other_rail(path_text(one), rounded_mm(family.path()));
      for (const Entry &entry : entries())
        {
          if (of_rail(entry) && entry.get(one) != entry.get(family))
            throw other_rail(entry_text(one, entry.section, entry.name), entry.get(family));
          if (entry.path() == "Run/Passage list" && entry.get(one) != "none")
            throw InputError(path + ": " + entry_text(one, entry.section, entry.name) +
                             ": a scene of a list cannot have one of its own; write none");
          if (entry.section == "Output" || entry.section == "Study" ||
              (entry.section == "Run" && entry.name != "Start" && entry.name != "Time step factor"))
            entry.set(one, entry.get(family));
        }
      return one;
    }

    std::vector<NamedScene>
    listed_scenes(const Scene &scene)
    {
      if (scene.passage_list == "none")
        return {{"", scene}};
      std::vector<NamedScene> list;
      if (is_list_of_scenes(scene.passage_list))
        {
          for (const std::string &name : split_list(scene.passage_list, ','))
            list.push_back({name, scene_over_rail(name, scene)});
          return list;
        }
      const MotionFile rows = read_passage_list(scene.passage_list);
      for (std::size_t row = 0; row < rows.rows(); ++row)
        list.push_back({scene.passage_list + ": row " + std::to_string(row + 1), scene_at(scene, rows, row)});
      return list;
    }

    SceneGeometry
    geometry_of(const NamedScene &named)
    {
      try
        {
          return make_geometry(named.second);
        }
      catch (const InputError &error)
        {
          throw InputError(named.first + ": " + error.what());
        }
    }

    bool
    same_contact(const ContactGeometry &a, const ContactGeometry &b)
    {
      return a.rail_x == b.rail_x && a.wheel_x == b.wheel_x && a.rolling_radius == b.rolling_radius &&
             a.angle == b.angle && a.wheel_curvature == b.wheel_curvature;
    }

    /// Lays fine cells for the largest load in all scenes, when loads differ.
    void
    plan_load(std::vector<PassingWheel> &wheels)
    {
      double largest = 0, least = HUGE_VAL;
      for (const PassingWheel &wheel : wheels)
        {
          const double load = std::max(wheel.scene.planned_load, expected_load(wheel.scene));
          largest           = std::max(largest, load);
          least             = std::min(least, load);
        }
      if (largest > least)
        for (PassingWheel &wheel : wheels)
          wheel.scene.planned_load = largest;
    }

    /// Lays them around all patches, when wheels touch the rail at different places; to 0.1 mm.
    void
    plan_strips(std::vector<PassingWheel> &wheels)
    {
      const auto here = [&](const PassingWheel &wheel) {
        return same_contact(wheel.geometry.contact, wheels.front().geometry.contact);
      };
      if (!wheels.front().scene.planned_strip.empty() || std::all_of(wheels.begin(), wheels.end(), here))
        return;
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const PassingWheel &wheel : wheels)
        {
          const double load =
            wheel.scene.planned_load > 0 ? wheel.scene.planned_load : expected_load(wheel.scene);
          const std::vector<double> strip = strip_of_patch(wheel.scene, wheel.geometry, load);
          low                             = std::min(low, strip[0]);
          high                            = std::max(high, strip[1]);
        }
      for (PassingWheel &wheel : wheels)
        wheel.scene.planned_strip = {std::floor(1e4 * low) / 1e4, std::ceil(1e4 * high) / 1e4};
    }
  } // namespace


  std::vector<PassingWheel>
  passing_wheels(const Scene &scene, const SceneGeometry &geometry)
  {
    if (scene.passage_list == "none")
      return {{"", scene, geometry}};
    std::vector<PassingWheel> wheels;
    for (const NamedScene &named : listed_scenes(scene))
      wheels.push_back({named.first, named.second, geometry_of(named)});
    plan_load(wheels);
    plan_strips(wheels);
    return wheels;
  }
} // namespace wheelrail
