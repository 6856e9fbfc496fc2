// label: long

// What comes back from the damped ends of a rail: a blow in the middle of a free rail, once with damped ends
// and once on a rail so long that nothing comes back from its ends meanwhile. The difference is what the ends
// threw back, their growing blocks included. "table" as argument: ends of half and of twice the length, too.

#include <wheelrail/model/model.h>
#include <wheelrail/receptance/blow.h>
#include <wheelrail/receptance/hammer_places.h>

#include "parallel.h"
#include "small_scene.h"

#include <cmath>
#include <complex>
#include <iostream>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  constexpr double undamped = 2;     ///< on either side of the blow [m]
  constexpr double duration = 13e-3; ///< waves of bending run 2.2 km/s at most
  constexpr double without  = 16;    ///< half of the long rail [m]

  /// Displacements of the head farther and farther along a free rail that is struck in its middle.
  BlowRecord
  blow(const double half, const double ends, const bool lateral)
  {
    Scene scene                  = small_scene(16e-3);
    scene.rail_profile           = "60E1";
    scene.track.inclination      = 0;
    scene.rail_material.density  = 7850;
    scene.rail_length            = 2 * half;
    scene.support.kind           = RailSupport::continuous_pads;
    scene.support.damped_ends    = ends;
    const SceneGeometry geometry = make_geometry(scene);
    // nodes lie alike on both sides of the middle
    scene.rolling_distance = 2 * sweep_plan(scene, geometry).block_length();
    const auto body        = make_lone_body(scene, geometry, Body::rail, MPI_COMM_WORLD);
    body->parts.erase(body->parts.begin()); // the pads
    const HammerFace        struck = rail_places(scene, body->plan.rail, "", lateral).faces[0];
    std::vector<HammerFace> faces  = {struck};
    for (double z = 0.6; z < undamped - 0.1; z += 0.1)
      {
        faces.push_back(struck);
        faces.back().middle[2] += z;
      }
    return strike(scene, *body, faces, duration, MPI_COMM_WORLD);
  }

  /// Of the acceleration, which fades out over the last fifth of the record: its slow waves, which ends do
  /// throw back, are small.
  std::complex<double>
  spectrum(const std::vector<double> &u, const double step, const double frequency)
  {
    std::complex<double> sum  = 0;
    const std::size_t    last = u.size() - 1;
    for (std::size_t n = 1; n < last; ++n)
      {
        const double left  = double(last - n) / (0.2 * last);
        const double share = left < 1 ? 0.5 - 0.5 * std::cos(M_PI * left) : 1;
        sum += share * (u[n + 1] - 2 * u[n] + u[n - 1]) * std::polar(1., -2 * M_PI * frequency * n * step);
      }
    return sum;
  }

  /// What one end throws back over what runs into it, roots of mean squares over the faces and a band of 120
  /// Hz. Where waves from both ends meet, their squares add up in the mean along the rail.
  double
  reflection(const BlowRecord &record, const BlowRecord &endless, const double frequency)
  {
    double back = 0, by = 0;
    for (double f = frequency - 60; f < frequency + 61; f += 15)
      for (std::size_t face = 1; face < record.moved.size(); ++face)
        {
          const auto all  = spectrum(record.moved[face], record.step, f);
          const auto runs = spectrum(endless.moved[face], endless.step, f);
          back += std::norm(all - runs);
          by += std::norm(runs);
        }
    return std::sqrt(0.5 * back / by);
  }

  void
  ends(const bool lateral, const double lowest, const double highest, const bool table)
  {
    const BlowRecord endless = blow(without, 0, lateral);
    for (const double length : table ? std::vector<double>{1.5, 3, 6} : std::vector<double>{3})
      {
        const BlowRecord record = blow(undamped + length, length, lateral);
        for (const double f : {100, 150, 200, 300, 400, 500, 700, 1000, 1250, 1500, 2000, 2500})
          if (table || (f >= lowest && f <= highest))
            {
              const double found = reflection(record, endless, f);
              const auto   name  = std::string(lateral ? "lateral" : "vertical") + ", ends of " +
                                std::to_string(length).substr(0, 3) + " m, " + std::to_string(int(f)) +
                                " Hz: reflection ";
              if (length == 3 && f >= lowest && f <= highest)
                BOOST_TEST(near(found, 0, 0.05, name));
              else
                std::cout << name << found << std::endl;
            }
      }
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(damped_ends, test::Parallel)
{
  const auto &all   = boost::unit_test::framework::master_test_suite();
  const bool  table = all.argc > 1 && std::string(all.argv[1]) == "table";
  ends(false, 300, 2000, table);
  ends(true, 400, 1500, table);
}
