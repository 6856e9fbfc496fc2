// Facets of the wheel: normals that are continuous over them, and the closest point of a rail node.

#include <wheelrail/contact/contact.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  void
  Contact::wheel_normals()
  {
    const auto    &x       = state_[1].x;
    const Lattice &lattice = wheel_.lattice;
    const int      n       = lattice.n_lateral;
    for (int i = window_.wheel_first; i < window_.wheel_last; ++i)
      {
        const int before = std::max(i - 1, window_.wheel_first),
                  after  = std::min(i + 1, window_.wheel_last - 1);
        for (int j = 0; j < n; ++j)
          {
            const int     left = std::max(j - 1, 0), right = std::min(j + 1, n - 1);
            const Vector3 along                = x[lattice.index(after, j)] - x[lattice.index(before, j)];
            const Vector3 lateral              = x[lattice.index(i, right)] - x[lattice.index(i, left)];
            wheel_normal_[lattice.index(i, j)] = normalised(cross(along, lateral));
          }
      }
  }


  std::array<std::size_t, 4>
  Contact::corners(const ContactNode &node) const
  {
    const std::size_t k = wheel_.lattice.index(node.facet_i, node.facet_j), next = wheel_.lattice.n_lateral;
    return {k, k + next, k + 1, k + next + 1};
  }


  bool
  Contact::project(ContactNode &node, const Vector3 &x, const int station, const int row) const
  {
    const int last_i = window_.wheel_last - 2, last_j = static_cast<int>(wheel_.lattice.n_lateral) - 2;
    if (node.facet_i < window_.wheel_first || node.facet_i > last_i)
      {
        node.facet_i = std::clamp(station, window_.wheel_first, last_i);
        node.facet_j = std::clamp(row, 0, last_j);
        node.xi = node.eta = 0.5;
      }
    const auto &y = state_[1].x;
    // over a ridge between two facets the foot lies outside of both: a move that is taken back pins
    // the foot to the edge
    int  last_move[2] = {0, 0};
    bool pinned[2]    = {false, false};
    for (int iteration = 0; iteration < 60; ++iteration)
      {
        const auto    c = corners(node);
        const Vector3 a = y[c[1]] - y[c[0]], b = y[c[2]] - y[c[0]], d = y[c[3]] - y[c[2]] - a;
        // Gauss-Newton for the foot of the perpendicular on the bilinear facet
        const Vector3 t1 = a + node.eta * d, t2 = b + node.xi * d;
        Vector3       r = x - y[c[0]];
        add(r, -node.xi, a);
        add(r, -node.eta, t2);
        const double m11 = dot(t1, t1), m12 = dot(t1, t2), m22 = dot(t2, t2), r1 = dot(r, t1),
                     r2    = dot(r, t2);
        const double det   = m11 * m22 - m12 * m12;
        double    place[2] = {node.xi + (r1 * m22 - r2 * m12) / det, node.eta + (r2 * m11 - r1 * m12) / det};
        int      *facet[2] = {&node.facet_i, &node.facet_j};
        const int first[2] = {window_.wheel_first, 0}, last[2] = {last_i, last_j};
        bool      moved = false;
        for (int k = 0; k < 2; ++k)
          {
            const int move = place[k] < 0 ? -1 : place[k] > 1 ? 1 : 0;
            if (move != 0 && !pinned[k] && move == -last_move[k])
              pinned[k] = true;
            if (pinned[k])
              place[k] = std::clamp(place[k], 0., 1.);
            else if (move != 0 && *facet[k] + move >= first[k] && *facet[k] + move <= last[k])
              {
                *facet[k] += move;
                place[k] -= move;
                last_move[k] = move;
                moved        = true;
              }
          }
        const double change = std::abs(place[0] - node.xi) + std::abs(place[1] - node.eta);
        node.xi             = place[0];
        node.eta            = place[1];
        if (!moved && change < 1e-9)
          return node.xi > -1e-6 && node.xi < 1 + 1e-6 && node.eta > -1e-6 && node.eta < 1 + 1e-6;
      }
    return false;
  }
} // namespace wheelrail
