// label: fast

// A plate that slides under a rigid plane: stopping way and heat for several friction coefficients, and the
// limit of sticking.

#include "parallel.h"
#include "scenes/contact.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

using namespace scenes;
using namespace wheelrail;
using namespace test;

namespace
{
  constexpr double cell = 2e-3, half = 10e-3, depth = 4e-3, pressure = 1e7;

  /// An elastic plate 20 x 4 x 20 mm, as the rail, pressed from below against a rigid plane at rest.
  class Plate
  {
  public:
    explicit Plate(const double friction)
      : surfaces(wheel_on_plane(1e4, 0, 30e-3))
      , scene(rail_block(grid(), {0, depth / 2, depth}, grid()), Setup())
    {
      const LocalMesh &mesh = scene.solid.mesh;
      const CellRange  fine = {-half, half, cell}, beyond = {-2 * half, 2 * half, cell};
      const Lattice    lattice = make_lattice(fine, fine);
      ContactSetup     contact;
      contact.cell_size = cell;
      contact.friction  = {friction};
      pair              = std::make_unique<ContactPair>(scene,
                                           surfaces,
                                           make_surface(mesh, Body::rail, surfaces, lattice, MPI_COMM_SELF),
                                           rigid_surface(surfaces, make_lattice(beyond, beyond)),
                                           contact);
      scene.press(select_faces(mesh, plane(1, -depth)), [](double) { return pressure; });
      // equilibrium at rest: sunk into the layer and shortened
      const Elasticity steel;
      for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
        {
          const Vector3 X = place_of(mesh, n);
          double       *u = &scene.solid.displacement[4 * n];
          u[0]            = steel.poissons_ratio * pressure / steel.youngs_modulus * X[0];
          u[1]            = pressure / pair->contact.law().stiffness - pressure / steel.youngs_modulus * X[1];
          u[2]            = steel.poissons_ratio * pressure / steel.youngs_modulus * X[2];
          mass += weight(n);
        }
    }

    double
    weight(const std::size_t node) const
    {
      return scene.solid.mass[node] + scene.solid.added_mass[node];
    }

    /// Mean over the mass of the displacement or velocity along Z.
    double
    mean(const AlignedVector<double> &field) const
    {
      double sum = 0;
      for (std::size_t n = 0; n < scene.solid.mass.size(); ++n)
        sum += weight(n) * field[4 * n + 2];
      return sum / mass;
    }

    /// A force along Z, spread over the mass.
    void
    pull(const Function &force)
    {
      scene.add_force([this, force](const double time, const Solid &, double *forces) {
        for (std::size_t n = 0; n < scene.solid.mass.size(); ++n)
          forces[4 * n + 2] += weight(n) / mass * force(time);
      });
    }

    static std::vector<double>
    grid()
    {
      return both_sides(fine_then_coarse(cell, half, half));
    }

    RunningSurfaces              surfaces;
    Dynamics                     scene;
    std::unique_ptr<ContactPair> pair;
    double                       mass = 0;
    static constexpr double      load = pressure * 4 * half * half;
  };

  void
  stopping(const double friction)
  {
    const std::string name  = "friction " + std::to_string(friction).substr(0, 3) + ": ";
    const double      speed = 5;
    Plate             plate(friction);
    for (std::size_t n = 0; n < plate.scene.solid.mass.size(); ++n)
      plate.scene.solid.velocity[4 * n + 2] = speed;
    const double kinetic = 0.5 * plate.mass * speed * speed;
    if (friction == 0)
      {
        plate.scene.run_to(60e-6);
        BOOST_TEST(
          near(plate.mean(plate.scene.solid.velocity) / speed, 1, 1e-6, name + "the plate keeps its speed"));
        BOOST_TEST(near(plate.pair->friction_energy, 0, 0, name + "no heat"));
        return;
      }
    const double deceleration = friction * Plate::load / plate.mass, way = speed * speed / (2 * deceleration);
    plate.scene.run_to(0.5 * speed / deceleration);
    BOOST_TEST(near(
      plate.mean(plate.scene.solid.displacement) / (0.75 * way), 1, 0.01, name + "way after half the time"));
    plate.scene.run_to(1.6 * speed / deceleration);
    BOOST_TEST(near(plate.mean(plate.scene.solid.displacement) / way, 1, 0.01, name + "way v^2/(2 mu g)"));
    BOOST_TEST(
      near(plate.pair->friction_energy / kinetic, 1, 0.01, name + "heat over the kinetic energy lost"));
    BOOST_TEST(near((plate.pair->work + plate.pair->friction_energy + plate.pair->damping_energy) / kinetic,
                    0,
                    0.01,
                    name + "work of the forces against heat and springs"));
  }

  void
  limit_of_sticking()
  {
    const double friction = 0.4, rise = 60e-6;
    for (const double part : {0.9, 1.1})
      {
        Plate plate(friction);
        plate.pull([&](const double time) {
          const double t = std::min(1., time / rise);
          return part * friction * Plate::load * t * t * (3 - 2 * t);
        });
        plate.scene.run_to(rise);
        const double before = plate.mean(plate.scene.solid.velocity), time = plate.scene.time();
        plate.scene.run_to(3 * rise);
        const double acceleration =
          (plate.mean(plate.scene.solid.velocity) - before) / (plate.scene.time() - time);
        const double expected = std::max(0., part - 1) * friction * Plate::load / plate.mass;
        BOOST_TEST(near(acceleration * plate.mass / (friction * Plate::load),
                        expected * plate.mass / (friction * Plate::load),
                        0.01,
                        "pulled with " + std::to_string(part).substr(0, 3) +
                          " of the bound: acceleration over the bound's"));
        if (part < 1)
          BOOST_TEST(plate.mean(plate.scene.solid.displacement) < 0.5e-6,
                     "below the bound it does not move away");
      }
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(contact_sliding, test::Parallel)
{
  for (const double friction : {0., 0.2, 0.5, 0.8})
    stopping(friction);
  limit_of_sticking();
}
