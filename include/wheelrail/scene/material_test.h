#pragma once

#include <wheelrail/base/body.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Values that a strain or a stress takes in each cycle.
  struct Stations
  {
    bool                of_stress = false; ///< stresses [Pa], else strains
    std::vector<double> values;            ///< none: free of stress; a single one is held
  };

  /// How the command material drives one point of a steel.
  struct MaterialTest
  {
    Body         body = Body::rail; ///< whose steel it is
    Stations     axial;             ///< along x
    Stations     shear;             ///< in the plane xy, strains as the change of the angle
    std::string  file   = "none";   ///< rows of strains and stresses to go through instead, or none
    unsigned int cycles = 20;
    unsigned int steps  = 0; ///< of the law from one station to the next; 0: as many as 0.1 % needs
  };
} // namespace wheelrail
