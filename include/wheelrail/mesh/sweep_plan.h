#pragma once

#include <wheelrail/geometry/running_surfaces.h>
#include <wheelrail/geometry/touching_profiles.h>
#include <wheelrail/mesh/fine_strip.h>
#include <wheelrail/mesh/section.h>
#include <wheelrail/mesh/wheel_section.h>

#include <cmath>
#include <vector>

namespace wheelrail
{
  /// How the two sections are swept and where the finest cells go.
  ///
  /// Track frame: X towards the track centre, Y up, Z along the track in the rolling direction, Z = 0
  /// at the contact point of the start. The wheel's arc coordinate is the angle in front of the
  /// contact times the rolling radius, so that arc coordinate and Z meet in rolling. A wheel with yaw has the
  /// strip at the same values of s in its own section: its circles pass the rail's lines at an angle, and
  /// rows face each other in the middle of the patch only.
  struct SweepPlan
  {
    Section             rail;          ///< in the track plane; opposite edges of blocks point the same way
    std::vector<double> rail_stations; ///< coarse block borders along Z [m], ascending

    Section      wheel;         ///< (lateral, radius)
    unsigned int sectors = 180; ///< coarse blocks around the wheel

    FineStrip       strip;
    RunningSurfaces surfaces;
    unsigned int    levels     = 4;    ///< refinements from the coarse blocks to the finest cells
    double          fine_depth = 5e-3; ///< of the finest cells below the running surface [m]
    Range           fine;              ///< of Z and of the arc coordinate with finest cells, at the start [m]
    double          reach  = 0;        ///< of finest cells at both ends of the rolled stretch, beyond it [m]
    bool            moving = false;    ///< the finest cells go with the wheel
    Range           around_block;     ///< finest cells that move, with the contact in the block from 0 on [m]
    double          longest_path = 0; ///< that the rail lets the wheel roll when they move [m]
    int             start_block  = 0; ///< blocks by which the wheel starts farther along the rail

    /// The part of a wide strip in which finest cells lie while the contact is in each block of the path,
    /// from that of the start on [m]; none: all of the strip.
    std::vector<Range> across;

    /// Length of a coarse block on the running circle [m]; where the wheel rolls, the stations of the rail
    /// are its multiples, too.
    double
    block_length() const;

    /// Where the strip begins and ends across [m].
    Range
    whole_strip() const
    {
      return {strip.s.front(), strip.s.back()};
    }
  };

  /// Where surfaces overlap across once they are pressed together at a place of the path [m].
  struct OverlapAt
  {
    double place;
    Range  across;
  };

  /// The lengths that a sweep plan is made with [m].
  struct SweepSizes
  {
    double cell        = 0;     ///< of the finest cells
    double coarse      = 0;     ///< of the blocks; the nearest of cell, 2 cell, 4 cell, ... is taken
    double fine_depth  = 0;     ///< of the finest cells below the running surface
    double fine_margin = 0;     ///< of finest cells around the expected patch
    double approach    = 0;     ///< of wheel and rail under the load, expected
    double distance    = 0;     ///< that the wheel rolls
    bool   moving      = false; ///< the finest cells move with the wheel
    double rail_length = 0;     ///< its middle lies under that of the rolled stretch, without `start`
    double start       = 0; ///< how much farther along the rail the wheel starts; the nearest whole blocks
    double onward      = 1; ///< even blocks of the rail beyond them, for a run that is resumed to roll on
    Range  strip;           ///< of s with finest cells, whatever the patch; without length: around it

    // of a wheelset that is led
    Range across; ///< where patches come to lie besides that of the start, over s
    Range along;  ///< overlaps besides that of the start, from the contact point
    Range ahead;  ///< how far the contact moves along besides the path

    // of surfaces that change along the whole path: a wide strip has finest cells only where they overlap
    std::vector<OverlapAt> overlaps;
  };

  /// Lays out the sections, the strip of finest cells, and the stations along rail and wheel. The finest
  /// cells cover the rolled stretch and, before and behind it, the reach of the undeformed wheel
  /// (overlap_along(), at kik_piotrowski of the approach) and the margin, at least three cells. On irregular
  /// surfaces, whose impacts spread the patch, the whole approach counts, and cells that move reach farther.
  /// Those that move cover the path through one block in place of the whole stretch; at the start they reach
  /// no further than those that do not move. Blocks of the rail are even under the stretch and `onward`
  /// beyond it; from there on each is a quarter longer than the one before, up to four times as long; a rail
  /// that the wheel starts farther along has the same blocks, all of them as much nearer to the start. Throws
  /// InputError when the rail is too short for them or a section cannot be divided, RunError when a block
  /// would be folded.
  SweepPlan
  make_sweep_plan(const TouchingProfiles &profiles, const WheelDimensions &wheel, const SweepSizes &sizes);

  /// How often cells are divided, from coarse to finest ones [m].
  inline unsigned int
  mesh_levels(const double cell, const double coarse)
  {
    return static_cast<unsigned int>(std::fmax(0, std::round(std::log2(coarse / cell))));
  }

  /// Coarse blocks around a wheel, a whole number. `cell`, `coarse`: the sizes asked for [m].
  inline unsigned int
  blocks_around(const double rolling_radius, const double cell, const double coarse)
  {
    const double block = cell * std::pow(2., mesh_levels(cell, coarse));
    return static_cast<unsigned int>(std::round(2 * M_PI * rolling_radius / block));
  }

  /// Place along the rail where a wheel starts that is to start `farther` along than others: whole blocks
  /// [m].
  inline double
  start_in_blocks(const double farther, const double rolling_radius, const double cell, const double coarse)
  {
    const double length = 2 * M_PI * rolling_radius / blocks_around(rolling_radius, cell, coarse);
    return std::round(farther / length) * length;
  }
} // namespace wheelrail
