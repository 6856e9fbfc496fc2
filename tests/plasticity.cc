// label: fast

// The plastic reduced hexahedron: patch test, rotation, energy, widths, fully
// plastic moments.

#include <wheelrail/solid/law_scope.h>
#include <wheelrail/solid/point_state.h>

#include "explicit_brick.h"
#include "parallel.h"
#include "scenes/dynamics.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace test;

namespace
{
  const Plasticity soft{100e6, 2.1e9, 0.4}, perfect{100e6, 0, 0};

  void
  patch_test()
  {
    Brick body(brick({3, 3, 3}, {1, 1, 1}, 0.25), Elasticity(), soft);
    for (const double amount : {1., 2., 0.5})
      body.move_to(nodal(body.mesh, [amount](const Vector &X) -> Vector {
        return {amount * (1e-3 * X[0] + 2e-3 * X[1]),
                amount * (-1e-3 * X[1] + 5e-4 * X[2]),
                amount * (3e-4 * X[0] + 1e-3 * X[2])};
      }));
    const auto stress = element_stress(body.blocks, body.u.data());
    const auto strain = element_plastic_strain(body.blocks);
    double     spread = 0;
    for (std::size_t e = 0; e < stress.size(); ++e)
      {
        for (int k = 0; k < 6; ++k)
          spread = std::max(spread, std::abs(stress[e][k] - stress[0][k]) / soft.yield_stress);
        spread = std::max(spread, std::abs(strain[e] - strain[0]) / strain[0]);
      }
    BOOST_TEST(strain[0] > 1e-3, "patch test: cells yield");
    BOOST_TEST(
      test::near(spread, 0, 1e-11, "patch test: equal stress and plastic strain in distorted cells"));
    double inner = 0;
    for (int k = 1; k < 3; ++k)
      for (int j = 1; j < 3; ++j)
        for (int i = 1; i < 3; ++i)
          for (int c = 0; c < 3; ++c)
            inner = std::max(inner, std::abs(body.f[4 * body.mesh.node(i, j, k) + c]));
    BOOST_TEST(test::near(inner / largest(body.f), 0, 1e-12, "patch test: inner forces vanish"));
    BOOST_TEST(
      test::near(body.energy.stabilisation / body.energy.strain, 0, 1e-20, "no stabilisation energy"));
  }

  /// A rough deformation, not linear in the cells.
  Vector
  rough(const Vector &X, const double amount)
  {
    return {amount * (2e-3 * X[0] + 3e-3 * X[1] * X[2] - 2e-3 * X[0] * X[1]),
            amount * (-1e-3 * X[1] + 4e-3 * X[0] * X[0]),
            amount * (1e-3 * X[2] - 3e-3 * X[0] * X[1] * X[2])};
  }

  Vector
  turned(const Vector &X, const Vector &u, const double angle)
  {
    const Vector x = {X[0] + u[0], X[1] + u[1], X[2] + u[2]};
    const double c = std::cos(angle), s = std::sin(angle);
    return {x[0] - X[0], c * x[1] - s * x[2] - X[1], s * x[1] + c * x[2] - X[2]};
  }

  /// Loads, flows and unloads once at rest and once during ten turns.
  void
  rotation()
  {
    Brick        rest(brick({2, 2, 2}, {1, 1, 1}, 0.2), Elasticity(), soft), turning = rest;
    const int    steps = 60;
    const double turns = 10 * 2 * M_PI + 1;
    for (int n = 1; n <= steps; ++n)
      {
        const double amount = std::sin(3. * n / steps);
        const double angle  = turns * n / steps;
        rest.move_to(nodal(rest.mesh, [&](const Vector &X) { return rough(X, amount); }));
        turning.move_to(
          nodal(rest.mesh, [&](const Vector &X) { return turned(X, rough(X, amount), angle); }));
      }
    auto back = turning.f;
    for (std::size_t n = 0; n < rest.mesh.vertices.size(); ++n)
      {
        const double y = back[4 * n + 1], z = back[4 * n + 2];
        back[4 * n + 1] = std::cos(turns) * y + std::sin(turns) * z;
        back[4 * n + 2] = -std::sin(turns) * y + std::cos(turns) * z;
      }
    BOOST_TEST(largest(AlignedVector<double>(rest.blocks.history)) > 1e-3, "rough deformation yields");
    BOOST_TEST(test::near(difference(rest.blocks.history, turning.blocks.history),
                          0,
                          1e-13,
                          "ten turns leave the plastic history as it is at rest"));
    BOOST_TEST(test::near(difference(back, rest.f) / largest(rest.f), 0, 1e-9, "forces turn with the body"));
    double force[3] = {}, moment[3] = {};
    for (std::size_t n = 0; n < rest.mesh.vertices.size(); ++n)
      for (int i = 0; i < 3; ++i)
        {
          const int    j = (i + 1) % 3, k = (i + 2) % 3;
          const double xj = rest.mesh.vertices[n][j] + turning.u[4 * n + j],
                       xk = rest.mesh.vertices[n][k] + turning.u[4 * n + k];
          force[i] += turning.f[4 * n + i];
          moment[i] += xj * turning.f[4 * n + k] - xk * turning.f[4 * n + j];
        }
    for (int i = 0; i < 3; ++i)
      {
        BOOST_TEST(test::near(force[i] / largest(rest.f), 0, 1e-12, "forces sum to zero"));
        BOOST_TEST(test::near(moment[i] / largest(rest.f), 0, 1e-12, "moments sum to zero"));
      }
  }

  void
  energy(const Plasticity &plasticity, const std::string &name)
  {
    Brick     body(brick({2, 2, 2}, {1, 1, 1}, 0.2), Elasticity(), plasticity);
    double    work = 0, last = 0;
    bool      monotone = true;
    const int steps    = 4000;
    for (int n = 1; n <= steps; ++n)
      {
        const double amount = 2 * std::sin(10. * n / steps);
        work += body.move_to(nodal(body.mesh, [&](const Vector &X) { return rough(X, amount); }));
        monotone = monotone && body.energy.plastic_work >= last - 1e-9 * work;
        last     = body.energy.plastic_work;
      }
    BOOST_TEST(body.energy.plastic_work > 10 * body.stored(), "most of the work is plastic" + name);
    BOOST_TEST(test::near((body.stored() + body.energy.plastic_work) / work,
                          1,
                          2e-4,
                          "strain, stabilisation and plastic work are the external work" + name));
    if (plasticity.kinematic_fraction == 0)
      BOOST_TEST(monotone, "plastic work only grows" + name);
  }

  void
  widths()
  {
    const Mesh mesh = brick({3, 3, 3}, {1, 1, 1}, 0.2);
    Brick      one(mesh, Elasticity(), soft, 1);
    for (const int width : {2, 4, 8})
      {
        Brick body(mesh, Elasticity(), soft, width);
        Brick single = one;
        for (const double amount : {0.2, 1., -0.5, 0.1})
          for (Brick *b : {&body, &single})
            b->move_to(nodal(mesh, [&](const Vector &X) { return rough(X, amount); }));
        BOOST_TEST(test::near(difference(body.f, single.f) / largest(single.f),
                              0,
                              1e-11,
                              "width " + std::to_string(width) + " equals width 1"));
        BOOST_TEST(
          test::near((body.energy.plastic_work - single.energy.plastic_work) / single.energy.plastic_work,
                     0,
                     1e-12,
                     "and so does its plastic work"));
      }
    Brick elastic(mesh, Elasticity(), Plasticity()), strong(mesh, Elasticity(), {1e12, 21e9, 0});
    for (Brick *b : {&elastic, &strong})
      b->move_to(nodal(mesh, [&](const Vector &X) { return rough(X, 1); }));
    BOOST_TEST(test::near(difference(elastic.f, strong.f) / largest(elastic.f),
                          0,
                          1e-14,
                          "far below yield a plastic body is an elastic one"));
  }

  /// A solver's trial states leave no trace in the history.
  void
  elastic_scope()
  {
    const Mesh mesh = brick({2, 2, 2}, {1, 1, 1}, 0.2);
    Brick      body(mesh, Elasticity(), soft), elastic(mesh, Elasticity(), Plasticity());
    const auto u = nodal(mesh, [](const Vector &X) { return rough(X, 1); });
    elastic.move_to(u);
    {
      const ElasticScope meanwhile(body.blocks);
      body.move_to(u);
    }
    BOOST_TEST(
      near(difference(body.f, elastic.f), 0, 0, "made elastic, a body beyond yield has elastic forces"));
    BOOST_TEST(near(largest(body.blocks.history), 0, 0, "and keeps its history"));
    body.find_force();
    BOOST_TEST(largest(body.blocks.history) > 1e-3, "afterwards it yields");
  }

  /// A body that takes the state of another goes on with the same bits.
  void
  saved_state()
  {
    const Mesh mesh = brick({3, 3, 3}, {1, 1, 1}, 0.2); // 27 cells: the last batch is not full
    Brick      body(mesh, Elasticity(), soft), other = body;
    body.move_to(nodal(mesh, [](const Vector &X) { return rough(X, 1); }));
    // as a checkpoint does it
    std::vector<AlignedVector<double>> saved;
    visit_histories(body.blocks, [&](const char *, unsigned int, const AlignedVector<double> &values) {
      saved.push_back(values);
    });
    std::size_t next = 0;
    visit_histories(other.blocks, [&](const char *, unsigned int, AlignedVector<double> &values) {
      values = saved[next++];
    });
    mark_flowed(other.blocks);
    for (Brick *b : {&body, &other})
      b->move_to(nodal(mesh, [](const Vector &X) { return rough(X, -0.5); }));
    BOOST_TEST(near(difference(body.f, other.f), 0, 0, "a restored history goes on with the same forces"));
    BOOST_TEST(near(body.energy.plastic_work - other.energy.plastic_work, 0, 0, "and the same plastic work"));
    BOOST_TEST((saved.size() == 3 && largest(saved[1]) > 1e-3),
               "viscous state, history and plastic work are visited");
  }

  /// Moment over fully plastic moment of a beam of `layers` cells through its
  /// height, bent uniformly to `curvature` times that of first yield, then to
  /// `last`: damped dynamics with the ends' rotation held. The step is small
  /// since a free cell breathes faster than one in a body.
  double
  bending_moment(const int layers, const Plasticity &plasticity, const double curvature, const double last)
  {
    const double  h = 1e-3, length = 2 * h / layers;
    scenes::Setup setup;
    setup.plasticity  = plasticity;
    setup.step_factor = 0.6;
    scenes::Dynamics scene(scenes::box({0, 0, 0}, {length, h, h}, {2, unsigned(layers), 1}), setup);
    scene.mass_damping        = 0.02 / scene.time_step;
    const double first_yield  = plasticity.yield_stress / (setup.material.youngs_modulus * h / 2);
    const int    steps        = 8000 * layers;
    const double duration     = steps * scene.time_step;
    const auto   curvature_at = [=](const double time) {
      // up in the first 60 %, to the last value until 80 %, then rest
      const double t  = time / duration;
      const double up = std::min(t / 0.6, 1.), down = std::clamp((t - 0.6) / 0.2, 0., 1.);
      return first_yield * (curvature * up + (last - curvature) * down);
    };
    std::vector<std::pair<unsigned int, double>> end; // numbers of the reactions and their arms
    for (unsigned int n = 0; n < scene.solid.mesh.n_nodes(); ++n)
      {
        const auto   X   = scenes::place_of(scene.solid.mesh, n);
        const double arm = X[1] - h / 2;
        if (X[0] > 1e-9 && X[0] < length - 1e-9)
          continue;
        const double side   = X[0] < 1e-9 ? 0.5 : -0.5;
        const auto   number = scene.prescribe(
          {n}, 0, [=](const double time) { return curvature_at(time) * arm * side * length; });
        if (side > 0)
          end.push_back({number, arm});
      }
    for (int n = 0; n < steps; ++n)
      scene.step();
    double moment = 0;
    for (const auto &[number, arm] : end)
      moment += scene.reaction(number) * arm;
    return moment / (plasticity.yield_stress * h * h * h / 4);
  }

  void
  fully_plastic_moment()
  {
    for (const int layers : {1, 2, 3, 4, 8})
      {
        const double moment = bending_moment(layers, perfect, 10, 10);
        BOOST_TEST(test::near(moment,
                              1,
                              layers == 2 ? 0.06 : 0.02,
                              "fully plastic moment of " + std::to_string(layers) + " layers"));
      }
    // between first yield and full plasticity, M = M_p (1 - 1/(3 k^2)) at k times the curvature of first
    // yield: a single layer stays elastic up to M_p
    const auto partly = [&](const int layers, const double k) {
      return bending_moment(layers, perfect, k, k) / (1 - 1 / (3 * k * k));
    };
    for (const double k : {1.25, 1.5, 2., 3.})
      {
        const std::string text = std::to_string(k).substr(0, 4) + " times first yield: moment of ";
        for (const int layers : {1, 2})
          {
            const double ratio = partly(layers, k);
            BOOST_TEST((ratio > 0.98 && ratio < 1.18),
                       text + std::to_string(layers) + " layers over beam theory " + std::to_string(ratio));
          }
        BOOST_TEST(test::near(partly(4, k), 1, 0.07, text + "4 layers over beam theory"));
      }
    BOOST_TEST(test::near(partly(1, 1.5) * (1 - 1 / 6.75), 1, 0.01, "a single layer is elastic up to M_p"));
    // unloading from 10 to 9 times the curvature of first yield is elastic: M = E
    // I kappa
    const double full = bending_moment(1, perfect, 10, 10);
    const double less = bending_moment(1, perfect, 10, 9);
    BOOST_TEST(test::near(full - less, 2. / 3, 0.005, "a plastic hinge unloads with its elastic stiffness"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(plasticity, test::Parallel)
{
  patch_test();
  rotation();
  energy(soft, " (mixed hardening)");
  energy(perfect, " (perfect plasticity)");
  energy({100e6, 21e9, 1}, " (kinematic hardening)");
  widths();
  elastic_scope();
  saved_state();
  fully_plastic_moment();
}
