#include <wheelrail/model/scene_parts.h>
#include <wheelrail/track/damped_ends.h>
#include <wheelrail/track/scene_track.h>

#include <cmath>
#include <memory>

namespace wheelrail
{
  TrackData
  track_data(const TrackSettings &scene, const double farther)
  {
    const SupportData &support = scene.support;
    TrackData          track;
    track.continuous  = support.kind == RailSupport::continuous_pads;
    track.spacing     = support.spacing;
    track.first       = support.first_sleeper - farther;
    track.pad_length  = support.pad_length;
    track.pad_damping = support.pad_damping == PadLoss::constant
                          ? constant_loss(support.pad_loss)
                          : matched_damper(support.pad_loss, support.pad_frequency);
    // stiffnesses are given at that frequency
    const double at_rest = 1 / track.pad_damping.dynamic_stiffness(2 * M_PI * support.pad_frequency).real();
    track.pad = at_rest * Vector3{support.pad_lateral, support.pad_stiffness, support.pad_longitudinal};
    track.rigid_sleepers = std::isinf(support.sleeper_mass);
    track.sleeper_mass   = support.sleeper_mass;
    track.ballast        = {support.ballast_lateral, support.ballast_stiffness, support.ballast_longitudinal};
    track.ballast_damper = matched_damper(support.ballast_loss, support.ballast_frequency).damper;
    return track;
  }


  void
  add_track(const Scene &scene, const double farther, MPI_Comm communicator, SceneParts &parts)
  {
    if (scene.support.kind != RailSupport::clamped_foot)
      parts.push_back(std::make_unique<TrackSupport>(track_data(scene, farther), communicator));
    if (scene.support.damped_ends > 0)
      parts.push_back(std::make_unique<DampedEnds>(scene.support.damped_ends, communicator));
  }
} // namespace wheelrail
