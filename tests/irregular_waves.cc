// ranks: 1
// label: long
// Corrugation so shallow that all is linear: the force of a run against the receptances of wheel and rail by
// a hammer, the spring of the contact, and how far the wheel sinks at rest; twice the depth, twice the force.
#include "between_rows.h"
#include "parallel.h"
#include "read_output.h"
#include "stopped_runs.h"

#include <wheelrail/model/model.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/receptance/blow.h>
#include <wheelrail/receptance/hammer_places.h>
#include <wheelrail/sampling/creep_scale.h>
#include <wheelrail/wheel/irregular_places.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  using Complex = std::complex<double>;
  using Curve   = std::vector<Complex>; ///< over the frequencies of the transforms

  constexpr double period = 40e-3; ///< of the Fourier sums [s]
  constexpr double fading =
    300; ///< of all signals, so that the sums do not feel what lies a period away [1/s]
  constexpr int    n_frequencies = int(4000 * period);
  constexpr double shallow = 5e-6, first_crest = 15e-3;

  /// A free wheel at 100 km/h on cells of 2 mm, on a clamped rail or one on pads all along, 300 MN/m each 0.6
  /// m.
  Scene
  waves_scene(const double wavelength, const double depth, const bool on_pads)
  {
    Scene scene;
    scene.title                        = "waves of " + std::to_string(std::lround(1e3 * wavelength)) + " mm";
    scene.cell_size                    = 2e-3;
    scene.fine_depth                   = 6e-3;
    scene.velocity                     = 100 / 3.6;
    scene.traction_coefficient         = 0;
    scene.rail_length                  = 0.8;
    scene.averaging_distance           = 5e-3;
    scene.ticks                        = 1;
    scene.volume_fields                = false;
    scene.checkpoint_interval          = 1e4;
    scene.folder                       = "waves";
    scene.irregularities[0].kind       = IrregularKind::corrugation;
    scene.irregularities[0].place      = first_crest;
    scene.irregularities[0].wavelength = wavelength;
    scene.irregularities[0].length     = wavelength * std::max(1., std::floor(80e-3 / wavelength + 0.5));
    scene.irregularities[0].depth      = depth;
    scene.rolling_distance             = first_crest + scene.irregularities[0].length + 2e-3;
    if (on_pads)
      {
        scene.title += " on pads";
        scene.support.kind        = RailSupport::continuous_pads;
        scene.support.damped_ends = 2.5;
        scene.rail_length         = 8;
      }
    return scene;
  }

  /// s of the transforms at the k-th frequency [1/s].
  Complex
  at_frequency(const int k)
  {
    return {fading, 2 * M_PI * k / period};
  }

  /// Integral of f exp(-s t) over the step of time.
  Complex
  transform(const std::vector<double> &f, const double step, const Complex s)
  {
    Complex sum = 0;
    for (std::size_t k = 0; k < f.size() && k * step < period; ++k)
      sum += f[k] * std::exp(-s * (k * step));
    return sum;
  }

  /// Receptances at one place of one body, or of both against each other [m/N].
  struct Receptances2
  {
    Curve vertical, lateral;
    Curve cross; ///< sideways of a vertical force, and the other way round

    void
    add(const Receptances2 &other)
    {
      for (int k = 0; k < n_frequencies; ++k)
        {
          vertical[k] += other.vertical[k];
          lateral[k] += other.lateral[k];
          cross[k] += other.cross[k];
        }
    }
  };

  /// Of one body, struck at X, the middle of the loaded patch: there the rail's head turns and yields
  /// sideways by more than downwards.
  Receptances2
  struck(const Scene &scene, const SceneGeometry &geometry, const Body body, const double X)
  {
    Receptances2 found;
    for (const bool lateral : {false, true})
      {
        const auto lone         = make_lone_body(scene, geometry, body, MPI_COMM_SELF);
        HammerFace upward       = body == Body::wheel
                                    ? wheel_faces(geometry, false)[0]
                                    : rail_places(scene, lone->plan.rail, "50 mm", false).faces[0];
        upward.middle[0]        = X;
        HammerFace sideways     = upward;
        sideways.direction      = {1, 0, 0};
        const BlowRecord record = strike(
          scene, *lone, {lateral ? sideways : upward, lateral ? upward : sideways}, period, MPI_COMM_SELF);
        for (int k = 0; k < n_frequencies; ++k)
          {
            const Complex s = at_frequency(k), force = transform(record.force, record.step, s);
            (lateral ? found.lateral : found.vertical)
              .push_back(transform(record.moved[0], record.step, s) / force);
            if (!lateral)
              found.cross.push_back(transform(record.moved[1], record.step, s) / force);
          }
      }
    return found;
  }

  /// How far a half-space gives way below the face of the hammer, mean over the face, which belongs to the
  /// receptances but not to a contact [m/N]: u = (1 - nu^2)/(pi E r) in Fourier space (Johnson, 1985, 3.2).
  double
  give_below_face(const Scene &scene)
  {
    const double R    = HammerFace().radius;
    const auto   face = [&](const double k) { // transform of (1 + cos(pi s/R))/(2 R)
      const double x = k * R;
      if (x < 1e-6)
        return 1.;
      return std::abs(x - M_PI) < 1e-6 ? 0.5 : std::sin(x) / x * M_PI * M_PI / (M_PI * M_PI - x * x);
    };
    constexpr int n_angles = 200, n_numbers = 4000;
    const double  dk = 40 / R / n_numbers, da = 0.5 * M_PI / n_angles;
    double        sum = 0;
    for (int a = 0; a < n_angles; ++a)
      for (int i = 0; i < n_numbers; ++i)
        {
          const double k = (i + 0.5) * dk, angle = (a + 0.5) * da;
          sum += std::pow(face(k * std::cos(angle)) * face(k * std::sin(angle)), 2) * dk * da;
        }
    const double E = scene.rail_material.youngs_modulus, nu = scene.rail_material.poissons_ratio;
    return 2 * (1 - nu * nu) / (M_PI * M_PI * E) * sum;
  }

  /// Approach of half-spaces over force, of small changes [m/N].
  double
  give_of_contact(const Scene &scene, const SceneGeometry &geometry, const double load)
  {
    const double less = solve_places(scene, geometry, 0.95 * load, {false, {0}})[0].approach,
                 more = solve_places(scene, geometry, 1.05 * load, {false, {0}})[0].approach;
    return (more - less) / (0.1 * load);
  }

  struct Signal
  {
    std::vector<double> along, force; ///< [m], [N]
  };

  Signal
  rolled(const Scene &scene)
  {
    BOOST_TEST(run(scene, false) == 0, scene.title + ": the run ends");
    const History history = read_history("waves/history.h5");
    return {*find_column(history, "rolled_distance"), *find_column(history, "vertical_force")};
  }

  /// Amplitude and phase over the last whole wave, by the Fourier coefficient of it [N].
  Complex
  amplitude(const Signal &signal, const Scene &scene)
  {
    constexpr int n      = 200;
    const double  lambda = scene.irregularities[0].wavelength,
                 from    = first_crest + scene.irregularities[0].length - lambda;
    Complex sum          = 0;
    for (int k = 0; k < n; ++k)
      sum += between_rows(signal.along, signal.force, from + k * lambda / n) *
             std::exp(Complex(0, -2 * M_PI * k / n)) * (2. / n);
    return sum;
  }

  /// How far the wheel sinks at rest along the track [m].
  Signal
  sinking(const Scene &scene, const SceneGeometry &geometry, const double load)
  {
    IrregularPlaces places{false, {}};
    const double    step = scene.irregularities[0].wavelength / 40;
    for (double x = 0; x < scene.rolling_distance + 20e-3; x += step)
      places.values.push_back(x);
    Signal drop;
    for (const PlaceContact &one : solve_places(scene, geometry, load, places))
      {
        drop.along.push_back(one.place);
        drop.force.push_back(one.drop);
      }
    return drop;
  }

  /// Force of the linear law over the path: F = -drop/compliance.
  Signal
  linear_force(const Scene &scene, const Signal &drop, const Curve &compliance)
  {
    constexpr double    step = 10e-6;
    std::vector<double> sunk;
    for (double t = 0; t < period; t += step)
      sunk.push_back(scene.velocity * t < drop.along.back()
                       ? between_rows(drop.along, drop.force, scene.velocity * t)
                       : 0);
    Curve force;
    for (int k = 0; k < n_frequencies; ++k)
      {
        const double part = double(k) / n_frequencies,
                     low  = part < 0.75 ? 1 : 0.5 - 0.5 * std::cos(4 * M_PI * part); // ends softly
        force.push_back(-low * step * transform(sunk, step, at_frequency(k)) / compliance[k]);
      }
    Signal result;
    for (double x = 0; x < scene.rolling_distance; x += 0.25e-3)
      {
        const double t   = x / scene.velocity;
        double       sum = force[0].real();
        for (std::size_t k = 1; k < force.size(); ++k)
          sum += 2 * (force[k] * std::exp(Complex(0, 2 * M_PI * k * t / period))).real();
        result.along.push_back(x);
        result.force.push_back(sum * std::exp(fading * t) / period);
      }
    return result;
  }

  Signal
  difference(const Signal &a, const Signal &b)
  {
    Signal result = a;
    for (std::size_t k = 0; k < a.along.size(); ++k)
      result.force[k] -= between_rows(b.along, b.force, a.along[k]);
    return result;
  }

  /// How far wheel and rail come nearer vertically, over the vertical force between them [m/N]. Friction
  /// holds both together sideways, but for the shear of the contact and Kalker's lateral creepage, so that
  ///
  ///   a_v F_v + a_c F_l = -drop,   a_c F_v + (a_l + shear + V/(s G a b C22)) F_l = 0.
  ///
  /// Half-spaces give way to shear (2 - nu)/(2 - 2 nu) times as far as to pressure: below a face that is
  /// alike along and across, and in a round contact (Mindlin, 1949). `patch`: of the run.
  Curve
  compliance(const Scene &scene, const SceneGeometry &geometry, const double load, const Summary &patch)
  {
    // the head turns under the load, by which the patch moves across: take it where the run has it
    const double at     = geometry.contact.frame.to_track({patch.patch_centre_lateral, 0}).x;
    Receptances2 bodies = struck(scene, geometry, Body::rail, at);
    bodies.add(struck(scene, geometry, Body::wheel, at));
    const double nu = scene.rail_material.poissons_ratio, shear = (2 - nu) / (2 - 2 * nu),
                 G      = 0.5 * scene.rail_material.youngs_modulus / (1 + nu);
    const double spring = give_of_contact(scene, geometry, load), face = give_below_face(scene);
    const double creep =
      creep_scale(scene.friction.at_rest * load, G, patch.patch_longitudinal, patch.patch_lateral).lateral;
    Curve sum;
    for (int k = 0; k < n_frequencies; ++k)
      {
        const Complex lateral =
          bodies.lateral[k] + shear * (spring - 2 * face) + scene.velocity / (at_frequency(k) * creep);
        sum.push_back(bodies.vertical[k] + spring - 2 * face - bodies.cross[k] * bodies.cross[k] / lateral);
      }
    std::cout << "        contact " << 1e9 * spring << " um/kN, half-space below a face " << 1e9 * face
              << " um/kN, G a b C22 " << 1e-6 * creep << " MN, struck at X = " << 1e3 * at << " mm\n";
    for (const int k : {5, 14, 28, 56})
      std::cout << "        " << k / period << " Hz: vertical " << 1e9 * bodies.vertical[k] << ", lateral "
                << 1e9 * bodies.lateral[k] << ", cross " << 1e9 * bodies.cross[k] << ", in all "
                << 1e9 * sum[k] << " um/kN\n";
    return sum;
  }

  /// One wavelength; `still`: the run over waves of next to no depth, over at least the same way.
  void
  test_wave(const Scene  &scene,
            const double  load,
            const Curve  &compliant,
            const Signal &still,
            const bool    twice)
  {
    const Signal  drop     = sinking(scene, make_geometry(scene), load);
    const double  half     = 0.5 * scene.irregularities[0].depth;
    const Complex found    = amplitude(difference(rolled(scene), still), scene),
                  linear   = amplitude(linear_force(scene, drop, compliant), scene);
    const std::string name = scene.title + ": ";
    std::cout << "        " << name << "sinks " << 1e6 * std::abs(amplitude(drop, scene)) << " um of "
              << 1e6 * half << "; force over amplitude " << 1e-9 * std::abs(found) / half << " kN/um, linear "
              << 1e-9 * std::abs(linear) / half << ", ahead by " << std::arg(found / linear) << " rad"
              << std::endl;
    BOOST_TEST(near_relative(std::abs(found), std::abs(linear), 0.1, name + "force by receptances"));
    if (!twice)
      return;
    Scene deep                   = scene;
    deep.irregularities[0].depth = 2 * scene.irregularities[0].depth;
    BOOST_TEST(near_relative(std::abs(amplitude(difference(rolled(deep), still), scene)),
                             2 * std::abs(found),
                             0.02,
                             name + "force of waves twice as deep"));
  }

  /// `deep`: the one of the lengths whose waves are computed twice as deep, too; the first is the longest.
  void
  test_waves(const std::vector<double> &lengths, const double deep, const bool on_pads)
  {
    const Scene         longest   = waves_scene(lengths.front(), 0.01e-6, on_pads);
    const SceneGeometry geometry  = make_geometry(longest);
    const double        load      = make_model(longest, geometry, MPI_COMM_SELF).wheel_load;
    const Signal        still     = rolled(longest);
    const Curve         compliant = compliance(longest, geometry, load, read_summary("waves/summary.json"));
    for (const double length : lengths)
      test_wave(waves_scene(length, shallow, on_pads), load, compliant, still, length == deep);
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(irregular_waves, test::Parallel)
{
  test_waves({0.2, 0.08, 0.04, 0.02}, 0.04, false);
  test_waves({0.08, 0.04}, 0, true);
}
