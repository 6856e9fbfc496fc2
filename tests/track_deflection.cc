// ranks: 1
// long ranks: 2

// Static deflection of a rail on pads and sleepers against beams: on Winkler's foundation, and on single
// supports at 11 places of a bay.

#include <deal.II/lac/full_matrix.h>

#include <wheelrail/model/model.h>
#include <wheelrail/statics/static_springs.h>
#include <wheelrail/statics/static_system.h>
#include <wheelrail/track/track_support.h>

#include "parallel.h"
#include "small_scene.h"
#include "stands_on.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  /// 60E1 upright, long enough for a load in its middle.
  Model
  long_rail()
  {
    Scene scene             = small_scene(8e-3);
    scene.rail_profile      = "60E1";
    scene.track.inclination = 0;
    scene.rail_length       = 7;
    return make_model(scene, make_geometry(scene), MPI_COMM_WORLD);
  }

  /// Deflection of the foot [m] at places along the track, downwards, the mean over the section.
  std::vector<double>
  deflections(const Model &model, const std::vector<double> &places)
  {
    const LocalMesh    &mesh = model.solid.mesh;
    std::vector<double> sums(2 * places.size(), 0.);
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      if (mesh.owns(n) && mesh.node_body[n] == Body::rail && mesh.reference[4 * n + 1] < -0.171)
        for (std::size_t k = 0; k < places.size(); ++k)
          if (std::abs(mesh.reference[4 * n + 2] - places[k]) < 1e-6)
            {
              sums[2 * k] -= model.solid.displacement[4 * n + 1];
              sums[2 * k + 1] += 1;
            }
    MPI_Allreduce(
      MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    std::vector<double> down;
    for (std::size_t k = 0; k < places.size(); ++k)
      down.push_back(sums[2 * k] / sums[2 * k + 1]);
    return down;
  }

  /// The rail of a model under a load downwards [N] that is spread over the section at Z = 0 as its mass is:
  /// no local indentation. Gives what the track bears.
  Vector3
  press(Model &model, const double load)
  {
    Solid                &solid = model.solid;
    AlignedVector<double> force(solid.force.size(), 0.);
    double                mass = 0;
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::rail && std::abs(solid.mesh.reference[4 * n + 2]) < 1e-6)
        {
          force[4 * n + 1] = -solid.mass[n];
          mass += solid.mesh.owns(n) ? solid.mass[n] : 0;
        }
    MPI_Allreduce(MPI_IN_PLACE, &mass, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    for (double &f : force)
      f *= load / mass;
    StaticSystem system(*model.discretization, solid, model.parts);
    system.set_springs({});
    NodeVector         moved = system.zero();
    const unsigned int steps = system.solve_held(system.right_hand_side(force), 1e-7, moved);
    BOOST_TEST(steps < 25, std::to_string(steps) + " steps of conjugate gradients");
    system.add_to_nodes(moved, 0, solid.displacement);
    return dynamic_cast<const TrackSupport &>(*model.parts.front()).force_at_rest(solid);
  }

  /// What single springs and joined nodes hold, against the part's own stiffness.
  void
  stiffness_in_parts(Model &model)
  {
    const LocalMesh                 &mesh = model.solid.mesh;
    const std::vector<unsigned char> free(mesh.n_nodes(), 0);
    const StaticParts                parts(model.parts, model.solid, MPI_COMM_WORLD);
    std::vector<double>              x(4 * mesh.n_nodes()), own(x.size(), 0.), sum(x.size(), 0.);
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] = ((4 * mesh.global_node[k / 4] + k % 4) * 2654435761u % 1000003u) / 500001.5 - 1;
    for (const unsigned int n : mesh.hanging)
      std::fill(&x[4 * n], &x[4 * n] + 4, 0.);
    parts.add_stiffness(x.data(), own.data());
    for (std::size_t k = 0; k < x.size(); ++k)
      sum[k] = parts.springs()[k] * x[k];
    StaticSprings(parts.joined(), mesh, free, MPI_COMM_WORLD).add_product(1, x.data(), sum.data());
    std::array<double, 2> worst{}; // size and difference
    for (std::size_t k = 0; k < 4 * mesh.n_owned; ++k)
      {
        worst[0] = std::max(worst[0], std::abs(own[k]));
        worst[1] = std::max(worst[1], std::abs(own[k] - sum[k]));
      }
    MPI_Allreduce(MPI_IN_PLACE, worst.data(), 2, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    const auto [size, off] = worst;
    BOOST_TEST((size > 0 && parts.joined().size() > 10), "sleepers join nodes of an upright rail");
    BOOST_TEST(near(
      off / size, 0, 1e-12, "springs of nodes less what sleepers give way, off the stiffness of the track"));
  }

  /// Winkler's foundation below Timoshenko's beam: bending stiffness, shear stiffness, foundation.
  struct Beam
  {
    double EI, GA, k;

    /// Of an endless beam under F, at the load (Timoshenko 1921 with Winkler 1867; the real case of the
    /// characteristic equation EI r^4 - (EI k/GA) r^2 + k = 0, with complex roots).
    double
    at_load() const
    {
      // displacement spectrum (1 + EI q^2/GA)/(EI q^4 + k (1 + EI q^2/GA)), by quadrature over the wave
      // number q
      double       sum  = 0;
      const double step = 1e-3;
      for (double q = 0.5 * step; q < 2000; q += q < 20 ? step : 0.05)
        {
          const double shear = 1 + EI * q * q / GA;
          sum += (q < 20 ? step : 0.05) * shear / (EI * std::pow(q, 4) + k * shear);
        }
      return sum / M_PI;
    }
  };

  /// Of 60E1 on a foundation [N/m2].
  Beam
  rail_beam(const double foundation)
  {
    return {210e9 * 3038.3e-8, 0.4 * 80.8e9 * 76.7e-4, foundation};
  }

  BOOST_FIXTURE_TEST_CASE(static_deflection, test::Parallel)
  {
    constexpr double load  = 100e3;
    Model            model = long_rail();
    TrackData        pads;
    pads.continuous = true;
    pads.pad        = {20e6, 30e6, 20e6}; // 50 MN/m2
    put_on(model, pads);
    const Vector3 borne = press(model, load);
    BOOST_TEST(near(borne[1] / load, -1, 1e-5, "the pads bear the load"));
    const Beam   beam       = rail_beam(50e6);
    const double deflection = deflections(model, {0})[0];
    BOOST_TEST(
      near(beam.at_load() / 1.246e-8, 1, 2e-3, "Timoshenko's beam on 50 MN/m2 over its closed form"));
    BOOST_TEST(
      near(deflection / load / 1.246e-8, 1, 0.03, "deflection of 60E1 on 50 MN/m2 over Timoshenko's beam"));

    // pads on sleepers on ballast as stiff per length
    TrackData on_sleepers;
    on_sleepers.first          = 0;
    on_sleepers.pad            = {40e6, 60e6, 40e6};
    on_sleepers.rigid_sleepers = false;
    on_sleepers.sleeper_mass   = 160;
    on_sleepers.ballast        = {40e6, 60e6, 40e6};
    std::fill(model.solid.displacement.begin(), model.solid.displacement.end(), 0.);
    TrackSupport &track = put_on(model, on_sleepers);
    stiffness_in_parts(model);
    BOOST_TEST(near(press(model, load)[1] / load, -1, 1e-5, "pads on sleepers bear the load"));
    BOOST_TEST(near(deflections(model, {0})[0] / load / 1.246e-8,
                    1,
                    0.06,
                    "deflection over a sleeper over that on the same stiffness per length"));
    track.start(model.solid);
    double sum = 0;
    for (const Vector3 &place : track.sleeper_places())
      sum += place[1] * on_sleepers.ballast[1];
    BOOST_TEST(near(sum / load, -1, 1e-4, "the ballast bears it as well"));
    BOOST_TEST(track.sleepers().size() == 11, "a sleeper every 0.6 m below 7 m of rail");
  }

  /// Timoshenko's beam on pads and sleepers, free at both ends: a finite beam by elements that are exact
  /// between their nodes (Przemieniecki 1968), 30 mm long, five springs a pad.
  class BeamOnSleepers
  {
  public:
    BeamOnSleepers(const Beam &beam, const double length, const TrackData &track)
      : middle_(std::lround(0.5 * length / pitch))
      , size_(2 * (2 * middle_ + 1))
    {
      // w and the turn of the section at each node
      const double phi = 12 * beam.EI / (beam.GA * pitch * pitch), of = beam.EI / (pitch * pitch * pitch);
      const double h         = pitch;
      const double own[4][4] = {{12, 6 * h, -12, 6 * h},
                                {6 * h, (4 + phi) * h * h, -6 * h, (2 - phi) * h * h},
                                {-12, -6 * h, 12, -6 * h},
                                {6 * h, (2 - phi) * h * h, -6 * h, (4 + phi) * h * h}};
      dealii::FullMatrix<double> stiffness(size_);
      for (int e = 0; e < 2 * middle_; ++e)
        for (int a = 0; a < 4; ++a)
          for (int b = 0; b < 4; ++b)
            stiffness(2 * e + a, 2 * e + b) += of / (1 + phi) * own[a][b];
      constexpr int springs = 5; // of a pad, 150 mm long
      for (double at = track.first - 6; at < 6; at += track.spacing)
        {
          std::vector<int> nodes;
          for (int p = 0; p < springs; ++p)
            if (const int node = middle_ + int(std::lround(at / pitch)) + p - springs / 2;
                node >= 0 && node <= 2 * middle_)
              nodes.push_back(node);
          const double spring = track.pad[1] / springs;
          // what the sleeper gives way is taken out
          const double shared =
            track.rigid_sleepers ? 0 : spring * spring / (nodes.size() * spring + track.ballast[1]);
          for (const int n : nodes)
            {
              stiffness(2 * n, 2 * n) += spring;
              for (const int m : nodes)
                stiffness(2 * n, 2 * m) -= shared;
            }
        }
      give_ = stiffness;
      give_.gauss_jordan();
    }

    /// At the middle of the beam, under a load there [m/N].
    double
    at_load() const
    {
      return give_(2 * middle_, 2 * middle_);
    }

  private:
    static constexpr double    pitch = 0.03; ///< [m]
    int                        middle_;
    unsigned int               size_;
    dealii::FullMatrix<double> give_;
  };

  /// Under the load at 11 places of a bay, from over a sleeper to over the next one; the second half of the
  /// bay is the mirror image of the first. Pads of 300 MN/m on sleepers on ballast of 50 MN/m.
  BOOST_FIXTURE_TEST_CASE(over_a_bay, test::Parallel)
  {
    constexpr double load  = 100e3;
    Model            model = long_rail();
    TrackData        track;
    track.pad            = {40e6, 300e6, 40e6};
    track.rigid_sleepers = false;
    track.sleeper_mass   = 160;
    track.ballast        = {25e6, 50e6, 25e6};
    std::vector<double> solid, beam;
    for (int place = 0; place <= 5; ++place)
      {
        track.first = -0.06 * place; // the sleepers move, the load stays
        std::fill(model.solid.displacement.begin(), model.solid.displacement.end(), 0.);
        put_on(model, track);
        press(model, load);
        solid.push_back(deflections(model, {0})[0] / load);
        beam.push_back(BeamOnSleepers(rail_beam(0), 7, track).at_load());
        BOOST_TEST(near(solid.back() / beam.back(),
                        1,
                        0.03,
                        std::to_string(60 * place) + " mm from a sleeper: deflection over that of the beam"));
      }
    BOOST_TEST((beam[5] > 1.01 * beam[0] && solid[5] > 1.01 * solid[0]),
               "the rail sinks more between sleepers than over one");
  }
} // namespace
