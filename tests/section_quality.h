#pragma once

#include <wheelrail/mesh/section.h>

#include <algorithm>
#include <limits>

namespace test
{
  /// Quality of all blocks of a section together.
  inline wheelrail::SectionQuality
  section_quality(const wheelrail::Section &section, const unsigned int subdivisions)
  {
    wheelrail::SectionQuality total;
    total.min_edge = std::numeric_limits<double>::max();
    for (unsigned int block = 0; block < section.blocks.size(); ++block)
      {
        const wheelrail::SectionQuality quality = wheelrail::block_quality(section, block, subdivisions);
        total.area += quality.area;
        total.min_scaled_jacobian = std::min(total.min_scaled_jacobian, quality.min_scaled_jacobian);
        total.min_edge            = std::min(total.min_edge, quality.min_edge);
        total.max_edge            = std::max(total.max_edge, quality.max_edge);
      }
    return total;
  }
} // namespace test
