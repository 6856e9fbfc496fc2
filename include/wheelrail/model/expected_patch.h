#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/verdict/measures.h>

#include <string>

namespace wheelrail
{
  /// What is known of the contact before anything is computed, from the rigid profiles.
  struct ExpectedPatch
  {
    double approach = 0; ///< of wheel and rail under the static load [m]
    double length   = 0; ///< along the track [m]
    double width    = 0; ///< lateral, on the tread [m]
  };

  /// E* of Hertz's theory, 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 [Pa].
  double
  contact_modulus(const SteelSettings &scene);

  /// Weight of half axle and a wheel of usual mass (320 kg) [N].
  double
  expected_unsprung_weight(const WheelsetSettings &scene);

  /// What to say of a Wheelset/Wheel load below the weight of wheel and half axle, `unsprung` [N].
  std::string
  load_too_small(const Scene &scene, double unsprung);

  /// Load on one rail: Wheelset/Wheel load, or the weight of sprung mass, half axle and a wheel of usual mass
  /// [N].
  double
  expected_load(const WheelsetSettings &scene);

  /// Approach of Hertz's theory (1882), proportional to (F^2 / (R E*^2))^(1/3), scaled from steel, a
  /// radius of 460 mm and 100 kN, which have about 0.1 mm [m].
  double
  expected_approach(const Scene &scene, double rolling_radius);

  /// Size of the patch as the stretch where the undeformed profiles interpenetrate at 0.55 of the
  /// approach, the rule of Kik and Piotrowski (1996); some 10 % too long for a wheel on a rail head.
  ExpectedPatch
  expected_patch(const Scene &scene, const SceneGeometry &geometry);

  /// What a run will have of cells over the patch and of the penetration of its penalty law, before it: the
  /// patch 10 % shorter than expected, the penetration that of a circular contact of Hertz (1882) with this
  /// diameter d, whose peak pressure over its approach is 4 E*/(pi d).
  Measures
  expected_measures(const Scene &scene, const ExpectedPatch &patch);

  /// Measures::lost() by them, with true bodies that will judge the run or without.
  double
  expected_loss(const Scene &scene, const ExpectedPatch &patch);

  /// How well the peak pressure of a run will be known by that, and what is wanted, in words for the screen;
  /// empty where no rule is known, of fewer than three cells over the patch.
  std::string
  expected_accuracy(const Scene &scene, const ExpectedPatch &patch);

  /// Number of hexahedra of the mesh, to about a third: a fixed strip of solution cells on both
  /// bodies, the cells around it, and coarse cells in the rest.
  double
  expected_elements(const Scene &scene, const ExpectedPatch &patch);

  /// Number of processes that speed up a run of so many hexahedra where there are `cores`: a rank with fewer
  /// than some 4000 cells mostly evaluates the contact, which all of them do (doc/manual/cluster.md).
  unsigned int
  useful_ranks(double elements, unsigned int cores);

  /// Memory of a run on all ranks together [bytes]; its peak is in the static start.
  double
  expected_memory(double elements, unsigned int ranks);
} // namespace wheelrail
