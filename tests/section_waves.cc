// label: fast

// Waves of a rail by its section (2.5-D elements with mass): Timoshenko's beam, the reduced basis against all
// displacements, a rail on pads against Winkler's foundation, energy and reciprocity of receptances.

#include <wheelrail/bodies/section_waves.h>
#include <wheelrail/geometry/profiles.h>
#include <wheelrail/mesh/rail_section.h>

#include "near.h"

#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;
using test::near_relative;

namespace
{
  using Complex = std::complex<double>;

  enum Force : unsigned int
  {
    on_head,
    on_foot,
    along_foot
  };

  /// 60E1, upright, in blocks of 16 mm; forces even over the middle of the head and over the foot.
  struct Rail
  {
    SectionMesh               mesh;
    WaveMatrices              matrices;
    std::vector<SectionForce> forces;

    Rail()
    {
      mesh = mesh_section(
        make_rail_section(rail_profile("60E1"), {{0, 0}, 0}, {{{0, 0}, 0}, {-0.016, 0, 0.016}}, 0.016),
        Boundary::bore,
        0);
      Elasticity steel;
      steel.density = 7850;
      matrices      = assemble_waves(mesh, steel, false);
      std::vector<std::array<unsigned int, 3>> head, foot;
      for (const auto &edge : mesh.running)
        if (std::abs(mesh.nodes[edge.node[1]].x) < 0.02)
          head.push_back(edge.node);
      constexpr unsigned int sides[4][3] = {{0, 3, 6}, {2, 5, 8}, {0, 1, 2}, {6, 7, 8}};
      for (const auto &cell : mesh.cells)
        for (const auto &side : sides)
          if (mesh.nodes[cell[side[0]]].y < -0.1715 && mesh.nodes[cell[side[1]]].y < -0.1715 &&
              mesh.nodes[cell[side[2]]].y < -0.1715)
            foot.push_back({cell[side[0]], cell[side[1]], cell[side[2]]});
      forces = {even(head, 1), even(foot, 1), even(foot, 2)};
    }

    SectionForce
    even(const std::vector<std::array<unsigned int, 3>> &edges, const int axis) const
    {
      SectionForce force;
      force.along  = axis == 2;
      double whole = 0;
      for (const auto &edge : edges)
        for (int n = 0; n < 3; ++n)
          {
            const double part = edge_weights(mesh, edge, [](const Point2 &) { return 1.; })[n];
            whole += part;
            for (const auto &[unknown, share] : matrices.unknowns[edge[n]])
              force.shares.emplace_back(3 * unknown + axis, part * share);
          }
      for (auto &share : force.shares)
        share.second /= whole;
      return force;
    }
  };

  /// Timoshenko's beam of 60E1 (density 7850, G 81 GPa, kappa 0.4): wavenumber of its travelling wave.
  double
  timoshenko(const double frequency)
  {
    const double w = 2 * M_PI * frequency, A = 76.70e-4, I = 3038.3e-8, E = 210e9, rho = 7850;
    const double shear = 0.4 * 81e9 * A, bend = E * I, m = rho * A, turn = rho * I;
    // (EI k^2 + kGA - rho I w^2)(kGA k^2 - rho A w^2) = (kGA k)^2
    const double a = bend * shear, b = -(bend * m + shear * turn) * w * w,
                 c = m * w * w * (turn * w * w - shear);
    return std::sqrt((-b + std::sqrt(b * b - 4 * a * c)) / (2 * a));
  }

  /// The travelling wave that moves the head most.
  double
  wave_number(const SectionWaves &waves, const double frequency)
  {
    double most = 0, k = 0;
    for (const auto &wave : waves.waves(2 * M_PI * frequency, 1e-4))
      if (std::abs(wave.k.imag()) < 0.01 * std::abs(wave.k.real()))
        if (const double moves = std::abs(wave.at[on_head] * wave.at[on_head] / wave.turn); moves > most)
          most = moves, k = wave.k.real();
    return k;
  }

  double
  group_speed(const std::function<double(double)> &k, const double frequency)
  {
    const double step = 1e-3 * frequency;
    return 2 * M_PI * 2 * step / (k(frequency + step) - k(frequency - step));
  }

  void
  free_rail(const SectionWaves &waves)
  {
    const auto solid = [&](const double f) { return wave_number(waves, f); };
    struct Speed
    {
      double frequency, phase, group;
    };
    for (const Speed &beam : {Speed{100, 446, 868}, Speed{1000, 1250, 1997}})
      {
        const std::string at = std::to_string(int(beam.frequency)) + " Hz: ";
        BOOST_TEST(near_relative(2 * M_PI * beam.frequency / timoshenko(beam.frequency),
                                 beam.phase,
                                 2e-3,
                                 at + "phase speed of Timoshenko's beam"));
        BOOST_TEST(near_relative(2 * M_PI * beam.frequency / solid(beam.frequency),
                                 beam.phase,
                                 0.02,
                                 at + "phase speed of the section"));
        BOOST_TEST(near_relative(
          group_speed(timoshenko, beam.frequency), beam.group, 2e-3, at + "group speed of the beam"));
        BOOST_TEST(near_relative(
          group_speed(solid, beam.frequency), beam.group, 0.02, at + "group speed of the section"));
      }
    for (const double frequency : {100., 1000., 4000.})
      for (const auto &wave : waves.waves(2 * M_PI * frequency, 1e-6))
        if (std::abs(wave.k.imag()) < 1e-3 * std::abs(wave.k.real()) && std::abs(wave.at[on_head]) > 1e-3)
          {
            double nearest = 0;
            for (const double f : waves.frequencies(wave.k.real(), 8))
              nearest = std::abs(f - frequency) < std::abs(nearest - frequency) ? f : nearest;
            BOOST_TEST(near_relative(nearest,
                                     frequency,
                                     1e-4,
                                     "frequency by all displacements of the wave " +
                                       std::to_string(wave.k.real()) + "/m at " +
                                       std::to_string(int(frequency)) + " Hz"));
          }
  }

  void
  on_pads(const SectionWaves &waves)
  {
    // 50 MN/m2 below the foot, next to at rest
    const auto   standing = waves.waves(2 * M_PI * 0.5, 0, {0., 50e6, 20e6});
    const double moved    = waves.response(standing, on_foot, on_head, 0).real();
    BOOST_TEST(
      near_relative(moved, 1.246e-8, 0.03, "deflection of the foot on 50 MN/m2 over Timoshenko's beam"));
    // sections stay plane and across the rail where it bends over some metres: the foot goes along by its
    // depth below the neutral axis (80.95 mm, EN 13674-1) times the slope; at 10 Hz, since much below the
    // wave along the rail drowns in rounding
    const auto   soft = waves.waves(2 * M_PI * 10, 0, {0., 0.5e6, 0.});
    const double step = 0.1, at = 1.5;
    const double slope =
      (waves.response(soft, on_foot, on_head, at + step) - waves.response(soft, on_foot, on_head, at - step))
        .real() /
      (2 * step);
    BOOST_TEST(near_relative(waves.response(soft, along_foot, on_head, at).real() / slope,
                             80.95e-3,
                             0.02, // shear turns sections less than the rail slopes
                             "motion of the foot along the rail over the slope of the rail"));
    for (const double frequency : {50., 300., 1000., 3000.})
      {
        const Complex loss(1, 0.25);
        const auto    all = waves.waves(2 * M_PI * frequency, 2e-4, {0., 50e6 * loss, 20e6 * loss});
        const Complex at  = waves.response(all, on_head, on_head, 0);
        BOOST_TEST(at.imag() < 0, std::to_string(int(frequency)) + " Hz: the blow gives energy to the rail");
        const Complex far  = waves.response(all, on_head, on_head, 3),
                      near = waves.response(all, on_head, on_head, 1);
        BOOST_TEST(std::abs(far) < std::abs(near), "it dies along the rail");
      }
  }

  /// What goes through a section of a rail that is struck: half of the power to either side. In a free rail
  /// without loss, power that waves carry is w |A|^2 d w/dk-like: here by the sum over travelling waves of
  /// their residues.
  void
  power(const SectionWaves &waves)
  {
    for (const double frequency : {200., 1500.})
      {
        const double w    = 2 * M_PI * frequency;
        const auto   all  = waves.waves(w, 1e-7);
        double       gone = 0; // -Im of the receptance by travelling waves alone
        for (const auto &wave : all)
          if (std::abs(wave.k.imag()) < 1e-4 * std::abs(wave.k.real()))
            gone -= (Complex(0, -1) * wave.at[on_head] * wave.at[on_head] / wave.turn).imag();
        BOOST_TEST(
          near(-waves.response(all, on_head, on_head, 0).imag() / gone,
               1,
               1e-4,
               std::to_string(int(frequency)) + " Hz: power of the blow over that of the waves that travel"));
      }
  }
} // namespace


BOOST_AUTO_TEST_CASE(section_waves)
{
  const Rail         rail;
  const SectionWaves waves(rail.matrices, rail.forces);
  BOOST_TEST(waves.basis() < 130,
             std::to_string(waves.basis()) + " directions of " + std::to_string(waves.size()));
  free_rail(waves);
  on_pads(waves);
  power(waves);
}
