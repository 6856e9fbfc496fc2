#pragma once

#include <wheelrail/scene/scene.h>

#include <ostream>

namespace wheelrail
{
  /// Drives one point of a steel of the scene through its material test: prints strains and stresses of each
  /// cycle, writes material.csv (all steps) and cycles.csv into the folder of the scene with "-material"
  /// behind its name, and draws the loops there unless switched off. Returns the exit code. Throws InputError
  /// and RunError.
  int
  run_material_command(const Scene &scene, bool draws, std::ostream &out);
} // namespace wheelrail
