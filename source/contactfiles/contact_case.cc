#include <wheelrail/contactfiles/contact_case.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  bool
  ContactMaterial::alike() const
  {
    // K of Kalker (1990)
    const double G = 2 / (1 / shear[0] + 1 / shear[1]);
    return std::abs(G * ((1 - 2 * poisson[0]) / shear[0] - (1 - 2 * poisson[1]) / shear[1]) / 4) < 1e-4;
  }

  int
  ContactGrid::rows_of_strip() const
  {
    if (values.back() <= 1)
      return my;
    const int within = std::max(1, int(std::lround(my / values.back())));
    return within + (my - within) % 2;
  }

  std::string
  ContactGrid::fault_of_size() const
  {
    return mx > 0 && my > 0 && double(mx) * my <= most_contact_elements
             ? ""
             : "a grid of MX x MY elements needs from 1 to 1000000 of them";
  }


  std::array<double, 4>
  ContactGrid::corner() const
  {
    const std::vector<double> &v       = values;
    const bool                 centred = kind == 3 || kind == 4, both_ends = kind == 2 || kind == 4;
    // from end to end lie mx elements, from the first to the last centre one less
    const int    less = centred ? 1 : 0;
    const double dx   = both_ends ? (v[2] - v[0]) / (mx - less) : v[2];
    const double dy   = both_ends ? (v[3] - v[1]) / (my - less) : v[3];
    return {{v[0] - (centred ? 0.5 * dx : 0), v[1] - (centred ? 0.5 * dy : 0), dx, dy}};
  }
} // namespace wheelrail
