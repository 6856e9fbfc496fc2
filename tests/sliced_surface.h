#pragma once

// The surface of a slices file of a test.

#include "slices_files.h"

#include <wheelrail/sections/sections_surface.h>

#include <cmath>
#include <string>

namespace test
{
  inline wheelrail::SectionsSurface
  surface_of(const std::string &file,
             const double       inclination = 0,
             const double       spacing     = 0.5e-3,
             const bool         ends        = false)
  {
    using namespace wheelrail;
    return {read_slices_file(file, ProfileUnit::millimetre),
            Placement{{}, -std::atan(inclination)},
            0,
            file,
            spacing,
            ends};
  }
} // namespace test
