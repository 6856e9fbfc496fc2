#pragma once

#include <wheelrail/sections/section_patch.h>

#include <vector>

namespace wheelrail
{
  /// A wheel that rolls at a place on rails by slices: its patches, each in its own plane, share its height
  /// and its load. Patches are more than a few millimetres apart and do not feel each other.
  struct SectionContacts
  {
    std::vector<TouchingPlace> touching;     ///< of the rigid wheel, first touch first
    double                     height = 0;   ///< of the wheel [m]
    std::vector<SectionPatch>  patches;      ///< those that carry
    bool                       found = true; ///< whether the load is carried to 1e-4 of it

    /// Force of all on the rails [N], in the track frame.
    Vector3
    force() const;
  };

  /// With the height at which all patches together carry a vertical load [N], what friction adds to it
  /// included. The rolling must outlive the result, and so must rails and wheel.
  SectionContacts
  contacts_under_load(const std::vector<SectionsSurface> &rails,
                      const PosedWheel                   &wheel,
                      const SectionRolling               &rolling,
                      double                              at,
                      double                              load);
} // namespace wheelrail
