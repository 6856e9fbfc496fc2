// ranks: 2
// long ranks: 1

// Passages that start farther along the rail. Where the rail lies for them is checked by what an earlier
// wheel has left: a light one that starts elsewhere and lets nothing yield leaves residual stresses, strains
// and flow at each place of the rail as they were, and starts with its weight.

#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/model/model.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/run/staggered_starts.h>

#include "error_of.h"
#include "parallel.h"
#include "small_scene.h"
#include "stopped_runs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  Scene
  scene(const std::string &name)
  {
    Scene scene                         = small_scene(4e-3);
    scene.rolling_distance              = 48e-3;
    scene.averaging_distance            = 8e-3;
    scene.rail_length                   = 0.5;
    scene.ticks                         = 1;
    scene.volume_fields                 = false;
    scene.checkpoint_interval           = 1e4;
    scene.wheel_load                    = 150e3;
    scene.rail_material.yield_stress    = 640e6;
    scene.rail_material.tangent_modulus = 21e9;
    scene.planned_load                  = 150e3;
    scene.folder                        = "staggered_" + name;
    return scene;
  }

  void
  test_places()
  {
    Scene               one      = scene("places");
    const SceneGeometry geometry = make_geometry(one);
    one.rolling_distance         = 40e-3;
    BOOST_TEST(StaggeredStarts(one, geometry).offset(2) == 0,
               "no room on a short way: all start at the same place");
    one.rolling_distance = 80e-3;
    const StaggeredStarts two(one, geometry);
    const double          step = two.offset(2);
    BOOST_TEST((two.offset(1) == 0 && step > 15e-3 && two.offset(3) == step && two.period() == 1),
               "all but the first start a patch farther along, which is longer than 15 mm here: " +
                 std::to_string(1e3 * step) + " mm");
    one.staggered_starts = 3;
    const StaggeredStarts three(one, geometry);
    BOOST_TEST((three.offset(2) == step && three.offset(3) == 2 * step && three.offset(4) == step &&
                three.period() == 2),
               "three places: the last two in turn");
    one.window = MeshWindow::fixed;
    BOOST_TEST(StaggeredStarts(one, geometry).offset(2) == 0, "one where the fine cells do not move");
    one.window           = MeshWindow::moving;
    one.staggered_starts = 9;
    const std::string said =
      test::error_of<InputError>([&]() { const StaggeredStarts too_many(one, geometry); });
    BOOST_TEST(same_text(
      said,
      "Run/Staggered starts = 9: each start lies " + rounded_mm(step) +
        " farther along than the one before, and the last one leaves no stretch that all wheels have "
        "rolled over; take "
        "fewer, or a longer Run/Rolling distance and Track/Rail length",
      "too many are refused"));
  }

  /// An irregularity of the rail stays at its place of the rail wherever the wheel starts.
  void
  test_irregular()
  {
    Scene one                    = scene("irregular");
    one.rolling_distance         = 80e-3;
    one.irregularities[0].kind   = IrregularKind::dent;
    one.irregularities[0].place  = 60e-3;
    one.irregularities[0].length = 30e-3;
    one.irregularities[0].width  = 30e-3;
    one.irregularities[0].depth  = 0.1e-3;
    BOOST_TEST(StaggeredStarts(one, make_geometry(one)).offset(2) == 0,
               "all wheels meet a dent after one way");
    one.start_offset               = 20e-3; // no whole number of blocks
    const SceneGeometry   geometry = make_geometry(one);
    const SweepPlan       plan     = sweep_plan(one, geometry);
    const RunningSurface &rail     = geometry.surfaces.rail;
    const double          farther  = plan.start_block * plan.block_length();
    BOOST_TEST(
      near(1e3 * (rail.at(0, 60e-3 - farther).n - rail.smooth(0).n), -0.1, 1e-6, "depth at its middle [mm]"));
    one.start_offset            = 0;
    one.staggered_starts        = 2;
    one.irregularities[0].place = 35e-3;
    const std::string said =
      test::error_of<InputError>([&]() { const StaggeredStarts on_it(one, make_geometry(one)); });
    BOOST_TEST((said.find("Run/Staggered starts = 2: a start ") == 0 &&
                said.find("farther along: Irregularity 1/Place = 35 mm: the wheel starts on the rail") !=
                  std::string::npos),
               "no start on a dent: " + said);
  }

  double
  figure(const Scene &of, const std::string &key)
  {
    return get_figure(read_summary(of.folder + "/summary.json"), key);
  }

  /// Stress along the rail two millimetres deep in AA_behind over the place on the rail, in the fourth part
  /// of a millimetre from the start without an offset.
  std::map<long, double>
  stress_over_place(const Scene &of)
  {
    const hdf5::Handle file(
      hdf5::open_in_memory(read_whole_file(of.folder + "/residual.h5")), H5Fclose, "read it");
    const hdf5::Handle group(H5Gopen2(file, "tick_0000/AA_behind_rail", H5P_DEFAULT), H5Gclose, "find AA");
    const auto position = hdf5::read_dataset(group, "position"), depth = hdf5::read_dataset(group, "depth"),
               stress          = hdf5::read_dataset(group, "stress_zz");
    const std::size_t      at  = std::lower_bound(depth.begin(), depth.end(), 1.9e-3) - depth.begin();
    const double           end = figure(of, "rolled_distance_m") + of.start_offset;
    std::map<long, double> result;
    for (std::size_t i = 0; i < position.size(); ++i)
      result[std::lround((position[i] + end) / 0.25e-3)] = stress[i * depth.size() + at];
    return result;
  }

  void
  test_light_wheel(const bool talks)
  {
    const Scene heavy = scene("heavy");
    BOOST_TEST(run(heavy, false) == 0, "a wheel that lets the rail yield");
    Scene light            = scene("light");
    light.wheel_load       = 65e3;
    light.rail_from        = heavy.folder;
    light.staggered_starts = 2;
    light.start_offset     = StaggeredStarts(light, make_geometry(light)).offset(2);
    BOOST_TEST(light.start_offset > 15e-3, "another one starts farther along");
    BOOST_TEST(run(light, false) == 0, "and rolls");
    BOOST_TEST(near(
      figure(light, "first_force_over_load"), 1, 0.01, "vertical force of the first step over the load"));
    BOOST_TEST(near(figure(light, "plastic_work_rail_J"), 0, 0, "nothing yields"));
    for (const char *key : {"rail_plastic_strain",
                            "residual_lateral_stress_Pa",
                            "residual_longitudinal_stress_Pa",
                            "residual_forward_flow_m"})
      BOOST_TEST(near_relative(figure(light, key), figure(heavy, key), 1e-3, key));
    if (!talks)
      return;
    const auto before = stress_over_place(heavy), after = stress_over_place(light);
    double     largest = 0, change = 0, varies = 0;
    bool       same = true;
    for (const auto &[place, stress] : after)
      {
        same    = same && before.count(place) == 1;
        largest = std::max(largest, std::abs(stress));
        change  = std::max(change, same ? std::abs(stress - before.at(place)) : 0);
        varies  = std::max(varies, std::abs(stress - after.begin()->second));
      }
    BOOST_TEST((same && after.size() < before.size()), "the same places on the rail, fewer before them");
    BOOST_TEST((after.size() > 2 && varies > 1e-2 * largest), "along the rail stresses vary");
    BOOST_TEST(
      near(change / largest, 0, 1e-3, "but stay at their places: largest change over the largest stress"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(staggered_starts)
{
  const Parallel parallel;
  test_places();
  test_irregular();
  test_light_wheel(parallel.rank == 0);
}
