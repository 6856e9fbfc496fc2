#pragma once

#include <wheelrail/damage/laws.h>
#include <wheelrail/damage/wear_plan.h>
#include <wheelrail/scene/contact_settings.h>
#include <wheelrail/scene/halfspace_settings.h>
#include <wheelrail/scene/irregularity_data.h>
#include <wheelrail/scene/material_test.h>
#include <wheelrail/scene/mesh_settings.h>
#include <wheelrail/scene/profile_settings.h>
#include <wheelrail/scene/run_settings.h>
#include <wheelrail/scene/steel_settings.h>
#include <wheelrail/scene/study.h>
#include <wheelrail/scene/track_settings.h>
#include <wheelrail/scene/wheelset_settings.h>

#include <array>
#include <string>

namespace wheelrail
{
  /// All values of one scene in SI units, as read from a .prm file. Functions take the settings that they
  /// need.
  struct Scene : ProfileSettings,
                 TrackSettings,
                 WheelsetSettings,
                 ContactSettings,
                 SteelSettings,
                 MeshSettings,
                 RunSettings,
                 OutputSettings,
                 HalfspaceSettings
  {
    std::string title;

    std::array<IrregularityData, most_irregularities> irregularities; ///< of the running surfaces

    WearData wear;      ///< laws of wear and cracks
    WearPlan wear_plan; ///< for the command wear

    MaterialTest material_test; ///< for the command material

    Study study; ///< the family that this scene stands for, for the command study

    /// Those of Wheelset, with the nominal radius of the track.
    WheelDimensions
    wheel_dimensions() const
    {
      WheelDimensions dimensions = wheel;
      dimensions.nominal_radius  = track.nominal_radius;
      return dimensions;
    }

    /// Whether the run ends as soon as its results are steady and known. Passages are compared at one place
    /// that all of them roll over, and a motion that is followed is never steady, nor is a wheel on irregular
    /// surfaces: these roll their path.
    bool
    until_steady() const
    {
      return rolling_distance == 0 && motion == "none" && !several_passages() && !irregular();
    }

    /// How far the mesh lets the wheel roll [m].
    double
    mesh_distance() const
    {
      return prepared_distance > 0 ? prepared_distance : path();
    }

    /// Whether a running surface is not the same all along: rail or wheel has an irregularity, or the rail is
    /// given by slices.
    bool
    irregular() const
    {
      if (rail_by_slices())
        return true;
      for (const IrregularityData &one : irregularities)
        if (one.kind != IrregularKind::none)
          return true;
      return false;
    }
  };

  /// Where the wheelset of a scene stands in its track, seen from the modelled wheel: a left one as its
  /// mirror image, in which X points to the track centre again.
  inline WheelsetPose
  wheelset_pose(const WheelsetSettings &scene)
  {
    const WheelsetPose pose{scene.lateral_shift, scene.roll, scene.roll_angle, scene.yaw};
    return scene.left_wheel ? mirrored(pose) : pose;
  }

  /// Lateral velocity of the wheelset over its velocity, seen likewise.
  inline double
  lateral_creepage(const WheelsetSettings &scene)
  {
    return scene.left_wheel ? -scene.lateral_creepage : scene.lateral_creepage;
  }

  /// Curvature of the wheelset's path, seen likewise: positive with the centre on the side of +X, where the
  /// modelled wheel is the outer one [1/m].
  inline double
  path_curvature(const Scene &scene)
  {
    return (scene.left_wheel ? -1 : 1) / scene.track_radius;
  }
} // namespace wheelrail
