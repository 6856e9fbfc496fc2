#pragma once

#include <wheelrail/wheel/halfspace_case.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Whether the scene's Half-space/Undeformed distance is hertz, rollers or a file.
  bool
  distance_is_given(const HalfspaceSettings &scene);

  /// Whether the half-spaces of a scene need wheel and rail in touch: for their distance or for the weight of
  /// the wheel.
  bool
  needs_profiles(const HalfspaceSettings &scene);

  /// Solves steady rolling with the undeformed distance of Half-space/Undeformed distance: Hertzian
  /// (Hertz, 1882), of rollers (roller_distance.h) or from a file. Normal force (auto: static wheel load of
  /// the wheel that touches the rail) or approach are given, the longitudinal force is traction coefficient x
  /// normal force, or with Drive = rate the creepage is given; spin is sin(Contact angle) / Radius along.
  /// Rail as body 1, no inclination of the contact plane. `geometry` may be null unless needs_profiles().
  /// Throws InputError for a faulty file, for a force and an approach at once or neither.
  WheelRailSolution
  solve_given_distance(const Scene &scene, const SceneGeometry *geometry);

  /// Distances of two undeformed surfaces on a regular grid, cubic in between (bilinear facets would cost
  /// 3 % of the peak pressure on steps of 0.4 mm).
  struct DistanceTable
  {
    std::vector<double> x, y;     ///< along the rolling direction and across, growing [m]
    std::vector<double> distance; ///< x.size() * y.size(), x fastest [m]

    /// At a place inside of the grid; outside, the value at the nearest place of its rim.
    double
    at(double place_x, double place_y) const;
  };

  /// Reads rows of three numbers x, y, distance in mm, in any order, one for each point of a regular grid;
  /// what follows # is a remark, commas count as blanks. Throws InputError with file and line for rows that
  /// are not three numbers, places that are missing or come twice, uneven steps (by more than 1 % of a
  /// step) and fewer than four lines each way.
  DistanceTable
  read_distance_file(const std::string &path);
} // namespace wheelrail
