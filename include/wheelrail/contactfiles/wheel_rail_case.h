#pragma once

#include <wheelrail/contactfiles/case_points.h>
#include <wheelrail/contactfiles/contact_case.h>
#include <wheelrail/contactfiles/gap_search.h>
#include <wheelrail/contactfiles/section_line.h>
#include <wheelrail/contactfiles/wheel_rail_pose.h>
#include <wheelrail/halfspace/kernels.h>
#include <wheelrail/halfspace/problem.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// A contact patch of a case of module 1 as CONTACT prints it: SI units, CONTACT's axes and signs, forces
  /// on the rail; y points to the right on both sides.
  struct WheelRailPatch
  {
    Vector3 in_track{}, on_rail{}, on_wheel{};  ///< the contact reference (CP) in the axes of each [m]
    double  angle    = 0;                       ///< DELTCP(TR)
    double  velocity = 0, step = 0;             ///< VELOC, DQ [m/s], [m]
    double  creepage = 0, lateral_creepage = 0; ///< CKSI, CETA; in shifts distances [m]
    double  spin      = 0;                      ///< CPHI [1/m]; in shifts an angle
    bool    backwards = false;                  ///< CHI = 180d
    double  friction  = 0;                      ///< FSTAT
    std::vector<double> friction_constants;     ///< as in the file, between its lines where V = 1, 2
    /// x forward, s across, both from the contact reference (in shifts and transient rolling from the
    /// origin of CONTACT's fixed grid, at `origin`), n into the rail.
    HalfspaceSolution solution;
    double            origin_x = 0, origin_y = 0; ///< the contact reference on that grid [m]
    double            spin_moment = 0;            ///< MN, about n through the contact reference [N m]
    /// On a curved reference surface (D = 4): the force along the normal and across, in the axes of the
    /// reference [N]; on a plane those of the solution.
    bool    curved       = false;
    double  normal_force = 0, lateral_force = 0;
    Vector3 force_track{}, force_wheelset{};
    Vector3 moment_rail{};     ///< about the origin of the rail's section, axes of the track [N m]
    Vector3 moment_wheelset{}; ///< about that of the wheel's, axes of the wheelset [N m]
    double  arc = 0;           ///< of the reference, along the rail's section from y = 0 [m]
    std::vector<std::vector<PointStress>> points; ///< below the surface, of each block (S = 1 to 3)
    std::vector<int> earlier;                     ///< patches of the case before that it goes on from, from 1
    double           y_low = 0, y_high = 0;       ///< of the overlap, in the track [m]
  };

  /// The solution of a case of module 1.
  struct WheelRailCase
  {
    double                      height     = 0; ///< Z_WS [m]
    double                      pitch_rate = 0; ///< VPITCH [rad/s]
    double                      along      = 0; ///< S_WS [m]
    double                      touching   = 0; ///< Z_WS at which wheel and rail first touch [m]
    Vector3                     deflection{};   ///< of a rail on springs (F = 3), in the track [m]
    Vector3                     force_track{}, force_wheelset{}; ///< sums over the patches
    std::vector<WheelRailPatch> patches;                         ///< from the field side to the track centre
    std::string                 refused;     ///< a sentence: what the case turns out to need; else empty
    std::string                 not_reached; ///< empty, or what was not reached, in words
  };

  /// What a solution may begin with: a case like it, and the influence functions of its patches.
  struct WheelRailStart
  {
    const WheelRailCase *guess = nullptr;
    KeptKernels          kernels; ///< those of this solution afterwards, too
  };

  /// Solves a case of module 1 without refusals(): finds height and pitch rate where forces are given (N = 1,
  /// F = 1). `before`: the case from which shifts and transient rolling go on, null: none; they go on from
  /// its tractions, with P = 1 from its pressures alone.
  WheelRailCase
  solve_wheel_rail(const ContactCase &one, const WheelRailCase *before, WheelRailStart &start);
  WheelRailCase
  solve_wheel_rail(const ContactCase &one, const WheelRailCase *before = nullptr);
} // namespace wheelrail
