// ranks: 1 2 3

// The swept meshes of wheel and rail: hanging nodes, rigid rotation of the whole wheel, the lattices of the
// running surfaces, equal sums on any number of ranks.

#include <wheelrail/model/model.h>

#include "parallel.h"
#include "scenes/p4est_mesh.h"
#include "small_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  const std::string body_name[2] = {"rail", "wheel"};

  /// The sums of this run against those of a mesh that one rank holds alone.
  void
  sums_do_not_depend_on_ranks(const Model &model)
  {
    const Model alone = test::small_model(MPI_COMM_SELF, 4e-3);
    BOOST_TEST((model.solid.quality.elements == alone.solid.quality.elements),
               "as many cells as on one rank");
    BOOST_TEST((model.solid.quality.nodes == alone.solid.quality.nodes), "as many nodes as on one rank");
    BOOST_TEST(near(model.solid.stable.step / alone.solid.stable.step, 1, 1e-12, "stable step of one rank"));
    for (const Body body : {Body::rail, Body::wheel})
      {
        const auto a = mass_properties(model.solid, body, model.axle.centre, MPI_COMM_WORLD);
        const auto b = mass_properties(alone.solid, body, model.axle.centre, MPI_COMM_SELF);
        const auto n = body_name[static_cast<int>(body)];
        BOOST_TEST(near(a.mass / b.mass, 1, 1e-13, n + ": mass of one rank"));
        BOOST_TEST(near(a.inertia / b.inertia, 1, 1e-13, n + ": inertia of one rank"));
        BOOST_TEST(near(norm(a.centre - b.centre), 0, 1e-13, n + ": centre of gravity of one rank"));
      }
    const Surface *surfaces[2][2] = {{&model.contact->rail(), &alone.contact->rail()},
                                     {&model.contact->wheel(), &alone.contact->wheel()}};
    double         difference     = 0;
    for (const auto &pair : surfaces)
      for (std::size_t k = 0; k < pair[0]->reference.size(); ++k)
        difference = std::max({difference,
                               norm(pair[0]->reference[k] - pair[1]->reference[k]),
                               std::abs(pair[0]->area[k] - pair[1]->area[k])});
    BOOST_TEST(
      near(difference, 0, 1e-14, "surface lattices of one rank: largest difference of places and areas"));
  }

  /// Nodes of a rank that lie on any boundary of the bodies, its parents of hanging nodes included.
  std::vector<bool>
  outer_nodes(const Model &model)
  {
    const Range       fine  = model.discretization->plan().fine;
    const MeshByKeys  whole = p4est_mesh(*model.discretization, {{fine}, {fine}}, MPI_COMM_WORLD);
    std::vector<bool> outer;
    for (const std::uint64_t key : model.solid.mesh.node_key)
      outer.push_back(whole.outer.count(key) > 0);
    return outer;
  }

  void
  hanging_nodes(Model &model)
  {
    Solid            &solid = model.solid;
    const LocalMesh  &mesh  = solid.mesh;
    double            error = 0, weight_error = 0;
    bool              parents_free = true;
    std::vector<bool> hangs(mesh.n_nodes());
    for (const unsigned int n : mesh.hanging)
      hangs[n] = true;
    double count[2] = {0, 0};
    for (std::size_t k = 0; k < mesh.hanging.size(); ++k)
      {
        Vector3 mean{};
        double  sum = 0;
        for (unsigned int p = mesh.hanging_begin[k]; p < mesh.hanging_begin[k + 1]; ++p)
          {
            const double *X = &mesh.reference[4 * mesh.parents[p]];
            add(mean, mesh.weights[p], {X[0], X[1], X[2]});
            sum += mesh.weights[p];
            parents_free = parents_free && !hangs[mesh.parents[p]];
          }
        const double *X = &mesh.reference[4 * mesh.hanging[k]];
        error           = std::max(error, norm(mean - Vector3{X[0], X[1], X[2]}));
        weight_error    = std::max(weight_error, std::abs(sum - 1));
        count[static_cast<int>(mesh.node_body[mesh.hanging[k]])] += 1;
      }
    MPI_Allreduce(MPI_IN_PLACE, count, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    BOOST_TEST((count[0] > 100 && count[1] > 100), "both bodies have hanging nodes");
    BOOST_TEST(parents_free, "no parent of a hanging node hangs");
    BOOST_TEST(near(weight_error, 0, 1e-14, "weights of the parents add up to 1"));
    BOOST_TEST(near(error, 0, 1e-15, "hanging nodes lie at the mean of their parents [m]"));

    // an equal strain everywhere must leave no force on inner nodes, across all jumps of cell size
    const double H[3][3] = {{1e-6, 2e-6, 0}, {-1e-6, 5e-7, 1e-6}, {3e-7, 0, 1e-6}};
    for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
      for (int i = 0; i < 3; ++i)
        {
          solid.displacement[4 * n + i] = 0;
          for (int j = 0; j < 3; ++j)
            solid.displacement[4 * n + i] += H[i][j] * mesh.reference[4 * n + j];
        }
    std::fill(solid.force.begin(), solid.force.end(), 0.);
    ElementEnergy energy;
    subtract_internal_force(
      solid.blocks, solid.displacement.data(), solid.force.data(), BulkViscosity(), false, energy);
    condense(mesh, solid.force.data());
    sum_over_ranks(mesh, solid.force.data());
    const auto outer    = outer_nodes(model);
    double     force[2] = {0, 0};
    for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
      for (int i = 0; i < 3; ++i)
        force[outer[n]] = std::max(force[outer[n]], std::abs(solid.force[4 * n + i]));
    MPI_Allreduce(MPI_IN_PLACE, force, 2, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    BOOST_TEST(
      near(force[0] / force[1], 0, 1e-9, "equal strain: force on inner nodes over that on the surface"));
  }

  /// The arc coordinate jumps opposite to the contact: cells there lie far from the fine ones all the same.
  void
  coarse_above_the_axle(const Model &model)
  {
    const LocalMesh &mesh     = model.solid.mesh;
    int              count[2] = {0, 0}; // all, divided
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      {
        bool above = mesh.cell_body[c] == Body::wheel;
        for (const unsigned int n : mesh.cells[c])
          above = above && mesh.reference[4 * n + 1] > model.axle.centre[1];
        count[0] += above;
        count[1] += above && mesh.cell_level[c] > 0;
      }
    MPI_Allreduce(MPI_IN_PLACE, count, 2, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    BOOST_TEST((count[0] > 1000 && count[1] == 0),
               "no cell of the wheel above its axle is divided, " + std::to_string(count[1]) + " of " +
                 std::to_string(count[0]));
  }

  void
  rigid_rotation(Model &model)
  {
    Solid           &solid = model.solid;
    const LocalMesh &mesh  = solid.mesh;
    const double     angle = 10 * 2 * M_PI + 1;
    for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
      {
        const double *R = &mesh.reference[4 * n];
        const Vector3 X = {R[0], R[1], R[2]};
        const Vector3 x = mesh.node_body[n] == Body::rail
                            ? X
                            : model.axle.centre + Rotation(model.axle.axis, angle)(X - model.axle.centre);
        for (int i = 0; i < 3; ++i)
          solid.displacement[4 * n + i] = x[i] - X[i] + (i == 2 ? 29. : 0.);
      }
    double worst[2] = {0, 0};
    for (const Body body : both_bodies)
      for (const auto &s : element_stress(solid.blocks[body], solid.displacement.data()))
        for (const double x : s)
          worst[0] = std::max(worst[0], std::abs(x));
    std::fill(solid.force.begin(), solid.force.end(), 0.);
    ElementEnergy energy;
    subtract_internal_force(
      solid.blocks, solid.displacement.data(), solid.force.data(), BulkViscosity(), true, energy);
    condense(mesh, solid.force.data());
    for (const double f : solid.force)
      worst[1] = std::max(worst[1], std::abs(f));
    MPI_Allreduce(MPI_IN_PLACE, worst, 2, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    BOOST_TEST(near(worst[0], 0, 5, "ten turns of the wheel and 29 m of way: largest stress [Pa]"));
    BOOST_TEST(near(worst[1], 0, 1e-3, "ten turns of the wheel and 29 m of way: largest nodal force [N]"));
    std::fill(solid.displacement.begin(), solid.displacement.end(), 0.);
  }

  /// Offsets between nodes of the lattice against the sagitta of the chords.
  struct Sagitta
  {
    double nodes = 0, least = 1, error = 0; ///< largest at nodes [m], least between [m], relative to h^2/8R
    int    compared = 0;
  };

  Sagitta
  sagitta(const Model &model, const Surface &surface)
  {
    const Lattice         &lattice  = model.contact->lattice();
    const RunningSurfaces &surfaces = model.contact->surfaces();
    const bool             wheel    = surface.body == Body::wheel;
    const auto             offset   = [&](const Vector3 &X) {
      return wheel ? surfaces.wheel.offset(X) : surfaces.rail.offset(X);
    };
    const auto middle = [&](std::size_t a, std::size_t b) {
      return 0.5 * (surface.reference[a] + surface.reference[b]);
    };
    const auto chord = [&](std::size_t a, std::size_t b) {
      return norm(surface.reference[a] - surface.reference[b]);
    };
    Sagitta result;
    // the outer lines hang on coarser cells
    for (unsigned int i = 2; i + 3 < lattice.n_along; ++i)
      for (unsigned int j = 1; j + 2 < lattice.n_lateral; ++j)
        {
          const std::size_t k = lattice.index(i, j), ahead = lattice.index(i + 1, j),
                            beside = lattice.index(i, j + 1);
          result.nodes             = std::max(result.nodes, std::abs(offset(surface.reference[k])));
          if (wheel)
            {
              const double s     = lattice.s_begin + j * lattice.spacing_lateral;
              const double slope = surfaces.outline.at(s).slope, angle = surfaces.frame.angle;
              const double radial   = std::cos(std::atan(slope) + angle - surfaces.pose().section.angle);
              const double expected = std::pow(chord(k, ahead), 2) / (8 * surfaces.local_radius(s)) * radial;
              const double found    = offset(middle(k, ahead));
              result.least          = std::min(result.least, found);
              result.error          = std::max(result.error, std::abs(found / expected - 1));
              ++result.compared;
              continue;
            }
          // the rail's curvature, where it does not change between the two nodes
          const double s = lattice.s_begin + j * lattice.spacing_lateral, h = lattice.spacing_lateral;
          const auto   kappa = [&](double x) {
            const double d = 1e-5, slope = surfaces.rail.smooth(x).slope;
            return (surfaces.rail.smooth(x - d).slope - surfaces.rail.smooth(x + d).slope) / (2 * d) /
                   std::pow(1 + slope * slope, 1.5);
          };
          const double R0 = kappa(s + 0.01 * h), R1 = kappa(s + 0.5 * h), R2 = kappa(s + 0.99 * h);
          const double found = offset(middle(k, beside));
          result.least       = std::min(result.least, found);
          if (std::abs(R0 / R1 - 1) > 1e-3 || std::abs(R2 / R1 - 1) > 1e-3)
            continue;
          result.error =
            std::max(result.error, std::abs(found / (std::pow(chord(k, beside), 2) * R1 / 8) - 1));
          ++result.compared;
        }
    return result;
  }

  void
  running_lattices(const Model &model)
  {
    for (const Surface *surface : {&model.contact->rail(), &model.contact->wheel()})
      {
        const std::string &n = body_name[static_cast<int>(surface->body)];
        const Sagitta      s = sagitta(model, *surface);
        BOOST_TEST(near(s.nodes, 0, 1e-9, n + ": offset of the true profile at nodes [m]"));
        BOOST_TEST(s.least > 0,
                   n + ": offset between nodes is positive, least " + std::to_string(1e6 * s.least) + " um");
        BOOST_TEST(near(s.error,
                        0,
                        0.03,
                        n + ": offset between nodes over h^2/8R, " + std::to_string(s.compared) + " chords"));
      }
    const double step = 2 * M_PI * model.geometry.rolling_radius / model.discretization->plan().sectors / 4;
    BOOST_TEST(near(model.contact->lattice().spacing_along, step, 1e-12, "stations at the wheel's arc [m]"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(forest, test::Parallel)
{
  Model model = test::small_model(MPI_COMM_WORLD, 4e-3);
  sums_do_not_depend_on_ranks(model);
  running_lattices(model);
  coarse_above_the_axle(model);
  hanging_nodes(model);
  rigid_rotation(model);
}
