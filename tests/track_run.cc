// ranks: 2
// Runs over rails on pads and on sleepers, as scenes ask for them: the static start stands on them, energy
// closes, very stiff pads are a clamped foot.

#include "parallel.h"
#include "read_output.h"
#include "small_scene.h"
#include "stopped_runs.h"

#include <wheelrail/base/format_text.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/run/run_start.h>
#include <wheelrail/scene/rail_bending.h>
#include <wheelrail/track/track_support.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  Scene
  on(const RailSupport kind, const double length)
  {
    Scene scene               = small_scene(4e-3);
    scene.rail_length         = length;
    scene.support.kind        = kind;
    scene.ticks               = 1;
    scene.volume_fields       = false;
    scene.checkpoint_interval = 1e4;
    scene.folder              = "track";
    return scene;
  }

  Summary
  result_of(const Scene &scene, const std::string &what)
  {
    BOOST_TEST(run(scene, false) == 0, what + ": the run ends");
    Summary summary = read_summary("track/summary.json");
    BOOST_TEST(summary.energy_error < 2e-3,
               what + ": energy error below 0.2 %: " + std::to_string(100 * summary.energy_error) + " %");
    return summary;
  }

  BOOST_FIXTURE_TEST_CASE(very_stiff_pads, test::Parallel)
  {
    const Summary clamped = result_of(on(RailSupport::clamped_foot, 1.2), "clamped foot");
    Scene         scene   = on(RailSupport::continuous_pads, 1.2);
    for (double SupportData::*stiffness :
         {&SupportData::pad_stiffness, &SupportData::pad_lateral, &SupportData::pad_longitudinal})
      scene.support.*stiffness = 1e12;
    const Summary stiff = result_of(scene, "very stiff pads");
    const auto    ratio = [&](const double Summary::*figure, const std::string &what) {
      BOOST_TEST(
        near(stiff.*figure / clamped.*figure, 1, 0.01, "very stiff pads over a clamped foot: " + what));
    };
    ratio(&Summary::vertical_force, "vertical force");
    ratio(&Summary::longitudinal_force, "longitudinal force");
    ratio(&Summary::max_pressure, "peak pressure");
    ratio(&Summary::contact_area, "area");
    ratio(&Summary::max_shear_traction, "peak shear");
    BOOST_TEST(!std::isfinite(get_figure(clamped, "foot_deflection_m")), "a clamped foot has no deflection");
    BOOST_TEST(get_figure(stiff, "foot_deflection_m") < 1e-6, "very stiff pads hardly give way");
  }

  /// The same track at rest and in the first millimetres.
  BOOST_FIXTURE_TEST_CASE(on_sleepers, test::Parallel)
  {
    Scene scene                = on(RailSupport::sleepers, 4);
    scene.support.pad_damping  = PadLoss::constant;
    scene.support.damped_ends  = 1;
    scene.support.sleeper_mass = 162;
    Model model                = make_model(scene, make_geometry(scene), MPI_COMM_WORLD);
    Log   log;
    start_from_rest(scene, model, {}, log);
    const auto &track = dynamic_cast<const TrackSupport &>(*model.parts.front());
    BOOST_TEST(near(track.force_at_rest(model.solid)[1] / model.wheel_load,
                    -1,
                    2e-3,
                    "the static start stands on the pads: what they bear over the wheel load"));
    double ballast = 0;
    for (const Vector3 &place : track.sleeper_places())
      ballast += place[1] * scene.support.ballast_stiffness;
    BOOST_TEST(near(ballast / model.wheel_load, -1, 2e-3, "and on the ballast"));

    const Summary summary = result_of(scene, "sleepers");
    BOOST_TEST(near(get_figure(summary, "first_force_over_load"), 1, 5e-3, "first force over the load"));
    BOOST_TEST(near(summary.vertical_force / model.wheel_load, 1, 0.02, "mean force over the load"));
    // pads are softer at rest than at the frequency that they are given for
    const double beam = rail_bending(scene.support).deflection * model.wheel_load,
                 foot = get_figure(summary, "foot_deflection_m");
    BOOST_TEST(near(foot / beam, 1.1, 0.15, "deflection over that of Winkler's beam"));
    const double most = get_figure(summary, "largest_pad_force_N") / model.wheel_load;
    BOOST_TEST((most > 0.2 && most < 0.5),
               "the most loaded pad bears a part of the load: " + std::to_string(most));
    BOOST_TEST(get_figure(summary, "largest_pad_pull_N") >= 0, "lifted pads pull");
    const History history = read_history("track/history.h5");
    for (const std::string &name : split_list("foot_deflection, pad_energy, pad_dissipation, sleeper_energy, "
                                              "ballast_energy, ballast_dissipation, end_dissipation"))
      BOOST_TEST((std::find(history.names.begin(), history.names.end(), name) != history.names.end()),
                 std::string("the history has ") + name);
  }
} // namespace
