#include <deal.II/lac/full_matrix.h>

#include <wheelrail/base/gather_all.h>
#include <wheelrail/mesh/discretization.h>
#include <wheelrail/statics/direct_bottom.h>
#include <wheelrail/statics/joined_solver.h>

#include <algorithm>
#include <cstdint>
#include <set>

namespace wheelrail
{
  DirectBottom::DirectBottom(const Discretization             &discretization,
                             const LocalMesh                  &mesh,
                             const PerBody<ElementBlocks>     &blocks,
                             const std::vector<unsigned char> &held,
                             const StaticGround               &ground)
    : mesh_(mesh)
    , communicator_(discretization.communicator())
  {
    int rank, n_ranks;
    MPI_Comm_rank(communicator_, &rank);
    MPI_Comm_size(communicator_, &n_ranks);
    rank_ = {0, 1 % n_ranks};
    struct Known
    {
      Place         place;
      unsigned char held;
      Vector3       ground;
    };
    std::vector<Known> known;
    for (unsigned int n = 0; n < mesh.n_owned; ++n)
      {
        const Body          body    = mesh.node_body[n];
        const SweptGrid    &grid    = discretization.grid(body);
        const std::uint64_t key     = mesh.node_key[n];
        const double       *spring  = ground.springs.empty() ? nullptr : &ground.springs[4 * n];
        const Vector3       springs = spring ? Vector3{spring[0], spring[1], spring[2]} : Vector3{};
        known.push_back(
          {{body, grid.n_corners() * grid.section_of_key(key) + grid.corner_of_key(key)}, held[n], springs});
      }
    PerBody<std::vector<unsigned char>> held_here;
    PerBody<std::vector<Vector3>>       ground_here;
    for (const Body body : both_bodies)
      {
        held_here[body].resize(std::size_t(discretization.grid(body).n_corners()) *
                               discretization.grid(body).n_sections());
        ground_here[body].resize(held_here[body].size());
      }
    // global numbers ascend with the ranks, and those of a rank's own nodes follow one another
    for (const Known &node : gather_all(known, communicator_))
      {
        place_.push_back(node.place);
        held_here[node.place.body].at(node.place.slot)   = node.held;
        ground_here[node.place.body].at(node.place.slot) = node.ground;
      }
    for (const Body body : both_bodies)
      {
        x_[body].resize(3 * held_here[body].size());
        if (rank == rank_[body])
          solver_[body] = make_swept_solver(discretization.grid(body),
                                            blocks[body].elasticity(),
                                            blocks[body].form,
                                            held_here[body],
                                            ground_here[body]);
      }
    join(ground.joined);
  }


  /// What joins nodes of the rail becomes part of its solver.
  void
  DirectBottom::join(const StaticSprings &joined)
  {
    std::unique_ptr<SweptSolver> &rail = solver_[Body::rail];
    if (!rail || joined.size() == 0)
      return;
    std::vector<JoinedRows> terms(joined.size());
    for (std::size_t k = 0; k < terms.size(); ++k)
      terms[k].stiffness = joined.stiffness()[k];
    for (const StaticSprings::Part &part : joined.parts())
      if (const Place place = place_[part.node]; place.body == Body::rail)
        for (int i = 0; i < 3; ++i)
          terms[part.spring].weights.emplace_back(3 * std::size_t(place.slot) + i, part.weight[i]);
    rail = std::make_unique<JoinedSolver>(std::move(rail), std::move(terms), x_[Body::rail].size());
  }


  void
  DirectBottom::set_springs(const StaticSprings &springs)
  {
    const SpringBlocks      blocks = spring_blocks(springs);
    std::set<std::uint32_t> touched;
    for (const auto &[pair, block] : blocks)
      touched.insert(pair.first);
    touched_.assign(touched.begin(), touched.end());
    const std::size_t n = 3 * touched_.size();
    couple_.clear();
    if (n == 0)
      return;
    find_responses();
    dealii::FullMatrix<double> G(n, n), S(n, n, compliance().data()), GS(n, n);
    const auto                 row = [&](const std::uint32_t node) {
      return 3 * (std::lower_bound(touched_.begin(), touched_.end(), node) - touched_.begin());
    };
    for (const auto &[pair, block] : blocks)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          G(row(pair.first) + i, row(pair.second) + j) = block[3 * i + j];
    G.mmult(GS, S);
    for (std::size_t k = 0; k < n; ++k)
      GS(k, k) += 1;
    GS.gauss_jordan();
    GS.mmult(S, G);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        couple_.push_back(S(i, j));
  }


  /// Of nodes that have none yet: springs come and go, but stay near the contact.
  void
  DirectBottom::find_responses()
  {
    for (const std::uint32_t node : touched_)
      if (const Place place = place_[node]; solver_[place.body] && responses_.count(node) == 0)
        for (int i = 0; i < 3; ++i)
          {
            std::vector<double> &x = responses_[node][i];
            x.assign(x_[place.body].size(), 0.);
            x[3 * std::size_t(place.slot) + i] = 1;
            solver_[place.body]->solve(x);
          }
  }


  /// S, row-major: displacements of the touched nodes under unit forces at them [m/N].
  std::vector<double>
  DirectBottom::compliance() const
  {
    const std::size_t   n = 3 * touched_.size();
    std::vector<double> S(n * n, 0.);
    for (std::size_t column = 0; column < n; ++column)
      if (const auto known = responses_.find(touched_[column / 3]); known != responses_.end())
        for (std::size_t row = 0; row < n; ++row)
          {
            const Place at = place_[touched_[row / 3]];
            if (at.body == place_[touched_[column / 3]].body)
              S[n * row + column] = known->second[column % 3][3 * std::size_t(at.slot) + row % 3];
          }
    MPI_Allreduce(MPI_IN_PLACE, S.data(), static_cast<int>(S.size()), MPI_DOUBLE, MPI_SUM, communicator_);
    return S;
  }


  void
  DirectBottom::solve(const NodeVector &forces, NodeVector &z)
  {
    std::vector<double> own;
    own.reserve(3 * mesh_.n_owned);
    for (std::size_t n = 0; n < mesh_.n_owned; ++n)
      own.insert(own.end(), forces.begin() + 4 * n, forces.begin() + 4 * n + 3);
    const std::vector<double> all = gather_all(own, communicator_);
    for (std::size_t node = 0; node < place_.size(); ++node)
      std::copy_n(&all[3 * node], 3, &x_[place_[node].body][3 * std::size_t(place_[node].slot)]);
    for (const Body body : both_bodies)
      if (solver_[body])
        solver_[body]->solve(x_[body]);
    hold_back();
    for (const Body body : both_bodies)
      MPI_Bcast(x_[body].data(), static_cast<int>(x_[body].size()), MPI_DOUBLE, rank_[body], communicator_);
    for (unsigned int n = 0; n < mesh_.n_owned; ++n)
      {
        const Place place = place_[mesh_.global_node[n]];
        std::copy_n(&x_[place.body][3 * std::size_t(place.slot)], 3, z.begin() + 4 * n);
      }
  }


  /// Takes off what the springs hold back.
  void
  DirectBottom::hold_back()
  {
    const std::size_t   n = 3 * touched_.size();
    std::vector<double> y(n, 0.);
    for (std::size_t k = 0; k < n; ++k)
      if (const Place place = place_[touched_[k / 3]]; solver_[place.body])
        y[k] = x_[place.body][3 * std::size_t(place.slot) + k % 3];
    MPI_Allreduce(MPI_IN_PLACE, y.data(), static_cast<int>(n), MPI_DOUBLE, MPI_SUM, communicator_);
    for (std::size_t k = 0; k < n; ++k)
      if (const Place place = place_[touched_[k / 3]]; solver_[place.body])
        {
          double force = 0;
          for (std::size_t j = 0; j < n; ++j)
            force += couple_[n * k + j] * y[j];
          const std::vector<double> &response = responses_.at(touched_[k / 3])[k % 3];
          std::vector<double>       &x        = x_[place.body];
          for (std::size_t m = 0; m < x.size(); ++m)
            x[m] -= force * response[m];
        }
  }
} // namespace wheelrail
