#include <wheelrail/geometry/irregular_lobes.h>
#include <wheelrail/geometry/irregular_shapes.h>

#include <algorithm>
#include <cmath>
#include <utility>

// Shapes of irregularities: depth times a profile along, 0 to 1, times one across; u is the place along from
// the middle [m] (doc/manual/irregularities.md).

namespace wheelrail
{
  namespace
  {
    /// A lobe where the shape has a width.
    Along
    across_lobe(const IrregularSize &size)
    {
      if (!(size.width > 0))
        return all_across();
      return [width = size.width](const double v) { return lobe(v, width); };
    }

    /// The same around the middle of its length.
    Irregularity
    hollow(const IrregularSize &size, Along along, Along across)
    {
      Irregularity shape = product(size,
                                   size.place - 0.5 * size.length,
                                   size.place + 0.5 * size.length,
                                   std::move(along),
                                   std::move(across));
      shape.shortest     = size.width > 0 ? std::min(size.length, size.width) : size.length;
      return shape;
    }

    Lobe
    waves(const double u, const double wavelength)
    {
      // (1 - cos(2 pi u/lambda))/2, from 0 to 1, and its slope
      const double phase = 2 * M_PI * u / wavelength;
      return {0.5 * (1 - std::cos(phase)), M_PI / wavelength * std::sin(phase)};
    }
  } // namespace


  Irregularity
  dent(const IrregularSize &size)
  {
    return hollow(
      size, [length = size.length](const double u) { return lobe(u, length); }, across_lobe(size));
  }


  Irregularity
  squat(const IrregularSize &size)
  {
    const auto lobes = [length = size.length](const double u) {
      // c (1 - (2 c - 1)^2/2) of c = cos^2, over its largest value
      const Lobe   c    = lobe(u, length);
      const double wave = 2 * c.value - 1, most = 0.65776427;
      return Lobe{c.value * (1 - 0.5 * wave * wave) / most,
                  c.slope * (1 - 0.5 * wave * wave - 2 * c.value * wave) / most};
    };
    Irregularity shape = hollow(size, lobes, across_lobe(size));
    shape.shortest     = std::min(shape.shortest, 0.6 * size.length); // of one lobe
    return shape;
  }


  Irregularity
  corrugation(const IrregularSize &size, const double wavelength)
  {
    const double length = wavelength * std::max(1., std::floor(size.length / wavelength + 1e-6));
    Irregularity shape  = product(
      size,
      size.place,
      size.place + length,
      [wavelength](const double u) { return waves(u, wavelength); },
      across_plateau(size));
    shape.shortest = wavelength;
    return shape;
  }


  Irregularity
  dipped_joint(const IrregularSize &size)
  {
    Irregularity joint = hollow(
      size,
      [length = size.length](const double u) {
        // (1 - 2 |u|/length)^2: two parabolas that meet in a kink at the joint, level at their ends
        const double rest = std::max(0., 1 - 2 * std::abs(u) / length);
        return Lobe{rest * rest, std::copysign(4 * rest / length, -u)};
      },
      across_plateau(size));
    joint.kinks = {{size.place}};
    return joint;
  }


  Irregularity
  fresh_flat(const IrregularSize &size, const double radius)
  {
    // a chord of `length` across the rolling circle, from -half to half along the arc
    const double half_angle = std::asin(0.5 * size.length / radius), half = radius * half_angle,
                 inner = std::cos(half_angle);
    IrregularSize unit = size;
    unit.depth         = 1;
    Irregularity flat  = product(
      unit,
      size.place - half,
      size.place + half,
      [radius, inner](const double u) {
        const double c = std::cos(u / radius), s = std::sin(u / radius);
        // depth below the circle r (1 - cos(half angle)/cos(u/r)), and its slope over the arc
        return Lobe{radius * (1 - inner / c), -inner * s / (c * c)};
      },
      across_plateau(size));
    flat.kinks    = {{size.place - half}, {size.place + half}};
    flat.shortest = size.length;
    return flat;
  }


  Irregularity
  rounded_flat(const IrregularSize &size)
  {
    return hollow(
      size, [length = size.length](const double u) { return lobe(u, length); }, across_plateau(size));
  }


  Irregularity
  polygon(const IrregularSize &size, const unsigned int order, const double radius)
  {
    const double circumference = 2 * M_PI * radius;
    Irregularity shape         = product(
      size,
      size.place - 0.5 * circumference,
      size.place + 0.5 * circumference,
      [wavelength = circumference / order](const double u) { return waves(u, wavelength); },
      across_plateau(size));
    shape.shortest = circumference / order;
    return shape;
  }


  IrregularMeasures
  measures_of(const Irregularity &irregularity, const double low, const double high)
  {
    constexpr double  step   = 0.5e-3;
    constexpr int     rows   = 41;
    const double      length = irregularity.end - irregularity.begin;
    const int         n      = static_cast<int>(std::clamp(std::ceil(length / step), 1., 20000.));
    IrregularMeasures measures;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i <= n; ++i)
        {
          const IrregularHeight h =
            irregularity.at(low + (high - low) * j / (rows - 1), irregularity.begin + length * i / n);
          measures.largest  = std::max(measures.largest, std::abs(h.height));
          measures.steepest = std::max({measures.steepest, std::abs(h.along), std::abs(h.across)});
        }
    return measures;
  }
} // namespace wheelrail
