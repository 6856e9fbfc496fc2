#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/conicity.h>

#include <algorithm>
#include <cmath>
#include <functional>

// Equivalent conicity (EN 15302, UIC 519; doc/theory/geometry.md): wavelength of Klingel's equation y'' =
// -difference/(e r0) at an amplitude, and the cone that has the same. e is the distance of the running
// circles, r0 the nominal radius [m].
// Checked: S1002 on 54E1, 1:40: 0.2002 at 3 mm; stepping through the equation gives the same to 3e-8.

namespace wheelrail
{
  namespace
  {
    /// One side of the path of a wheelset, from its rolling line to a turning point.
    struct HalfSwing
    {
      double potential = 0; ///< integral of the difference from the line to the turning point [m2]
      double quarter   = 0; ///< of the wavelength, over the root of e r0 [1]; NaN: it does not turn there
    };

    HalfSwing
    half_swing(const RadiusDifference &difference,
               const double            line,
               const double            side,
               const double            amplitude)
    {
      // with y = amplitude sin(theta) the integrand stays finite at the turning point; the inner
      // integral is summed from there, by the trapezoidal rule, which is exact between the table's places
      // y'' = -f(y)/(e r0) (Klingel 1883), f the difference of rolling radii, has the energy y'^2/2 +
      // integral f dy/(e r0): dx = dy/sqrt(2 (P(a) - P(y))/(e r0)), a quarter of the wavelength from the line
      // to the turning point a
      constexpr int n     = 2000;
      const auto    value = [&](const double y) { return side * difference.at(line + side * y); };
      HalfSwing     swing;
      double        y_before = amplitude;
      for (int i = n - 1; i >= 0; --i)
        {
          const double theta = (i + 0.5) / n * M_PI / 2, y = amplitude * std::sin(theta);
          swing.potential += 0.5 * (value(y) + value(y_before)) * (y_before - y);
          swing.quarter += swing.potential > 0
                             ? amplitude * std::cos(theta) / std::sqrt(2 * swing.potential) * (M_PI / 2 / n)
                             : std::nan("");
          y_before = y;
        }
      swing.potential += 0.5 * value(y_before) * y_before;
      return swing;
    }

    /// Adds a value to a table, and as many before it as a straight line from the last one misses by more
    /// than 1 um, halving: the contact jumps at places of its own, which are found to 1 um.
    void
    add_between(const std::function<double(double)> &difference,
                const double                         y,
                const double                         value,
                RadiusDifference                    &table)
    {
      if (!table.displacement.empty() && y - table.displacement.back() > 1e-6)
        {
          const double middle = 0.5 * (table.displacement.back() + y), there = difference(middle),
                       straight = 0.5 * (table.value.back() + value);
          if (std::abs(there - straight) > 1e-6)
            {
              add_between(difference, middle, there, table);
              add_between(difference, y, value, table);
              return;
            }
          if (!std::isnan(there))
            {
              table.displacement.push_back(middle);
              table.value.push_back(there);
            }
        }
      table.displacement.push_back(y);
      table.value.push_back(value);
    }
  } // namespace


  double
  RadiusDifference::at(const double y) const
  {
    if (odd && y < 0)
      return -at(-y);
    const auto after = std::upper_bound(displacement.begin(), displacement.end(), y);
    if (after == displacement.begin())
      return value.front();
    if (after == displacement.end())
      return value.back();
    const std::size_t i = after - displacement.begin();
    // linear between the places of the table
    const double f = (y - displacement[i - 1]) / (displacement[i] - displacement[i - 1]);
    return value[i - 1] + f * (value[i] - value[i - 1]);
  }


  double
  RadiusDifference::rolling_line() const
  {
    if (odd)
      return 0;
    double line = std::nan("");
    for (std::size_t i = 1; i < value.size(); ++i)
      // where the difference goes through zero and grows, the wheelset comes back; the one next to the middle
      if (value[i - 1] < 0 && value[i] >= 0)
        if (const double y = displacement[i - 1] + value[i - 1] / (value[i - 1] - value[i]) *
                                                     (displacement[i] - displacement[i - 1]);
            !(std::abs(line) <= std::abs(y)))
          line = y;
    return line;
  }


  RadiusDifference
  radius_difference(const RailProfile     &rail,
                    const WheelProfile    &wheel,
                    const TrackDimensions &track,
                    const RollMode         roll,
                    const double           most,
                    const double           step,
                    const WheelOnRail     *other)
  {
    // the wheel towards whose rail the wheelset has moved, less the other; NaN: no contact
    const auto difference = [&](const double y) {
      try
        {
          // the modelled wheel comes to its own rail with a negative shift
          const ContactGeometry contact = find_contact(rail, wheel, track, {-y, roll}, other);
          return contact.rolling_radius - contact.other_radius;
        }
      catch (const InputError &)
        {
          return std::nan("");
        }
    };
    RadiusDifference result{{}, {}, other == nullptr};
    if (!other) // whatever the profiles
      result = {{0}, {0}, true};
    const int last = static_cast<int>(most / step * (1 + 1e-12));
    for (int i = other ? -last : 1; i <= last; ++i)
      if (const double value = difference(i * step); !std::isnan(value))
        add_between(difference, i * step, value, result);
      else if (i < 0) // what lies beyond is not reached from the middle
        result = {{}, {}, false};
      else
        break;
    return result;
  }


  double
  equivalent_conicity(const RadiusDifference &difference,
                      const double            amplitude,
                      const double            distance,
                      const double            radius)
  {
    const double none = std::nan(""), line = difference.rolling_line();
    if (!(amplitude > 0) || !std::isfinite(line))
      return none;
    double right = amplitude; // the path to the turning point towards the modelled rail
    if (!difference.odd)
      {
        double low = 0, high = 2 * amplitude;
        for (int i = 0; i < 50; ++i)
          {
            right = 0.5 * (low + high);
            // profiles that differ on both sides: the same potential at both turning points, together 2 x
            // amplitude apart
            const bool farther = half_swing(difference, line, 1, right).potential <
                                 half_swing(difference, line, -1, 2 * amplitude - right).potential;
            (farther ? low : high) = right;
          }
        if (line - (2 * amplitude - right) < difference.displacement.front() * (1 + 1e-12))
          return none;
      }
    if (line + right > difference.displacement.back() * (1 + 1e-12))
      return none;
    const double half = half_swing(difference, line, 1, right).quarter +
                        half_swing(difference, line, -1, 2 * amplitude - right).quarter;
    // L = 2 (quarter right + quarter left); the cone of the same L has tan gamma = (pi/L)^2 2 e r0 (EN 15302;
    // doc/theory/geometry.md)
    const double wavelength = 2 * half * std::sqrt(distance * radius);
    return std::isfinite(half) ? std::pow(M_PI / wavelength, 2) * 2 * distance * radius : none;
  }
} // namespace wheelrail
