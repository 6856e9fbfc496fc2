#pragma once

#include <wheelrail/contactfiles/contact_case.h>
#include <wheelrail/contactfiles/inp_words.h>

namespace wheelrail
{
  // The groups of values of a case, in the order of the file. What the digits as written ask for is read
  // into `one`, which holds the values of the case before.

  /// Solver, and in module 3 forces and creepages, friction and rolling.
  void
  read_general_groups(InpWords &words, ContactCase &one);

  /// Influence functions, material, damping and heat.
  void
  read_material_groups(InpWords &words, ContactCase &one);

  /// One line of the friction law for each place (V = 1, 2) or row (V = 3).
  void
  read_friction(InpWords &words, ContactCase &one, std::size_t count);

  /// Module 1: elements, track, wheelset.
  void
  read_wheel_rail_groups(InpWords &words, ContactCase &one);

  /// Module 3: potential contact, undeformed distance, friction by rows, extra rigid slip.
  void
  read_grid_groups(InpWords &words, ContactCase &one);

  /// Points below the surface.
  void
  read_points(InpWords &words, ContactCase &one);
} // namespace wheelrail
