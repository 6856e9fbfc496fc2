#include "dynamics.h"
#include "make_solid.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace scenes
{
  using namespace wheelrail;

  std::vector<Setup>
  each_form(const Setup &setup)
  {
    std::vector<Setup> result = {setup, setup};
    result[0].form = ElementForm::reduced, result[1].form = ElementForm::full;
    return result;
  }


  std::string
  form_name(const Setup &setup)
  {
    return setup.form == ElementForm::reduced ? "reduced" : "full";
  }


  Dynamics::Dynamics(LocalMesh mesh, const Setup &setup)
    : solid(make_solid(std::move(mesh),
                       material_law(setup.material, setup.plasticity),
                       material_law(setup.wheel_material.value_or(setup.material), setup.plasticity),
                       setup.bulk_viscosity,
                       MPI_COMM_SELF,
                       {setup.form, setup.form}))
    , time_step(setup.step_factor * solid.stable.step)
    , mass_damping(setup.mass_damping)
    , loop_(solid, {time_step, setup.bulk_viscosity, setup.mass_damping}, MPI_COMM_SELF)
  {
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mass[n] > 0)
        masses_.push_back(n);
  }


  unsigned int
  Dynamics::add_tie(const Nodes &nodes, const int component, const int side, const Function &value)
  {
    Nodes moving;
    for (const unsigned int n : nodes)
      if (solid.mass[n] > 0)
        moving.push_back(n);
    ties_.push_back(std::make_unique<Tie>(moving, component, side, value));
    return ties_.size() - 1;
  }


  unsigned int
  Dynamics::prescribe(const Nodes &nodes, const int component, const Function &displacement)
  {
    return add_tie(nodes, component, 0, displacement);
  }


  unsigned int
  Dynamics::fix(const Nodes &nodes, const int component)
  {
    return add_tie(nodes, component, 0, [](double) { return 0.; });
  }


  unsigned int
  Dynamics::wall(const Nodes &nodes, const int component, const int side, const Function &level)
  {
    return add_tie(nodes, component, side, level);
  }


  void
  Dynamics::join(const Nodes &one, const Nodes &other)
  {
    seams_.push_back(std::make_unique<Seam>(one, other));
  }


  void
  Dynamics::add_force(const NodalLoad::Force &force)
  {
    loads_.push_back(std::make_unique<NodalLoad>(force));
  }


  void
  Dynamics::press(const std::vector<BoundaryFace> &faces, const Function &pressure)
  {
    add_force(dead_pressure(solid.mesh, faces, pressure));
  }


  void
  Dynamics::step(const bool with_energy)
  {
    const bool first = loop_.steps() == 0;
    if (first)
      {
        // loads before seams and these before ties: reactions are to all forces
        for (auto &load : loads_)
          loop_.add(*load);
        for (auto &seam : seams_)
          loop_.add(*seam);
        for (auto &tie : ties_)
          loop_.add(*tie);
        loop_.prepare();
      }
    loop_.scheme.time_step    = time_step;
    loop_.scheme.mass_damping = mass_damping;
    loop_.step(first || with_energy);
  }


  void
  Dynamics::run_to(const double time)
  {
    while (loop_.time() < time)
      step();
  }


  double
  Dynamics::kinetic_energy() const
  {
    double sum = 0;
    for (const unsigned int n : masses_)
      {
        const double *v = &solid.velocity[4 * n];
        sum += 0.5 * mass(n) * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      }
    return sum;
  }

  double
  Dynamics::highest_frequency(const unsigned int iterations) const
  {
    using Vector = wheelrail::AlignedVector<double>;
    Solid  body  = solid;
    Vector free(body.force.size(), 0.);
    for (const unsigned int n : masses_)
      for (int i = 0; i < 3; ++i)
        free[4 * n + i] = 1;
    for (const auto &tie : ties_)
      if (tie->prescribed())
        for (const unsigned int n : tie->nodes())
          free[4 * n + tie->component()] = 0;
    Vector      &u = body.displacement, &f = body.force;
    std::mt19937 random(1);
    for (std::size_t k = 0; k < u.size(); ++k)
      u[k] = free[k] * std::uniform_real_distribution<double>(-1, 1)(random);
    const double size   = 1e-9 * solid.quality.smallest; // so small that the forces are linear
    double       square = 0;
    for (unsigned int k = 0; k < iterations; ++k)
      {
        double largest = 0;
        for (const double x : u)
          largest = std::max(largest, std::abs(x));
        for (double &x : u)
          x *= size / largest;
        distribute(body.mesh, u.data());
        std::fill(f.begin(), f.end(), 0.);
        ElementEnergy ignored;
        subtract_internal_force(body.blocks, u.data(), f.data(), BulkViscosity(), false, ignored);
        condense(body.mesh, f.data());
        double uKu = 0, uMu = 0;
        for (const unsigned int n : masses_)
          for (unsigned int i = 4 * n; i < 4 * n + 3; ++i)
            {
              uKu -= free[i] * u[i] * f[i];
              uMu += free[i] * u[i] * u[i] * mass(n);
              u[i] = -free[i] * f[i] / mass(n);
            }
        square = uKu / uMu;
      }
    return std::sqrt(square);
  }
} // namespace scenes
