#pragma once

#include <wheelrail/base/simd.h>
#include <wheelrail/solid/part.h>
#include <wheelrail/wheelset/axle.h>

namespace wheelrail
{
  /// Velocities of steady rolling for the static field: the wheel turns at `pitch_rate` while its
  /// field is steady in the frame of the axle, v = V + (I + grad u)(omega x r), V with what a path leads
  /// besides; the rail's field runs along with the contact, v = -V d(u - still)/dz, where `still` is what
  /// stays in place, the displacement before the start (4 numbers a node); on the wheel what turns with it.
  /// Without `travelling` fields the wheel turns as a rigid body and the rail rests. What `parts` hold has no
  /// velocity, and their own unknowns start with the field. Collective.
  void
  rolling_velocities(Solid                       &solid,
                     const SceneParts            &parts,
                     const AxleData              &axle,
                     double                       pitch_rate,
                     const AlignedVector<double> &still,
                     bool                         travelling = true);
} // namespace wheelrail
