#pragma once

#include <wheelrail/contact/contact.h>
#include <wheelrail/halfspace/added_influence.h>
#include <wheelrail/planes/wheel_on_rail.h>
#include <wheelrail/statics/start_grid.h>

#include <functional>
#include <memory>
#include <vector>

namespace wheelrail
{
  /// Shear tractions and creepage that a run starts from.
  struct StartTractions
  {
    double               creepage  = 0;     ///< at the rolling radius of 2D-Geo, positive driving
    double               force     = 0;     ///< longitudinal force on the wheel that the tractions give [N]
    bool                 saturated = false; ///< the wanted force exceeds the friction bound
    bool                 converged = true;  ///< the half-space solver reached its tolerance
    std::vector<Vector3> traction;          ///< on the rail at every lattice node [Pa]

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &creepage &force &saturated &converged &traction;
    }
  };

  /// How the wheel rolls.
  struct StartMotion
  {
    double velocity;             ///< [m/s]
    double lateral_creepage = 0; ///< velocity of the wheel along X over that
    double stretch          = 0; ///< of the tread along the track less that of the head, tread_stretch() [-]
  };

  /// What the bodies give way beyond half-spaces on the grid of a plane; none: they are half-spaces there.
  using BeyondHalfspaces = std::function<std::shared_ptr<const AddedInfluence>(const StartGrid &)>;

  /// Steady shear tractions for a given longitudinal force [N, on the wheel], exact for two half-spaces
  /// under the pressures of `contact` (Kalker 1990; doc/theory/halfspace.md): every lateral strip slides with
  /// its own rolling radius and, ahead of and behind the axle, sideways with the inclined surface of the
  /// turning wheel (together: creepage and spin), and with the yaw of the wheel. Patches in several planes
  /// (start_grids()) have one creepage. Elements of at most 0.42 mm, an odd number a lattice node. The
  /// friction law is that of the contact, at the slip velocities of rolling with its velocity. Wanted forces
  /// are cut to 98 % of full slip at rest, and with friction that falls with speed to the largest that it
  /// carries (to 1 %); a law that is zero at rest starts without tractions.
  /// A tread that is stretched more than the head runs backwards against it by as much. The wheel's steel is
  /// that which the rail meets where both have moved to (facing_after_shift()). Under the tractions the
  /// bodies give way as `beyond` tells: the yaw of one against the other slides the wheel aside.
  StartTractions
  start_tractions(const Contact          &contact,
                  double                  longitudinal_force,
                  const HalfspaceSteels  &bodies,
                  const StartMotion      &motion,
                  const BeyondHalfspaces &beyond = {});

  /// The same with the creepage given instead of the force.
  StartTractions
  start_tractions_at_creepage(const Contact          &contact,
                              double                  creepage,
                              const HalfspaceSteels  &bodies,
                              const StartMotion      &motion,
                              const BeyondHalfspaces &beyond = {});
} // namespace wheelrail
