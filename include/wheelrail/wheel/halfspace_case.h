#pragma once

#include <wheelrail/geometry/surface_kinks.h>
#include <wheelrail/halfspace/problem.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/planes/contact_sections.h>
#include <wheelrail/sampling/patch_measures.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/verdict/interval.h>
#include <wheelrail/verdict/verdict.h>
#include <wheelrail/wheel/contact_reference.h>

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// What presses and drives the wheel.
  struct WheelRailLoad
  {
    double force        = 0;     ///< on the wheel: normal to the contact plane, or vertical [N]
    bool   vertical     = false; ///< the normal force N follows from N cos a + T sin a = force
    double longitudinal = 0;     ///< on the wheel, positive forward [N]
    bool   rate_held    = false; ///< `creepage` is given instead of the longitudinal force
    double creepage     = 0;     ///< at the rolling radius of 2D-Geo, positive driving
    bool   along_track  = false; ///< `longitudinal` counts along the track, else along the wheelset
    bool   slides       = false; ///< as a whole, so that friction bounds the force
  };

  /// Forces on a body in contact, gathered on rows of its running surface as a BodyTable has them.
  struct BodyLoads
  {
    int                               first = 0; ///< row
    std::vector<double>               along;     ///< places along the track from the first contact point [m]
    std::vector<std::vector<Vector3>> forces;    ///< along X, Y, Z on each row at each place [N]
  };

  /// Shares by which the noise of measured profiles may move results of a contact, in 95 of 100 cases; NaN
  /// where no profile is of a file.
  struct NoiseEffect
  {
    double peak = Measures::none, area = Measures::none, width = Measures::none, length = Measures::none,
           approach = Measures::none;
  };

  /// The half-space solution of wheel and rail. Tractions, forces and creepages of `solution` are those on
  /// the rail (body 1); its y is the coordinate s of the contact frame of 2D-Geo, along the rail.
  struct WheelRailSolution
  {
    HalfspaceProblem  problem; ///< as it was solved
    HalfspaceSolution solution;
    PatchFields       patch; ///< in the form and with the signs of a run's patch
    std::vector<Point2>
      row_edges; ///< of its rows across the rail: on the rail's surface, in the track plane [m]
    std::optional<Point2> centre;       ///< middle of the patch on the rail's surface, in the track plane [m]
    Placement             rail;         ///< of its section in that plane
    PatchMeasures         measures;     ///< of `patch`: area and extents from the edge line
    double                angle    = 0; ///< of the surfaces against X, mean over the pressure [rad]
    double                spin     = 0; ///< d w_y / dx at the centre of pressure [1/m]
    double                turn     = 0; ///< of the surfaces across the patch, edge to edge [rad]
    double                lateral  = 0; ///< force on the wheel along X [N]
    double                vertical = 0; ///< force on the wheel upwards [N]
    double                roll     = 0; ///< of the wheelset, from X to Y [rad]
    double                ahead =
      0; ///< of the first contact point, from which places along the rail count, ahead of the axle [m]
    std::optional<ContactReference> reference;  ///< of wheel and rail; none where the distance is given
    double      shift_effect  = Measures::none; ///< of half-spaces, of all patches, see shift_effect()
    double      bodies_effect = Measures::none; ///< of half-spaces, see hold_against_bodies()
    std::string unheld;                         ///< why the latter cannot be, or is not all; empty: it is
    std::map<std::string, double> bodies; ///< results of the true bodies under the same forces, by their keys
    NoiseEffect                   noise_effect; ///< see noise_effect()
    SurfaceKinks                  kinks;        ///< of the surfaces under pressure
    std::string made_up; ///< part of a profile that no file holds and the patch lies on, see made_up_part()
    std::vector<std::string> notes;            ///< what was done to files that were read for it
    double                   time         = 0; ///< computing time [s]
    int                      enlargements = 0; ///< of the grid, until the contact did not touch its edge
    std::array<BodyLoads, 2> body_loads;       ///< of true bodies: on the rail, on the wheel
    /// Patches beside this one, in planes of their own. What is above is of one patch each.
    std::vector<WheelRailSolution> others;
  };

  /// The normal contact of wheel and rail without what friction adds to it.
  struct HalfspacePressure
  {
    double           peak = 0, approach = 0; ///< [Pa], [m]
    double           width = 0, length = 0;  ///< extents of the patch across and along the rail [m]
    double           turn = 0;               ///< of the surfaces across the patch, edge to edge [rad]
    ContactReference reference;              ///< creepages and spin of the rigid bodies, without forces
    double           patches = 1; ///< in planes of their own; what is above is that of the highest pressure
  };

  /// The sum of a quantity over all patches of a solution.
  double
  sum_over_patches(const WheelRailSolution                                &result,
                   const std::function<double(const WheelRailSolution &)> &of);

  /// At the rolling radius of 2D-Geo; NaN where a wheel spins up and has no steady one, and without friction.
  double
  steady_creepage(const WheelRailSolution &result);

  /// What the scene's own entries ask for: static wheel load, traction coefficient or creepage.
  WheelRailLoad
  scene_load(const Scene &scene, const SceneGeometry &geometry);

  /// Offsets of the scene's subsection Half-space.
  SectionOffsets
  scene_offsets(const HalfspaceSettings &scene);

  /// Solves the contact of the profiles in steady rolling by half-spaces, in one plane or, where the wheel
  /// has contacts in planes that differ by more than 0.1 (separate_regions()), each in its own. The
  /// undeformed distance is that of the exact surfaces; materials, friction, speed, element size and spin are
  /// those of the scene (doc/manual/compare.md). Where the longitudinal force exceeds friction the whole
  /// patch slides, see solve_carried().
  WheelRailSolution
  solve_halfspaces(const Scene          &scene,
                   const SceneGeometry  &geometry,
                   const WheelRailLoad  &load,
                   const SectionOffsets &offsets);

  /// Notes on all patches of a solution which part of a profile that no file holds they lie on.
  void
  name_made_up(const SceneGeometry &geometry, WheelRailSolution &result);

  /// The normal problem of solve_wheel_rail() alone, under a force normal to the contact plane [N], with the
  /// rigid slip of a wheel that rolls with `creepage`: some hundredths of a second.
  HalfspacePressure
  halfspace_pressure(const Scene          &scene,
                     const SceneGeometry  &geometry,
                     double                normal_force,
                     const SectionOffsets &offsets,
                     double                creepage = 0);

  /// The same figures of a solution with friction.
  HalfspacePressure
  halfspace_pressure(const WheelRailSolution &result);

  /// How far the pressure of a patch can be trusted, without the others.
  Verdict
  judge_patch(const Scene &scene, const WheelRailSolution &result);

  /// The figures of a solution under the names of a run's summary, in its signs. Of several patches forces,
  /// areas and work are sums, pressures and tractions the largest, and extents, places and creepages those of
  /// the patch with the largest force; the figures of each stand under "patch_1_...", in the order of
  /// `result` and its `others`. What intervals are made of is added to `contributions`.
  Summary
  halfspace_summary(const Scene             &scene,
                    const WheelRailSolution &result,
                    Contributions           *contributions = nullptr);
} // namespace wheelrail
