#include <wheelrail/halfspace/added_influence.h>
#include <wheelrail/halfspace/friction_field.h>
#include <wheelrail/halfspace/kernels.h>
#include <wheelrail/halfspace/measures.h>
#include <wheelrail/halfspace/normal.h>
#include <wheelrail/halfspace/plastic_layer.h>
#include <wheelrail/halfspace/simplified.h>
#include <wheelrail/halfspace/tangential.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

// Rolling contact of two half-spaces (doc/theory/halfspace.md, Equations): normal problem, tangential
// problem, and what ties them, by turns until they settle (Panagiotopoulos 1975): tractions of unlike bodies
// move surfaces along the normal, pressures along the tangent; friction follows the slip speed.

namespace wheelrail
{
  namespace
  {
    using Spectrum = InfluenceProducts::Spectrum;

    /// One problem while it is solved.
    class Solver
    {
    public:
      Solver(const HalfspaceProblem  &problem,
             HalfspaceKernels        &kernels,
             const HalfspaceSolution *guess = nullptr)
        : problem_(problem)
        , grid_(problem.grid)
        , kernels_(kernels)
        , products_(kernels.products())
        , pressure_given_(!problem.pressure.empty())
        , coupled_(!problem.simplified &&
                   std::abs(kernels.constants().coupling) > 1e-12 * kernels.constants().normal)
        , friction_(problem.motion != HalfspaceMotion::none)
      {
        for (int j = 0; j < grid_.my; ++j)
          {
            const FrictionLaw &law = problem.friction_of_row(j);
            friction_varies_       = friction_varies_ || (!problem.simplified && law.depends_on_speed());
            largest_friction_      = std::max(largest_friction_, law.largest());
          }
        friction_varies_ = friction_varies_ || !problem.hot_friction.empty();
        const bool shift = problem.motion == HalfspaceMotion::shift;
        solution_.grid   = grid_;
        // dq of the relative slip s = w + (u - u')/dq; a shift has no length, so that its slip is a distance
        // [m]
        solution_.step = shift ? 1. : problem.step > 0 ? problem.step : grid_.dx;
        offset_        = shift ? 0. : solution_.step;
        // a guess saves steps; the solution is the same to the tolerances
        if (guess && guess->grid.mx == grid_.mx && guess->grid.my == grid_.my)
          {
            normal_.pressure = guess->pressure;
            if (friction_ && guess->within_friction)
              tangential_.traction = {{guess->traction_x, guess->traction_y}};
          }
        if (pressure_given_)
          {
            normal_.pressure  = problem.pressure;
            normal_.converged = true;
          }
      }

      HalfspaceSolution
      run();

    private:
      /// Adds factor times the displacement a (seen `ahead`) of a traction field in direction b.
      void
      add_displacement(const int                  a,
                       const int                  b,
                       const double               ahead,
                       const std::vector<double> &traction,
                       const double               factor,
                       std::vector<double>       &result)
      {
        // u_a = A_ab t_b by FFT; `ahead` > 0: where the particle was one step before
        Spectrum            s;
        std::vector<double> u;
        products_.forward(traction, s);
        const Spectrum &k = kernels_.of(a, b, ahead);
        for (std::size_t m = 0; m < s.size(); ++m)
          s[m] = times(s[m], k[m]);
        products_.backward(s, u);
        for (std::size_t e = 0; e < u.size(); ++e)
          result[e] += factor * u[e];
      }

      /// False when the friction of this round does not carry the force asked for.
      bool
      tangential_problem();
      VectorField
      rigid_slip(const std::vector<RunIn> &run_in);
      /// Sets the coefficients to the slip of the last round; the largest change over the larger coefficient
      /// of the law.
      double
      update_friction();
      void
      displacements();

      const HalfspaceProblem &problem_;
      HalfspaceGrid           grid_;
      HalfspaceKernels       &kernels_;
      InfluenceProducts      &products_;
      bool                    pressure_given_, coupled_, friction_, friction_varies_ = false;
      double                  largest_friction_ = 0; ///< of all rows and speeds
      double                  offset_           = 0;
      NormalContact           normal_;
      TangentialState         tangential_;
      std::vector<double>     mu_;
      SlipKernels             displacement_; ///< of steps of several elements in steady rolling: A / step
      double                  weight_ = 1;   ///< of the steps of the coefficients
      std::vector<double>     last_steps_;   ///< of the coefficients
      HalfspaceSolution       solution_;
    };

    // w: all of the slip that does not depend on the tractions of this step (doc/theory/halfspace.md, Frame
    // and signs, Equations): spin and given fields; of unlike bodies what the pressure shifts; in a shift or
    // a step of transient rolling -u'/dq of the state before, which steady rolling has in B.
    VectorField
    Solver::rigid_slip(const std::vector<RunIn> &run_in)
    {
      VectorField  w;
      const double ahead =
        problem_.motion == HalfspaceMotion::shift ? 0. : problem_.spin_offset * solution_.step;
      // w_x = xi - phi y, w_y = eta + phi (x + dq/6), without the creepages, which solve_tangential() adds;
      // CONTACT counts the spin dq/6 ahead of the element (`spin_offset`)
      const auto  &L      = problem_.simplified; // spin counts by its own flexibility there
      const double spin_x = problem_.phi * (L ? L->along / L->spin : 1),
                   spin_y = problem_.phi * (L ? L->across / L->spin : 1);
      w[0]                = sampled_distance(grid_, [&](double, double y) { return -spin_x * y; });
      w[1]                = sampled_distance(grid_, [&](double x, double) { return spin_y * (x + ahead); });
      for (std::size_t e = 0; e < w[0].size(); ++e)
        {
          if (!problem_.rigid_slip_x.empty())
            w[0][e] += problem_.rigid_slip_x[e];
          if (!problem_.rigid_slip_y.empty())
            w[1][e] += problem_.rigid_slip_y[e];
        }
      const double per_step = 1 / solution_.step;
      const bool   steady   = problem_.motion == HalfspaceMotion::steady;
      for (int d = 0; d < 2; ++d)
        {
          // u_d/dq at the end of the step, at its begin, and at the begin on the leading edge
          std::vector<double> now(w[d].size(), 0.), before = now, edge = now;
          if (coupled_)
            {
              // unlike materials: slip of the pressure, (u(p) - u'(p))/dq with u_x = A_xn p, u_y = A_yn p
              add_displacement(d, 2, 0, normal_.pressure, per_step, now);
              if (steady)
                add_displacement(d, 2, offset_, normal_.pressure, per_step, before);
            }
          if (steady && problem_.added)
            problem_.added->add_slip({{nullptr, nullptr, &normal_.pressure}},
                                     {{d == 0 ? &w[0] : nullptr, d == 1 ? &w[1] : nullptr, nullptr}});
          if (!steady && problem_.previous)
            {
              // shift and transient rolling: -u'/dq of the state before, moved on by dq; what runs in has
              // that of the leading edge, as CONTACT takes it
              const HalfspaceSolution &old = *problem_.previous;
              for (const auto &[ahead, u] : {std::pair{offset_, &before}, std::pair{0., &edge}})
                {
                  if (u == &edge && run_in.empty())
                    continue;
                  add_displacement(d, 0, ahead, old.traction_x, per_step, *u);
                  add_displacement(d, 1, ahead, old.traction_y, per_step, *u);
                  if (coupled_)
                    add_displacement(d, 2, ahead, old.pressure, per_step, *u);
                }
            }
          const std::vector<double> rigid = w[d];
          for (std::size_t e = 0; e < rigid.size(); ++e)
            w[d][e] += now[e] - before[e];
          for (const RunIn &r : run_in)
            w[d][r.element] =
              rigid[r.element] + (now[r.element] - (steady ? now : edge)[std::size_t(r.edge)]) / r.share;
        }
      return w;
    }

    bool
    Solver::tangential_problem()
    {
      TangentialTask task;
      if (!problem_.simplified)
        task.kernels = &kernels_.slip(solution_.step, problem_.motion == HalfspaceMotion::steady);
      task.added        = problem_.added.get();
      task.grid         = grid_;
      task.run_in       = elements_run_in(problem_, solution_.step, normal_.pressure);
      task.rigid_slip   = rigid_slip(task.run_in);
      const bool steady = problem_.motion == HalfspaceMotion::steady;
      if (steady && !task.run_in.empty() && displacement_.xx.empty())
        displacement_ = slip_kernels(products_, kernels_.constants(), grid_, solution_.step, false);
      task.displacement = steady ? &displacement_ : nullptr;
      // a force along x alone, or both: the moment is a result
      task.force_given = {{problem_.longitudinal_force_given, problem_.lateral_force_given}};
      task.force       = {{problem_.fx, problem_.fy}};
      task.tolerance   = problem_.tangential_tolerance;
      task.max_steps   = problem_.max_newton_steps;
      task.yield       = brought_yield(problem_);
      // slips are over the step: h |s| dq of plastic shift hardens by this [Pa]
      task.hardening   = problem_.layer_hardening * solution_.step;
      task.least_yield = 0.1 * problem_.layer_yield;
      task.carried     = problem_.motion == HalfspaceMotion::steady;
      task.bound.resize(grid_.size());
      double limit = 0;
      for (std::size_t e = 0; e < task.bound.size(); ++e)
        {
          // Coulomb: |t| <= g = mu p; the forces that it carries in all, sum of g dx dy
          task.bound[e] = mu_[e] * normal_.pressure[e];
          limit += task.bound[e] * grid_.element_area();
        }
      // a force beyond sum(mu p) dA spins up: no tractions
      const double asked =
        std::hypot(task.force_given[0] ? task.force[0] : 0., task.force_given[1] ? task.force[1] : 0.);
      // 1e-9: at the limit itself the creepage is infinite
      const bool carried = asked == 0 || asked < limit * (1 - 1e-9);
      if (!carried || limit == 0)
        {
          for (int d = 0; d < 2; ++d)
            {
              tangential_.traction[d].assign(grid_.size(), 0.);
              tangential_.slip[d].assign(grid_.size(), 0.);
            }
          tangential_.slipping.assign(grid_.size(), 1);
          tangential_.converged = true;
          return carried;
        }
      if (problem_.simplified)
        solve_simplified(problem_, solution_.step, normal_.pressure, task, tangential_, mu_);
      else
        // from the tractions of the last round on
        solve_tangential(products_, task, tangential_);
      solution_.newton_steps += tangential_.newton_steps;
      solution_.krylov_iterations += tangential_.krylov_iterations;
      return true;
    }

    double
    Solver::update_friction()
    {
      double change = 0;
      if (!friction_varies_ || tangential_.slip[0].empty())
        return change;
      const std::vector<double> wanted = friction_field(
        problem_,
        solution_.step,
        tangential_.slip,
        normal_.pressure,
        problem_.hot_friction.empty() ? std::vector<double>()
                                      : temperatures_in_rolling(problem_, normal_.pressure, tangential_)[0]);
      // fixed point mu = mu(|s(mu)| V), relaxed: friction that falls with speed makes the map steep
      std::vector<double> steps(mu_.size(), 0.);
      double              same = 0; // direction as in the round before
      for (std::size_t e = 0; e < mu_.size(); ++e)
        if (normal_.pressure[e] > 0)
          {
            steps[e] = wanted[e] - mu_[e];
            change   = std::max(change, std::abs(steps[e]) / largest_friction_);
            same += last_steps_.empty() ? 0 : steps[e] * last_steps_[e];
          }
      // in steady rolling whole steps may swing; slow ones of one direction go on towards the first solution
      weight_ = same < 0 ? std::max(0.02, 0.6 * weight_) : std::min(1., 1.2 * weight_);
      for (std::size_t e = 0; e < mu_.size(); ++e)
        mu_[e] += weight_ * (normal_.pressure[e] > 0 ? steps[e] : wanted[e] - mu_[e]);
      last_steps_ = std::move(steps);
      return change;
    }

    HalfspaceSolution
    Solver::run()
    {
      // from rest: the solution with the least slip; from_sliding: that with the most
      tangential_.creepage = {{problem_.xi, problem_.eta}};
      mu_.resize(std::size_t(grid_.size()));
      for (int e = 0; e < grid_.size(); ++e)
        mu_[std::size_t(e)] =
          problem_.friction_of_row(e / grid_.mx).at(problem_.from_sliding ? problem_.velocity : 0);
      for (solution_.coupling_rounds = 1;; ++solution_.coupling_rounds)
        {
          const std::vector<double> old = normal_.pressure;
          // 1. pressure under the tractions of the last round
          if (!pressure_given_ && (solution_.coupling_rounds == 1 || coupled_))
            {
              solve_normal_problem(problem_, kernels_, coupled_, tangential_.traction, normal_);
              solution_.normal_iterations += normal_.iterations;
            }
          double change = 0, peak = 0;
          for (std::size_t e = 0; e < old.size(); ++e)
            {
              change = std::max(change, std::abs(normal_.pressure[e] - old[e]));
              peak   = std::max(peak, normal_.pressure[e]);
            }
          // 2. coefficients of the slip of the last round
          const double friction_change = update_friction();
          solution_.coupling_converged =
            !friction_ || (!coupled_ && !friction_varies_) ||
            (solution_.coupling_rounds > 1 && change <= problem_.coupling_tolerance * peak &&
             friction_change <= problem_.coupling_tolerance);
          const bool last = solution_.coupling_rounds == problem_.max_coupling_rounds;
          // 3. tractions; after a settled round those of that round are kept
          if (friction_ && (solution_.coupling_rounds == 1 || !solution_.coupling_converged))
            solution_.within_friction = tangential_problem();
          if (solution_.coupling_converged || last || !solution_.within_friction)
            break;
        }
      // 4. Displacements, temperatures, state of the layer, sums
      displacements();
      // heat of this solution's own slip; temperatures that change friction were those of each round
      if (problem_.heat && problem_.motion == HalfspaceMotion::steady)
        solution_.temperature = temperatures_in_rolling(problem_, normal_.pressure, tangential_);
      set_layer_state(problem_, tangential_, solution_);
      solution_.xi  = tangential_.creepage[0];
      solution_.eta = tangential_.creepage[1];
      solution_.phi = problem_.phi;
      measure(problem_, friction_ ? tangential_.slipping : std::vector<char>(), solution_);
      solution_.normal_converged     = normal_.converged;
      solution_.normal_residual      = normal_.residual;
      solution_.tangential_converged = !friction_ || tangential_.converged;
      solution_.tangential_residual  = tangential_.residual;
      solution_.not_reached          = not_reached(problem_, solution_);
      return solution_;
    }

    void
    Solver::displacements()
    {
      const std::size_t  n = grid_.size();
      HalfspaceSolution &s = solution_;
      s.pressure           = normal_.pressure;
      s.approach           = normal_.approach;
      s.traction_x         = tangential_.traction[0];
      s.traction_y         = tangential_.traction[1];
      s.slip_x             = tangential_.slip[0];
      s.slip_y             = tangential_.slip[1];
      for (auto *field : {&s.traction_x, &s.traction_y, &s.slip_x, &s.slip_y})
        field->resize(n, 0.);
      s.friction = mu_;
      // u_n under the pressures; what tractions of unlike bodies add comes below
      s.displacement_n = normal_.displacement;
      s.displacement_n.resize(n, 0.);
      s.displacement_x.assign(n, 0.);
      s.displacement_y.assign(n, 0.);
      // u_a = sum over b of A_ab t_b; u_n(p) is there from the normal problem; pairs (x, n), (y, n) of unlike
      // materials alone
      std::vector<double>       *u[3] = {&s.displacement_x, &s.displacement_y, &s.displacement_n};
      const std::vector<double> *t[3] = {&s.traction_x, &s.traction_y, &s.pressure};
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          if ((a < 2 && b < 2 && friction_ && !problem_.simplified) || (coupled_ && (a == 2) != (b == 2)))
            add_displacement(a, b, 0, *t[b], 1, *u[a]);
      for (std::size_t e = 0; problem_.simplified && e < n; ++e)
        {
          s.displacement_x[e] = problem_.simplified->along * s.traction_x[e];
          s.displacement_y[e] = problem_.simplified->across * s.traction_y[e];
        }
      if (problem_.added)
        {
          // the normal displacement under the pressure has it already
          problem_.added->add_displacement({{t[0], t[1], nullptr}}, {{u[0], u[1], u[2]}});
          problem_.added->add_displacement({{nullptr, nullptr, t[2]}}, {{u[0], u[1], nullptr}});
        }
      s.gap.assign(n, 0.);
      for (std::size_t e = 0; e < n && !pressure_given_; ++e)
        // e = h - approach cos a + u_n
        s.gap[e] = problem_.undeformed_distance[e] + s.displacement_n[e] -
                   s.approach * (problem_.normal_cosine.empty() ? 1 : problem_.normal_cosine[e]);
    }

  } // namespace

  HalfspaceSolution
  solve_rolling(const HalfspaceProblem &problem)
  {
    check_problem(problem);
    HalfspaceKernels kernels(problem);
    return Solver(problem, kernels).run();
  }


  HalfspaceSolution
  solve_rolling(const HalfspaceProblem            &problem,
                std::shared_ptr<HalfspaceKernels> &kernels,
                const HalfspaceSolution           *guess)
  {
    check_problem(problem);
    // influence functions take most of the time of a small solution, and serve all loads on the same grid
    if (!kernels || !kernels->fit(problem))
      kernels = std::make_shared<HalfspaceKernels>(problem);
    return Solver(problem, *kernels, guess).run();
  }
} // namespace wheelrail
