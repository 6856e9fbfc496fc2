#pragma once

#include <wheelrail/material/material_point.h>
#include <wheelrail/scene/material_test.h>
#include <wheelrail/scene/scene.h>

#include <ostream>
#include <vector>

namespace wheelrail
{
  /// Drives one point of a steel of the scene through its material test: prints strains and stresses of each
  /// cycle, writes material.csv (all steps) and cycles.csv into the folder of the scene with "-material"
  /// behind its name, and draws the loops there unless switched off. Returns the exit code. Throws InputError
  /// and RunError.
  int
  run_material_command(const Scene &scene, bool draws, std::ostream &out);

  /// The targets of one cycle of a material test, the last one its end. Reads the file of the
  /// test, if there is one. Throws InputError when the test says nothing, when its lists do not fit each
  /// other, or when the file cannot be understood.
  std::vector<PointTarget>
  material_path(const MaterialTest &test);
} // namespace wheelrail
