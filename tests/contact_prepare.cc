// A contact that goes on after its surfaces have moved along their lattices.

#include <wheelrail/model/model.h>

#include "parallel.h"
#include "small_scene.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  constexpr double along = 10e-3, step = 1e-7;

  /// Part of a surface: without so many stations and rows at its beginning and end.
  Surface
  cut(const Surface &whole, const int first, const int last, const int left, const int right)
  {
    Surface part               = whole;
    part.lattice.first_station = whole.lattice.first_station + first;
    part.lattice.n_along       = whole.lattice.n_along - first - last;
    part.lattice.s_begin       = whole.lattice.s_begin + left * whole.lattice.spacing_lateral;
    part.lattice.n_lateral     = whole.lattice.n_lateral - left - right;
    const auto keep            = [&](auto &values, const auto &all) {
      values.clear();
      for (unsigned int i = 0; i < part.lattice.n_along; ++i)
        for (unsigned int j = 0; j < part.lattice.n_lateral; ++j)
          values.push_back(all[whole.lattice.index(i + first, j + left)]);
    };
    keep(part.reference, whole.reference);
    keep(part.area, whole.area);
    keep(part.global_node, whole.global_node);
    keep(part.owner, whole.owner);
    keep(part.local, whole.local);
    return part;
  }

  /// The wheel lowered by 60 um at `along`, turned as far as it has rolled, sliding forwards and sideways.
  void
  place_wheel(Model &model)
  {
    const double  angle = along / model.geometry.rolling_radius;
    const Vector3 move  = {0, -60e-6, along};
    Solid        &solid = model.solid;
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::wheel)
        {
          const double *R = &solid.mesh.reference[4 * n];
          const Vector3 X = {R[0], R[1], R[2]}, x = model.axle.centre + move +
                                                    Rotation(model.axle.axis, angle)(X - model.axle.centre);
          for (int i = 0; i < 3; ++i)
            solid.displacement[4 * n + i] = x[i] - X[i];
          solid.velocity[4 * n]     = 0.1;
          solid.velocity[4 * n + 2] = 0.3;
        }
  }

  ContactSums
  next_step(Contact &contact, const Solid &solid)
  {
    contact.move_window(along, 0);
    contact.gather(solid.displacement.data(), solid.velocity.data());
    return contact.evaluate(step);
  }

  Vector3
  largest_history(const Contact &contact)
  {
    Vector3 largest{};
    for (const ContactNode &node : contact.nodes())
      for (int i = 0; i < 3; ++i)
        largest[i] = std::max(largest[i], std::abs(node.elastic[i]));
    return largest;
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(contact_prepare, test::Parallel)
{
  Scene scene            = small_scene(2e-3);
  scene.rolling_distance = 20e-3;
  Model         model    = make_model(scene, make_geometry(scene), MPI_COMM_WORLD);
  const Surface rail = model.contact->rail(), wheel = model.contact->wheel();
  Contact       contact(model.contact->surfaces(), model.contact->law(), 14e-3, MPI_COMM_WORLD);
  contact.prepare(rail, wheel);
  place_wheel(model);
  for (int n = 0; n < 20; ++n)
    next_step(contact, model.solid);
  BOOST_TEST(norm(largest_history(contact)) > 1e6, "a history of shear is there");

  // other stations and rows of rail and wheel
  Contact           moved     = contact;
  const Surface     rail_part = cut(rail, 2, 3, 1, 2), wheel_part = cut(wheel, 1, 2, 2, 1);
  const std::size_t n_numbers = model.solid.displacement.size();
  moved.prepare(rail_part, wheel_part);
  std::vector<double> force(n_numbers, 0.), force_moved(n_numbers, 0.);
  for (int n = 0; n < 3; ++n)
    {
      const ContactSums sums = next_step(contact, model.solid), sums_moved = next_step(moved, model.solid);
      BOOST_TEST(
        (sums.nodes > 10 && sums.nodes == sums_moved.nodes && !sums.at_border && !sums_moved.at_border),
        "the patch lies on stations that are stored before and after");
      BOOST_TEST(
        near(norm(sums_moved.force - sums.force), 0, 0, "the same forces on a part of the lattices"));
      BOOST_TEST(near(sums_moved.friction_power, sums.friction_power, 0, "the same friction"));
    }
  contact.add_forces(force.data());
  moved.add_forces(force_moved.data());
  BOOST_TEST((force == force_moved), "the same nodal forces");

  // back on the whole lattices
  moved.prepare(rail, wheel);
  const ContactSums sums = next_step(contact, model.solid), sums_moved = next_step(moved, model.solid);
  BOOST_TEST(near(norm(sums_moved.force - sums.force), 0, 0, "the same forces back on the whole lattices"));

  Contact fresh(contact.surfaces(), contact.law(), 14e-3, MPI_COMM_WORLD);
  fresh.prepare(rail_part, wheel_part);
  BOOST_TEST(std::abs(next_step(fresh, model.solid).force[2]) < 0.5 * std::abs(sums.force[2]),
             "without the history shear begins anew");

  // the same nodes, said to be of other lattices
  Surface other_rail = rail, other_wheel = wheel;
  other_rail.lattice.spacing_along *= 1.5;
  other_wheel.lattice.spacing_along *= 1.5;
  moved.prepare(other_rail, other_wheel);
  BOOST_TEST(near(norm(largest_history(moved)), 0, 0, "lattices of another spacing begin without a history"));
}
