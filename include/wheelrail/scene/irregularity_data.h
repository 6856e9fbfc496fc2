#pragma once

#include <cmath>
#include <limits>
#include <string>

namespace wheelrail
{
  /// Shapes that a running surface may have besides its profile.
  enum class IrregularKind
  {
    none,
    dent,
    squat,
    corrugation,
    weld,
    dipped_joint,
    flat,
    rounded_flat,
    polygon,
    roughness, ///< waves of a spectrum in a file
    file       ///< measured heights or slices
  };

  /// The body that an irregularity lies on.
  enum class IrregularBody
  {
    automatic, ///< the wheel for flats, polygons and slices of a wheel, else the rail
    rail,
    wheel
  };

  /// A subsection Irregularity 1, 2, ... of a scene [SI].
  struct IrregularityData
  {
    static constexpr double automatic = std::numeric_limits<double>::infinity();

    IrregularKind kind       = IrregularKind::none;
    IrregularBody body       = IrregularBody::automatic;
    double        place      = 0;         ///< along, of its middle (corrugation: first crest) [m]
    double        lateral    = automatic; ///< x in the section; infinite: where wheel and rail touch [m]
    double        length     = 40e-3;     ///< [m]
    double        width      = 0;         ///< 0: all across [m]
    double        depth      = automatic; ///< infinite: from the length of a flat; negative: raised [m]
    double        wavelength = 50e-3;     ///< of a corrugation [m]
    double        angle      = automatic; ///< total, of a dipped joint [rad]; infinite: from the depth
    unsigned int  order      = 3;         ///< of a polygon
    unsigned int  seed       = 1;         ///< of the phases of roughness
    std::string   file       = "none";

    /// Whether it lies on the wheel.
    bool
    on_wheel() const
    {
      if (body != IrregularBody::automatic)
        return body == IrregularBody::wheel;
      return kind == IrregularKind::flat || kind == IrregularKind::rounded_flat ||
             kind == IrregularKind::polygon ||
             (kind == IrregularKind::file && file.size() > 5 &&
              file.compare(file.size() - 5, 5, ".slcw") == 0);
    }

    /// Whether its shape is in its file.
    bool
    in_file() const
    {
      return kind == IrregularKind::file || kind == IrregularKind::roughness;
    }

    /// Its depth below the smooth surface, on a circle of `radius` where it is that of a flat [m]. A fresh
    /// flat has length^2/(8 R), one that is rolled round half of it (Wu and Thompson 2002).
    double
    true_depth(const double radius) const
    {
      if (kind == IrregularKind::dipped_joint && std::isfinite(angle))
        return angle * length / 8;
      if (kind == IrregularKind::flat)
        return radius - std::sqrt(radius * radius - length * length / 4);
      if (kind == IrregularKind::rounded_flat && !std::isfinite(depth))
        return length * length / (16 * radius);
      return depth;
    }
  };

  /// Subsections that a scene may have.
  constexpr int most_irregularities = 9;
} // namespace wheelrail
