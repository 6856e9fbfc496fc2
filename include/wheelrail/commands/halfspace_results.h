#pragma once

#include <wheelrail/output/summary.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/wheel/halfspace_case.h>
#include <wheelrail/wheel/halfspace_stresses.h>

#include <ostream>
#include <string>

namespace wheelrail
{
  /// What the commands that solve half-spaces write of a solution.
  struct HalfspaceResults
  {
    Summary           figures; ///< with the largest stresses
    HalfspaceStresses stresses;
    Contributions     contributions; ///< to the intervals of the figures
  };

  /// Prints what is computed, in words (scene_head()), with the load of a wheel [N].
  void
  print_head(const Scene &scene, double wheel_load, std::ostream &out);

  /// The figures of a solution of a scene, and the stresses below its patches.
  HalfspaceResults
  halfspace_results(const Scene &scene, const WheelRailSolution &solution);

  /// Prints a line on the largest von Mises stress.
  void
  print_stresses(const HalfspaceStresses &stresses, std::ostream &out);

  /// Writes the first patch of a solution into `folder`/halfspace.h5, others into halfspace_patch_2.h5 and so
  /// on.
  void
  write_halfspace_patches(const WheelRailSolution &solution, const std::string &folder);

  /// Writes wear and work of friction over the lateral place of each patch, in its own plane, as a table.
  void
  write_halfspace_wear(const Scene &scene, const WheelRailSolution &solution, const std::string &path);

  /// Writes the folder of one wheel: parameters.prm, the patches, slices.h5 (stresses below the contact, as a
  /// run's), summary.json and intervals.csv. Throws RunError.
  void
  write_halfspace_folder(const Scene             &scene,
                         const WheelRailSolution &solution,
                         const HalfspaceResults  &results,
                         const std::string       &folder);
} // namespace wheelrail
