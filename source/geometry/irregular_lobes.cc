#include <wheelrail/geometry/irregular_lobes.h>

#include <cmath>
#include <utility>

namespace wheelrail
{
  Lobe
  lobe(const double u, const double length)
  {
    if (std::abs(u) >= 0.5 * length)
      return {};
    // cos^2(pi u/length): value and slope are 0 at both ends
    const double c = std::cos(M_PI * u / length), s = std::sin(M_PI * u / length);
    return {c * c, -2 * M_PI / length * c * s};
  }


  Along
  all_across()
  {
    return [](double) { return Lobe{1, 0}; };
  }


  Along
  across_plateau(const IrregularSize &size)
  {
    if (!(size.width > 0))
      return all_across();
    return [width = size.width](const double v) {
      const double beyond = std::abs(v) - 0.25 * width;
      if (beyond <= 0)
        return Lobe{1, 0};
      const Lobe side = lobe(beyond, 0.5 * width);
      return Lobe{side.value, std::copysign(side.slope, -v)};
    };
  }


  Irregularity
  product(const IrregularSize &size, const double begin, const double end, Along along, Along across)
  {
    Irregularity shape;
    shape.begin = begin;
    shape.end   = end;
    shape.at    = [size, along = std::move(along), across = std::move(across)](const double x,
                                                                            const double place) {
      const Lobe a = along(place - size.place), b = across(x - size.lateral);
      // depth counts into the body, height out of it; height = -depth a(place) b(x), and its slopes along and
      // across
      return IrregularHeight{
        -size.depth * a.value * b.value, -size.depth * a.value * b.slope, -size.depth * a.slope * b.value};
    };
    return shape;
  }
} // namespace wheelrail
