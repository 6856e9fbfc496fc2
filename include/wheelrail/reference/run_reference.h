#pragma once

#include <wheelrail/reference/halfspace_case.h>

#include <limits>
#include <string>

namespace wheelrail
{
  /// What the differences between a run and the half-spaces come from, each from a rule of
  /// doc/manual/compare.md.
  struct Trust
  {
    double peak_difference = 0; ///< (run - half-space) / half-space
    double cells           = 0; ///< solution cells over the shorter extent of the patch
    double penetration     = 0; ///< of the penalty law at the peak, over the approach
    double unsteadiness    = 0; ///< largest std of vertical and longitudinal force over vertical force
    double turn            = 0; ///< of the surfaces across the patch [rad]
    double pose_effect     = 0; ///< peak with the pose over peak without it, less 1
    double plastic_strain  = 0; ///< largest one of the run, 0 where nothing has flowed
    double patches         = 1; ///< separate ones of the run, where the half-spaces have not as many

    /// What the penalty contact takes from the peak, about: a layer of springs between the bodies. 0.85 p/(1
    /// + p) of the penetration p fits the runs of doc/theory/accuracy.md (f = 10: 0.7 %, f = 0.1: a third).
    double
    penalty_part() const
    {
      return -0.85 * penetration / (1 + penetration);
    }

    /// What the cells take from it, about: 1.3 over the square of their number (13 cells: 0.8 %, 7: 2.7 %);
    /// of fewer than three no such rule is known, and it is NaN.
    double
    mesh_part() const
    {
      return cells < 3 ? std::numeric_limits<double>::quiet_NaN() : -1.3 / (cells * cells);
    }
  };

  /// The measures of a run against the pressures of half-spaces under its load and in its pose, but for the
  /// effect of the pose.
  Trust
  trust_of(const Scene &scene, const Summary &run, const HalfspacePressure &halfspace);

  /// One sentence on how far the run can be trusted, and why.
  std::string
  trust_sentence(const Scene &scene, const Trust &trust, bool finished);

  /// Says by how much the peak pressure misses that of half-spaces, when by more than a tenth, and what that
  /// comes from; empty otherwise. Where half-spaces are no full reference (steel that has
  /// flowed, surfaces that turn, several patches) the miss is no fault of the run.
  struct PeakMiss
  {
    std::string sentence;
    bool        is_fault = false; ///< the run is off, not the reference
  };
  PeakMiss
  peak_miss(const Scene &scene, const Trust &trust);

  /// The load of a finished run: means of its vertical and longitudinal force.
  WheelRailLoad
  load_of_run(const Summary &run);

  /// Rolls and offset that the run's summary records; zero where it has none.
  SectionOffsets
  offsets_of_run(const Summary &run);
} // namespace wheelrail
