#include <wheelrail/base/gather_all.h>
#include <wheelrail/mesh/cell_place.h>
#include <wheelrail/mesh/fetch_rows.h>
#include <wheelrail/solid/law_scope.h>
#include <wheelrail/solid/momentum.h>
#include <wheelrail/solid/transfer.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

// Displacements, velocities and histories of one mesh on another, rank to rank (doc/theory/mesh.md,
// Transfer): u_new = u_old + (F - I) dX, v_new = v_old + dF/dt dX, with the nodal F of the old mesh.

namespace wheelrail
{
  namespace
  {
    constexpr std::size_t n_keys = 9;
    using CellKeys               = std::array<std::uint64_t, n_keys>; ///< of the nodes, and of the cell

    Vector3
    times(const std::array<double, 9> &H, const Vector3 &x)
    {
      Vector3 y;
      for (int i = 0; i < 3; ++i)
        y[i] = H[3 * i] * x[0] + H[3 * i + 1] * x[1] + H[3 * i + 2] * x[2];
      return y;
    }

    void
    put(AlignedVector<double> &values, const std::size_t node, const Vector3 &v)
    {
      std::copy(v.begin(), v.end(), &values[4 * node]);
    }

    void
    make_unique(std::vector<std::uint64_t> &keys)
    {
      std::sort(keys.begin(), keys.end());
      keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    }

    std::vector<char>
    hanging_marks(const LocalMesh &mesh)
    {
      std::vector<char> hanging(mesh.n_nodes(), 0);
      for (const unsigned int n : mesh.hanging)
        hanging[n] = 1;
      return hanging;
    }
  } // namespace


  SolidTransfer::SolidTransfer(Solid before, const double middle, MPI_Comm communicator)
    : before_(std::move(before))
    , middle_(middle)
    , communicator_(communicator)
  {
    distribute(before_.mesh, before_.displacement.data());
    distribute(before_.mesh, before_.velocity.data());
    // nodal H = F - 1 and dH/dt, volume-weighted means of the cells around (doc/theory/mesh.md, Transfer)
    gradient_u_ = nodal_gradient(before_, before_.displacement.data());
    gradient_v_ = nodal_gradient(before_, before_.velocity.data());
  }


  /// What old cells in the blocks of this rank's new ones have, and then what their nodes and the new ones
  /// do.
  void
  SolidTransfer::fetch(const Solid &after)
  {
    // 1. Which blocks this rank's new cells lie in: all old cells of these are fetched, whatever rank has
    // them
    const auto block_of = [](const std::uint64_t cell) { return CellPlace::of_key(cell).ancestor(0).key(); };
    std::vector<std::uint64_t> wanted, blocks;
    for (const std::uint64_t cell : after.mesh.cell_key)
      wanted.push_back(block_of(cell));
    make_unique(wanted);
    // of each cell: its key and those of its nodes, as they stand in memory, and its histories
    const auto histories = cell_histories(before_);
    width_               = n_keys;
    for (const auto &[name, history] : histories)
      {
        columns_[name] = {width_, history.components};
        width_ += history.components;
      }
    // 2. A row for each old cell of the rank: nine keys, then its histories
    const LocalMesh    &mesh = before_.mesh;
    std::vector<double> own(width_ * mesh.cells.size());
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      {
        blocks.push_back(block_of(mesh.cell_key[c]));
        CellKeys keys;
        keys[8] = mesh.cell_key[c];
        for (unsigned int v = 0; v < 8; ++v)
          keys[v] = mesh.node_key[mesh.cells[c][v]];
        std::memcpy(&own[width_ * c], keys.data(), sizeof keys);
        for (const auto &[name, history] : histories)
          std::copy_n(&history.values[history.components * c],
                      history.components,
                      &own[width_ * c + columns_.at(name).first]);
      }
    cells_ = fetch_rows(blocks, own, wanted, communicator_);
    // 3. State of the nodes of these cells, and of nodes that old and new mesh share
    std::vector<std::uint64_t> nodes = after.mesh.node_key;
    std::vector<CellKeys>      cells(cells_.size() / width_);
    for (std::size_t c = 0; c < cells.size(); ++c)
      {
        std::memcpy(cells[c].data(), &cells_[width_ * c], sizeof cells[c]);
        nodes.insert(nodes.end(), cells[c].begin(), cells[c].end() - 1);
      }
    make_unique(nodes);
    fetch_nodes(nodes);
    cell_.reserve(2 * cells.size());
    for (const CellKeys &cell : cells)
      {
        cell_[cell[8]] = corners_.size();
        auto &corners  = corners_.emplace_back();
        for (unsigned int v = 0; v < 8; ++v)
          corners[v] = static_cast<std::uint32_t>(node_.at(cell[v]));
      }
  }


  void
  SolidTransfer::fetch_nodes(const std::vector<std::uint64_t> &wanted)
  {
    const LocalMesh           &mesh = before_.mesh;
    std::vector<std::uint64_t> own_keys;
    std::vector<KeyedValue>    own;
    for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
      if (mesh.owns(n))
        {
          own_keys.push_back(mesh.node_key[n]);
          KeyedValue &keyed = own.emplace_back();
          keyed.key         = mesh.node_key[n];
          Value &value      = keyed.value;
          value.X           = mesh.place(n);
          value.u           = vector_at(before_.displacement, n);
          value.v           = vector_at(before_.velocity, n);
          std::copy_n(&gradient_u_[9 * n], 9, value.H.begin());
          std::copy_n(&gradient_v_[9 * n], 9, value.D.begin());
        }
    const auto rows = fetch_rows(own_keys, own, wanted, communicator_);
    node_.reserve(2 * rows.size());
    values_.reserve(rows.size());
    for (const KeyedValue &row : rows)
      {
        node_[row.key] = values_.size();
        values_.push_back(row.value);
      }
  }


  /// State of the old mesh at a vertex of a new cell; without a cell (of another rank), only a node that the
  /// old mesh has too can be found.
  bool
  SolidTransfer::find(const Solid       &after,
                      const std::size_t  node,
                      const std::size_t  cell,
                      const unsigned int vertex,
                      Value             &value) const
  {
    if (const auto same = node_.find(after.mesh.node_key[node]); same != node_.end())
      {
        value = values_[same->second];
        return true;
      }
    if (cell >= after.mesh.cells.size())
      return false;
    // The new cell is a part of an old one, or it has replaced its parts; in the latter case its vertices are
    // old ones, and were found above
    const CellPlace place = CellPlace::of_key(after.mesh.cell_key[cell]);
    for (int level = place.level; level >= 0; --level)
      {
        const CellPlace whole = place.ancestor(static_cast<unsigned char>(level));
        const auto      found = cell_.find(whole.key());
        if (found == cell_.end())
          continue;
        const int d = place.level - level;
        // natural coordinates, 0 to 1, of the vertex in the cell `level` that it is a part of
        const double x[3] = {std::ldexp(place.i - (whole.i << d) + int(vertex & 1), -d),
                             std::ldexp(place.j - (whole.j << d) + int(vertex >> 1 & 1), -d),
                             std::ldexp(place.k - (whole.k << d) + int(vertex >> 2), -d)};
        value             = Value();
        for (unsigned int a = 0; a < 8; ++a)
          {
            // trilinear shape function of corner a
            const double weight =
              (a & 1 ? x[0] : 1 - x[0]) * (a >> 1 & 1 ? x[1] : 1 - x[1]) * (a >> 2 ? x[2] : 1 - x[2]);
            const Value &corner = values_[corners_[found->second][a]];
            add(value.X, weight, corner.X);
            add(value.u, weight, corner.u);
            add(value.v, weight, corner.v);
            for (int i = 0; i < 9; ++i)
              {
                value.H[i] += weight * corner.H[i];
                value.D[i] += weight * corner.D[i];
              }
          }
        return true;
      }
    throw std::logic_error("a vertex of the new mesh lies in no cell of the old one");
  }


  void
  SolidTransfer::fill_nodes(Solid &after) const
  {
    const LocalMesh &mesh = after.mesh;
    // hanging nodes are set last, from their parents: the old field has no say there
    const std::vector<char>    hanging = hanging_marks(mesh);
    constexpr std::uint32_t    none    = ~0u;
    std::vector<std::uint32_t> corner(mesh.n_nodes(), none); ///< 8 cell + vertex of a cell that has the node
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      for (unsigned int a = 0; a < 8; ++a)
        if (corner[mesh.cells[c][a]] == none)
          corner[mesh.cells[c][a]] = static_cast<std::uint32_t>(8 * c + a);
    // ranks that find a node in cells of their own may differ by round-off: all take the mean
    AlignedVector<double> found(4 * mesh.n_nodes(), 0.);
    after.displacement.assign(4 * mesh.n_nodes(), 0.);
    after.velocity.assign(4 * mesh.n_nodes(), 0.);
    for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
      {
        Value value;
        if (hanging[n] ||
            !find(after, n, corner[n] == none ? mesh.cells.size() : corner[n] / 8, corner[n] % 8, value))
          continue;
        const Vector3 off = mesh.place(n) - value.X;
        if (off != Vector3{0, 0, 0})
          {
            // u_new = u_old + (F - I) dX, v_new = v_old + dF/dt dX, dX = X_new - X_old: surfaces are curved,
            // and a new vertex lies beside the old cell; linear fields pass exactly
            add(value.u, 1, times(value.H, off));
            add(value.v, 1, times(value.D, off));
          }
        put(after.displacement, n, value.u);
        put(after.velocity, n, value.v);
        found[4 * n] = 1;
      }
    for (auto *const values : {&found, &after.displacement, &after.velocity})
      sum_over_ranks(mesh, values->data());
    for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
      if (found[4 * n] > 1)
        for (int i = 0; i < 3; ++i)
          {
            after.displacement[4 * n + i] /= found[4 * n];
            after.velocity[4 * n + i] /= found[4 * n];
          }
    distribute(mesh, after.displacement.data());
    distribute(mesh, after.velocity.data());
  }


  /// Whether each cell of the rank is one of the old mesh, too, with the same places and velocities.
  std::vector<char>
  SolidTransfer::unchanged_cells(const Solid &after) const
  {
    const LocalMesh &mesh = after.mesh;
    // to round-off of places of a metre [m] and of velocities of 40 m/s [m/s]
    std::vector<char> same_node(mesh.n_nodes(), 0), same(mesh.cells.size(), 0);
    const auto        near = [](const Vector3 &a, const Vector3 &b, const double tolerance) {
      return std::abs(a[0] - b[0]) <= tolerance && std::abs(a[1] - b[1]) <= tolerance &&
             std::abs(a[2] - b[2]) <= tolerance;
    };
    for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
      if (const auto found = node_.find(mesh.node_key[n]); found != node_.end())
        {
          const Value &old = values_[found->second];
          same_node[n] =
            near(old.X, mesh.place(n), 1e-14) && near(old.v, vector_at(after.velocity, n), 1e-13);
        }
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      same[c] = cell_.count(mesh.cell_key[c]) > 0 &&
                std::all_of(mesh.cells[c].begin(), mesh.cells[c].end(), [&](const unsigned int n) {
                  return same_node[n];
                });
    return same;
  }


  /// Keys of the cells that have not changed, of those that the rank had or has.
  std::unordered_set<std::uint64_t>
  SolidTransfer::kept_cells(const Solid &after) const
  {
    const std::vector<char>    same = unchanged_cells(after);
    std::vector<std::uint64_t> own;
    for (std::size_t c = 0; c < same.size(); ++c)
      if (same[c])
        own.push_back(after.mesh.cell_key[c]);
    std::unordered_set<std::uint64_t> kept(own.begin(), own.end());
    for (const std::uint64_t key : fetch_rows(own, own, before_.mesh.cell_key, communicator_))
      kept.insert(key);
    return kept;
  }


  void
  SolidTransfer::fill_histories(Solid &after) const
  {
    std::vector<double> mean;
    set_cell_histories(after, [&](const std::string &name, const std::size_t cell) -> const double * {
      // Plastic strains, back stresses and amplitudes are densities: parts inherit them, a whole takes their
      // mean. Plastic work is a sum [J]: parts share it, a whole adds it up.
      const auto [first, components] = columns_.at(name);
      const auto      row   = [&, at = first](const std::size_t c) { return &cells_[width_ * c + at]; };
      const CellPlace place = CellPlace::of_key(after.mesh.cell_key[cell]);
      // the cell itself, or the one that it is a part of; work is divided by the volume
      for (int level = place.level; level >= 0; --level)
        if (const auto found = cell_.find(place.ancestor(static_cast<unsigned char>(level)).key());
            found != cell_.end())
          {
            if (level == place.level)
              return row(found->second);
            // an eighth of the volume for each level
            const double share = name == "plastic_work" ? std::ldexp(1., 3 * (level - place.level)) : 1.;
            mean.assign(row(found->second), row(found->second) + components);
            for (double &value : mean)
              value *= share;
            return mean.data();
          }
      // its parts: eight of the next level, and so on
      mean.assign(components, 0.);
      const auto add_parts = [&](const auto &self, const CellPlace &part, const double weight) -> void {
        for (unsigned int c = 0; c < 8; ++c)
          {
            const CellPlace child = part.child(c);
            const double    share = name == "plastic_work" ? 1. : weight / 8;
            const auto      found = cell_.find(child.key());
            if (found == cell_.end())
              self(self, child, share);
            else
              for (std::size_t i = 0; i < mean.size(); ++i)
                mean[i] += share * row(found->second)[i];
          }
      };
      add_parts(add_parts, place, 1);
      return mean.data();
    });
  }


  /// Dilatations of the step behind, on cells that were not there.
  void
  SolidTransfer::fill_viscous(Solid &after, const double time_step) const
  {
    // A force pass at u(n-1) with viscosity of coefficient 0 only records tr E there: the first rate on new
    // cells is then that of the motion, and not the jump from zero
    AlignedVector<double> behind = after.displacement, ignored(after.displacement.size(), 0.);
    for (std::size_t k = 0; k < behind.size(); ++k)
      // u(n-1) = u(n) - dt v(n-1/2)
      behind[k] -= time_step * after.velocity[k];
    for (const Body body : both_bodies)
      {
        ElementBlocks              &blocks    = after.blocks[body];
        const AlignedVector<double> inherited = blocks.viscous;
        ElementEnergy               energy;
        {
          const ElasticScope elastic(blocks);
          subtract_internal_force(
            blocks, behind.data(), ignored.data(), BulkViscosity{0, time_step}, false, energy);
        }
        const std::size_t W = blocks.width;
        for (std::size_t e = 0; e < blocks.n_elements; ++e)
          if (cell_.count(after.mesh.cell_key[after.block_cells[body][e]]) > 0)
            for (std::size_t i = 0; i < 2; ++i)
              {
                const std::size_t k = (e / W * 2 + i) * W + e % W;
                blocks.viscous[k]   = inherited[k];
              }
      }
  }


  void
  SolidTransfer::fill(Solid &after, const std::vector<NodeInertia> &inertia, const double time_step)
  {
    // 1. Old cells and nodes that this rank needs
    fetch(after);
    // 2. Displacements and velocities
    fill_nodes(after);
    // 3. Momentum, before the viscosity, which takes velocities
    const auto kept = kept_cells(after);
    conserve_momentum(
      before_,
      after,
      [&](const std::uint64_t key) { return kept.count(key) == 0; },
      middle_,
      inertia,
      communicator_);
    // 4. Plastic histories; 5. dilatations of the step behind
    fill_histories(after);
    if (time_step > 0)
      fill_viscous(after, time_step);
  }

} // namespace wheelrail
