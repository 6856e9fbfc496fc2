#pragma once

#include <wheelrail/verdict/verdict.h>

#include "near.h"

#include <string>

namespace test
{
  inline void
  holds(const std::string &text, const std::string &part, const std::string &name)
  {
    BOOST_TEST((text.find(part) != std::string::npos), name + " [" + text + "]");
  }

  /// The main scene on 1 mm, as it comes out.
  inline wheelrail::Measures
  good()
  {
    wheelrail::Measures m;
    m.cells             = 12.8;
    m.cells_across_peak = 6.5;
    m.penetration       = 0.008;
    m.unsteadiness      = 3e-4;
    m.pressure_noise    = 1e-3;
    m.swing             = 2e-3;
    m.swing_of          = "creepage";
    m.drift             = 3e-3;
    m.drift_of          = "contact area";
    m.settled_after     = 10e-3;
    m.means_from        = 40e-3;
    m.energy_error      = 4e-4;
    m.load_miss         = 2e-4;
    m.torque_miss       = 2e-3;
    m.peak_pressure     = 1.23e9;
    m.peak_difference   = -0.015;
    m.turn              = 0.1;
    m.contact_modulus   = 115.4e9;
    m.margin            = 23e-3;
    return m;
  }
} // namespace test
