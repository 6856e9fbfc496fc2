#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <wheelrail/base/gather_all.h>
#include <wheelrail/mesh/discretization.h>
#include <wheelrail/statics/direct_coarse_solver.h>

#include <algorithm>
#include <cstdint>
#include <map>

// Exact coarse solver (doc/theory/rolling.md, Static start, 4): K^-1 of each body by its sweep; contact
// springs and what joins nodes of the rail are a correction of low rank in their directions (Woodbury).

namespace wheelrail
{
  DirectCoarseSolver::DirectCoarseSolver(const Discretization             &discretization,
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
    // 1. Each body on a rank of its own where there are two: both are solved at the same time
    rank_ = {0, 1 % n_ranks};
    // 2. Place of each node in the swept order of its body, gathered from all ranks
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
        // 3. The factors of K, once for a mesh
        if (rank == rank_[body])
          solver_[body] = make_swept_solver(discretization.grid(body),
                                            blocks[body].elasticity(),
                                            blocks[body].form,
                                            held_here[body],
                                            ground_here[body]);
      }
    // 4. What parts join, sleepers say, are directions of many nodes of the rail; their stiffness may be
    // negative, as what condensation takes off the diagonal springs
    for (std::size_t k = 0; k < ground.joined.size(); ++k)
      joined_.push_back({Body::rail, ground.joined.stiffness()[k], {}, {}});
    for (const StaticSprings::Part &part : ground.joined.parts())
      if (const Place place = place_[part.node]; place.body == Body::rail)
        for (int i = 0; i < 3; ++i)
          joined_[part.spring].weights.emplace_back(3 * std::size_t(place.slot) + i, part.weight[i]);
    for (Direction &direction : joined_)
      find_response(direction);
    set_springs({});
  }


  /// Component of a vector along it.
  double
  DirectCoarseSolver::Direction::operator*(const std::vector<double> &x) const
  {
    // T' x with the few weights of a direction
    double sum = 0;
    for (const auto &[row, weight] : weights)
      sum += weight * x[row];
    return sum;
  }


  void
  DirectCoarseSolver::find_response(Direction &direction)
  {
    if (!solver_[direction.body])
      return;
    direction.response.assign(x_[direction.body].size(), 0.);
    for (const auto &[row, weight] : direction.weights)
      direction.response[row] += weight;
    // K^-1 b
    solver_[direction.body]->solve(direction.response);
  }


  void
  DirectCoarseSolver::set_springs(const StaticSprings &springs)
  {
    const SpringBlocks blocks = spring_blocks(springs);
    // Columns of B': first the joined directions, then three for each node that a contact spring touches
    held_.clear();
    for (const Direction &direction : joined_)
      held_.push_back(&direction);
    std::map<std::uint32_t, std::size_t> first; // row of a node
    for (const auto &[pair, block] : blocks)
      if (first.emplace(pair.first, held_.size()).second)
        for (const Direction &direction : directions_of(pair.first))
          held_.push_back(&direction);
    const std::size_t n = held_.size();
    couple_.reinit(n, n);
    if (n == 0)
      return;
    // G [N/m] is diagonal for joined directions and has 3 x 3 blocks for pairs of nodes; S [m/N]
    dealii::FullMatrix<double> G(n, n), S(n, n, compliance().data()), GS(n, n);
    for (std::size_t k = 0; k < joined_.size(); ++k)
      G(k, k) = joined_[k].stiffness;
    for (const auto &[pair, block] : blocks)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          G(first.at(pair.first) + i, first.at(pair.second) + j) = block[3 * i + j];
    // (K + B'G B)^-1 = K^-1 - K^-1 B' (1 + G S)^-1 G B K^-1 with S = B K^-1 B' (Woodbury): G of contact
    // springs is singular, so that the form with G^-1 is not taken
    G.mmult(GS, S);
    for (std::size_t k = 0; k < n; ++k)
      GS(k, k) += 1;
    GS.gauss_jordan();
    GS.mmult(couple_, G);
  }


  /// Springs come and go, but stay near the contact: responses are kept.
  const std::array<DirectCoarseSolver::Direction, 3> &
  DirectCoarseSolver::directions_of(const std::uint32_t node)
  {
    // K^-1 of a unit force along each axis [m/N]: three solutions, once a node
    const auto [entry, fresh] = of_node_.try_emplace(node);
    const Place place         = place_[node];
    if (fresh)
      for (std::size_t i = 0; i < 3; ++i)
        {
          entry->second[i] = {place.body, 0, {{3 * std::size_t(place.slot) + i, 1.}}, {}};
          find_response(entry->second[i]);
        }
    return entry->second;
  }


  /// S, row-major: displacements along the directions under unit forces along them [m/N].
  std::vector<double>
  DirectCoarseSolver::compliance() const
  {
    const std::size_t   n = held_.size();
    std::vector<double> S(n * n, 0.);
    for (std::size_t column = 0; column < n; ++column)
      // the rank of a body has its columns; directions of different bodies are not coupled in K
      if (const Direction &force = *held_[column]; !force.response.empty())
        for (std::size_t row = 0; row < n; ++row)
          if (held_[row]->body == force.body)
            S[n * row + column] = *held_[row] * force.response;
    MPI_Allreduce(MPI_IN_PLACE, S.data(), static_cast<int>(S.size()), MPI_DOUBLE, MPI_SUM, communicator_);
    return S;
  }


  void
  DirectCoarseSolver::solve(const NodeVector &forces, NodeVector &z)
  {
    // 1. Forces of all coarse nodes on all ranks; 2. K^-1 of each body
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
    // 3. Springs (Woodbury)
    hold_back();
    for (const Body body : both_bodies)
      // 4. Each rank takes its own nodes
      MPI_Bcast(x_[body].data(), static_cast<int>(x_[body].size()), MPI_DOUBLE, rank_[body], communicator_);
    for (unsigned int n = 0; n < mesh_.n_owned; ++n)
      {
        const Place place = place_[mesh_.global_node[n]];
        std::copy_n(&x_[place.body][3 * std::size_t(place.slot)], 3, z.begin() + 4 * n);
      }
  }


  /// Takes off what the springs hold back.
  void
  DirectCoarseSolver::hold_back()
  {
    const std::size_t      n = held_.size();
    dealii::Vector<double> y(n), force(n);
    for (std::size_t k = 0; k < n; ++k)
      if (const Direction &direction = *held_[k]; solver_[direction.body])
        y[k] = direction * x_[direction.body];
    MPI_Allreduce(MPI_IN_PLACE, y.begin(), static_cast<int>(n), MPI_DOUBLE, MPI_SUM, communicator_);
    if (n > 0)
      // y = B x: what the springs would be stretched; forces = (1 + G S)^-1 G y, whose responses K^-1 B' are
      // taken off
      couple_.vmult(force, y);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t m = 0; m < held_[k]->response.size(); ++m)
        x_[held_[k]->body][m] -= force[k] * held_[k]->response[m];
  }
} // namespace wheelrail
