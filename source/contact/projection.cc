#include <wheelrail/contact/projection.h>

#include <algorithm>
#include <cmath>
#include <utility>

// Closest points, normals and gaps (doc/theory/contact.md, Projection and normals, Gap between the true
// profiles). Facets are chords of the true surfaces: without offsets gaps would vary by h^2/(8 R), 0.3 um at
// 1 mm and 460 mm. Normals of nodes, interpolated, are continuous over the edges of facets, where those of
// the facets jump.

namespace wheelrail
{
  namespace
  {
    std::array<std::size_t, 4>
    corners(const Lattice &lattice, const FacetPoint &point)
    {
      // (0, 0), (1, 0), (0, 1), (1, 1): xi along the track, eta across it
      const std::size_t k = lattice.index(point.i, point.j), next = lattice.n_lateral;
      return {k, k + next, k + 1, k + next + 1};
    }
  } // namespace


  Projection::Projection(RunningSurfaces surfaces)
    : surfaces_(std::move(surfaces))
  {
    for (const Irregularity &one : surfaces_.wheel.irregularities())
      wheel_offsets_ = wheel_offsets_ || one.carried == CarriedBy::offset;
  }


  void
  Projection::prepare(const PerBody<SurfaceState> &states)
  {
    rail_offset_.clear();
    for (const Vector3 &X : states.rail.reference)
      // what the rail's true profile stands out of the filtered node, along its normal; constant in a run
      rail_offset_.push_back(surfaces_.rail.offset(X));
    wheel_normal_.assign(states.wheel.reference.size(), Vector3{});
  }


  void
  Projection::renew_normals(const Lattice &wheel, const StationRange &stations, const std::vector<Vector3> &x)
  {
    const int n = wheel.n_lateral;
    for (int i = stations.first; i < stations.last; ++i)
      {
        const int before = std::max(i - 1, stations.first), after = std::min(i + 1, stations.last - 1);
        for (int j = 0; j < n; ++j)
          {
            const int left = std::max(j - 1, 0), right = std::min(j + 1, n - 1);
            // cross product of central differences over the neighbours, one-sided at borders; along x lateral
            // points out of the rail
            const Vector3 along              = x[wheel.index(after, j)] - x[wheel.index(before, j)];
            const Vector3 lateral            = x[wheel.index(i, right)] - x[wheel.index(i, left)];
            wheel_normal_[wheel.index(i, j)] = normalised(cross(along, lateral));
          }
      }
  }


  Facing
  Projection::facing(const Lattice               &wheel,
                     const PerBody<SurfaceState> &states,
                     const std::size_t            index,
                     const FacetPoint            &point) const
  {
    // bilinear weights of the corners (0, 0), (1, 0), (0, 1), (1, 1)
    const double xi = point.xi, eta = point.eta;
    Facing       facing;
    facing.corners = corners(wheel, point);
    facing.weight  = {(1 - xi) * (1 - eta), xi * (1 - eta), (1 - xi) * eta, xi * eta};
    Vector3 foot{}, normal{}, X{};
    for (int m = 0; m < 4; ++m)
      {
        const std::size_t k = facing.corners[m];
        add(foot, facing.weight[m], states.wheel.x[k]);
        add(normal, facing.weight[m], wheel_normal_[k]);
        add(X, facing.weight[m], states.wheel.reference[k]);
      }
    // weights of the foot also for the normals: continuous over edges, where normals of facets would jump and
    // a node that rolls over would feel a blow
    facing.normal = normalised(normal);
    // g = (foot - x) . n - w(X) of doc/theory/contact.md, X the reference place of the foot; less the rail's
    // own offset, which its filtered node has, too
    facing.gap =
      dot(foot - states.rail.x[index], facing.normal) - surfaces_.wheel.offset(X) - rail_offset_[index];
    if (wheel_offsets_)
      facing.tilt = tilt(X, facing.normal);
    return facing;
  }


  /// The gap shrinks by what stands out of the wheel at the foot, a place X of its surface. When the wheel
  /// moves by t along its tangent plane, X moves by -t on it, and the gap grows by t times the slope: a force
  /// on the wheel, pressure times slope, in addition to that along the normal. For a rail the offset of a
  /// node stays.
  Vector3
  Projection::tilt(const Vector3 &X, const Vector3 &normal) const
  {
    // gradient of w along the wheel's arc and across it
    // true normal = n + tilt to first order in the slopes of w [-]
    const auto    slopes = surfaces_.wheel.offset_slopes(surfaces_.wheel.place(X));
    const Vector3 along = normalised(cross(surfaces_.pose().axis(), normal)), across = cross(normal, along);
    return slopes.along * along + slopes.across * across;
  }


  bool
  project(const Lattice              &lattice,
          const StationRange         &stations,
          const std::vector<Vector3> &x,
          const Vector3              &place,
          const int                   station,
          const int                   row,
          FacetPoint                 &point)
  {
    const int last_i = stations.last - 2, last_j = static_cast<int>(lattice.n_lateral) - 2;
    if (point.i < stations.first || point.i > last_i)
      point = {std::clamp(station, stations.first, last_i), std::clamp(row, 0, last_j), 0.5, 0.5};
    // over a ridge between two facets the foot lies outside of both: a move that is taken back pins
    // the foot to the edge
    int  last_move[2] = {0, 0};
    bool pinned[2]    = {false, false};
    // xi and eta leave [0, 1] at the border of the window alone: such a node faces no facet. A pinned foot
    // stays on its edge.
    for (int iteration = 0; iteration < 60; ++iteration)
      {
        const auto    c = corners(lattice, point);
        const Vector3 a = x[c[1]] - x[c[0]], b = x[c[2]] - x[c[0]], d = x[c[3]] - x[c[2]] - a;
        // Gauss-Newton for the foot of the perpendicular on the bilinear facet
        const Vector3 t1 = a + point.eta * d, t2 = b + point.xi * d;
        Vector3       r = place - x[c[0]];
        add(r, -point.xi, a);
        add(r, -point.eta, t2);
        // x(xi, eta) = c0 + xi a + eta b + xi eta d; tangents t1 = a + eta d, t2 = b + xi d, r the place less
        // x: normal equations T'T (dxi, deta) = T'r, whose neglected part r . d is of the order of gap times
        // twist
        const double m11 = dot(t1, t1), m12 = dot(t1, t2), m22 = dot(t2, t2), r1 = dot(r, t1),
                     r2   = dot(r, t2);
        const double det  = m11 * m22 - m12 * m12;
        double    next[2] = {point.xi + (r1 * m22 - r2 * m12) / det, point.eta + (r2 * m11 - r1 * m12) / det};
        int      *facet[2] = {&point.i, &point.j};
        const int first[2] = {stations.first, 0}, last[2] = {last_i, last_j};
        bool      moved = false;
        for (int k = 0; k < 2; ++k)
          {
            // a foot beyond its facet is sought on the next one
            const int move = next[k] < 0 ? -1 : next[k] > 1 ? 1 : 0;
            if (move != 0 && !pinned[k] && move == -last_move[k])
              pinned[k] = true;
            if (pinned[k])
              next[k] = std::clamp(next[k], 0., 1.);
            else if (move != 0 && *facet[k] + move >= first[k] && *facet[k] + move <= last[k])
              {
                *facet[k] += move;
                next[k] -= move;
                last_move[k] = move;
                moved        = true;
              }
          }
        const double change = std::abs(next[0] - point.xi) + std::abs(next[1] - point.eta);
        point.xi            = next[0];
        point.eta           = next[1];
        if (!moved && change < 1e-9)
          // settled to 1e-9 of a facet
          return point.xi > -1e-6 && point.xi < 1 + 1e-6 && point.eta > -1e-6 && point.eta < 1 + 1e-6;
      }
    return false;
  }
} // namespace wheelrail
