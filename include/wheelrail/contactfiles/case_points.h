#pragma once

#include <wheelrail/contactfiles/contact_case.h>
#include <wheelrail/halfspace/problem.h>
#include <wheelrail/halfspace/subsurface.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// Coordinates of a block of points below the surface: all combinations of them [m]. z counts along the
  /// normal: from 0 on in body 1, negative in body 2.
  struct PointBlock
  {
    std::vector<double> x, y, z;
  };

  /// The block that ISUBS describes on the grid: element centres by their indices, or places. Throws
  /// InputError for indices outside of the grid.
  PointBlock
  point_block(const ContactPoints &points, const HalfspaceGrid &grid);

  /// What CONTACT says of a point.
  struct PointStress
  {
    double                x = 0, y = 0, z = 0; ///< [m]
    HalfspaceStress       stress;              ///< [Pa]
    std::array<double, 3> principal{};         ///< falling [Pa]

    /// A third of the trace [Pa].
    double
    mean() const
    {
      return (stress.xx + stress.yy + stress.nn) / 3;
    }
  };

  /// Stresses at all points of a block, x slowest, z fastest.
  std::vector<PointStress>
  block_stresses(const PointBlock &block, const ContactMaterial &material, const HalfspaceSolution &solution);

  /// The same of each block of a case; nothing where it asks for none (S = 0).
  std::vector<std::vector<PointStress>>
  case_stresses(const ContactCase &one, const HalfspaceSolution &solution);
} // namespace wheelrail
