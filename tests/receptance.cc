// A hammer on the rail: spectra of known records, the track by waves against beams on pads and sleepers, a
// blow on the elements against the waves, places and what is answered to unsuitable ones.

#include <wheelrail/application/command_line.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/receptance/hammer_places.h>
#include <wheelrail/receptance/spectra.h>
#include <wheelrail/receptance/track_waves.h>
#include <wheelrail/track/scene_track.h>

#include "messages.h"
#include "parallel.h"
#include "small_scene.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  using Complex = std::complex<double>;

  /// A mass on a spring and a damper, struck by a very short blow.
  void
  known_record()
  {
    constexpr double mass = 2, w0 = 2 * M_PI * 400, ratio = 0.02;
    for (const double duration : {0.2, 0.04})
      {
        BlowRecord record;
        record.step = 2e-5;
        record.moved.resize(1);
        const double wd = w0 * std::sqrt(1 - ratio * ratio);
        for (double t = 0; t < duration; t += record.step)
          {
            record.moved[0].push_back(std::exp(-ratio * w0 * t) * std::sin(wd * t) / (mass * wd));
            record.force.push_back(t == 0 ? 1 / record.step : 0); // of 1 N s
          }
        const Receptances found = receptances(record, 1, 20, 2000);
        BOOST_TEST(((found.fading > 0) == (duration < 0.1)), "faded where the motion is not over");
        std::vector<double> mobility;
        double              worst = 0;
        for (std::size_t k = 0; k < found.frequency.size(); ++k)
          {
            const Complex iw    = Complex(found.fading, 2 * M_PI * found.frequency[k]);
            const Complex exact = 1. / (mass * (iw * iw + 2 * ratio * w0 * iw + w0 * w0));
            worst               = std::max(
              worst, std::abs(found.of_face[0][k] - exact) / std::abs(1 / (2 * ratio * mass * w0 * w0)));
            mobility.push_back(2 * M_PI * found.frequency[k] * std::abs(found.of_face[0][k]));
          }
        BOOST_TEST(near(worst, 0, 0.02, "receptance of a mass on a spring, largest error over its peak"));
        const auto peaks = resonances(found.frequency, mobility);
        BOOST_REQUIRE_MESSAGE(peaks.size() == 1, "one resonance");
        BOOST_TEST(near_relative(peaks[0].frequency, 400, 0.005, "its frequency"));
        BOOST_TEST(near_relative(peaks[0].loss, 2 * ratio + 2 * found.fading / w0, 0.03, "its loss factor"));
      }
    std::vector<double> distance, amplitude;
    for (double z = 0; z < 4; z += 0.05)
      distance.push_back(z), amplitude.push_back(std::exp(-2 * z));
    BOOST_TEST(near_relative(decay_rate(distance, amplitude), 8.686 * 2, 0.01, "decay rate of exp(-2 z/m)"));
  }

  struct Peak
  {
    double frequency, mobility;
  };

  /// 60E1, upright, density 7850, in blocks of 16 mm.
  Scene
  track_scene()
  {
    Scene scene                 = small_scene(16e-3);
    scene.rail_profile          = "60E1";
    scene.track.inclination     = 0;
    scene.rail_material.density = 7850;
    scene.rail_length           = 8;
    scene.support.kind          = RailSupport::sleepers;
    scene.support.damped_ends   = 2.5;
    scene.support.sleeper_mass  = INFINITY;
    return scene;
  }

  /// The largest mobility between two frequencies where the hammer hits over a sleeper; all loss factors are
  /// constant: dampers are matched at each frequency.
  Peak
  peak(Scene scene, const Section &section, const double from, const double to)
  {
    TrackWaves waves(section,
                     elasticity(scene.rail_material),
                     scene.support.kind,
                     track_data(scene),
                     {rail_places(scene, section, "sleeper", false).faces[0]});
    const auto mobility = [&](const double f) {
      scene.support.pad_frequency = scene.support.ballast_frequency = f;
      waves.stand_on(track_data(scene));
      return 2 * M_PI * f * std::abs(waves.receptances(f, 0)[0]);
    };
    // golden section, to 0.4 %
    const double part = 0.5 * (std::sqrt(5.) - 1);
    double       a = from, b = to, c = b - part * (b - a), d = a + part * (b - a);
    double       fc = mobility(c), fd = mobility(d);
    while (b - a > 4e-3 * a)
      if (fc > fd)
        b = d, d = c, fd = fc, c = b - part * (b - a), fc = mobility(c);
      else
        a = c, c = d, fc = fd, d = a + part * (b - a), fd = mobility(d);
    return {0.5 * (a + b), std::max(fc, fd)};
  }

  /// Mobilities of a Timoshenko beam of 60E1 on discrete supports (rolland 10e8e9a,
  /// data_analytical_methods.csv): pads of 300 MN/m with a loss factor of 0.25 each 0.6 m, over a support.
  void
  against_a_beam(Scene scene, const Section &section)
  {
    // the mobility at the second is 26 % above that of the beam, which has no foot that gives way below the
    // pad
    for (const Peak &beam : {Peak{449, 1.706e-5}, Peak{1261, 6.76e-6}})
      {
        const Peak        found = peak(scene, section, 0.9 * beam.frequency, 1.1 * beam.frequency);
        const std::string at    = std::to_string(int(beam.frequency)) + " Hz";
        BOOST_TEST(near_relative(found.frequency, beam.frequency, 0.03, "rigid base, resonance at " + at));
        if (beam.frequency < 1000)
          BOOST_TEST(near_relative(found.mobility, beam.mobility, 0.15, "rigid base, mobility at " + at));
      }
    scene.support.sleeper_mass = 162;
    const Peak found           = peak(scene, section, 80, 115);
    BOOST_TEST(near_relative(found.frequency, 95.5, 0.03, "sleepers of 162 kg on 50 MN/m: resonance"));
    BOOST_TEST(near_relative(found.mobility, 4.99e-6, 0.15, "mobility"));
    const TrackWaves waves(section,
                           elasticity(scene.rail_material),
                           scene.support.kind,
                           track_data(scene),
                           {rail_places(scene, section, "sleeper", false).faces[0]});
    BOOST_TEST(near_relative(waves.pinned_pinned(), 1067, 0.03, "pinned-pinned over that of the beam"));
    // a record with two fifths of the mobility of the waves has lost 8 dB
    const double of_waves = 2 * M_PI * found.frequency * std::abs(waves.receptances(found.frequency, 0)[0]);
    const auto   cut      = most_cut({{found.frequency, 0.4 * of_waves, 0.05}}, waves, 0);
    BOOST_TEST(near(cut ? cut->decibel : 0, 7.96, 0.3, "a peak that a record cuts [dB]"));
    BOOST_TEST(!most_cut({{found.frequency, of_waves, 0.05}}, waves, 0), "a whole one is not cut");
  }

  /// A short blow on a rail on continuous pads.
  void
  blow_and_waves(Scene scene, const SceneGeometry &geometry)
  {
    scene.support.kind        = RailSupport::continuous_pads;
    scene.support.damped_ends = 2;
    scene.rail_length         = 5.6;
    const auto       body     = make_lone_body(scene, geometry, Body::rail, MPI_COMM_WORLD);
    const RailPlaces places   = rail_places(scene, body->plan.rail, "", false);
    const BlowRecord record   = strike(scene, *body, places.faces, 8e-3, MPI_COMM_WORLD);
    BOOST_TEST(near(record.energy_error, 0, 2e-3, "energy error of the blow"));
    const Receptances blow = receptances(record, 10, 300, 3000);
    const TrackWaves  waves(body->plan.rail,
                           elasticity(scene.rail_material),
                           scene.support.kind,
                           track_data(scene),
                           {places.faces[0], places.faces[1], places.faces[6]});
    for (std::size_t k = 0; k < blow.frequency.size(); k += 45)
      {
        const auto        second = waves.receptances(blow.frequency[k], blow.fading);
        const std::string at     = std::to_string(int(blow.frequency[k])) + " Hz: ";
        BOOST_TEST(
          near(std::abs(blow.of_face[0][k] / second[0]), 1, 0.06, at + "receptance by elements over waves"));
        BOOST_TEST(near(std::arg(blow.of_face[0][k] / second[0]), 0, 0.06, at + "its phase"));
      }
  }

  void
  messages(const Scene &scene, const Section &section)
  {
    const auto answer = [&](const Scene &of, const std::string &at) {
      return message_of([&]() { rail_places(of, section, at, false); });
    };
    Scene pads        = scene;
    pads.support.kind = RailSupport::continuous_pads;
    BOOST_TEST(same_text(
      answer(pads, "between"),
      "--at between: the scene has no sleepers; set Track/Support = sleepers, or give a place along the "
      "track, such as --at \"250 mm\"",
      "no sleepers"));
    BOOST_TEST(
      same_text(answer(scene, "3 m"),
                "--at 3 m: at 3000 mm the hammer hits the rail beside the stretch from -1497 mm to 1503 mm, "
                "where it is "
                "not damped; take another place, a longer Track/Rail length or shorter Track/Damped ends",
                "on a damped end"));
    const std::string unknown = answer(scene, "sleper");
    BOOST_TEST(
      (unknown.rfind("--at sleper: neither sleeper nor between nor a place along the track; ", 0) == 0),
      unknown);
    BOOST_TEST(near(
      rail_places(scene, section, "sleeper", false).along, 0.3, 1e-12, "the sleeper nearest to the middle"));
    BOOST_TEST(near(rail_places(scene, section, "between", false).along, 0, 1e-12, "the middle of a bay"));
  }
  void
  messages_of_the_command()
  {
    const auto answer = [](const Arguments &options) {
      Arguments all = {"receptance", std::string(WHEELRAIL_SOURCE_DIR) + "/prm/receptance.prm"};
      all.insert(all.end(), options.begin(), options.end());
      std::ostringstream out;
      return message_of([&]() { execute(all, RunFunction(), out); });
    };
    BOOST_TEST(same_text(answer({"--duration", "1 ms"}),
                         "--duration 1 ms: not between 5 ms and 1 s",
                         "a record that is too short"));
    BOOST_TEST(same_text(answer({"--body", "wheel", "--at", "sleeper"}),
                         "--at sleeper: a wheel is struck at its contact; leave it out",
                         "a place along the track for a wheel"));
    BOOST_TEST(same_text(answer({"--body", "sleeper"}),
                         "--body sleeper: not known here; rail or wheel is accepted",
                         "another body"));
    const auto beside = [](const std::string &text) {
      const std::string path = "receptance_beside.csv";
      std::ofstream(path) << text;
      return message_of([&]() { read_receptance_file(path); });
    };
    BOOST_TEST(same_text(beside("mobility [m/(N s)]\n1e-6\n"),
                         "receptance_beside.csv: no frequency; name a column \"frequency [Hz]\"",
                         "a table without frequencies"));
    BOOST_TEST(
      same_text(beside("frequency [Hz],phase [deg]\n100,10\n"),
                "receptance_beside.csv: nothing to draw; name a column receptance, mobility or accelerance",
                "a table of phases"));
    const MotionFile known = [] {
      std::ofstream("receptance_beside.csv") << "frequency [Hz],receptance [mm/kN],phase [deg]\n100,2,90\n";
      return read_receptance_file("receptance_beside.csv");
    }();
    BOOST_TEST(
      near_relative(known.find(MotionQuantity::receptance)->front(), 2e-6, 1e-12, "receptance in mm/kN"));
    BOOST_TEST(
      near_relative(known.find(MotionQuantity::phase)->front(), 0.5 * M_PI, 1e-12, "phase in degrees"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(receptance)
{
  const Parallel parallel;
  known_record();
  if (parallel.rank == 0)
    messages_of_the_command();
  const Scene         scene    = track_scene();
  const SceneGeometry geometry = make_geometry(scene);
  const Section       section  = sweep_plan(scene, geometry).rail;
  messages(scene, section);
  against_a_beam(scene, section);
  blow_and_waves(scene, geometry);
}
