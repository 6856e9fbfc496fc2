#pragma once

#include <wheelrail/material/material_point.h>
#include <wheelrail/scene/material_test.h>

#include <vector>

namespace wheelrail
{
  /// The targets of one cycle of a material test, the last one its end. Reads the file of the
  /// test, if there is one. Throws InputError when the test says nothing, when its lists do not fit each
  /// other, or when the file cannot be understood.
  std::vector<PointTarget>
  material_path(const MaterialTest &test);
} // namespace wheelrail
