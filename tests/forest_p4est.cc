// ranks: 1 2 3 4

// The mesh of the program against that which p4est and deal.II make from the same rule of refinement: cells,
// nodes, hanging nodes with their parents and weights; at the start, farther on, and with columns that stay
// fine.

#include <wheelrail/model/model.h>

#include "parallel.h"
#include "scenes/p4est_mesh.h"
#include "small_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  std::string
  count(const std::set<std::uint64_t> &ours, const std::set<std::uint64_t> &theirs)
  {
    return std::to_string(ours.size()) + " and " + std::to_string(theirs.size());
  }

  void
  judge(Discretization &discretization, const PerBody<FineZone> &zones, const std::string &where)
  {
    discretization.lay(zones);
    const MeshByKeys ours   = program_mesh(discretization.local_mesh(), MPI_COMM_WORLD);
    const MeshByKeys theirs = p4est_mesh(discretization, zones, MPI_COMM_WORLD);
    BOOST_TEST((ours.cells == theirs.cells), where + ": cells, " + count(ours.cells, theirs.cells));
    BOOST_TEST((ours.nodes == theirs.nodes), where + ": nodes, " + count(ours.nodes, theirs.nodes));
    bool   same_parents = ours.hanging.size() == theirs.hanging.size();
    double error        = 0;
    for (const auto &[node, parents] : theirs.hanging)
      if (const auto found = ours.hanging.find(node);
          found == ours.hanging.end() || found->second.size() != parents.size())
        same_parents = false;
      else
        for (std::size_t p = 0; p < parents.size(); ++p)
          {
            same_parents = same_parents && found->second[p].first == parents[p].first;
            error        = std::max(error, std::abs(found->second[p].second - parents[p].second));
          }
    BOOST_TEST(same_parents,
               where + ": " + std::to_string(theirs.hanging.size()) + " hanging nodes and their parents");
    BOOST_TEST(near(error, 0, 1e-14, where + ": weights of the parents"));
  }

  void
  judge_scene(const Scene &scene, const std::string &name)
  {
    Discretization discretization(MPI_COMM_WORLD, sweep_plan(scene, make_geometry(scene)));
    const Range    fine  = discretization.plan().fine;
    const double   block = discretization.plan().block_length();
    judge(discretization, {{fine}, {fine}}, name + ", start");
    judge(discretization,
          {{Range{fine.s0 + block, fine.s1 + block}, Range{-block, 0}},
           {Range{fine.s0 + 2 * block, fine.s1 + 2 * block}}},
          name + ", farther on");
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(forest_p4est, test::Parallel)
{
  judge_scene(test::small_scene(4e-3), "4 mm");
  Scene flange         = test::small_scene(2e-3);
  flange.lateral_shift = -5.5e-3; // thin blocks stay whole beside the strip, and neighbours divide others
  judge_scene(flange, "flange root, 2 mm");
}
