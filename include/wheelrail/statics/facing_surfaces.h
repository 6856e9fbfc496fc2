#pragma once

#include <wheelrail/base/vector3.h>
#include <wheelrail/statics/start_grid.h>

#include <vector>

namespace wheelrail
{
  /// Displacements of the rail's nodes in the window, as gathered; zero elsewhere [m].
  std::vector<Vector3>
  rail_displacements(const Contact &contact);

  /// How much more the tread is stretched along the track in the patch than the head [-]: of the place of the
  /// wheel's steel along the track over its arc, less d u_z / d z of the rail, the slope of least squares
  /// over the loaded nodes, lines of nodes along the track with means of their own. The arc z + z^3/(6 r^2)
  /// is what the wheel's turning counts: with z in its place the flattening of the surface would count as
  /// stretch, z^2/(2 r^2) or 0.13e-4 in the main scene. Half-spaces of one material are stretched alike by
  /// pressure; bodies of finite size are not, and a wheel whose tread is longer turns slower by as much
  /// (doc/theory/bodies.md). To be asked under pressure alone: tractions stretch both surfaces, too, which
  /// the half-space theory of the start knows. `rail_before`: what the rail began with, as the residual shape
  /// that earlier wheels left stands still in the steel and is no velocity.
  double
  tread_stretch(const Contact &contact, const std::vector<Vector3> &rail_before);

  /// How much farther out on its profile the wheel's steel lies than the rail's that it rests on, because
  /// both have moved aside under the load; along the plane, mean over its pressure [m].
  double
  facing_after_shift(const Contact &contact, const StartGrid &loaded);
} // namespace wheelrail
