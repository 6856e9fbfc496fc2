#pragma once

#include <wheelrail/material/material_point.h>
#include <wheelrail/output/figure_table.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wheelrail
{
  /// Extremes of a value over a cycle.
  struct Extent
  {
    double low = HUGE_VAL, high = -HUGE_VAL;

    void
    add(const double value)
    {
      low  = std::min(low, value);
      high = std::max(high, value);
    }
    double
    mean() const
    {
      return 0.5 * (low + high);
    }
  };

  /// What a cycle of a material test shows, shear strains as changes of the angle.
  struct MaterialCycle
  {
    Extent axial_strain, axial_stress, shear_strain, shear_stress;
    double accumulated = 0, work = 0, stored = 0; ///< at its end

    void
    add(const MaterialPoint &point);
  };

  /// A path that a point of a steel has gone through some times.
  struct MaterialAnswer
  {
    std::vector<MaterialCycle> cycles;
    FigureTable                steps; ///< states in between: stresses [MPa], energies [MJ/m3]
  };

  /// Goes through the targets so many times, in so many even steps from one to the next; what is driven
  /// by another quantity than before starts from where it is. The table gets every step, or about `rows` from
  /// one to the next (0: none). Throws RunError, which names the stress then, where the steel does not bear
  /// it, or where a normal strain comes to -0.5, a length of zero.
  MaterialAnswer
  drive_material(const MaterialLaw              &law,
                 const std::vector<PointTarget> &path,
                 unsigned int                    cycles,
                 unsigned int                    steps,
                 unsigned int                    rows);

  /// One row a cycle, in the units of the steps. Ratcheting of a cycle: by how much the middle of the strains
  /// has moved since the one before.
  FigureTable
  cycle_table(const std::vector<MaterialCycle> &cycles);

  /// Steps with which strains, stresses and ratcheting of the first cycles are within 0.1 % of those of
  /// infinitely many, from 200 to 100000: errors of the law are of first order, so that twice the steps show
  /// what is missing. Throws RunError as drive_material().
  unsigned int
  enough_material_steps(const MaterialLaw &law, const std::vector<PointTarget> &path, unsigned int cycles);
} // namespace wheelrail
