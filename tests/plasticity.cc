// The plastic reduced hexahedron: patch test, rotation, energy, fully plastic moments, hard cases.

#include <wheelrail/solid/kernel.h>

#include "check.h"

#include <functional>
#include <random>

using namespace wheelrail;
using Vector = std::array<double, 3>;

namespace
{
  struct Mesh
  {
    std::vector<Vector>                      vertices;
    std::vector<std::array<unsigned int, 8>> cells;
    std::vector<ElementGeometry>             geometry;
    int                                      n[3];

    unsigned int
    node(const int i, const int j, const int k) const
    {
      return i + (n[0] + 1) * (j + (n[1] + 1) * k);
    }
  };

  /// A brick of n cells; inner vertices moved at random by `distortion` of a cell.
  Mesh
  brick(const std::array<int, 3> &n, const Vector &size, const double distortion = 0)
  {
    Mesh mesh;
    std::copy(n.begin(), n.end(), mesh.n);
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> shift(-distortion, distortion);
    for (int k = 0; k <= n[2]; ++k)
      for (int j = 0; j <= n[1]; ++j)
        for (int i = 0; i <= n[0]; ++i)
          {
            Vector X = {double(i), double(j), double(k)};
            for (int c = 0; c < 3; ++c)
              X[c] = (X[c] + shift(random)) * size[c] / n[c];
            mesh.vertices.push_back(X);
          }
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i)
          {
            std::array<unsigned int, 8> cell;
            std::array<Vector, 8>       X;
            for (int a = 0; a < 8; ++a)
              {
                cell[a] = mesh.node(i + (a & 1), j + (a >> 1 & 1), k + (a >> 2));
                X[a]    = mesh.vertices[cell[a]];
              }
            mesh.cells.push_back(cell);
            mesh.geometry.push_back(element_geometry(X));
          }
    return mesh;
  }

  /// An explicit body: central differences, velocities at half steps.
  struct Body
  {
    Mesh                  mesh;
    ElementBlocks         blocks;
    AlignedVector<double> u, v, f; ///< f: internal forces
    std::vector<double>   mass;
    double                step = 1e300;
    ElementEnergy         energy;

    Body(const Mesh       &m,
         const Elasticity &material,
         const Plasticity &plasticity,
         const int         width = native_width)
      : mesh(m)
      , blocks(pack_elements(m.geometry, m.cells, material, width))
      , u(4 * m.vertices.size(), 0.)
      , v(u)
      , f(u)
      , mass(m.vertices.size(), 0.)
    {
      set_plasticity(blocks, plasticity);
      for (std::size_t e = 0; e < m.cells.size(); ++e)
        {
          for (int a = 0; a < 8; ++a)
            mass[m.cells[e][a]] += material.density * m.geometry[e].node_volume[a];
          step = std::min(step, 2 / std::sqrt(element_frequency_bound(m.geometry[e], material)));
        }
    }

    void
    find_force(const BulkViscosity &viscosity = {})
    {
      std::fill(f.begin(), f.end(), 0.);
      energy = ElementEnergy();
      subtract_internal_force(blocks, u.data(), f.data(), viscosity, true, energy);
      for (double &x : f)
        x = -x;
    }

    /// Sets a displacement and returns the work that goes with it, by the trapezoidal rule [J].
    double
    move_to(const AlignedVector<double> &target)
    {
      const auto before = f, from = u;
      u = target;
      find_force();
      double work = 0;
      for (std::size_t k = 0; k < u.size(); ++k)
        work += 0.5 * (before[k] + f[k]) * (u[k] - from[k]);
      return work;
    }

    double
    stored() const
    {
      return energy.strain + energy.stabilisation;
    }
  };

  AlignedVector<double>
  nodal(const Mesh &mesh, const std::function<Vector(const Vector &)> &field)
  {
    AlignedVector<double> u(4 * mesh.vertices.size(), 0.);
    for (std::size_t n = 0; n < mesh.vertices.size(); ++n)
      {
        const Vector value = field(mesh.vertices[n]);
        std::copy(value.begin(), value.end(), &u[4 * n]);
      }
    return u;
  }

  double
  largest(const AlignedVector<double> &x)
  {
    double m = 0;
    for (const double value : x)
      m = std::max(m, std::abs(value));
    return m;
  }

  double
  difference(const AlignedVector<double> &a, const AlignedVector<double> &b)
  {
    double m = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
      m = std::max(m, std::abs(a[k] - b[k]));
    return m;
  }

  const Plasticity soft{100e6, 2.1e9, 0.4}, perfect{100e6, 0, 0};

  void
  patch_test()
  {
    Body body(brick({3, 3, 3}, {1, 1, 1}, 0.25), Elasticity(), soft);
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
    test::check(strain[0] > 1e-3, "patch test: cells yield");
    test::check_near(spread, 0, 1e-11, "patch test: equal stress and plastic strain in distorted cells");
    double inner = 0;
    for (int k = 1; k < 3; ++k)
      for (int j = 1; j < 3; ++j)
        for (int i = 1; i < 3; ++i)
          for (int c = 0; c < 3; ++c)
            inner = std::max(inner, std::abs(body.f[4 * body.mesh.node(i, j, k) + c]));
    test::check_near(inner / largest(body.f), 0, 1e-12, "patch test: inner forces vanish");
    test::check_near(body.energy.stabilisation / body.energy.strain, 0, 1e-20, "no stabilisation energy");
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
    Body         rest(brick({2, 2, 2}, {1, 1, 1}, 0.2), Elasticity(), soft), turning = rest;
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
    test::check(largest(AlignedVector<double>(rest.blocks.history)) > 1e-3, "rough deformation yields");
    test::check_near(difference(rest.blocks.history, turning.blocks.history),
                     0,
                     1e-13,
                     "ten turns leave the plastic history as it is at rest");
    test::check_near(difference(back, rest.f) / largest(rest.f), 0, 1e-9, "forces turn with the body");
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
        test::check_near(force[i] / largest(rest.f), 0, 1e-12, "forces sum to zero");
        test::check_near(moment[i] / largest(rest.f), 0, 1e-12, "moments sum to zero");
      }
  }

  void
  energy(const Plasticity &plasticity, const std::string &name)
  {
    Body      body(brick({2, 2, 2}, {1, 1, 1}, 0.2), Elasticity(), plasticity);
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
    test::check(body.energy.plastic_work > 10 * body.stored(), "most of the work is plastic" + name);
    test::check_near((body.stored() + body.energy.plastic_work) / work,
                     1,
                     2e-4,
                     "strain, stabilisation and plastic work are the external work" + name);
    if (plasticity.kinematic_fraction == 0)
      test::check(monotone, "plastic work only grows" + name);
  }

  void
  widths()
  {
    const Mesh mesh = brick({3, 3, 3}, {1, 1, 1}, 0.2);
    Body       one(mesh, Elasticity(), soft, 1);
    for (const int width : {2, 4, 8})
      {
        Body body(mesh, Elasticity(), soft, width);
        Body single = one;
        for (const double amount : {0.2, 1., -0.5, 0.1})
          for (Body *b : {&body, &single})
            b->move_to(nodal(mesh, [&](const Vector &X) { return rough(X, amount); }));
        test::check_near(difference(body.f, single.f) / largest(single.f),
                         0,
                         1e-11,
                         "width " + std::to_string(width) + " equals width 1");
        test::check_near((body.energy.plastic_work - single.energy.plastic_work) / single.energy.plastic_work,
                         0,
                         1e-12,
                         "and so does its plastic work");
      }
    Body elastic(mesh, Elasticity(), Plasticity()), strong(mesh, Elasticity(), {1e12, 21e9, 0});
    for (Body *b : {&elastic, &strong})
      b->move_to(nodal(mesh, [&](const Vector &X) { return rough(X, 1); }));
    test::check_near(difference(elastic.f, strong.f) / largest(elastic.f),
                     0,
                     1e-14,
                     "far below yield a plastic body is an elastic one");
  }

  /// Moment over fully plastic moment of a beam of `layers` cells through its height, bent uniformly to
  /// `curvature` times that of first yield, then to `last`: damped dynamics with the ends' rotation held.
  /// The step is small since a free cell breathes faster than one in a body.
  double
  bending_moment(const int         layers,
                 const Plasticity &plasticity,
                 const double      curvature,
                 const double      last,
                 Body             &body)
  {
    const double h = 1e-3, length = 2 * h / layers;
    body                     = Body(brick({2, layers, 1}, {length, h, h}), Elasticity(), plasticity);
    const double first_yield = plasticity.yield_stress / (body.blocks.material.youngs_modulus * h / 2);
    const int    steps       = 8000 * layers;
    double       moment      = 0;
    for (int n = 1; n <= steps; ++n)
      {
        // up in the first 60 %, to the last value until 80 %, then rest
        const double t  = double(n) / steps;
        const double up = std::min(t / 0.6, 1.), down = std::clamp((t - 0.6) / 0.2, 0., 1.);
        const double kappa = first_yield * (curvature * up + (last - curvature) * down);
        for (std::size_t k = 0; k < body.u.size(); ++k)
          {
            body.v[k] = 0.98 * body.v[k] - 0.6 * body.step * body.f[k] / body.mass[k / 4];
            body.u[k] += 0.6 * body.step * body.v[k];
          }
        for (std::size_t node = 0; node < body.mesh.vertices.size(); ++node)
          {
            const Vector &X = body.mesh.vertices[node];
            if (X[0] == 0 || X[0] == length)
              body.u[4 * node] = kappa * (X[1] - h / 2) * (X[0] == 0 ? 0.5 : -0.5) * length;
          }
        body.find_force();
        moment = 0;
        for (std::size_t node = 0; node < body.mesh.vertices.size(); ++node)
          if (body.mesh.vertices[node][0] == 0)
            moment += body.f[4 * node] * (body.mesh.vertices[node][1] - h / 2);
      }
    return moment / (plasticity.yield_stress * h * h * h / 4);
  }

  void
  fully_plastic_moment()
  {
    Body body(brick({1, 1, 1}, {1, 1, 1}), Elasticity(), perfect);
    for (const int layers : {1, 2, 3, 4, 8})
      {
        const double moment = bending_moment(layers, perfect, 10, 10, body);
        test::check_near(moment,
                         1,
                         layers == 2 ? 0.06 : 0.02,
                         "fully plastic moment of " + std::to_string(layers) + " layers");
      }
    // unloading from 10 to 9 times the curvature of first yield is elastic: M = E I kappa
    const double full = bending_moment(1, perfect, 10, 10, body);
    const double less = bending_moment(1, perfect, 10, 9, body);
    test::check_near(full - less, 2. / 3, 0.005, "a plastic hinge unloads with its elastic stiffness");
  }

  struct Impact
  {
    double energy_error; ///< largest imbalance over the kinetic energy at the start
    double plastic;      ///< plastic work over the same
    double strain;       ///< largest plastic strain
    double rebound;      ///< largest displacement over the bar's length
  };

  /// A bar of 24 x 3 x 3 cells of the aspect ratio given whose left third hits the rest, `overload`
  /// times as fast as makes the pressure wave yield. The first cells yield within one step, which is
  /// `part` of the stable one.
  Impact
  impact(const Elasticity &material,
         const Plasticity &plasticity,
         const double      aspect,
         const double      overload,
         const double      part)
  {
    const double h = 1e-3, length = 24 * h / aspect;
    Body         body(brick({24, 3, 3}, {length, 3 * h, 3 * h}), material, plasticity);
    const double viscosity = 0.06;
    // every cell is at a free surface, where it breathes in three directions: see element.md
    const double lambda = material.lame_lambda(), mu = material.shear_modulus();
    const double step = part * std::sqrt((lambda + 2 * mu) / (3 * lambda + 2 * mu)) * body.step;
    // a wave of uniaxial strain v / (2 c) has the equivalent stress mu v / c
    const double speed =
      overload * plasticity.yield_stress * material.wave_speed() / material.shear_modulus();
    double start = 0;
    for (std::size_t n = 0; n < body.mass.size(); ++n)
      {
        body.v[4 * n] = body.mesh.vertices[n][0] < 8.5 * length / 24 ? speed : 0;
        start += 0.5 * body.mass[n] * body.v[4 * n] * body.v[4 * n];
      }
    Impact result{};
    double viscous = 0;
    body.find_force({0, step});
    const int steps = std::lround(360 / part); // the same time whatever the step
    for (int n = 0; n < steps; ++n)
      {
        for (std::size_t k = 0; k < body.u.size(); ++k)
          {
            body.v[k] -= (n == 0 ? 0.5 : 1) * step * body.f[k] / body.mass[k / 4];
            body.u[k] += step * body.v[k];
          }
        body.find_force({viscosity, step});
        viscous += step * body.energy.viscous_power;
        double kinetic = 0;
        for (std::size_t k = 0; k < body.u.size(); ++k)
          {
            const double ahead = body.v[k] - step * body.f[k] / body.mass[k / 4];
            kinetic += 0.5 * body.mass[k / 4] * body.v[k] * ahead; // the form that central differences keep
            result.rebound = std::max(result.rebound, std::abs(body.u[k]) / length);
          }
        const double total = kinetic + body.stored() + body.energy.plastic_work + viscous;
        result.energy_error =
          std::max(std::abs(total / start - 1), result.energy_error); // lets a NaN through
      }
    result.plastic = body.energy.plastic_work / start;
    for (const double strain : element_plastic_strain(body.blocks))
      result.strain = std::max(result.strain, strain);
    return result;
  }

  void
  hard_cases()
  {
    for (const double poissons_ratio : {0.3, 0.49})
      for (const double tangent : {0., 0.21e9, 21e9})
        for (const double aspect : {1., 20.})
          {
            Elasticity material;
            material.poissons_ratio = poissons_ratio;
            const Plasticity  plasticity{500e6, tangent, 0.5};
            const Impact      r    = impact(material, plasticity, aspect, 2, 0.9);
            const Impact      half = impact(material, plasticity, aspect, 2, 0.45);
            const std::string name = "impact, nu " + std::to_string(poissons_ratio).substr(0, 4) + ", E_t " +
                                     std::to_string(tangent / 1e9).substr(0, 5) + " GPa, aspect ratio " +
                                     std::to_string(int(aspect));
            std::cout << "        " << name << ": plastic work " << r.plastic << " of the start, strain "
                      << r.strain << ", largest displacement " << r.rebound << ", energy error "
                      << r.energy_error << ", with half the step " << half.energy_error << std::endl;
            // In cells that yield within one step the stress before it is not known to the book of
            // plastic work, and the viscosity's power is taken half a step behind: 1.2 to 1.9 % at the
            // stable step. Both are errors of second order.
            test::check(half.energy_error < 0.01, name + ": energy error below 1 % with half the step");
            test::check(r.energy_error > 3 * half.energy_error, name + ": which is of second order");
            test::check(r.plastic > 0.01 && r.plastic < 1, name + ": part of the energy is plastic work");
          }
  }
} // namespace

int
main()
{
  patch_test();
  rotation();
  energy(soft, " (mixed hardening)");
  energy(perfect, " (perfect plasticity)");
  energy({100e6, 21e9, 1}, " (kinematic hardening)");
  widths();
  fully_plastic_moment();
  hard_cases();
  return test::report();
}
