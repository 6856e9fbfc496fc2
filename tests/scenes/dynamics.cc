#include "dynamics.h"

#include <cmath>
#include <random>

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


  Program::Program(int &argc, char **&argv)
  {
    MPI_Init(&argc, &argv);
  }

  Program::~Program()
  {
    MPI_Finalize();
  }


  Dynamics::Dynamics(LocalMesh mesh, const Setup &setup)
    : solid(make_solid(std::move(mesh),
                       setup.material,
                       setup.wheel_material.value_or(setup.material),
                       setup.bulk_viscosity,
                       MPI_COMM_SELF,
                       {setup.plasticity, setup.plasticity},
                       {setup.form, setup.form}))
    , time_step(setup.step_factor * solid.stable.step)
    , mass_damping(setup.mass_damping)
    , bulk_viscosity_(setup.bulk_viscosity)
    , external_(solid.force.size(), 0.)
  {
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mass[n] > 0)
        masses_.push_back(n);
  }


  unsigned int
  Dynamics::add_tie(const Nodes &nodes, const int component, const int side, const Function &value)
  {
    Tie tie{{}, static_cast<unsigned int>(component), side, value, 0};
    for (const unsigned int n : nodes)
      if (solid.mass[n] > 0)
        tie.nodes.push_back(n);
    ties_.push_back(tie);
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
  Dynamics::add_force(const Force &force)
  {
    forces_.push_back(force);
  }


  void
  Dynamics::press(const std::vector<BoundaryFace> &faces, const Function &pressure)
  {
    // integrals of shape function times outward normal, 2 x 2 Gauss points
    std::vector<double> loads(4 * solid.mesh.n_nodes(), 0.);
    for (const auto &face : faces)
      for (int q = 0; q < 4; ++q)
        {
          const double x     = 0.5 + (q & 1 ? 0.5 : -0.5) / std::sqrt(3.),
                       y     = 0.5 + (q >> 1 ? 0.5 : -0.5) / std::sqrt(3.);
          const double N[4]  = {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
          const double dx[4] = {y - 1, 1 - y, -y, y}, dy[4] = {x - 1, -x, 1 - x, x};
          Vector3      a{}, b{};
          for (int k = 0; k < 4; ++k)
            {
              add(a, dx[k], place_of(solid.mesh, face.nodes[k]));
              add(b, dy[k], place_of(solid.mesh, face.nodes[k]));
            }
          const Vector3 normal = cross(a, b);
          for (int k = 0; k < 4; ++k)
            for (int i = 0; i < 3; ++i)
              loads[4 * face.nodes[k] + i] += 0.25 * N[k] * normal[i];
        }
    add_force([loads, pressure](const double time, const Solid &, double *force) {
      const double p = pressure(time);
      for (std::size_t k = 0; k < loads.size(); ++k)
        force[k] -= p * loads[k];
    });
  }


  void
  Dynamics::add_internal_forces(const bool with_energy)
  {
    // the first call only records the dilatation
    const BulkViscosity viscosity{steps_ == 0 ? 0. : bulk_viscosity_, bulk_viscosity_ > 0 ? time_step : 0.};
    std::fill(solid.force.begin(), solid.force.end(), 0.);
    elements_ = ElementEnergy();
    for (auto &blocks : solid.blocks)
      if (blocks.n_elements > 0)
        subtract_internal_force(
          blocks, solid.displacement.data(), solid.force.data(), viscosity, with_energy, elements_);
    condense(solid.mesh, solid.force.data());
  }


  void
  Dynamics::add_external_forces()
  {
    if (forces_.empty())
      return;
    std::fill(external_.begin(), external_.end(), 0.);
    for (const auto &force : forces_)
      force(time_, solid, external_.data());
    condense(solid.mesh, external_.data());
    for (std::size_t k = 0; k < external_.size(); ++k)
      solid.force[k] += external_[k];
  }


  void
  Dynamics::move_nodes(const double kick)
  {
    double *v = solid.velocity.data(), *u = solid.displacement.data();
    for (const unsigned int n : masses_)
      {
        const double factor = kick / mass(n), damping = 0.5 * kick * mass_damping;
        for (int i = 0; i < 3; ++i)
          {
            // the damping force belongs to the mean of the velocities of both half steps
            v[4 * n + i] = ((1 - damping) * v[4 * n + i] + factor * solid.force[4 * n + i]) / (1 + damping);
            u[4 * n + i] += time_step * v[4 * n + i];
          }
      }
  }


  void
  Dynamics::apply(Tie &tie, const double kick)
  {
    const double value = tie.value(time_ + time_step);
    tie.reaction       = 0;
    for (const unsigned int n : tie.nodes)
      {
        const unsigned int k = 4 * n + tie.component;
        double            &u = solid.displacement[k], &v = solid.velocity[k];
        const double       target = tie.side == 0 ? value : value - solid.mesh.reference[k];
        if (tie.side != 0 && tie.side * (u - target) >= 0)
          continue;
        const double before = u - time_step * v, velocity = (target - before) / time_step;
        const double force = mass(n) / kick * (velocity - v) * (1 + 0.5 * kick * mass_damping);
        tie.reaction += force;
        energy_.work += kick * force * 0.5 * (velocity_before_[k] + velocity);
        v = velocity;
        u = target;
      }
  }


  void
  Dynamics::step(const bool with_energy)
  {
    const bool   first = steps_ == 0;
    const double kick  = first ? time_step / 2 : time_step;
    add_internal_forces(first || with_energy);
    add_external_forces();
    velocity_before_    = solid.velocity;
    const Energy before = energy_;
    move_nodes(kick);
    for (auto &tie : ties_)
      apply(tie, kick);
    distribute(solid.mesh, solid.displacement.data());

    energy_.viscous += time_step * elements_.viscous_power; // of the step behind
    // forces work with the mean of the velocities of both half steps
    for (const unsigned int n : masses_)
      for (unsigned int k = 4 * n; k < 4 * n + 3; ++k)
        {
          const double way = kick * 0.5 * (velocity_before_[k] + solid.velocity[k]);
          energy_.work += external_[k] * way;
          energy_.damping += mass_damping * mass(n) * way * way / kick;
        }
    time_ += time_step;
    ++steps_;
    if (first || with_energy)
      balance(before);
  }


  void
  Dynamics::balance(const Energy &before)
  {
    // states belong to the full step, works to the half steps around it: their means
    const bool   first = steps_ == 1;
    const double share = first ? 0 : 0.5;
    balance_.kinetic   = 0;
    for (const unsigned int n : masses_)
      for (unsigned int k = 4 * n; k < 4 * n + 3; ++k)
        balance_.kinetic +=
          0.5 * mass(n) * velocity_before_[k] * (first ? velocity_before_[k] : solid.velocity[k]);
    balance_.work          = before.work + share * (energy_.work - before.work);
    balance_.viscous       = energy_.viscous;
    balance_.damping       = before.damping + share * (energy_.damping - before.damping);
    balance_.strain        = elements_.strain;
    balance_.stabilisation = elements_.stabilisation;
    balance_.plastic       = elements_.plastic_work;
    if (first)
      balance_.start = balance_.residual();
  }


  void
  Dynamics::run_to(const double time)
  {
    while (time_ < time)
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
    Solid  body = solid;
    Vector free(body.force.size(), 0.);
    for (const unsigned int n : masses_)
      for (int i = 0; i < 3; ++i)
        free[4 * n + i] = 1;
    for (const auto &tie : ties_)
      for (const unsigned int n : tie.nodes)
        free[4 * n + tie.component] = tie.side == 0 ? 0 : free[4 * n + tie.component];
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
        for (auto &blocks : body.blocks)
          if (blocks.n_elements > 0)
            subtract_internal_force(blocks, u.data(), f.data(), BulkViscosity(), false, ignored);
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
