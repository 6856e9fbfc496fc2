#include <wheelrail/base/errors.h>
#include <wheelrail/halfspace/element_stress.h>
#include <wheelrail/halfspace/subsurface.h>

#include <cmath>
#include <string>

// Stresses at points in one body, element by element in closed form (doc/theory/halfspace.md, Stresses below
// the surface). Signs: tension positive, n of the contact frame.

namespace wheelrail
{
  namespace
  {
    /// Stresses at (x, y, z) from the centre of a loaded element dx x dy.
    void
    add_element(const HalfspaceGrid &grid,
                const double         nu,
                const double         x,
                const double         y,
                const double         z,
                const double         qx,
                const double         qy,
                const double         p,
                HalfspaceStress     &s)
    {
      // the load from -hx to hx: seen from it the point is x + hx, x - hx off its edges
      const double hx = grid.dx / 2, hy = grid.dy / 2;
      // far_far, far_near, near_far, near_near: the first is that of x
      add_stress(rectangle_derivatives(corner_derivatives(x + hx, y + hy, z),
                                       corner_derivatives(x + hx, y - hy, z),
                                       corner_derivatives(x - hx, y + hy, z),
                                       corner_derivatives(x - hx, y - hy, z)),
                 nu,
                 z,
                 qx,
                 qy,
                 p,
                 s);
    }
  } // namespace

  void
  check_depth(const double depth)
  {
    if (!(depth >= 0))
      throw InputError("Subsurface stresses: the depth " + std::to_string(depth) +
                       " m is negative; depths count into the body.");
  }

  double
  HalfspaceStress::von_mises() const
  {
    // von Mises (1913): sqrt(3/2 s : s) of the deviator s
    return std::sqrt(0.5 * (std::pow(xx - yy, 2) + std::pow(yy - nn, 2) + std::pow(nn - xx, 2)) +
                     3 * (xy * xy + xn * xn + yn * yn));
  }

  std::vector<HalfspaceStress>
  subsurface_stresses(const HalfspaceSolution            &solution,
                      const HalfspaceBody                &body,
                      const HalfspaceSide                 side,
                      const std::vector<SubsurfacePoint> &points)
  {
    // for a few points; layers below all elements at once are cheaper by FFT (SubsurfaceLayers)
    const HalfspaceGrid &g = solution.grid;
    // p and t act on body 1, whose inside lies along +n. Body 2 has the opposite tractions, and its depth
    // runs along -n, so that a pressure presses it, too.
    const double                 sign = side == HalfspaceSide::body1 ? 1 : -1;
    std::vector<HalfspaceStress> stresses(points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
      {
        // z is the depth into the body; points at the surface, z = 0, are limits from inside
        const SubsurfacePoint &point = points[k];
        check_depth(point.depth);
        for (int j = 0; j < g.my; ++j)
          for (int i = 0; i < g.mx; ++i)
            {
              const int e = i + g.mx * j;
              // closed integrals of all loaded elements, added up: n points times n elements
              if (solution.pressure[e] <= 0)
                continue;
              add_element(g,
                          body.poisson_ratio,
                          point.x - g.x(i),
                          point.y - g.y(j),
                          point.depth,
                          sign * solution.traction_x[e],
                          sign * solution.traction_y[e],
                          solution.pressure[e],
                          stresses[k]);
            }
        // Depth runs against n in body 2.
        stresses[k].xn *= sign;
        stresses[k].yn *= sign;
      }
    return stresses;
  }
} // namespace wheelrail
