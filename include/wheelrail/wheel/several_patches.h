#pragma once

#include <wheelrail/planes/common_creepage.h>
#include <wheelrail/wheel/plane_contact.h>

#include <cstddef>
#include <string>
#include <vector>

namespace wheelrail
{
  /// The regions of the contacts that a wheel has with its rail at once, where their planes differ by
  /// `least_turn` or more [rad]: that of the first contact point, and those of further points that the
  /// approach of `one`, the contact as solved in the plane of the first point alone, closes. Patches in
  /// nearly the same plane, and points that one patch connects, are one region. From the first point on, in
  /// the order of ContactGeometry::further; the profiles are divided where they are farthest apart between
  /// two points.
  std::vector<ContactRegion>
  separate_regions(const SceneGeometry  &geometry,
                   const SectionOffsets &offsets,
                   const PlaneContact   &one,
                   double                least_turn = same_plane);

  /// Solves the contacts of several regions, each in its own plane. The wheel is lowered as a whole, so that
  /// the approach of a region is the lowering times the cosine of its inclination less the least distance
  /// there; the half-spaces are pressed down by the forces of the other patches as by point loads at their
  /// centres (Boussinesq 1885), whose component along the normal counts. All patches have the wheel's one
  /// creepage (or the one lateral creepage and yaw) and share the force that drives. `one` gives the first
  /// guess.
  ///
  /// The result is the patch of the first contact point, with the others in `others`; each has its own
  /// forces.
  WheelRailSolution
  solve_together(const Scene                      &scene,
                 const SceneGeometry              &geometry,
                 const WheelRailLoad              &load,
                 const SectionOffsets             &offsets,
                 const std::vector<ContactRegion> &regions,
                 const PlaneContact               &one);

  /// Before the keys of figures of one patch, from 1: "patch_2_".
  std::string
  patch_prefix(std::size_t number);
} // namespace wheelrail
