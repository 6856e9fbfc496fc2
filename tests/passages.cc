// label: long

// Wheels that pass one after the other over a rail that yields. A passage at a load at which nothing yields
// leaves dents and residual stresses as they are and starts with its weight; passages flow less and less
// under isotropic hardening; a family that is interrupted goes on to the same figures.

#include <wheelrail/base/errors.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/run/passage_table.h>
#include <wheelrail/solid/kernel.h>
#include <wheelrail/state/rail_state.h>

#include "error_of.h"
#include "parallel.h"
#include "small_scene.h"
#include "stopped_runs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;
namespace fs = std::filesystem;

namespace
{
  Scene
  scene(const std::string &name, const MeshWindow window = MeshWindow::moving)
  {
    Scene scene                         = small_scene(4e-3);
    scene.window                        = window;
    scene.rolling_distance              = 24e-3;
    scene.rail_length                   = 0.4;
    scene.ticks                         = 2;
    scene.planned_load                  = 110e3;
    scene.volume_fields                 = false;
    scene.checkpoint_interval           = 1e4;
    scene.rail_material.yield_stress    = 400e6;
    scene.rail_material.tangent_modulus = 21e9;
    scene.folder                        = "passages_" + name;
    return scene;
  }

  /// What a run has left in the rail: its mesh of the end, with displacements and histories.
  struct LeftRail
  {
    Model model;

    LeftRail(const Scene &of, const std::string &folder)
      : model(make_model(of, make_geometry(of), MPI_COMM_WORLD))
    {
      Scene there           = of;
      there.rail_from       = folder;
      const Checkpoint rail = read_rail(there, print_parameters(of), MPI_COMM_WORLD);
      if (model.discretization->plan().moving)
        {
          model.window = rail.window;
          prepare_mesh(model, MPI_COMM_WORLD);
        }
      BOOST_TEST(restore_bodies(rail, model.solid, 0, MPI_COMM_WORLD),
                 "the rail of " + folder + " has the mesh of its run");
    }
    std::vector<std::array<double, 6>>
    stress() const
    {
      return element_stress(model.solid.blocks.rail, model.solid.displacement.data());
    }
  };

  double
  figure(const std::string &folder, const std::string &key)
  {
    return get_figure(read_summary(folder + "/summary.json"), key);
  }

  void
  light_passage(const MeshWindow window)
  {
    const std::string kind  = window == MeshWindow::moving ? " (moving window)" : " (fixed mesh)";
    const Scene       heavy = scene("heavy", window);
    BOOST_TEST(run(heavy, false) == 0, "a passage that yields" + kind);
    Scene light      = scene("light", window);
    light.wheel_load = 65e3; // the patch is still as long as three cells
    light.rail_from  = heavy.folder;
    BOOST_TEST(run(light, false) == 0, "a light one over the same rail" + kind);
    BOOST_TEST(near(figure(light.folder, "first_force_over_load"),
                    1,
                    0.01,
                    "vertical force of the first step over the load" + kind));
    BOOST_TEST(near(figure(light.folder, "plastic_work_rail_J"), 0, 0, "nothing yields" + kind));
    BOOST_TEST(figure(light.folder, "energy_error") < 5e-3, "the energy balance holds" + kind);

    const LeftRail before(heavy, heavy.folder), after(light, light.folder);
    const auto     was = before.stress(), is = after.stress();
    BOOST_TEST((was.size() == is.size()), "the same cells" + kind);
    double largest = 0, change = 0;
    for (std::size_t e = 0; e < std::min(was.size(), is.size()); ++e)
      for (int k = 0; k < 6; ++k)
        {
          largest = std::max(largest, std::abs(was[e][k]));
          change  = std::max(change, std::abs(was[e][k] - is[e][k]));
        }
    BOOST_TEST(largest > 20e6, "stress is left: " + std::to_string(1e-6 * largest) + " MPa" + kind);
    BOOST_TEST(near(change / largest, 0, 1e-3, "change of the residual stress over the largest" + kind));
  }

  void
  three_passages()
  {
    Scene one    = scene("one_go");
    one.passages = 3;
    fs::remove_all(one.folder);
    BOOST_TEST(run(one, false) == 0, "three passages");
    double last = 1e300;
    for (unsigned int k = 1; k <= 3; ++k)
      {
        const std::string folder = passage_folder(one.folder, k), text = ", passage " + std::to_string(k);
        const double      work = figure(folder, "plastic_work_rail_J");
        BOOST_TEST(work < last, "less plastic work than before: " + std::to_string(work) + " J" + text);
        BOOST_TEST(near(
          figure(folder, "first_force_over_load"), 1, 0.01, "first vertical force over the load" + text));
        BOOST_TEST(figure(folder, "energy_error") < 5e-3, "the energy balance holds" + text);
        last = work;
      }
    BOOST_TEST(fs::exists(one.folder + "/passages.csv"), "their table is written");
    BOOST_TEST(read_summary(one.folder + "/summary.json").finished, "and the summary of the last");

    Scene parts    = scene("parts");
    parts.passages = 3;
    fs::remove_all(parts.folder);
    BOOST_TEST(run(parts, false, 40) == 3, "interrupted in the first passage");
    BOOST_TEST(run(parts, true, 40) == 3, "gone on, and interrupted in the second");
    RunOptions options;
    options.prm_text        = "# a test\n";
    options.parameters_text = print_parameters(parts);
    BOOST_TEST(
      same_text(test::error_of<InputError>([&]() { run_scene(parts, make_geometry(parts), options); }),
                "Output/Folder = passages_parts: the folder holds passages of an earlier run; --resume "
                "continues them, --overwrite starts anew",
                "begun passages are protected"));
    BOOST_TEST(run(parts, true) == 0, "gone on to the end");
    for (unsigned int k = 1; k <= 3; ++k)
      for (const char *key :
           {"normal_force_N", "max_pressure_Pa", "plastic_work_rail_J", "rail_plastic_strain"})
        BOOST_TEST(
          near(figure(passage_folder(parts.folder, k), key) / figure(passage_folder(one.folder, k), key),
               1,
               1e-4, // two static starts of the same scene differ by some 1e-8
               "the same " + std::string(key) + " of passage " + std::to_string(k)));

    parts.velocity = 30;
    BOOST_TEST(same_text(
      test::error_of<InputError>([&]() { run(parts, true); }),
      "passages_parts/passage_001: this passage was computed with other entries: Wheelset/Velocity = "
      "108 km/h, saved with 140 km/h; set them back, or start anew with --overwrite or in another "
      "Output/Folder",
      "finished passages of another velocity"));
  }

  /// Wheels at two places in turn: the second one rolls over a rail of the same cells, starts with its
  /// weight, and leaves its own band beside the first, whose plastic strain stays where it does not reach.
  void
  shifted_passages()
  {
    Scene two        = scene("shifted");
    two.passage_list = "passages_shifts.csv";
    std::ofstream(two.passage_list) << "lateral shift [mm]\n0\n2\n";
    fs::remove_all(two.folder);
    BOOST_TEST(run(two, false) == 0, "two wheels at two places");
    for (unsigned int k = 1; k <= 2; ++k)
      {
        const std::string folder = passage_folder(two.folder, k), text = ", passage " + std::to_string(k);
        BOOST_TEST(near(
          figure(folder, "first_force_over_load"), 1, 0.01, "first vertical force over the load" + text));
        BOOST_TEST(figure(folder, "energy_error") < 5e-3, "the energy balance holds" + text);
        BOOST_TEST(figure(folder, "plastic_work_rail_J") > 0.1, "the rail yields" + text);
      }
    BOOST_TEST(figure(passage_folder(two.folder, 2), "plastic_band_width_m") >
                 1.5 * figure(passage_folder(two.folder, 1), "plastic_band_width_m"),
               "the band of both is wider than that of one");
  }

  /// A wheel that yields comes back: it starts with its weight and yields less than a new one.
  void
  same_wheel()
  {
    Scene fresh                          = scene("fresh_wheel");
    fresh.passages                       = 2;
    fresh.wheel_material.yield_stress    = 400e6;
    fresh.wheel_material.tangent_modulus = 21e9;
    Scene same                           = fresh;
    same.next_wheel                      = NextWheel::same;
    same.folder                          = "passages_same_wheel";
    for (const Scene &one : {fresh, same})
      {
        fs::remove_all(one.folder);
        BOOST_TEST(run(one, false) == 0, "two passages of a wheel that yields");
        const std::string folder = passage_folder(one.folder, 2);
        BOOST_TEST(
          near(figure(folder, "first_force_over_load"), 1, 0.01, "first vertical force over the load"));
        BOOST_TEST(figure(folder, "energy_error") < 5e-3, "the energy balance holds");
      }
    const auto work = [](const Scene &of, const unsigned int k) {
      return figure(passage_folder(of.folder, k), "plastic_work_wheel_J");
    };
    BOOST_TEST(work(fresh, 2) > 0.7 * work(fresh, 1),
               "each new wheel yields: " + std::to_string(work(fresh, 2)) + " J");
    BOOST_TEST(work(same, 2) < 0.5 * work(same, 1),
               "the same one much less the second time: " + std::to_string(work(same, 2)) + " J");
  }

  /// A passage that stops leaves those before it and says so.
  void
  stopped_passage()
  {
    Scene family    = scene("stopped");
    family.passages = 2;
    fs::remove_all(family.folder);
    run(family, false);
    fs::remove_all(passage_folder(family.folder, 2));
    family.energy_limit    = 1e-9;
    const std::string told = test::error_of<RunError>([&]() { run(family, true); });
    BOOST_TEST(
      (told.rfind("passage 2: the run stopped: ", 0) == 0 &&
       told.find("; the 1 before it are kept, with their results in passages_stopped/passages.csv") !=
         std::string::npos),
      "a passage that stops: " + told);
    BOOST_TEST(read_summary(passage_folder(family.folder, 1) + "/summary.json").finished,
               "the first one is kept");
  }

  std::string
  fault(const Scene &of)
  {
    return test::error_of<InputError>([&]() { run(of, false); });
  }

  void
  faults()
  {
    Scene other     = scene("other");
    other.rail_from = "passages_nowhere";
    BOOST_TEST(
      same_text(fault(other),
                "Run/Rail = passages_nowhere: there is no rail.h5, which runs with a rail that yields leave "
                "when they have "
                "finished",
                "no rail"));
    std::filesystem::create_directories("passages_cut");
    std::ofstream("passages_cut/rail.h5") << "no whole file";
    other.rail_from = "passages_cut";
    BOOST_TEST(
      same_text(fault(other),
                "Run/Rail = passages_cut: passages_cut/rail.h5 is no whole rail (HDF5 cannot read it.); "
                "compute that run again with --overwrite, or name another folder",
                "a rail that was cut off"));
    other.rail_from                  = "passages_heavy";
    other.rail_material.yield_stress = 480e6;
    BOOST_TEST(same_text(
      fault(other),
      "Run/Rail = passages_heavy: the steel of that rail is another one: Rail material/Yield stress "
      "= 480 MPa, "
      "there 400 MPa",
      "another steel"));
    other               = scene("other");
    other.rail_from     = "passages_heavy";
    other.lateral_shift = 2e-3;
    BOOST_TEST(same_text(
      fault(other),
      "Run/Rail = passages_heavy: that rail has another mesh; rail profile, track, rolling distance and "
      "the cells of Mesh must be those of its run, and Mesh/Planned load the same in both where loads "
      "differ, Mesh/Planned strip where lateral shifts or wheels differ",
      "another mesh"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(passages, test::Parallel)
{
  light_passage(MeshWindow::fixed);
  light_passage(MeshWindow::moving);
  three_passages();
  shifted_passages();
  same_wheel();
  stopped_passage();
  faults();
}
