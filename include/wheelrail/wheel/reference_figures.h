#pragma once

#include <wheelrail/output/summary.h>
#include <wheelrail/wheel/contact_reference.h>

namespace wheelrail
{
  /// Adds the place of a reference point ahead of the axle, its angle, and creepages and spin there; NaN in
  /// their place where they are not `determined`.
  void
  set_reference_figures(const ContactReference &at, bool determined, Summary &summary);
} // namespace wheelrail
