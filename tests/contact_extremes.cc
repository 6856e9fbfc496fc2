// Light and heavy loads, bodies of different stiffness, a first touch at full speed, and cells that change
// their size beside and inside the patch.

#include "error_of.h"
#include "parallel.h"
#include "scenes/hertz_scene.h"
#include "scenes/rolling_pair.h"

#include <wheelrail/base/errors.h>
#include <wheelrail/sampling/patch_measures.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

using namespace scenes;
using namespace wheelrail;
using namespace test;

namespace
{
  /// The patch of 1 kN is three cells long and two wide, that of 300 kN twenty and fifteen.
  BOOST_FIXTURE_TEST_CASE(loads, test::Parallel)
  {
    struct Row
    {
      double load, peak, approach, size;
    };
    std::cout << hertz_row(HertzShape::ellipse, 0, 0, nullptr) << std::endl;
    for (const Row &row : {Row{1e3, 0.02, 0.02, 1.34}, Row{3e5, 0.01, 0.01, 8.96}})
      {
        const HertzRun    run  = run_hertz(HertzShape::ellipse, 1e-3, 10, true, row.load);
        const std::string name = std::to_string(std::lround(1e-3 * row.load)) + " kN: ";
        std::cout << hertz_row(HertzShape::ellipse, 1e-3, 10, &run) << "  " << name << std::endl;
        BOOST_TEST(near(run.force, 0, 1e-4, name + "the contact carries the load"));
        BOOST_TEST(near(run.peak, 0, row.peak, name + "peak pressure"));
        BOOST_TEST(near(run.approach, 0, row.approach, name + "approach"));
        // size: mean radius of the patch in cells
        BOOST_TEST(
          near((std::sqrt(1 + run.area) - 1) * row.size, 0, 0.1, name + "edge of the patch in cells"));
      }
  }

  /// A steel ball on a ball of aluminium, pressed together without friction; quarters of both.
  BOOST_FIXTURE_TEST_CASE(different_stiffness, test::Parallel)
  {
    constexpr double      radius = 0.46, cell = 1e-3, fine = 10e-3, descent = 85e-6, ramp = 80e-6;
    const RunningSurfaces surfaces = wheel_on_plane(radius, radius, 50e-3);
    const auto            half     = fine_then_coarse(cell, fine, 30e-3, 1.3),
               depth               = fine_then_coarse(cell, 5e-3, 30e-3, 1.3);
    Setup setup;
    setup.mass_damping   = 1e5;
    setup.material       = {70e9, 0.33, 2700};
    setup.wheel_material = Elasticity();
    Dynamics scene(join(rail_block(half, depth, half), wheel_block(surfaces, half, depth, half)), setup);
    const LocalMesh &mesh = scene.solid.mesh;
    scene.fix(select(mesh, plane(0, 0)), 0);
    scene.fix(select(mesh, plane(2, 0)), 2);
    for (int i = 0; i < 3; ++i)
      scene.fix(select(mesh, [&](const Vector3 &X) { return X[1] < 1e-9 - depth.back(); }), i);
    const Nodes inner = select(mesh, [&](const Vector3 &X) {
      return X[1] > 0 && std::hypot(X[1] - radius, X[2]) < surfaces.local_radius(X[0]) - depth.back() + 1e-9;
    });
    scene.fix(inner, 0);
    scene.fix(inner, 2);
    scene.prescribe(inner, 1, [](const double time) {
      const double t = std::min(1., time / ramp);
      return -descent * t * t * (3 - 2 * t);
    });
    ContactSetup contact;
    contact.symmetry   = {true, true};
    const auto surface = [&](const Body body) {
      return make_surface(
        mesh, body, surfaces, make_lattice({0, fine, cell}, {0, fine, cell}), MPI_COMM_SELF);
    };
    ContactPair pair(scene, surfaces, surface(Body::rail), surface(Body::wheel), contact);
    scene.run_to(350e-6);

    const Elasticity &a = setup.material, &b = *setup.wheel_material;
    const auto        soft = [](const Elasticity &m) {
      return (1 - m.poissons_ratio * m.poissons_ratio) / m.youngs_modulus;
    };
    const Hertz         exact    = hertz(pair.sums.force[1], radius, radius, 1 / (soft(a) + soft(b)));
    const PatchMeasures measures = measure_patch(pair.patch());
    std::cout << "        steel on aluminium, " << 1e-3 * pair.sums.force[1] << " kN, a " << 1e3 * exact.a
              << " mm, " << mesh.cells.size() << " cells, " << scene.steps() << " steps" << std::endl;
    BOOST_TEST(!pair.sums.at_border, "steel on aluminium: the patch lies in the fine cells");
    BOOST_TEST(
      near(measures.peak_pressure / exact.peak, 1, 0.015, "steel on aluminium: peak pressure over Hertz's"));
    BOOST_TEST(
      near(measures.area / (M_PI * exact.a * exact.b), 1, 0.02, "steel on aluminium: area over Hertz's"));
  }

  /// The wheel rolls at 40 m/s with a creepage beyond saturation and is set down at up to 1 m/s.
  BOOST_FIXTURE_TEST_CASE(touch_at_speed, test::Parallel)
  {
    RollingPairSetup setup;
    setup.friction            = {0.5};
    setup.depth               = 30e-3;
    setup.descent             = 65e-6;
    setup.creepage            = 1e-2;
    setup.ramp                = 4e-3;
    setup.distance            = 40e-3;
    const RollingPairRun run  = roll(setup);
    const double         load = run.force[1] / setup.cell, modulus = 210e9 / (2 * (1 - 0.3 * 0.3));
    std::cout << "        set down at full speed: " << 1e-3 * load << " N/mm, F/(mu N) "
              << run.force[2] / (0.5 * run.force[1]) << ", noise " << run.noise << std::endl;
    BOOST_TEST(near(run.force[2] / (0.5 * run.force[1]), 1, 0.002, "set down at full speed: full sliding"));
    BOOST_TEST(near(run.peak / std::sqrt(load * modulus / (M_PI * setup.radius)),
                    1,
                    0.02,
                    "set down at full speed: peak pressure over Hertz's"));
    BOOST_TEST(near(run.energy_error, 0, 0.01, "set down at full speed: friction and springs against work"));
  }

  // --- cells of two sizes -------------------------------------------------------------------------

  /// A block of 2 mm cells, of 1 mm between x = -8 mm and `edge`, under a rigid wheel that comes down.
  class TwoSizes
  {
  public:
    static constexpr double fine = 1e-3, across = 8e-3, along = 10e-3, deep = 6e-3, descent = 52e-6;

    explicit TwoSizes(const double edge)
      : surfaces(wheel_on_plane(0.92, 0.6, 30e-3))
      , scene(mesh(edge), setup())
      , pair(scene,
             surfaces,
             make_surface(scene.solid.mesh, Body::rail, surfaces, lattice(edge), MPI_COMM_SELF),
             rigid_surface(surfaces, lattice(across)),
             ContactSetup())
    {
      for (int i = 0; i < 3; ++i)
        scene.fix(select(scene.solid.mesh, plane(1, -20e-3)), i);
      pair.drive = [this](const double time, RigidWheel &wheel) {
        wheel.velocity[1] = -descent / 300e-6;
        wheel.move[1]     = wheel.velocity[1] * (time + scene.time_step);
      };
    }
    static Setup
    setup()
    {
      Setup result;
      result.mass_damping = 1e5;
      return result;
    }
    static LocalMesh
    mesh(const double edge)
    {
      const auto small = [edge](const Vector3 &X) {
        return X[0] > -across && X[0] < edge && std::abs(X[2]) < along && X[1] > -deep;
      };
      LocalMesh mesh =
        two_level_box({-20e-3, -20e-3, -20e-3}, {20e-3, 0, 20e-3}, {20, 10, 20}, small, 0, Body::rail);
      mark_faces(mesh, Boundary::running, plane(1, 0));
      return mesh;
    }
    static Lattice
    lattice(const double edge)
    {
      return make_lattice({-along, along, fine}, {-across, edge, fine});
    }

    RunningSurfaces surfaces;
    Dynamics        scene;
    ContactPair     pair;
  };

  BOOST_FIXTURE_TEST_CASE(jump_in_the_patch, test::Parallel)
  {
    constexpr double edge = 4e-3;
    TwoSizes         jump(edge), even(TwoSizes::across);
    while (!jump.pair.sums.at_border && jump.scene.time() < 300e-6)
      {
        jump.scene.step();
        even.scene.step();
      }
    BOOST_TEST((jump.pair.sums.at_border && !even.pair.sums.at_border),
               "a patch that comes to the change of cell size is told");
    const Lattice &lattice = jump.pair.contact.lattice(), &whole = even.pair.contact.lattice();
    double         largest = 0, hanging = 0, distance = 0;
    for (unsigned int i = 0; i < lattice.n_along; ++i)
      for (unsigned int j = 0; j < lattice.n_lateral; ++j)
        {
          const double p   = jump.pair.contact.nodes()[lattice.index(i, j)].pressure;
          const double off = std::abs(p - even.pair.contact.nodes()[whole.index(i, j)].pressure);
          if (off > largest)
            {
              largest  = off;
              distance = edge - lattice.s_begin - j * lattice.spacing_lateral;
            }
          if (j + 1 == lattice.n_lateral)
            hanging = std::max(hanging, p);
        }
    const double peak = even.pair.sums.largest_pressure;
    std::cout << "        told at " << 1e-3 * jump.pair.sums.force[1] << " kN, peak " << 1e-6 * peak
              << " MPa, pressures off by up to " << 100 * largest / peak << " % of it, " << 1e3 * distance
              << " mm from the change" << std::endl;
    BOOST_TEST(hanging == 0, "before a hanging node is loaded");
    BOOST_TEST(near(
      jump.pair.sums.largest_pressure / peak, 1, 0.01, "until then the coarse cells hardly change the peak"));
    BOOST_TEST((largest < 0.05 * peak && distance < 2.1 * TwoSizes::fine),
               "they change pressures beside them by less than a twentieth of it");
    BOOST_TEST(near(jump.pair.sums.force[1] / even.pair.sums.force[1], 1, 0.005, "nor the force"));

    // what would come of going on: no facets beyond the edge, so the load there is lost
    while (jump.scene.time() < 300e-6)
      {
        jump.scene.step();
        even.scene.step();
      }
    const double lost = 1 - jump.pair.sums.force[1] / even.pair.sums.force[1];
    std::cout << "        going on to " << 1e-3 * even.pair.sums.force[1] << " kN would lose " << 100 * lost
              << " % of the force" << std::endl;
    BOOST_TEST((lost > 0.005 && std::isfinite(jump.pair.sums.largest_pressure)), "going on would lose force");
  }

  /// Lattices with nodes where the mesh has only coarse cells are refused.
  BOOST_FIXTURE_TEST_CASE(holes, test::Parallel)
  {
    const RunningSurfaces surfaces = wheel_on_plane(0.92, 0.6, 30e-3);
    const std::string     message  = test::error_of<RunError>([&]() {
      make_surface(
        TwoSizes::mesh(4e-3), Body::rail, surfaces, TwoSizes::lattice(TwoSizes::across), MPI_COMM_SELF);
    });
    BOOST_TEST((message.find("the fine zone of the rail has a hole at station") != std::string::npos),
               "coarse cells under the lattice are refused: " + message);
  }
} // namespace
