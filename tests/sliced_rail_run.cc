// ranks: 1 2
// label: long
// Runs on rails by slices: one section all along is the plain rail; over the gap of a joint the load goes
// from one rail to the other, and momentum changes by the impulse where that is lower or higher; on a
// crossing the load goes from the wing to the nose where half-spaces on bodies that give as these do share
// it.
#include "between_rows.h"
#include "parallel.h"
#include "read_output.h"
#include "slices_files.h"
#include "stopped_runs.h"

#include <wheelrail/input/parameters.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/run/run_state.h>
#include <wheelrail/sections/rail_slices.h>
#include <wheelrail/sections/section_contacts.h>
#include <wheelrail/wheel/halfspace_parts.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  /// A free wheel at 30 m/s on cells of 4 mm, over 12 mm of a rail of the file's section.
  Scene
  short_scene(const std::string &rail)
  {
    Scene scene;
    scene.title               = rail;
    scene.rail_profile        = rail;
    scene.rail_file.noise     = 0;
    scene.rail_file.placed    = true;
    scene.cell_size           = 4e-3;
    scene.fine_margin         = 4e-3;
    scene.fine_depth          = 8e-3;
    scene.rail_length         = 0.5;
    scene.velocity            = 30;
    scene.rolling_distance    = 12e-3;
    scene.averaging_distance  = 4e-3;
    scene.ticks               = 1;
    scene.volume_fields       = false;
    scene.checkpoint_interval = 1e4;
    scene.folder              = "sliced";
    return scene;
  }

  void
  write_rails()
  {
    write_points("head.txt", head_points());
    write_slices("plain.slcs", "head.txt", -200, 300);
    write_slices("before.slcs", "head.txt", -200, 0);
    write_slices("behind.slcs", "head.txt", 6, 200);
    for (const double low : {0.5, -0.5})
      {
        std::vector<Point2> points = head_points();
        for (Point2 &p : points)
          p.y += low;
        const std::string name = low > 0 ? "lower" : "higher";
        write_points(name + ".txt", points);
        write_slices(name + ".slcs", name + ".txt", 6, 200);
      }
  }

  Summary
  rolled(const Scene &scene)
  {
    BOOST_TEST(run(scene, false) == 0, scene.title + ": the run ends");
    return read_summary("sliced/summary.json");
  }

  void
  test_one_section()
  {
    Scene scene          = short_scene("head.txt");
    scene.rail_file.turn = ProfileMirror::yes; // its z points down, as that of slices does
    const Summary plain  = rolled(scene);
    scene                = short_scene("plain.slcs");
    const Summary sliced = rolled(scene);
    BOOST_TEST(
      near_relative(sliced.max_pressure, plain.max_pressure, 1e-6, "peak pressure of one section by slices"));
    BOOST_TEST(near_relative(sliced.contact_area, plain.contact_area, 1e-6, "its contact area"));
    BOOST_TEST(near_relative(sliced.vertical_force, plain.vertical_force, 1e-6, "its vertical force"));
  }

  /// A joint with a gap of 6 mm between level rails.
  void
  test_joint()
  {
    Scene scene            = short_scene("before.slcs");
    scene.second_rail      = "behind.slcs";
    scene.rail_place       = -24e-3;
    scene.rolling_distance = 60e-3;
    scene.energy_limit     = 0.02;
    const Summary summary  = rolled(scene);
    const History history  = read_history("sliced/history.h5");
    const auto    at       = [&](const std::string &name, const double place) {
      return between_rows(column(history, "rolled_distance"), column(history, name), place);
    };
    BOOST_TEST(summary.energy_error < 0.01,
               "energy error " + std::to_string(100 * summary.energy_error) + " %");
    BOOST_TEST(near(at("second_rail_force", 6e-3), 0, 1e-9, "the second rail before the wheel is there [N]"));
    BOOST_TEST(near(at("first_rail_force", 55e-3), 0, 50, "the first when the wheel is off it [N]"));
    BOOST_TEST(at("vertical_force", 55e-3) > 2e4, "the second rail carries");
    double even = 0; // where both carry alike the axle stands over the middle of the gap, but for a cell
    for (double place = 18e-3; place < 36e-3; place += 0.05e-3)
      if (at("second_rail_force", place) < at("first_rail_force", place))
        even = place;
    BOOST_TEST(near(1e3 * even, 27, 2.5, "the load goes over to the second rail [mm]"));
    BOOST_TEST(
      (get_figure(summary, "first_rail_force_N") > 5e4 && get_figure(summary, "second_rail_force_N") > 5e4),
      "largest forces of both rails are in the summary");
  }

  /// Vertical momentum of wheel and axle, of the half step behind [N s]. The added mass of the contact moves
  /// with the wheel: on cells of 4 mm over the wide strip of a crossing it has 4 % of it.
  double
  momentum(const RunState &run, const double axle_mass, const double axle_speed)
  {
    double       sum   = axle_mass * axle_speed;
    const Solid &solid = run.model.solid;
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::wheel && solid.mesh.owns(n))
        sum += (solid.mass[n] + solid.added_mass[n]) * solid.velocity[4 * n + 1];
    return sum;
  }

  /// The momentum of wheel and axle changes by the impulse of contact, load and suspension, and energy is
  /// kept. Up to `even` [m], also down the slope of a wing, the rail bears the load.
  void
  test_impulse(const Scene &scene, const double even)
  {
    const std::string  &behind   = scene.second_rail;
    const SceneGeometry geometry = make_geometry(scene);
    Log                 log;
    const auto          run =
      start_run(scene, geometry, make_model(scene, geometry, MPI_COMM_SELF), {}, log, MPI_COMM_SELF);
    const AxleData &axle = run->model.axle;
    const double    dt = run->model.time_step, load = run->model.wheel_load;
    const double of_wheel = mass_properties(run->model.solid, Body::wheel, axle.centre, MPI_COMM_SELF).mass,
                 of_axle  = load / scene.gravity - axle.sprung_mass - of_wheel;
    const double start    = run->axle.height();
    double before = start, speed = 0, impulse = 0, first = 0, largest = 0, worst = 0, energy = 0, bumped = 0;
    for (long k = 0; k < std::lround(run->model.duration / dt); ++k)
      {
        const double force = load + axle.stiffness * (before - start) + axle.damping * speed;
        follow_wheel(*run);
        run->rolling.step(true);
        speed            = (run->axle.height() - before) / dt;
        before           = run->axle.height();
        const double now = momentum(*run, of_axle, speed);
        if (k == 0)
          first = now;
        else
          impulse += dt * (run->rolling.contact_sums().force[1] - force);
        largest = std::max(largest, std::abs(impulse));
        if (run->axle.travelled() < even)
          bumped = std::max(bumped, std::abs(run->rolling.contact_sums().force[1] / load - 1));
        worst  = std::max(worst, std::abs(now - first - impulse));
        energy = std::max(energy, std::abs(run->rolling.energy().residual()));
      }
    BOOST_TEST(worst < 0.01 * largest,
               behind + ": momentum by impulse, off by " + std::to_string(worst) + " of " +
                 std::to_string(largest) + " N s");
    BOOST_TEST(bumped < 0.1, behind + ": the load before the impact, within " + std::to_string(bumped));
    BOOST_TEST(energy < 0.01 * load * 0.5e-3, behind + ": energy off by " + std::to_string(energy) + " J");
  }

  /// Over a gap of 6 mm to a rail 0.5 mm lower or higher.
  void
  test_step(const std::string &behind)
  {
    Scene scene            = short_scene("before.slcs");
    scene.second_rail      = behind;
    scene.rail_place       = -30e-3;
    scene.rolling_distance = 60e-3;
    scene.velocity         = 15;
    scene.fine_margin      = 8e-3;
    scene.window           = MeshWindow::fixed;
    test_impulse(scene, 15e-3);
  }

  /// Wing and nose on cells of 4 mm.
  Scene
  crossing_scene(const double from, const double distance)
  {
    Scene scene               = read_scene(WHEELRAIL_SOURCE_DIR "/prm/crossing.prm", {}).scene;
    scene.rail_place          = from;
    scene.rolling_distance    = distance;
    scene.rail_length         = 0.8;
    scene.cell_size           = 4e-3;
    scene.fine_margin         = 4e-3;
    scene.fine_depth          = 8e-3;
    scene.mass_scaling        = false;
    scene.ticks               = 1;
    scene.volume_fields       = false;
    scene.checkpoint_interval = 1e4;
    scene.folder              = "sliced";
    return scene;
  }

  /// Wing and nose under a wheel on half-spaces.
  struct RigidCrossing
  {
    const Scene                 &scene;
    std::vector<SectionsSurface> wing, nose;
    PosedWheel                   wheel;
    SectionRolling               rolling;

    RigidCrossing(const Scene &scene, std::vector<std::string> &notes)
      : scene(scene)
      , wing{read_rail_slices(scene, "Profiles/Rail", scene.rail_profile, {}, notes)}
      , nose{read_rail_slices(scene, "Profiles/Second rail", scene.second_rail, {}, notes)}
      , wheel(read_wheel_profile(scene).wheel, scene.track, wheelset_pose(scene))
    {
      rolling.problem = halfspace_problem(scene);
      rolling.turning = scene.velocity / scene.track.nominal_radius;
    }

    /// Height of the wheel on one of them [m].
    double
    height(const std::vector<SectionsSurface> &rail, const double place, const double load) const
    {
      return contacts_under_load(rail, wheel, rolling, scene.rail_place + place, load).height;
    }
  };

  /// A function's root.
  template <typename Function>
  double
  root(const Function &function, const double low, const double high)
  {
    std::uintmax_t steps = 30;
    const auto     found = boost::math::tools::toms748_solve(
      function, low, high, boost::math::tools::eps_tolerance<double>(12), steps);
    return 0.5 * (found.first + found.second);
  }

  /// Finest cells lie where wheel and rails overlap: over half of the strip on the wing alone, over all of it
  /// where both rails are near. The step of the run is stable on all meshes.
  void
  test_narrow_cells()
  {
    const Scene      scene = crossing_scene(400e-3, 170e-3);
    Model            model = make_model(scene, make_geometry(scene), MPI_COMM_WORLD);
    const SweepPlan &plan  = model.discretization->plan();
    const double     whole = plan.whole_strip().s1 - plan.whole_strip().s0;
    double           least = whole, most = 0;
    for (double at = 0; at < scene.rolling_distance; at += plan.block_length())
      {
        if (move_window(scene, model, {at, at}, MPI_COMM_WORLD))
          prepare_mesh(model, MPI_COMM_WORLD);
        const Lattice &lattice = model.contact->lattice();
        const double   across  = (lattice.n_lateral - 1) * lattice.spacing_lateral;
        least                  = std::min(least, across);
        most                   = std::max(most, across);
        BOOST_TEST(model.solid.stable.step > model.time_step,
                   "step on the mesh at " + std::to_string(at) + " m");
      }
    BOOST_TEST(least < 0.51 * whole, "the narrowest finest cells [m]: " + std::to_string(least));
    BOOST_TEST(near(most, whole, 1e-9, "the widest are the strip"));
  }

  /// From the wing to the nose: the place where both carry the same. The bodies below wing and nose give
  /// differently under a load beside their middle: that is measured before and behind the hand-over, and half
  /// of it, as half of the load is on each, moves the place of half-spaces.
  void
  test_crossing()
  {
    const Scene   scene   = crossing_scene(490e-3, 130e-3);
    const Summary summary = rolled(scene);
    const History history = read_history("sliced/history.h5");
    const auto    at      = [&](const std::string &name, const double place) {
      return between_rows(column(history, "rolled_distance"), column(history, name), place);
    };
    const double load  = get_figure(summary, "wheel_load_N");
    double       both  = 0;
    const auto  &first = column(history, "first_rail_force"), &second = column(history, "second_rail_force");
    for (std::size_t k = 0; k < first.size(); ++k)
      both += (first[k] + second[k]) / static_cast<double>(first.size());
    BOOST_TEST(near_relative(both, load, 0.03, "wing and nose carry the load"));
    BOOST_TEST(summary.energy_error < 0.01,
               "energy error " + std::to_string(100 * summary.energy_error) + " %");
    std::vector<std::string> notes;
    const RigidCrossing      rigid(scene, notes);
    const double             before = 5e-3, behind = 127e-3, half = 0.5 * load,
                 touch = touching_places(rigid.wing, rigid.wheel, scene.rail_place).front().height;
    const auto give    = [&](const std::vector<SectionsSurface> &rail, const double place, const double on) {
      return rigid.height(rail, on, load) - touch - at("axle_height", place);
    };
    const double more = give(rigid.wing, before, before) - give(rigid.nose, behind, behind);
    const auto   step = [&](const double given) {
      return [&rigid, half, given](const double place) {
        return rigid.height(rigid.wing, place, half) - rigid.height(rigid.nose, place, half) - 0.5 * given;
      };
    };
    const double wanted = root(step(more), 55e-3, 115e-3);
    const double even =
      root([&](const double place) { return at("second_rail_force", place) - at("first_rail_force", place); },
           55e-3,
           115e-3);
    BOOST_TEST(
      near(1e3 * even,
           1e3 * wanted,
           5,
           "the load goes over to the nose [mm], the wing gives " + std::to_string(1e6 * more) + " um more"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(sliced_rail_run)
{
  const Parallel parallel;
  if (parallel.rank == 0)
    write_rails();
  MPI_Barrier(MPI_COMM_WORLD);
  test_one_section();
  test_joint();
  if (parallel.size == 1)
    {
      for (const std::string behind : {"lower.slcs", "higher.slcs"})
        test_step(behind);
      Scene fast    = crossing_scene(490e-3, 100e-3); // the wheel falls from the wing and hits the nose
      fast.velocity = 100 / 3.6;
      test_impulse(fast, 30e-3);
    }
  test_narrow_cells();
  test_crossing();
}
