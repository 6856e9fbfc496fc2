#pragma once

#include <wheelrail/halfspace/problem.h>

#include <vector>

namespace wheelrail
{
  /// What a particle of the surface meets on its path over one element, from the centre upstream (x + dx) to
  /// the centre of the element: the means of pressure [Pa] and tractions on body 1 [Pa] of both, and the slip
  /// over the path [-]. Of all elements of the grid; zero where neither is in contact.
  struct SlidingPaths
  {
    std::vector<double> pressure, traction_x, traction_y, slip_x, slip_y;
  };

  /// The paths of a steady solution on steps of one element, as steady problems have them. The slip of an
  /// element that a particle leaves the contact in, where the problem has no unknown, follows from the
  /// displacements: s = w + (u(x) - u(x + dx)) / dx, with the rigid slip w.
  SlidingPaths
  sliding_paths(const HalfspaceProblem &problem, const HalfspaceSolution &solution);

  /// Work that friction takes for each metre rolled: minus the sum of the means of tractions times slip
  /// [N = J/m]. The elastic part of the slip vanishes in this sum, since influence is mutual
  /// (sum of (t + t') (u - u') = 0 for like materials): it is the work of the creepages, but for the half
  /// cell by which the spin is counted upstream of the centres (HalfspaceProblem::spin_offset). NaN where the
  /// motion is not steady.
  double
  friction_work(const HalfspaceProblem &problem, const HalfspaceSolution &solution);
} // namespace wheelrail
