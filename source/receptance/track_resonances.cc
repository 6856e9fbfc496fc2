#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/receptance/hammer_places.h>
#include <wheelrail/receptance/track_waves.h>
#include <wheelrail/run/run_resonances.h>
#include <wheelrail/track/scene_track.h>

#include <boost/math/tools/minima.hpp>

#include <cmath>
#include <limits>

namespace wheelrail
{
  namespace
  {
    /// What the spectra of a run over irregular surfaces are read by [Hz].
    struct TrackResonances
    {
      /// A wave of the unsupported rail is twice as long as a bay; NaN without sleepers.
      double pinned_pinned;
      /// Wheel and rail swing against each other on the spring of their contact: where a height of the
      /// surfaces makes the largest force, 1/|a_rail + a_wheel + a_contact| with receptances a, between 200
      /// Hz and 3 kHz (Thompson 2009, section 5.2). The rail midway between two sleepers, by the waves of its
      /// section; the wheel as a rigid mass; the spring as Hertz has it under the wheel load.
      double contact;
    };

    /// Where a function of the frequency is least: of a grid, then between its neighbours [Hz].
    template <typename F>
    double
    least_at(const F &value, const double from, const double to)
    {
      constexpr double growth = 1.04;
      constexpr int    bits   = 10;
      double           best = from, least = std::numeric_limits<double>::infinity();
      for (double f = from; f <= to; f *= growth)
        if (const double v = value(f); v < least)
          least = v, best = f;
      return boost::math::tools::brent_find_minima(value, best / growth, best * growth, bits).first;
    }

    /// `unsprung_mass`: of wheel and half axle [kg]; `wheel_load` [N].
    TrackResonances
    track_resonances(const Scene         &scene,
                     const SceneGeometry &geometry,
                     const double         unsprung_mass,
                     const double         wheel_load)
    {
      constexpr double lowest = 200, highest = 3000;
      const SweepPlan  plan       = sweep_plan(scene, geometry);
      const bool       sleepers   = scene.support.kind == RailSupport::sleepers;
      Scene            endless    = scene;
      endless.rail_length         = 30;
      endless.support.damped_ends = 0;
      const HammerFace face = rail_places(endless, plan.rail, sleepers ? "between" : "", false).faces.front();
      const TrackWaves waves(plan.rail,
                             elasticity(scene.rail_material),
                             scene.support.kind,
                             track_data(scene, plan.start_block * plan.block_length()),
                             {face});
      // F = C d^(3/2)
      const double contact = expected_approach(scene, geometry.contact.rolling_radius) / (1.5 * wheel_load);
      const auto   give    = [&](const double f) {
        const double w = 2 * M_PI * f;
        return std::abs(waves.receptances(f, 0)[0] + contact - 1 / (unsprung_mass * w * w));
      };
      return {sleepers ? waves.pinned_pinned() : std::numeric_limits<double>::quiet_NaN(),
              least_at(give, lowest, highest)};
    }
  } // namespace


  void
  add_resonances(const Scene &scene, const SceneGeometry &geometry, const Model &model, Summary &summary)
  {
    const double unsprung = model.wheel_load / scene.gravity - model.axle.sprung_mass;
    const auto   track    = track_resonances(scene, geometry, unsprung, model.wheel_load);
    if (std::isfinite(track.pinned_pinned))
      set_figure(summary, "pinned_pinned_Hz", track.pinned_pinned);
    set_figure(summary, "contact_resonance_Hz", track.contact);
  }
} // namespace wheelrail
