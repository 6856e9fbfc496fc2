#include <wheelrail/halfspace/added_influence.h>
#include <wheelrail/halfspace/friction_field.h>
#include <wheelrail/halfspace/kernels.h>
#include <wheelrail/halfspace/measures.h>
#include <wheelrail/halfspace/normal.h>
#include <wheelrail/halfspace/plastic_layer.h>
#include <wheelrail/halfspace/simplified.h>
#include <wheelrail/halfspace/tangential.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <sstream>
#include <utility>
#include <vector>

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

      void
      normal_problem();
      /// False when the friction of this round does not carry the force asked for.
      bool
      tangential_problem();
      /// Elements that ran in within a step of several.
      std::vector<RunIn>
      run_in() const;
      VectorField
      rigid_slip(const std::vector<RunIn> &run_in);
      /// Sets the coefficients to the slip of the last round; the largest change over the larger coefficient
      /// of the law.
      double
      update_friction();
      /// Temperatures of the surfaces under the tractions and slip of the last round.
      std::array<std::vector<double>, 2>
      temperatures() const;
      void
      displacements();
      void
      tell();

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
      double                  weight_ = 0.5, last_change_ = 0; ///< of the steps of the coefficients
      HalfspaceSolution       solution_;
    };

    void
    Solver::normal_problem()
    {
      std::vector<double> distance = problem_.undeformed_distance;
      if (problem_.added && !tangential_.traction[0].empty())
        problem_.added->add_displacement({{&tangential_.traction[0], &tangential_.traction[1], nullptr}},
                                         {{nullptr, nullptr, &distance}});
      if (coupled_ && !tangential_.traction[0].empty())
        {
          Spectrum            x, y;
          std::vector<double> u;
          products_.forward(tangential_.traction[0], x);
          products_.forward(tangential_.traction[1], y);
          const Spectrum &under_x = kernels_.of(2, 0, 0), &under_y = kernels_.of(2, 1, 0);
          for (std::size_t m = 0; m < x.size(); ++m)
            // u_n = A_nx t_x + A_ny t_y (Kalker 1990), K/G of unlike materials
            x[m] = times(x[m], under_x[m]) + times(y[m], under_y[m]);
          products_.backward(x, u);
          for (std::size_t e = 0; e < u.size(); ++e)
            distance[e] += u[e];
        }
      // Conformal contact: where the normal makes the angle a to the approach, e = h - approach cos a + u_n.
      // With e/cos a for the gap and p cos a for the pressure the approach has the factor 1, the load is
      // their sum, and A(1/cos .)/cos stays symmetric, as conjugate gradients need.
      const std::vector<double> &cosine = problem_.normal_cosine;
      // gaps along the approach, so that conjugate gradients meet one lowering for all elements: pressures
      // times their cosine stand for pressures
      const auto scale = [&](std::vector<double> &field, const bool up) {
        for (std::size_t e = 0; e < std::min(cosine.size(), field.size()); ++e)
          field[e] *= up ? cosine[e] : 1 / cosine[e];
      };
      const Spectrum     &kernel  = kernels_.of(2, 2, 0);
      const NormalProduct product = [&](const std::vector<double> &v, std::vector<double> &result) {
        Spectrum            s;
        std::vector<double> p = v;
        scale(p, false);
        products_.forward(p, s);
        for (std::size_t m = 0; m < s.size(); ++m)
          s[m] = times(s[m], kernel[m]);
        products_.backward(s, result);
        for (std::size_t e = 0; problem_.normal_compliance > 0 && e < p.size(); ++e)
          result[e] += problem_.normal_compliance * p[e];
        if (problem_.added)
          problem_.added->add_displacement({{nullptr, nullptr, &p}}, {{nullptr, nullptr, &result}});
        scale(result, false);
      };
      scale(distance, false);
      scale(normal_.pressure, true);
      normal_.approach = problem_.approach;
      solve_normal(product,
                   grid_,
                   distance,
                   problem_.force_given,
                   problem_.normal_force,
                   problem_.normal_tolerance,
                   problem_.max_normal_iterations,
                   normal_);
      scale(normal_.pressure, false);
      scale(normal_.displacement, true);
      solution_.normal_iterations += normal_.iterations;
    }

    std::vector<RunIn>
    Solver::run_in() const
    {
      std::vector<RunIn> found;
      if (problem_.motion == HalfspaceMotion::shift || problem_.simplified ||
          solution_.step < 1.001 * grid_.dx)
        return found;
      for (int j = 0; j < grid_.my; ++j)
        for (int i = grid_.mx - 1, edge = -1; i >= 0; --i)
          {
            const int e = i + grid_.mx * j;
            if (!(normal_.pressure[e] > 0))
              edge = e;
            else if (edge >= 0 && i + 2 < grid_.mx && (edge - e) * grid_.dx < 0.9999 * solution_.step)
              found.push_back({e, edge, (edge - e) * grid_.dx / solution_.step});
          }
      return found;
    }

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
      task.run_in       = run_in();
      task.rigid_slip   = rigid_slip(task.run_in);
      const bool steady = problem_.motion == HalfspaceMotion::steady;
      if (steady && !task.run_in.empty() && displacement_.xx.empty())
        displacement_ = slip_kernels(products_, kernels_.constants(), grid_, solution_.step, false);
      task.displacement = steady ? &displacement_ : nullptr;
      task.force_given  = {{problem_.longitudinal_force_given, problem_.lateral_force_given}};
      task.force        = {{problem_.fx, problem_.fy}};
      task.tolerance    = problem_.tangential_tolerance;
      task.max_steps    = problem_.max_newton_steps;
      task.yield        = brought_yield(problem_);
      task.hardening    = problem_.layer_hardening * solution_.step;
      task.least_yield  = 0.1 * problem_.layer_yield;
      task.carried      = problem_.motion == HalfspaceMotion::steady;
      task.bound.resize(grid_.size());
      double limit = 0;
      for (std::size_t e = 0; e < task.bound.size(); ++e)
        {
          // Coulomb: |t| <= g = mu p; the forces that it carries in all, sum of g dx dy
          task.bound[e] = mu_[e] * normal_.pressure[e];
          limit += task.bound[e] * grid_.element_area();
        }
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
      // Half a step from the fourth round on: falling friction makes whole steps swing.
      const double              weight = solution_.coupling_rounds < 4 ? 1 : weight_;
      const std::vector<double> wanted =
        friction_field(problem_,
                       solution_.step,
                       tangential_.slip,
                       normal_.pressure,
                       problem_.hot_friction.empty() ? std::vector<double>() : temperatures()[0]);
      for (std::size_t e = 0; e < mu_.size(); ++e)
        {
          const double step = wanted[e] - mu_[e];
          mu_[e] += weight * step;
          if (normal_.pressure[e] > 0)
            change = std::max(change, std::abs(step) / largest_friction_);
        }
      // smaller steps where half ones keep swinging
      if (solution_.coupling_rounds > 12 && change > 0.8 * last_change_)
        weight_ = std::max(0.02, 0.8 * weight_);
      last_change_ = change;
      return change;
    }

    HalfspaceSolution
    Solver::run()
    {
      tangential_.creepage = {{problem_.xi, problem_.eta}};
      mu_.resize(std::size_t(grid_.size()));
      for (int e = 0; e < grid_.size(); ++e)
        mu_[std::size_t(e)] = problem_.friction_of_row(e / grid_.mx).at(0);
      for (solution_.coupling_rounds = 1;; ++solution_.coupling_rounds)
        {
          const std::vector<double> old = normal_.pressure;
          // 1. pressure under the tractions of the last round
          if (!pressure_given_ && (solution_.coupling_rounds == 1 || coupled_))
            normal_problem();
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
      displacements();
      if (problem_.heat && problem_.motion == HalfspaceMotion::steady)
        solution_.temperature = temperatures();
      set_layer_state(problem_, tangential_, solution_);
      solution_.xi  = tangential_.creepage[0];
      solution_.eta = tangential_.creepage[1];
      solution_.phi = problem_.phi;
      measure(problem_, friction_ ? tangential_.slipping : std::vector<char>(), solution_);
      tell();
      return solution_;
    }

    std::array<std::vector<double>, 2>
    Solver::temperatures() const
    {
      std::vector<double> heat(std::size_t(grid_.size()), 0.); // what the tractions do a second [W/m2]
      for (std::size_t e = 0; e < heat.size() && !tangential_.slip[0].empty(); ++e)
        {
          const double yields = tangential_.plastic.empty() ? 0 : tangential_.plastic[e];
          heat[e]             = std::hypot(tangential_.traction[0][e], tangential_.traction[1][e]) *
                    std::hypot(tangential_.slip[0][e], tangential_.slip[1][e]) * problem_.velocity *
                    (1 - yields + yields * problem_.heat->plastic_share);
        }
      return surface_temperatures(*problem_.heat, grid_, problem_.velocity, normal_.pressure, heat);
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
      s.friction       = mu_;
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

    void
    Solver::tell()
    {
      HalfspaceSolution &s   = solution_;
      s.normal_converged     = normal_.converged;
      s.normal_residual      = normal_.residual;
      s.tangential_converged = !friction_ || tangential_.converged;
      s.tangential_residual  = tangential_.residual;
      std::ostringstream text;
      if (!s.normal_converged)
        text << "The normal problem reached " << s.normal_residual << " of its tolerance "
             << problem_.normal_tolerance << " in " << s.normal_iterations << " iterations. ";
      if (!s.tangential_converged && s.within_friction)
        text << "The tangential problem reached " << s.tangential_residual << " of its tolerance "
             << problem_.tangential_tolerance << " in " << s.newton_steps << " steps. ";
      if (!s.within_friction)
        text << "Friction does not carry the tangential force of " << std::hypot(problem_.fx, problem_.fy)
             << " N that is asked for. ";
      else if (!s.coupling_converged)
        text << "Pressure, tractions and friction coefficients did not settle to each other in "
             << s.coupling_rounds << " rounds. ";
      s.not_reached = text.str();
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
    if (!kernels || !kernels->fit(problem))
      kernels = std::make_shared<HalfspaceKernels>(problem);
    return Solver(problem, *kernels, guess).run();
  }
} // namespace wheelrail
