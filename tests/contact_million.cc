// label: long
// A million steps of a small elastic plate that is pushed to and fro on a block by less than friction holds:
// no drift of position, force and energy.

#include "parallel.h"
#include "scenes/contact.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using namespace scenes;
using namespace wheelrail;
using namespace test;

namespace
{
  constexpr unsigned long million = 1000000;
  constexpr double        half = 4e-3, wide = 6e-3, cell = 2e-3;

  /// A plate 12 x 12 x 4 mm pressed on a block 8 x 8 x 4 mm, so that no node comes to the rim of the facets.
  class PressedPlate
  {
  public:
    static constexpr double friction = 0.4, pressure = 5e7, push = 0.7;
    static constexpr int    cycle = 1000; ///< steps of one turn of the push

    PressedPlate()
      : surfaces(wheel_on_plane(1e4, 0, 30e-3))
      , scene(join(rail_block(grid(half), depth(), grid(half)),
                   wheel_block(surfaces, grid(wide), depth(), grid(wide))),
              setup())
      , pair(scene, surfaces, surface(Body::rail, half), surface(Body::wheel, wide), law())
      , top(select(scene.solid.mesh, plane_above(3.9e-3)))
    {
      for (int i = 0; i < 3; ++i)
        scene.fix(select(scene.solid.mesh, plane(1, -4e-3)), i);
      const double ramp = 0.5 * cycle * scene.time_step;
      scene.press(select_faces(scene.solid.mesh, plane_above(3.9e-3)),
                  [ramp](const double time) { return pressure * std::min(1., time / ramp); });
      scene.add_force([this](const double time, const Solid &, double *force) {
        const double t = time / (cycle * scene.time_step) - 1; // the first cycle presses only
        const double q = t < 0 ? 0. : push * friction * load() * std::sin(2 * M_PI * t);
        for (const unsigned int n : top)
          force[4 * n + 2] += q / top.size();
      });
    }

    static std::vector<double>
    grid(const double end)
    {
      return both_sides(fine_then_coarse(cell, end, end));
    }
    static std::vector<double>
    depth()
    {
      return {0, 2e-3, 4e-3};
    }
    static Setup
    setup()
    {
      Setup result;
      result.bulk_viscosity = 0.06;
      return result;
    }
    static ContactSetup
    law()
    {
      ContactSetup result;
      result.filter    = false; // the whole lattice is loaded
      result.cell_size = cell;
      result.friction  = {friction};
      return result;
    }
    static Predicate
    plane_above(const double height)
    {
      return [height](const Vector3 &X) { return X[1] > height; };
    }
    static double
    load()
    {
      return pressure * 4 * wide * wide;
    }
    Surface
    surface(const Body body, const double end) const
    {
      const CellRange range = {-end, end, cell};
      return make_surface(scene.solid.mesh, body, surfaces, make_lattice(range, range), MPI_COMM_SELF);
    }
    /// Mean place of the plate's top [m].
    Vector3
    place() const
    {
      Vector3 mean{};
      for (const unsigned int n : top)
        add(mean, 1. / top.size(), scene.solid.position(n));
      return mean;
    }

    RunningSurfaces surfaces;
    Dynamics        scene;
    ContactPair     pair;
    Nodes           top;
  };

  /// What one turn of the push leaves behind.
  struct Cycle
  {
    Vector3 place{};    ///< at its end [m]
    double  normal = 0; ///< at its end, over the load
    double  shear  = 0; ///< largest, over the bound of friction
    double  swing  = 0; ///< of the plate [m]
  };

  /// `turns` cycles; figures of the last one.
  Cycle
  turn(PressedPlate &plate, const int turns)
  {
    Cycle  cycle;
    double least = 1, most = -1;
    for (int k = 1; k <= turns * PressedPlate::cycle; ++k)
      {
        plate.scene.step(k % PressedPlate::cycle == 0);
        if (k <= (turns - 1) * PressedPlate::cycle)
          continue;
        const double z = plate.place()[2];
        least          = std::min(least, z);
        most           = std::max(most, z);
        cycle.shear    = std::max(cycle.shear, std::abs(plate.pair.sums.force[2]));
      }
    cycle.shear /= PressedPlate::friction * PressedPlate::load();
    cycle.normal = plate.pair.sums.normal_force / PressedPlate::load();
    cycle.place  = plate.place();
    cycle.swing  = most - least;
    return cycle;
  }

  BOOST_FIXTURE_TEST_CASE(pushed_plate, test::Parallel)
  {
    PressedPlate  plate;
    constexpr int settled = 20;
    const Cycle   early = turn(plate, settled), late = turn(plate, million / PressedPlate::cycle - settled);
    const double  drift       = norm(late.place - early.place);
    const EnergyBalance &e    = plate.scene.energy();
    const auto          &pair = plate.pair;
    const double         kept = pair.sums.stored_energy + pair.friction_energy + pair.damping_energy;
    std::cout << "        plate: swing " << 1e6 * late.swing << " um, drift " << 1e9 * drift
              << " nm, shear force " << late.shear << " of the bound, friction " << pair.friction_energy
              << " J, energy of the bodies off by " << e.residual() << " J, of the contact by "
              << pair.work + kept << " J" << std::endl;
    BOOST_TEST((plate.scene.steps() == million), "plate: a million steps");
    // inertia adds to the push
    BOOST_TEST(near(late.shear / PressedPlate::push, 1, 0.03, "plate: shear force over the push"));
    BOOST_TEST(
      near(late.shear / early.shear, 1, 1e-3, "plate: shear force over that of the twentieth cycle"));
    BOOST_TEST(near(late.normal, 1, 1e-4, "plate: normal force over the load"));
    BOOST_TEST(std::abs(late.normal - 1) < std::abs(early.normal - 1) + 1e-5,
               "plate: normal force no farther from the load than after twenty cycles");
    BOOST_TEST(near(drift / late.swing, 0, 1e-3, "plate: place at the end of a cycle, over the swing"));
    BOOST_TEST(near(e.residual() / (e["strain_energy"] + e["viscous_dissipation"]),
                    0,
                    1e-3,
                    "plate: energy of the bodies"));
    BOOST_TEST(near((pair.work + kept) / kept, 0, 1e-3, "plate: energy of the contact"));
  }
} // namespace
