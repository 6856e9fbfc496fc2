#include <wheelrail/mesh/fetch_rows.h>
#include <wheelrail/state/checkpoint.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// The rows of a saved state that this rank has asked for: each its key, as it stands in memory, and its
    /// values.
    struct SavedRows
    {
      struct Column
      {
        std::size_t  first      = 0;
        unsigned int components = 0;
      };
      std::map<std::string, Column>                  column;
      std::size_t                                    width = 1, all_ranks = 0; ///< numbers a row; rows saved
      std::vector<double>                            values;
      std::unordered_map<std::uint64_t, std::size_t> row; ///< of a key

      const double *
      at(const std::string &name, const std::uint64_t key) const
      {
        return &values[width * row.at(key) + column.at(name).first];
      }

      bool
      has(const std::string &name, const unsigned int components) const
      {
        return column.count(name) == 1 && column.at(name).components >= components;
      }
    };

    /// Rows of the saved state, of which other ranks than the first may have none, by the keys that they have
    /// there. Collective.
    SavedRows
    saved_rows(const std::vector<std::uint64_t>            &keys,
               const std::map<std::string, NumberedValues> &saved,
               const std::vector<std::uint64_t>            &wanted,
               MPI_Comm                                     communicator)
    {
      namespace mpi = dealii::Utilities::MPI;
      SavedRows                                         rows;
      std::vector<std::pair<std::string, unsigned int>> names;
      for (const auto &[name, values] : saved)
        names.emplace_back(name, values.components);
      for (const auto &[name, components] : mpi::broadcast(communicator, names))
        {
          rows.column[name] = {rows.width, components};
          rows.width += components;
        }
      rows.all_ranks = mpi::broadcast(communicator, keys.size());
      std::vector<double> own(rows.width * keys.size());
      for (std::size_t k = 0; k < keys.size(); ++k)
        {
          std::memcpy(&own[rows.width * k], &keys[k], sizeof keys[k]);
          for (const auto &[name, values] : saved)
            std::copy_n(&values.values[values.components * k],
                        values.components,
                        &own[rows.width * k + rows.column.at(name).first]);
        }
      rows.values = fetch_rows(keys, own, wanted, communicator);
      for (std::size_t k = 0; k < rows.values.size() / rows.width; ++k)
        {
          std::uint64_t key;
          std::memcpy(&key, &rows.values[rows.width * k], sizeof key);
          rows.row.emplace(key, k);
        }
      return rows;
    }

    /// Whether a body is the one that is asked for, or none is.
    bool
    of(const std::optional<Body> asked, const Body body)
    {
      return !asked || *asked == body;
    }

    /// Whether the nodes of a body (none: of both) that the rank has lie where those of the saved state did,
    /// those of the rail `farther` along, but for round-off.
    bool
    same_places(const SavedRows          &saved,
                const LocalMesh          &mesh,
                const double              farther,
                const std::optional<Body> body)
    {
      constexpr double tolerance = 1e-10; // [m]
      for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
        for (int d = 0; d < 3 && of(body, mesh.node_body[n]); ++d)
          {
            const double moved = d == 2 && mesh.node_body[n] == Body::rail ? farther : 0;
            if (!(std::abs(saved.at("position", mesh.node_key[n])[d] + moved - mesh.reference[4 * n + d]) <
                  tolerance))
              return false;
          }
      return true;
    }

    /// Whether a saved state has what bodies with this mesh need, or one of them.
    bool
    fits(const SavedRows          &nodes,
         const SavedRows          &cells,
         const Solid              &solid,
         const double              farther,
         const std::optional<Body> body)
    {
      const LocalMesh &mesh = solid.mesh;
      bool             same_mesh =
        body || (nodes.all_ranks == solid.quality.nodes && cells.all_ranks == solid.quality.elements);
      for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
        same_mesh = same_mesh && (!of(body, mesh.node_body[n]) || nodes.row.count(mesh.node_key[n]) == 1);
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        same_mesh = same_mesh && (!of(body, mesh.cell_body[c]) || cells.row.count(mesh.cell_key[c]) == 1);
      bool complete = nodes.has("position", 3) && nodes.has("displacement", 3) && nodes.has("velocity", 3);
      for (const Body other : both_bodies)
        visit_histories(solid.blocks[other], [&](const char *name, const unsigned int n, const auto &) {
          complete = complete && (!of(body, other) || cells.has(name, n));
        });
      return same_mesh && complete && same_places(nodes, mesh, farther, body);
    }

    void
    restore_solid(const SavedRows          &nodes,
                  const SavedRows          &cells,
                  Solid                    &solid,
                  const std::optional<Body> body)
    {
      const LocalMesh &mesh = solid.mesh;
      for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
        if (of(body, mesh.node_body[n]))
          {
            std::copy_n(nodes.at("displacement", mesh.node_key[n]), 3, &solid.displacement[4 * n]);
            std::copy_n(nodes.at("velocity", mesh.node_key[n]), 3, &solid.velocity[4 * n]);
          }
      // for what is left out, as long as the longest row of either body
      unsigned int longest = 0;
      for (const Body other : both_bodies)
        visit_histories(solid.blocks[other], [&](const char *, const unsigned int n, const auto &) {
          longest = std::max(longest, n);
        });
      const std::vector<double> zeros(longest, 0.);
      set_cell_histories(solid, [&](const std::string &name, const std::size_t cell) {
        return of(body, mesh.cell_body[cell]) ? cells.at(name, mesh.cell_key[cell]) : zeros.data();
      });
    }
  } // namespace


  bool
  restore_bodies(const Checkpoint         &saved,
                 Solid                    &solid,
                 const double              farther,
                 MPI_Comm                  communicator,
                 const std::optional<Body> body)
  {
    const SavedRows nodes = saved_rows(saved.node, saved.node_values, solid.mesh.node_key, communicator),
                    cells = saved_rows(saved.cell, saved.cell_values, solid.mesh.cell_key, communicator);
    const bool same =
      dealii::Utilities::MPI::min(int(fits(nodes, cells, solid, farther, body)), communicator) == 1;
    if (same)
      restore_solid(nodes, cells, solid, body);
    return same;
  }
} // namespace wheelrail
