#include <wheelrail/bodies/wave_element.h>
#include <wheelrail/bodies/wave_matrices.h>

#include <cholmod.h>


// K0, K1, K2 and M of a section, (1) of doc/theory/bodies.md, assembled once: K(k) is their sum at any
// wavenumber, with one pattern.

namespace wheelrail
{
  namespace
  {
    /// Numbers the free nodes, those of the running surface last.
    void
    number_unknowns(const SectionMesh &mesh, WaveMatrices &waves)
    {
      enum : char
      {
        inside,
        surface,
        fixed,
        hanging
      };
      // later marks win: a held node that hangs is held
      std::vector<char> kind(mesh.nodes.size(), inside);
      for (const auto &edge : mesh.running)
        for (const unsigned int node : edge.node)
          kind[node] = surface;
      for (const auto &node : mesh.hanging)
        kind[node.node] = hanging;
      for (const unsigned int node : mesh.held)
        kind[node] = fixed;
      waves.unknowns.resize(mesh.nodes.size());
      for (const char wanted : {inside, surface})
        for (unsigned int node = 0; node < kind.size(); ++node)
          if (kind[node] == wanted)
            {
              waves.unknowns[node] = {{waves.n_free++, 1.}};
              // unknowns of the surface last: their compliance needs the end of the factor alone
              waves.n_surface += wanted == surface;
            }
      for (const auto &node : mesh.hanging)
        for (unsigned int m = 0; m < node.masters.size(); ++m)
          if (kind[node.masters[m]] != fixed)
            // a hanging node is the mean, with these weights, of nodes of the coarser edge; held ones do not
            // move
            waves.unknowns[node.node].emplace_back(waves.unknowns[node.masters[m]].front().first,
                                                   node.weights[m]);
    }
  } // namespace


  std::array<double, 3>
  edge_weights(const SectionMesh                           &mesh,
               const std::array<unsigned int, 3>           &nodes,
               const std::function<double(const Point2 &)> &weight)
  {
    std::array<double, 3> weights{};
    for (int g = 0; g < 3; ++g)
      {
        // quadratic edge: shape functions and their slopes at t in [0, 1]
        const double t    = wave_gauss_place[g];
        const double N[3] = {(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)};
        const double d[3] = {4 * t - 3, 4 - 8 * t, 4 * t - 1};
        // speed = dX/dt [m]
        Point2 speed, place;
        for (int n = 0; n < 3; ++n)
          {
            speed = speed + d[n] * mesh.nodes[nodes[n]];
            place = place + N[n] * mesh.nodes[nodes[n]];
          }
        for (int n = 0; n < 3; ++n)
          // integral of N_n times a weight over the arc: ds = |dX/dt| dt, three Gauss points
          weights[n] += wave_gauss_weight[g] * norm(speed) * weight(place) * N[n];
      }
    return weights;
  }


  WaveMatrices
  assemble_waves(const SectionMesh &mesh, const Elasticity &elasticity, const bool wheel)
  {
    WaveMatrices waves;
    number_unknowns(mesh, waves);
    std::vector<int>                   rows, columns;
    std::array<std::vector<double>, 4> entries;
    for (const auto &cell : mesh.cells)
      {
        // entries of all four go to the same places, so that K(k) is a sum over one array
        const auto K = wave_matrices(mesh, cell, elasticity, wheel);
        for (unsigned int i = 0; i < n_wave_local; ++i)
          for (unsigned int j = 0; j < n_wave_local; ++j)
            for (const auto &[a, wa] : waves.unknowns[cell[i / 3]])
              for (const auto &[b, wb] : waves.unknowns[cell[j / 3]])
                {
                  // (x, y, w) of each free node; several free nodes where one hangs
                  const int row = 3 * a + i % 3, column = 3 * b + j % 3;
                  // K0, K2 and M are symmetric, and so is K1 with the factor i in u_z: lower half
                  if (row < column)
                    continue;
                  rows.push_back(row);
                  columns.push_back(column);
                  for (int p = 0; p < 4; ++p)
                    // W' K W, W the weights of unknowns in the nodes: hanging nodes leave the equations, and
                    // K stays symmetric
                    entries[p].push_back(wa * wb * K[p][i][j]);
                }
      }
    // duplicates are added up by CHOLMOD; the pattern is the same for all
    // sums over cells meet at equal (row, column)
    cholmod_common common{};
    cholmod_start(&common);
    for (int p = 0; p < 4; ++p)
      {
        // K0, K1, K2, M one after the other; all have the entries of one pattern, zeros included
        cholmod_triplet triplet{};
        triplet.nrow = triplet.ncol = waves.size();
        triplet.nzmax = triplet.nnz = rows.size();
        triplet.i                   = rows.data();
        triplet.j                   = columns.data();
        triplet.x                   = entries[p].data();
        // lower half of a symmetric matrix
        triplet.stype          = -1;
        triplet.itype          = CHOLMOD_INT;
        triplet.xtype          = CHOLMOD_REAL;
        triplet.dtype          = CHOLMOD_DOUBLE;
        cholmod_sparse *sparse = cholmod_triplet_to_sparse(&triplet, 0, &common);
        const auto      n      = cholmod_nnz(sparse, &common);
        const auto     *x      = static_cast<const double *>(sparse->x);
        const auto *start = static_cast<const int *>(sparse->p), *row = static_cast<const int *>(sparse->i);
        waves.values[p].assign(x, x + n);
        if (p == 0)
          {
            waves.start.assign(start, start + waves.size() + 1);
            waves.row.assign(row, row + n);
          }
        cholmod_free_sparse(&sparse, &common);
      }
    cholmod_finish(&common);
    return waves;
  }
} // namespace wheelrail
