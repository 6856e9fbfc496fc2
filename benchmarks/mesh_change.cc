// What a change of the mesh costs, by parts: the cells by the closed form of CellTree, and by p4est's
// recursion from the roots with the same rule; then topology, solid and contact, which both need.
//
//   benchmark_mesh_change FILE.prm ["Section/Entry = value" ...]
//
// With mpirun on several ranks, too. p4est has all trees on each rank, or shares them among the ranks; its
// cells are counted against those of CellTree with balance and without.

#include <deal.II/base/mpi.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/mesh/coarse_levels.h>
#include <wheelrail/model/model.h>

#include <p8est.h>
#include <p8est_bits.h>
#include <p8est_extended.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

using namespace wheelrail;

namespace
{
  /// The median time of five calls [ms], the slowest rank.
  double
  milliseconds(const std::function<void()> &call, MPI_Comm communicator)
  {
    std::vector<double> times;
    for (int n = 0; n < 5; ++n)
      {
        MPI_Barrier(communicator);
        const auto begin = std::chrono::steady_clock::now();
        call();
        double taken = 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        MPI_Allreduce(MPI_IN_PLACE, &taken, 1, MPI_DOUBLE, MPI_MAX, communicator);
        times.push_back(taken);
      }
    std::sort(times.begin(), times.end());
    return times[2];
  }

  struct DestroyForest
  {
    void
    operator()(p8est_t *forest) const
    {
      p8est_destroy(forest);
    }
  };
  using Forest8 = std::unique_ptr<p8est_t, DestroyForest>;

  struct Trees
  {
    PerBody<SweptGrid>    grids;
    RefinementRule        rule;
    int                   first_wheel;
    p8est_connectivity_t *connectivity;

    CellPlace
    place(const p4est_topidx_t tree, const p8est_quadrant_t &q) const
    {
      CellPlace cell;
      cell.body              = tree < first_wheel ? Body::rail : Body::wheel;
      const SweptGrid &grid  = grids[cell.body];
      const int        n     = tree - (tree < first_wheel ? 0 : first_wheel);
      const int        shift = P8EST_MAXLEVEL - q.level;
      cell.level             = q.level;
      cell.block             = n % grid.n_blocks();
      cell.i                 = q.x >> shift;
      cell.j                 = q.y >> shift;
      cell.k                 = ((n / grid.n_blocks()) << q.level) + (q.z >> shift);
      return cell;
    }
  };

  p8est_connectivity_t *
  make_connectivity(const PerBody<SweptGrid> &grids)
  {
    const int n_rail_vertices = grids.rail.n_corners() * grids.rail.n_sections();
    const int n_vertices      = n_rail_vertices + grids.wheel.n_corners() * grids.wheel.n_sections();
    const int n_trees =
      grids.rail.n_blocks() * grids.rail.n_columns() + grids.wheel.n_blocks() * grids.wheel.n_columns();
    p8est_connectivity_t *c = p8est_connectivity_new(n_vertices, n_trees, 0, 0, 0, 0);
    p4est_topidx_t        t = 0;
    for (const Body body : both_bodies)
      for (int k = 0; k < grids[body].n_columns(); ++k)
        for (int b = 0; b < grids[body].n_blocks(); ++b, ++t)
          {
            for (int v = 0; v < 8; ++v)
              c->tree_to_vertex[8 * t + v] =
                (body == Body::rail ? 0 : n_rail_vertices) +
                (k + v / 4) % grids[body].n_sections() * grids[body].n_corners() +
                grids[body].corners(b)[v % 4];
            for (int f = 0; f < 6; ++f)
              {
                c->tree_to_tree[6 * t + f] = t;
                c->tree_to_face[6 * t + f] = f;
              }
          }
    for (int v = 0; v < 3 * n_vertices; ++v)
      c->vertices[v] = v; // places are not used
    p8est_connectivity_complete(c);
    return c;
  }

  int
  refine(p8est_t *forest, const p4est_topidx_t tree, p8est_quadrant_t *q)
  {
    const auto *trees = static_cast<const Trees *>(forest->user_pointer);
    return trees->rule.wanted(trees->place(tree, *q));
  }

  void
  run(const Scene &scene, MPI_Comm communicator)
  {
    int rank, size;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &size);
    const auto tell = [&](const std::string &what, const std::function<long()> &cells) {
      long         n  = 0;
      const double ms = milliseconds([&]() { n = cells(); }, communicator);
      if (rank == 0)
        std::printf("%-60s %8.1f ms %8ld\n", what.c_str(), ms, n);
    };
    const SceneGeometry      geometry = make_geometry(scene);
    const SweepPlan          plan     = sweep_plan(scene, geometry);
    const PerBody<FineZone>  zones{{plan.fine}, {plan.fine}};
    const PerBody<SweptGrid> grids{SweptGrid(plan, Body::rail), SweptGrid(plan, Body::wheel)};
    if (rank == 0)
      std::printf("ranks %d; main parts: time, cells\n", size);
    tell("closed form: cells", [&]() { return CellTree(plan, grids, zones).leaves({0, 0}).size(); });

    const RefinementRule rule(plan, grids, zones);
    Trees                trees{grids, rule, grids.rail.n_blocks() * grids.rail.n_columns(), nullptr};
    tell("p4est: connectivity, once", [&]() {
      if (trees.connectivity != nullptr)
        p8est_connectivity_destroy(trees.connectivity);
      trees.connectivity = make_connectivity(grids);
      return trees.connectivity->num_trees;
    });
    for (const bool shared : {false, true})
      {
        const MPI_Comm    on   = shared ? communicator : MPI_COMM_SELF;
        const std::string name = shared ? "p4est, shared among the ranks: " : "p4est, whole on each rank: ";
        Forest8           roots, fine, even;
        tell(name + "roots", [&]() {
          roots.reset(p8est_new_ext(on, trees.connectivity, 0, 0, 1, 0, nullptr, &trees));
          return roots->global_num_quadrants;
        });
        tell(name + "copy, refine", [&]() {
          fine.reset(p8est_copy(roots.get(), 0));
          p8est_refine_ext(fine.get(), 1, plan.levels, refine, nullptr, nullptr);
          return fine->global_num_quadrants;
        });
        tell(name + "is it balanced", [&]() { return p8est_is_balanced(fine.get(), P8EST_CONNECT_FULL); });
        tell(name + "copy, balance", [&]() {
          even.reset(p8est_copy(fine.get(), 0));
          p8est_balance(even.get(), P8EST_CONNECT_FULL, nullptr);
          return even->global_num_quadrants;
        });
      }
    p8est_connectivity_destroy(trees.connectivity);

    tell("cells, nodes, hanging nodes, local mesh", [&]() {
      Forest forest(communicator, plan);
      return forest.local_mesh().cells.size();
    });
    Model model = make_model(scene, geometry, communicator);
    tell("the same, solid, contact", [&]() {
      prepare_mesh(model, communicator);
      return model.solid.quality.elements;
    });
    tell("coarse levels of static solutions",
         [&]() { return coarse_levels(*model.forest, model.solid.mesh).size(); });
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc < 2)
    {
      std::cerr << "usage: benchmark_mesh_change FILE.prm [\"Section/Entry = value\" ...]\n";
      return 1;
    }
  try
    {
      run(read_scene(argv[1], std::vector<std::string>(argv + 2, argv + argc)).scene, MPI_COMM_WORLD);
    }
  catch (const InputError &error)
    {
      std::cerr << error.what() << "\n";
      return 1;
    }
  return 0;
}
