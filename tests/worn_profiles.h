#pragma once

// Wear of profiles by one wheel, on half-spaces of 1 mm elements, shared by several tests.

#include <wheelrail/wear/wear_evolution.h>

#include <functional>

namespace test
{
  /// One wheel of 100 kN; all wears over the rail. `gross_load` [kg].
  inline wheelrail::Scene
  wearing_scene(const double traction, const double gross_load)
  {
    wheelrail::Scene scene;
    scene.wheel_load             = 100e3;
    scene.traction_coefficient   = traction;
    scene.halfspace_element_size = 1e-3;
    scene.wear.archard           = 5e-4;
    scene.wear_plan.gross_load   = gross_load;
    return scene;
  }

  /// The profiles at the end of the plan.
  inline wheelrail::WearState
  worn(const wheelrail::Scene &scene, const std::function<void(const wheelrail::MachiningEvent &)> &tell = {})
  {
    double               weights = 1;
    wheelrail::WearState state   = wheelrail::begin_wear(wheelrail::read_profiles(scene));
    wheelrail::wear_on(
      scene,
      wheelrail::mix_rows(scene, scene.wheel_load, weights),
      [](const wheelrail::WearState &) {},
      state,
      tell);
    return state;
  }
} // namespace test
