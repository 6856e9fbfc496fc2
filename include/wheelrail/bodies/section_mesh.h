#pragma once

#include <wheelrail/mesh/section.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// A plane section of quadratic quadrilaterals (nine nodes), fine along its running surface and coarse
  /// elsewhere: what the 2.5-D elements of wave_stiffness.h live on.
  struct SectionMesh
  {
    /// A node in the middle of an edge of a smaller cell beside a larger one: its displacement is that of
    /// the larger cell's edge.
    struct Hanging
    {
      unsigned int          node = 0;
      std::vector<unsigned> masters;
      std::vector<double>   weights;
    };

    /// An edge of a cell on the running surface: start, middle, end, towards the track centre.
    struct Edge
    {
      std::array<unsigned int, 3> node;
    };

    std::vector<Point2>                      nodes; ///< in the frame of the section [m]
    std::vector<std::array<unsigned int, 9>> cells; ///< three rows of three nodes, right-handed
    std::vector<Hanging>                     hanging;
    std::vector<unsigned int>                held;    ///< nodes of the foot or the bore, which do not move
    std::vector<Edge>                        running; ///< in the order of the running surface
  };

  /// Divides the blocks of a section: those along edges marked `running` `levels` times, so that each such
  /// edge carries 2^levels cells, the others as far as a ratio of 2 between neighbours asks for. Nodes lie
  /// on the exact edges of the blocks. Nodes on edges marked `held` do not move. Uses deal.II's adaptive
  /// quadrilaterals and their hanging nodes. Throws RunError where the running surface is not one line.
  SectionMesh
  mesh_section(const Section &section, Boundary held, unsigned int levels);
} // namespace wheelrail
