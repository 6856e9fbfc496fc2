// ranks: 2

// Taking the loads off after some rolling: elastic bodies return to their shape, steel that has flowed keeps
// stresses in equilibrium with themselves, wherever the wheel has turned to.

#include <wheelrail/dynamics/rolling.h>
#include <wheelrail/run/run_start.h>
#include <wheelrail/solid/point_state.h>
#include <wheelrail/statics/unloading.h>

#include "parallel.h"
#include "small_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  constexpr double yield_stress = 480e6, tangent = 21e9;

  double
  over_ranks(double value, const MPI_Op what)
  {
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, what, MPI_COMM_WORLD);
    return value;
  }

  /// Bodies that have rolled a little.
  struct Rolled
  {
    Model                 model;
    std::unique_ptr<Axle> axle;
  };

  Rolled
  roll(const bool yields, const double distance)
  {
    Scene scene = small_scene(4e-3);
    if (yields)
      for (MaterialData *material : {&scene.rail_material, &scene.wheel_material})
        {
          material->yield_stress    = yield_stress;
          material->tangent_modulus = tangent;
        }
    scene.rolling_distance = distance;
    Rolled         rolled{make_model(scene, make_geometry(scene), MPI_COMM_WORLD), nullptr};
    Model         &model = rolled.model;
    Log            log;
    const RunStart start = start_from_rest(scene, model, {}, log);
    rolled.axle = std::make_unique<Axle>(model.axle, start.hub_displacement, start.rate, MPI_COMM_WORLD);
    Rolling rolling(
      model.solid, *model.contact, model.parts, *rolled.axle, time_scheme(scene, model), MPI_COMM_WORLD);
    const long steps = std::lround(distance / scene.velocity / model.time_step);
    for (long n = 1; n <= steps; ++n)
      rolling.step(false);
    return rolled;
  }

  /// Largest von Mises stress [Pa].
  double
  largest_stress(const Solid &solid)
  {
    double largest = 0;
    for (const Body body : both_bodies)
      for (const auto &s : element_stress(solid.blocks[body], solid.displacement.data()))
        largest = std::max(largest, von_mises(s.data()));
    return over_ranks(largest, MPI_MAX);
  }

  void
  elastic_bodies()
  {
    Rolled       rolled = roll(false, 0.2e-3);
    Solid       &solid  = rolled.model.solid;
    const double loaded = largest_stress(solid);
    const auto   done   = unload(*rolled.model.discretization, solid, rolled.model.parts, *rolled.axle);
    BOOST_TEST((largest_stress(solid) == loaded), "the bodies are left as they were");
    const WhileUnloaded without(solid, done);
    BOOST_TEST(loaded > 300e6, "a loaded wheel");
    BOOST_TEST(
      near(largest_stress(solid) / loaded, 0, 1e-4, "elastic bodies: stress left over that of the load"));
    BOOST_TEST(done.steps <= 4, "elastic bodies: " + std::to_string(done.steps) + " Newton steps");
    double moved = 0;
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::rail)
        moved = std::max(moved, std::abs(solid.displacement[4 * n + 1]));
    BOOST_TEST(near(over_ranks(moved, MPI_MAX), 0, 1e-8, "the rail has its shape again [m]"));
  }

  /// Mean over the rail's volume of a stress component over that of its size [1]: zero for stresses in
  /// equilibrium with themselves, but for what the foot holds.
  double
  one_sidedness(const Solid &solid, const int component)
  {
    double      sum = 0, size = 0;
    const auto &blocks = solid.blocks[Body::rail];
    const auto  stress = element_stress(blocks, solid.displacement.data());
    for (std::size_t e = 0; e < blocks.n_elements; ++e)
      {
        sum += blocks.volume[e] * stress[e][component];
        size += blocks.volume[e] * std::abs(stress[e][component]);
      }
    return over_ranks(sum, MPI_SUM) / over_ranks(size, MPI_SUM);
  }

  double
  steel_that_flowed(Rolled &rolled)
  {
    Solid &solid = rolled.model.solid;
    BOOST_TEST(one_sidedness(solid, 1) < -0.5, "under the wheel the rail is pressed down");
    const WhileUnloaded without(
      solid, unload(*rolled.model.discretization, solid, rolled.model.parts, *rolled.axle));
    const double left = largest_stress(solid);
    BOOST_TEST(left > 0.05 * yield_stress, "stress is left: " + std::to_string(1e-6 * left) + " MPa");
    // hardened by the largest plastic strain
    double strain = 0;
    for (const Body body : both_bodies)
      for (const double value : element_plastic_strain(solid.blocks[body]))
        strain = std::max(strain, value);
    strain = over_ranks(strain, MPI_MAX);
    BOOST_TEST(left < yield_stress + 1.5 * tangent * strain, "no more than steel can bear");
    BOOST_TEST(near(one_sidedness(solid, 0), 0, 0.03, "stress xx over the rail, one-sided"));
    return left;
  }

  /// The loaded bodies with the wheel turned on about its axle and moved along the rail: that leaves the same
  /// stress, `left` [Pa].
  void
  turned_wheel(Rolled &rolled, const double left)
  {
    Solid         &solid = rolled.model.solid;
    const Vector3  now   = rolled.axle->centre();
    const Rotation turn(rolled.axle->axis(), 0.3);
    PartState      turned = rolled.axle->state();
    turned.numbers["angle"] += 0.3;
    turned.numbers["travelled"] += 0.1;
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::wheel)
        {
          const Vector3 x = now + Vector3{0, 0, 0.1} + turn(solid.position(n) - now);
          for (int i = 0; i < 3; ++i)
            solid.displacement[4 * n + i] = x[i] - solid.mesh.reference[4 * n + i];
        }
    rolled.axle->set_state(turned);
    const WhileUnloaded without(
      solid, unload(*rolled.model.discretization, solid, rolled.model.parts, *rolled.axle));
    BOOST_TEST(
      near(largest_stress(solid) / left, 1, 1e-4, "stress left in a wheel that has turned on by 0.3 rad"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(unloading, test::Parallel)
{
  elastic_bodies();
  Rolled       rolled = roll(true, 0.5e-3);
  const double left   = steel_that_flowed(rolled);
  turned_wheel(rolled, left);
}
