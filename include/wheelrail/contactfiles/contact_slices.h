#pragma once

#include <wheelrail/contactfiles/section_line.h>
#include <wheelrail/sections/sections_surface.h>

#include <memory>

namespace wheelrail
{
  /// The surface of the slices that a line of an input file names, of a rail or a wheel, mirrored and scaled
  /// as the line says. Throws InputError for what cannot be read.
  std::shared_ptr<const SectionsSurface>
  contact_slices(const ContactProfile &profile, bool wheel);

  /// Its section at a place [m] or an angle [rad]. Throws InputError where there is none.
  ProfileLine
  section_at(const SectionsSurface &slices, double place, bool wheel = false);
} // namespace wheelrail
