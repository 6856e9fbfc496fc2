#pragma once

#include <wheelrail/contact/contact.h>
#include <wheelrail/solid/part.h>
#include <wheelrail/statics/start_tractions.h>
#include <wheelrail/wheelset/axle.h>

#include <functional>
#include <string>

namespace wheelrail
{
  class Discretization;

  /// What the static start is asked for.
  struct StaticLoads
  {
    AxleData axle;
    double   forward_radius     = 0.46; ///< way along the track for each angle that the wheel turns [m]
    double   yaw                = 0;    ///< of the axle, from Z to X [rad]
    double traction_coefficient = 0; ///< force along the wheelset over wheel load, when the drive is a torque
    bool   rate_held            = false;
    double creepage             = 0;    ///< when the rate is held
    bool   tractions            = true; ///< false: without shear, the creepage is still predicted
    double first_approach       = 1e-4; ///< lowering of the wheel that the search starts from [m]
    BeyondHalfspaces beyond;            ///< what the bodies give way under tractions; of the first rank alone
  };

  struct StaticResult
  {
    double  hub_displacement = 0; ///< vertical displacement of the axle [m]
    double  wheel_load       = 0; ///< weight of sprung mass, axle and wheel [N]
    double  creepage         = 0; ///< predicted, at the rolling radius of 2D-Geo
    Vector3 contact_force{};      ///< on the wheel [N]
    double  tread_stretch = 0;    ///< tread_stretch() under pressure alone; 0 for unlike materials
    int     newton_steps = 0, cg_steps = 0;
    int     flow_steps        = 0;    ///< of bodies that yield, after the elastic ones
    double  residual          = 0;    ///< largest nodal force out of balance over the wheel load
    bool    converged         = true; ///< else what is out of balance is small, or the patch is at the border
    bool    at_border         = false; ///< the patch touches the border of the fine cells
    bool    tractions_settled = true;  ///< else pressures and tractions still changed each other at the end
  };

  /// Static equilibrium of both bodies on the parts of the scene (all but contact and axle) under contact,
  /// weight, suspension preload and the centrifugal load of the turning wheel, with the shear tractions of
  /// the exact half-space theory.
  ///
  /// Newton's method on the explicit kernel's own forces: the kernel is the operator of the bodies at rest,
  /// to which the contact springs of the moment are added, see StaticSystem. The hub is moved; its height is
  /// one of the unknowns, with the vertical balance as its equation. The bodies begin with the displacement
  /// and the history that they have: a rail that has yielded before with its dents and residual stresses.
  /// Bodies that yield flow from this equilibrium to about their own, see static_flow(); the creepage stays
  /// that of elastic bodies. Fills solid.displacement, the history of elements that flow and the shear
  /// tractions of the contact. Throws RunError when it does not converge. Collective.
  StaticResult
  static_start(const Discretization                   &discretization,
               Solid                                  &solid,
               Contact                                &contact,
               const SceneParts                       &parts,
               const StaticLoads                      &loads,
               const std::function<void(std::string)> &report);
} // namespace wheelrail
