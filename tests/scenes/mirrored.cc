#include "mirrored.h"

#include <cmath>
#include <cstdlib>

namespace scenes
{
  using namespace wheelrail;

  namespace
  {
    /// The line of a half lattice behind which a line of the whole one lies.
    struct Line
    {
      unsigned int line   = 0;
      double       sign   = 1;     ///< -1: beyond the plane
      bool         inside = false; ///< in the plane
    };

    Line
    source_line(const unsigned int line, const bool mirror, const unsigned int n_half)
    {
      if (!mirror)
        return {line, 1, false};
      const int distance = static_cast<int>(line) - static_cast<int>(n_half - 1);
      return {static_cast<unsigned int>(std::abs(distance)), distance < 0 ? -1. : 1., distance == 0};
    }
  } // namespace


  WholeSurface
  mirrored(const Surface &part, const Symmetry &symmetry)
  {
    const bool     rigid = part.local[0] < 0;
    const bool     along = symmetry.along && !rigid, across = symmetry.across && !rigid;
    const Lattice &half = part.lattice;
    WholeSurface   whole;
    Surface       &surface = whole.surface;
    surface.body           = part.body;
    surface.lattice        = half;
    if (along)
      {
        surface.lattice.n_along       = 2 * half.n_along - 1;
        surface.lattice.first_station = 1 - static_cast<int>(half.n_along);
      }
    if (across)
      {
        surface.lattice.n_lateral = 2 * half.n_lateral - 1;
        surface.lattice.s_begin   = -(half.n_lateral - 1.) * half.spacing_lateral;
      }
    for (unsigned int i = 0; i < surface.lattice.n_along; ++i)
      for (unsigned int j = 0; j < surface.lattice.n_lateral; ++j)
        {
          const Line a = source_line(i, along, half.n_along), b = source_line(j, across, half.n_lateral);
          const std::size_t k    = half.index(a.line, b.line);
          const double      cuts = (a.inside ? 2 : 1) * (b.inside ? 2 : 1);
          const Vector3     sign = {b.sign, 1, a.sign}, X = part.reference[k];
          surface.reference.push_back({sign[0] * X[0], X[1], sign[2] * X[2]});
          // in a plane of symmetry the mesh holds half of the node's area and takes half of its force
          surface.area.push_back(cuts * part.area[k]);
          whole.sources.push_back({part.local[k], sign, a.sign < 0 || b.sign < 0 ? 0. : 1 / cuts});
        }
    return whole;
  }
} // namespace scenes
