// ranks: 1 2

// A rail on pads and sleepers: laws of damping, very stiff pads against a clamped foot, energy balance, and
// runs that go on from a saved state.

#include <wheelrail/dynamics/rolling.h>
#include <wheelrail/run/run_start.h>
#include <wheelrail/state/checkpoint.h>
#include <wheelrail/track/track_support.h>

#include "checkpoint_everywhere.h"
#include "parallel.h"
#include "small_scene.h"
#include "stands_on.h"

#include <algorithm>
#include <cmath>
#include <memory>

using namespace wheelrail;
using namespace test;

namespace
{
  double
  loss_factor(const PadDamping &damping, const double frequency)
  {
    const auto stiffness = damping.dynamic_stiffness(2 * M_PI * frequency);
    return stiffness.imag() / stiffness.real();
  }

  void
  laws_of_damping()
  {
    const PadDamping damper = matched_damper(0.25, 449);
    BOOST_TEST(near(loss_factor(damper, 449), 0.25, 1e-12, "one damper: its loss factor at its frequency"));
    BOOST_TEST(near(loss_factor(damper, 1261), 0.702, 1e-3, "and in proportion at another"));
    for (const double loss : {0.02, 0.1, 0.25, 0.5})
      {
        const PadDamping constant = constant_loss(loss);
        double           low = 1e300, high = 0;
        for (double f = constant_loss_from; f <= constant_loss_to; f *= 1.02)
          {
            low  = std::min(low, loss_factor(constant, f));
            high = std::max(high, loss_factor(constant, f));
          }
        BOOST_TEST(
          near(0.5 * (low + high) / loss, 1, 0.01, "three branches: loss factor over the wanted one"));
        BOOST_TEST(high - low < 0.08 * loss, "and it is constant to 4 %");
        for (const PadDamping::Branch &branch : constant.branches)
          BOOST_TEST((branch.share > 0 && branch.time > 0), "springs and dampers that lose energy");
      }
    const PadDamping quarter = constant_loss(0.25);
    const auto stiffness     = [&](const double f) { return quarter.dynamic_stiffness(2 * M_PI * f).real(); };
    BOOST_TEST(near(stiffness(1261) / stiffness(449), 1.175, 0.01, "a constant 0.25 stiffens by causality"));
  }

  struct Track
  {
    Scene                     scene;
    Model                     model;
    std::unique_ptr<Axle>     axle;
    std::unique_ptr<Rolling>  rolling;
    std::unique_ptr<Recorder> recorder;

    explicit Track(const Scene &of)
      : scene(of)
      , model(make_model(scene, make_geometry(scene), MPI_COMM_WORLD))
    {
    }

    void
    set_out(const double hub_displacement, const double rate)
    {
      axle    = std::make_unique<Axle>(model.axle, hub_displacement, rate, MPI_COMM_WORLD);
      rolling = std::make_unique<Rolling>(
        model.solid, *model.contact, model.parts, *axle, time_scheme(scene, model), MPI_COMM_WORLD);
      recorder = std::make_unique<Recorder>(model);
    }

    void
    start()
    {
      Log            log;
      const RunStart start = start_from_rest(scene, model, {}, log);
      set_out(start.hub_displacement, start.rate);
    }
  };

  void
  very_stiff_pads()
  {
    TrackData stiff;
    stiff.continuous  = true;
    stiff.pad         = {1e12, 1e12, 1e12};
    Scene scene       = small_scene(4e-3);
    scene.rail_length = 1.2; // the ends are clamped in one and free in the other: let them be far away
    Track one(scene), other(scene);
    put_on(other.model, stiff);
    one.start(), other.start();
    for (int n = 1; n <= 20; ++n)
      {
        one.rolling->step(n == 20);
        other.rolling->step(n == 20);
      }
    const ContactSums &a = one.rolling->contact_sums(), &b = other.rolling->contact_sums();
    BOOST_TEST(
      near(b.force[1] / a.force[1], 1, 0.01, "very stiff pads: vertical force over that on a clamped foot"));
    BOOST_TEST(near(b.force[2] / a.force[2], 1, 0.01, "longitudinal force"));
    BOOST_TEST(near(b.largest_pressure / a.largest_pressure, 1, 0.01, "peak pressure"));
    BOOST_TEST(near(other.axle->height() / one.axle->height(), 1, 0.01, "height of the axle"));
  }

  /// On sleepers that lie close, with pads that have a state of their own.
  Track
  on_sleepers()
  {
    Scene scene       = small_scene(4e-3);
    scene.rail_length = 0.6;
    Track     track(scene);
    TrackData data;
    data.spacing        = 0.2;
    data.pad_length     = 0.08;
    data.first          = 0.05;
    data.pad            = {40e6, 200e6, 40e6};
    data.pad_damping    = constant_loss(0.25);
    data.rigid_sleepers = false;
    data.sleeper_mass   = 160;
    data.ballast        = {25e6, 50e6, 25e6};
    data.ballast_damper = matched_damper(1, 100).damper;
    put_on(track.model, data);
    return track;
  }

  Checkpoint
  saved(const Track &track, const int rank)
  {
    return test::everywhere(
      gather_checkpoint(take_checkpoint(track.model, *track.rolling, *track.recorder), MPI_COMM_WORLD), rank);
  }

  void
  energy_and_resume(const int rank)
  {
    Track track = on_sleepers();
    track.start();
    Rolling &rolling = *track.rolling;
    double   worst   = 0;
    for (int n = 1; n <= 60; ++n)
      {
        rolling.step(n == 1 || n % 5 == 0);
        worst = std::max(worst, rolling.energy().error());
        if (n == 1)
          BOOST_TEST(near(rolling.contact_sums().force[1] / track.model.wheel_load,
                          1,
                          0.005,
                          "the static start stands on pads and sleepers: first force over the weight"));
      }
    const Checkpoint whole = saved(track, rank);
    BOOST_TEST(!whole.rolling.parts.at("track").values.empty(), "the pads' own state is saved");
    for (int n = 61; n <= 120; ++n)
      {
        rolling.step(n % 5 == 0);
        worst = std::max(worst, rolling.energy().error());
      }
    BOOST_TEST(near(worst, 0, 2e-3, "energy error, largest"));
    const EnergyBalance &energy = rolling.energy();
    BOOST_TEST((energy["pad_energy"] > 1 && energy["ballast_energy"] > 1 && energy["sleeper_energy"] > 0 &&
                energy["pad_dissipation"] > 0 && energy["ballast_dissipation"] > 0),
               "named energies");

    Track again = on_sleepers();
    again.set_out(0, 0);
    restore_checkpoint(whole, again.model, *again.rolling, *again.recorder, MPI_COMM_WORLD);
    for (int n = 61; n <= 120; ++n)
      again.rolling->step(n % 5 == 0);
    BOOST_TEST((again.axle->height() == track.axle->height() &&
                again.rolling->energy()["pad_energy"] == energy["pad_energy"] &&
                again.rolling->energy()["pad_dissipation"] == energy["pad_dissipation"]),
               "a run that goes on makes the same steps, bit for bit");
  }
} // namespace


BOOST_AUTO_TEST_CASE(track_support)
{
  const Parallel parallel;
  laws_of_damping();
  very_stiff_pads();
  energy_and_resume(parallel.rank);
}
