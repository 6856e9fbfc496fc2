#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/conicity.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  double
  RadiusDifference::at(const double y) const
  {
    const auto after = std::upper_bound(displacement.begin(), displacement.end(), y);
    if (after == displacement.begin())
      return value.front();
    if (after == displacement.end())
      return value.back();
    const std::size_t i = after - displacement.begin();
    const double      f = (y - displacement[i - 1]) / (displacement[i] - displacement[i - 1]);
    return value[i - 1] + f * (value[i] - value[i - 1]);
  }


  RadiusDifference
  radius_difference(const RailProfile     &rail,
                    const WheelProfile    &wheel,
                    const TrackDimensions &track,
                    const RollMode         roll,
                    const double           most,
                    const double           step)
  {
    RadiusDifference result{{0}, {0}};
    for (int i = 1; i * step <= most * (1 + 1e-12); ++i)
      try
        {
          const double y = i * step;
          // the modelled wheel comes to its own rail with a negative shift
          const double here  = find_contact(rail, wheel, track, {-y, roll}).rolling_radius;
          const double there = find_contact(rail, wheel, track, {y, roll}).rolling_radius;
          result.displacement.push_back(y);
          result.value.push_back(here - there);
        }
      catch (const InputError &) // no contact from here on
        {
          break;
        }
    return result;
  }


  double
  equivalent_conicity(const RadiusDifference &difference,
                      const double            amplitude,
                      const double            distance,
                      const double            radius)
  {
    const double pi = M_PI, none = std::nan("");
    if (!(amplitude > 0) || amplitude > difference.displacement.back() * (1 + 1e-12))
      return none;

    // with y = amplitude sin(theta) the integrand stays finite at the turning point; the inner
    // integral is summed from there, by the trapezoidal rule, which is exact between the table's places
    constexpr int n         = 2000;
    double        potential = 0, quarter = 0, y_before = amplitude;
    for (int i = n - 1; i >= 0; --i)
      {
        const double theta = (i + 0.5) / n * pi / 2, y = amplitude * std::sin(theta);
        potential +=
          0.5 * (difference.at(y) + difference.at(y_before)) * (y_before - y) / (distance * radius);
        if (!(potential > 0))
          return none;
        quarter += amplitude * std::cos(theta) / std::sqrt(2 * potential) * (pi / 2 / n);
        y_before = y;
      }
    const double wavelength = 4 * quarter;
    return std::pow(pi / wavelength, 2) * 2 * distance * radius;
  }
} // namespace wheelrail
