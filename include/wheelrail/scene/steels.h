#pragma once

#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// A steel of the standards with its 0.2 % proof stress [Pa].
  struct Steel
  {
    std::string name;
    double      strength;
  };

  /// Rails: 0.55 of the least tensile strength of EN 13674-1 (R200 680, R260 and R260Mn 880 MPa), 0.65 of it
  /// where the head is heat-treated (R350HT 1175 MPa), since that standard has no proof stress.
  const std::vector<Steel> &
  rail_steels();

  /// Wheels: the least proof stress of the rim of EN 13262 (ER6 500 to ER9 580 MPa).
  const std::vector<Steel> &
  wheel_steels();

  /// The yield stress of a body [Pa]: the one that is given, else that of its named steel; infinite: neither.
  double
  yield_strength(const MaterialData &material);
} // namespace wheelrail
