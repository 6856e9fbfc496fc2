#include <wheelrail/halfspace/krylov.h>
#include <wheelrail/halfspace/tangential.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    using Spectrum = InfluenceProducts::Spectrum;

    constexpr double krylov_tolerance = 1e-3;
    constexpr int    max_krylov       = 200;

    /// The Newton iteration of one task. Compressed vectors hold (x, y) of the n contact elements, then the
    /// unknown creepages.
    class Newton
    {
    public:
      Newton(InfluenceProducts &products, const TangentialTask &task, TangentialState &state)
        : products_(products)
        , task_(task)
        , state_(state)
        , kernels_(*task.kernels)
      {
        for (int k = 0; k < task.grid.size(); ++k)
          if (task.bound[k] > 0)
            elements_.push_back(k);
        for (int d = 0; d < 2; ++d)
          if (task.force_given[d])
            forces_.push_back(d);
        n_ = elements_.size();
        for (const int k : elements_)
          largest_ = std::max(largest_, task.bound[k]);
        for (auto &w : work_)
          w.assign(task.grid.size(), 0.);
        b_ = kernels_.diagonal;
      }

      void
      run();

    private:
      /// Newton steps with the regularisation in force; true when the tolerance is met within `max_steps`.
      bool
      iterate(std::vector<double> &t, double tolerance, int max_steps);

      /// The slow way that does not fail: proximal points. Each solves the task with slip + c (t - t_before)
      /// in place of the slip, which for a large c is solved in one step; c falls while that goes well.
      bool
      proximal_points(std::vector<double> &t);

      /// Force asked for less that of tractions t, over the element area [Pa].
      double
      missing_force(const std::vector<double> &t, std::size_t f) const;
      double
      force_error(const std::vector<double> &t) const;
      /// How the regularisation holds on to unknown creepages [Pa].
      double
      creepage_grip() const
      {
        return 0.1 * c_ * n_ / (b_ * b_);
      }

      void
      apply(const Spectrum &xx, const Spectrum &xy, const Spectrum &yy, VectorField &in, VectorField &out)
      {
        products_.forward(in[0], sx_);
        products_.forward(in[1], sy_);
        for (std::size_t m = 0; m < sx_.size(); ++m)
          {
            const auto a = sx_[m], b = sy_[m];
            sx_[m] = xx[m] * a + xy[m] * b;
            sy_[m] = xy[m] * a + yy[m] * b;
          }
        products_.backward(sx_, out[0]);
        products_.backward(sy_, out[1]);
      }

      /// Slip and residual of tractions t (compressed) and creepages in its tail.
      double
      residual(const std::vector<double> &t, std::vector<double> &slip);
      void
      linearise(const std::vector<double> &t,
                const std::vector<double> &slip,
                bool                       first,
                std::vector<double>       &rhs);
      void
      jacobian(const std::vector<double> &dt, std::vector<double> &result);
      void
      precondition(const std::vector<double> &r, std::vector<double> &result);
      /// Approximate inverse of the rows of the elements: slip by its diagonal, adhesion by FFT.
      void
      inverse_block(const double *r, std::vector<double> &result);
      /// Of the rows in adhesion: sums slip against rolling, as if no adhesion lay ahead, then takes the
      /// inverse symbol of A on the whole periodic grid.
      void
      inverse_adhesion(const double *r, std::vector<double> &result);
      void
      set_responses();
      void
      project(std::vector<double> &t) const;

      InfluenceProducts               &products_;
      const TangentialTask            &task_;
      TangentialState                 &state_;
      const SlipKernels               &kernels_;
      std::vector<int>                 elements_, forces_;
      std::size_t                      n_       = 0;
      double                           largest_ = 0;
      double                           b_       = 0; ///< diagonal, regularisation included [1/Pa]
      double                           c_       = 0; ///< regularisation [1/Pa]
      std::vector<double>              before_;      ///< tractions and creepages it holds on to
      std::vector<double>              slip_;
      VectorField                      work_, image_;
      Spectrum                         sx_, sy_;
      std::vector<char>                slipping_;
      std::vector<double>              nx_, ny_, stiffness_; ///< slip direction (of traction), |s| / bound
      std::vector<std::vector<double>> response_;            ///< of the preconditioner to unit creepages
    };

    double
    Newton::residual(const std::vector<double> &t, std::vector<double> &slip)
    {
      for (std::size_t e = 0; e < n_; ++e)
        for (int d = 0; d < 2; ++d)
          work_[d][elements_[e]] = t[2 * e + d];
      apply(kernels_.xx, kernels_.xy, kernels_.yy, work_, image_);
      std::array<double, 2> creepage = state_.creepage;
      for (std::size_t f = 0; f < forces_.size(); ++f)
        creepage[forces_[f]] = t[2 * n_ + f];
      slip.resize(2 * n_);
      double sum = 0, largest = 0;
      for (std::size_t e = 0; e < n_; ++e)
        {
          const int k = elements_[e];
          double    q[2];
          for (int d = 0; d < 2; ++d)
            {
              slip[2 * e + d] = task_.rigid_slip[d][k] + creepage[d] + image_[d][k];
              if (c_ > 0)
                slip[2 * e + d] += c_ * (t[2 * e + d] - before_[2 * e + d]);
              q[d] = t[2 * e + d] - slip[2 * e + d] / b_;
            }
          const double size   = std::hypot(q[0], q[1]),
                       factor = size > task_.bound[k] ? task_.bound[k] / size : 1;
          largest             = std::max(largest, factor * size);
          for (int d = 0; d < 2; ++d)
            sum += std::pow(t[2 * e + d] - factor * q[d], 2);
        }
      return largest > 0 ? std::sqrt(sum / n_) / largest : 0;
    }

    void
    Newton::linearise(const std::vector<double> &t,
                      const std::vector<double> &slip,
                      bool                       first,
                      std::vector<double>       &rhs)
    {
      slipping_.assign(n_, 0);
      nx_.assign(n_, 0);
      ny_.assign(n_, 0);
      stiffness_.assign(n_, 0);
      rhs.assign(2 * n_ + forces_.size(), 0.);
      const double b = b_;
      for (std::size_t e = 0; e < n_; ++e)
        {
          const double *te = &t[2 * e], *s = &slip[2 * e];
          const double  g  = task_.bound[elements_[e]];
          const double  qx = te[0] - s[0] / b, qy = te[1] - s[1] / b, q = std::hypot(qx, qy);
          // Before the first step only elements at their bound slip: the slip of others says nothing yet.
          if (q <= g || (first && std::hypot(te[0], te[1]) < g * (1 - 1e-6)))
            {
              rhs[2 * e]     = -s[0];
              rhs[2 * e + 1] = -s[1];
              continue;
            }
          slipping_[e]  = 1;
          nx_[e]        = qx / q;
          ny_[e]        = qy / q;
          stiffness_[e] = b * (q - g) / g;
          // Normal row: the bound, times b; tangential row: the direction, see doc/halfspace.md.
          const double fx = te[0] - g * nx_[e], fy = te[1] - g * ny_[e];
          const double normal  = -b * (fx * nx_[e] + fy * ny_[e]);
          const double tangent = -b * q / g * (-fx * ny_[e] + fy * nx_[e]);
          rhs[2 * e]           = normal * nx_[e] - tangent * ny_[e];
          rhs[2 * e + 1]       = normal * ny_[e] + tangent * nx_[e];
        }
      for (std::size_t f = 0; f < forces_.size(); ++f)
        {
          rhs[2 * n_ + f] = missing_force(t, f) * b / std::sqrt(double(n_));
          if (c_ > 0)
            rhs[2 * n_ + f] +=
              creepage_grip() * (t[2 * n_ + f] - before_[2 * n_ + f]) * b / std::sqrt(double(n_));
        }
      set_responses();
    }

    void
    Newton::set_responses()
    {
      response_.clear();
      for (const int d : forces_)
        {
          std::vector<double> unit(2 * n_, 0.), z;
          for (std::size_t e = 0; e < n_; ++e)
            unit[2 * e + d] = 1;
          for (std::size_t e = 0; e < n_; ++e)
            if (slipping_[e])
              {
                const double tangent = -unit[2 * e] * ny_[e] + unit[2 * e + 1] * nx_[e];
                unit[2 * e]          = -tangent * ny_[e];
                unit[2 * e + 1]      = tangent * nx_[e];
              }
          inverse_block(unit.data(), z);
          response_.push_back(z);
        }
    }

    void
    Newton::jacobian(const std::vector<double> &dt, std::vector<double> &result)
    {
      for (std::size_t e = 0; e < n_; ++e)
        for (int d = 0; d < 2; ++d)
          work_[d][elements_[e]] = dt[2 * e + d];
      apply(kernels_.xx, kernels_.xy, kernels_.yy, work_, image_);
      std::array<double, 2> creepage{{0, 0}};
      for (std::size_t f = 0; f < forces_.size(); ++f)
        creepage[forces_[f]] = dt[2 * n_ + f];
      result.assign(dt.size(), 0.);
      for (std::size_t e = 0; e < n_; ++e)
        {
          const int k = elements_[e];
          double    s[2];
          for (int d = 0; d < 2; ++d)
            s[d] = image_[d][k] + creepage[d] + c_ * dt[2 * e + d];
          if (slipping_[e])
            {
              const double normal  = b_ * (dt[2 * e] * nx_[e] + dt[2 * e + 1] * ny_[e]);
              const double tangent = -s[0] * ny_[e] + s[1] * nx_[e] +
                                     stiffness_[e] * (-dt[2 * e] * ny_[e] + dt[2 * e + 1] * nx_[e]);
              s[0] = normal * nx_[e] - tangent * ny_[e];
              s[1] = normal * ny_[e] + tangent * nx_[e];
            }
          result[2 * e]     = s[0];
          result[2 * e + 1] = s[1];
        }
      for (std::size_t f = 0; f < forces_.size(); ++f)
        {
          double sum = 0;
          for (std::size_t e = 0; e < n_; ++e)
            sum += dt[2 * e + forces_[f]];
          result[2 * n_ + f] = (sum - creepage_grip() * dt[2 * n_ + f]) * b_ / std::sqrt(double(n_));
        }
    }

    void
    Newton::inverse_block(const double *r, std::vector<double> &result)
    {
      result.assign(2 * n_, 0.);
      if (c_ > 0.3 * kernels_.diagonal) // then B + c is nearly diagonal
        for (std::size_t k = 0; k < 2 * n_; ++k)
          result[k] = r[k] / b_;
      else
        inverse_adhesion(r, result);
      for (std::size_t e = 0; e < n_; ++e)
        if (slipping_[e])
          {
            const double normal  = (r[2 * e] * nx_[e] + r[2 * e + 1] * ny_[e]) / b_;
            const double tangent = (-r[2 * e] * ny_[e] + r[2 * e + 1] * nx_[e]) / (b_ + stiffness_[e]);
            result[2 * e]        = normal * nx_[e] - tangent * ny_[e];
            result[2 * e + 1]    = normal * ny_[e] + tangent * nx_[e];
          }
    }

    void
    Newton::inverse_adhesion(const double *r, std::vector<double> &result)
    {
      for (auto &w : work_)
        std::fill(w.begin(), w.end(), 0.);
      for (std::size_t e = n_; e-- > 0;)
        {
          const int k = elements_[e];
          if (slipping_[e])
            continue;
          const bool follows = kernels_.steady && e + 1 < n_ && elements_[e + 1] == k + 1 &&
                               !slipping_[e + 1] && (k + 1) % task_.grid.mx != 0;
          for (int d = 0; d < 2; ++d)
            work_[d][k] = kernels_.steady ? (follows ? work_[d][k + 1] : 0.) + task_.grid.dx * r[2 * e + d]
                                          : kernels_.step * r[2 * e + d];
        }
      apply(kernels_.inverse_xx, kernels_.inverse_xy, kernels_.inverse_yy, work_, image_);
      for (auto &w : work_)
        std::fill(w.begin(), w.end(), 0.);
      for (std::size_t e = 0; e < n_; ++e)
        if (!slipping_[e])
          for (int d = 0; d < 2; ++d)
            result[2 * e + d] = image_[d][elements_[e]];
    }

    void
    Newton::precondition(const std::vector<double> &r, std::vector<double> &result)
    {
      inverse_block(r.data(), result);
      const std::size_t m = forces_.size();
      result.resize(2 * n_ + m, 0.);
      if (m == 0)
        return;
      // Block elimination of the creepages: sum(z) - sum(response) creepage = force row.
      const double scale   = b_ / std::sqrt(double(n_));
      double       a[2][2] = {{0, 0}, {0, 0}}, c[2] = {0, 0};
      for (std::size_t f = 0; f < m; ++f)
        {
          for (std::size_t e = 0; e < n_; ++e)
            {
              c[f] += result[2 * e + forces_[f]];
              for (std::size_t g = 0; g < m; ++g)
                a[f][g] += response_[g][2 * e + forces_[f]];
            }
          c[f] -= r[2 * n_ + f] / scale;
          a[f][f] += creepage_grip();
        }
      double creepage[2] = {0, 0};
      if (m == 1)
        creepage[0] = c[0] / a[0][0];
      else
        {
          const double det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
          creepage[0]      = (c[0] * a[1][1] - c[1] * a[0][1]) / det;
          creepage[1]      = (a[0][0] * c[1] - a[1][0] * c[0]) / det;
        }
      for (std::size_t f = 0; f < m; ++f)
        {
          result[2 * n_ + f] = creepage[f];
          for (std::size_t k = 0; k < 2 * n_; ++k)
            result[k] -= creepage[f] * response_[f][k];
        }
    }

    void
    Newton::project(std::vector<double> &t) const
    {
      for (std::size_t e = 0; e < n_; ++e)
        {
          const double g = task_.bound[elements_[e]], size = std::hypot(t[2 * e], t[2 * e + 1]);
          if (size > g)
            for (int d = 0; d < 2; ++d)
              t[2 * e + d] *= g / size;
        }
    }

    double
    Newton::missing_force(const std::vector<double> &t, const std::size_t f) const
    {
      double sum = 0;
      for (std::size_t e = 0; e < n_; ++e)
        sum += t[2 * e + forces_[f]];
      return task_.force[forces_[f]] / task_.grid.element_area() - sum;
    }

    double
    Newton::force_error(const std::vector<double> &t) const
    {
      double error = 0;
      for (std::size_t f = 0; f < forces_.size(); ++f)
        error = std::max(error, std::abs(missing_force(t, f)) / (n_ * largest_));
      return error;
    }

    bool
    Newton::iterate(std::vector<double> &t, const double tolerance, const int max_steps)
    {
      const LinearMap A = [&](const std::vector<double> &v, std::vector<double> &r) { jacobian(v, r); };
      const LinearMap M = [&](const std::vector<double> &v, std::vector<double> &r) { precondition(v, r); };
      std::vector<double> rhs, step;
      for (int steps = 0;; ++steps)
        {
          state_.residual = residual(t, slip_);
          if (!std::isfinite(state_.residual))
            return false;
          const double grip = c_ > 0 ? 1. : force_error(t);
          if (state_.residual <= tolerance && (c_ > 0 || grip <= tolerance))
            return true;
          if (steps == max_steps)
            return false;
          linearise(t, slip_, steps == 0, rhs);
          double reached;
          state_.krylov_iterations += solve_gmres(A, M, rhs, krylov_tolerance, max_krylov, step, reached);
          ++state_.newton_steps;
          for (std::size_t k = 0; k < t.size(); ++k)
            t[k] += step[k];
        }
    }

    bool
    Newton::proximal_points(std::vector<double> &t)
    {
      const int last = state_.newton_steps + 10 * task_.max_steps;
      for (double c = kernels_.diagonal; state_.newton_steps < last;)
        {
          before_         = t;
          c_              = c;
          b_              = kernels_.diagonal + c;
          const bool good = iterate(t, 0.1 * task_.tolerance, 12);
          if (!good)
            t = before_;
          c_ = 0;
          b_ = kernels_.diagonal;
          if (good && residual(t, slip_) <= 1e-3)
            {
              std::vector<double> trial = t;
              if (iterate(trial, task_.tolerance, 12))
                {
                  t = trial;
                  return true;
                }
            }
          c *= good ? 0.3 : 8;
        }
      return false;
    }

    void
    Newton::run()
    {
      std::vector<double> cold(2 * n_ + forces_.size(), 0.), t = cold;
      for (std::size_t f = 0; f < forces_.size(); ++f)
        cold[2 * n_ + f] = t[2 * n_ + f] = state_.creepage[forces_[f]];
      const bool warm = int(state_.traction[0].size()) == task_.grid.size();
      if (warm)
        for (std::size_t e = 0; e < n_; ++e)
          for (int d = 0; d < 2; ++d)
            t[2 * e + d] = state_.traction[d][elements_[e]];
      project(t);
      state_.newton_steps = state_.krylov_iterations = 0;
      state_.converged = warm && iterate(t, task_.tolerance, std::min(15, task_.max_steps));
      if (!state_.converged)
        state_.converged = iterate(t = cold, task_.tolerance, task_.max_steps);
      if (!state_.converged)
        state_.converged = proximal_points(t = cold);
      std::vector<double> unused;
      state_.residual = residual(t, slip_);
      linearise(t, slip_, false, unused);
      state_.slipping.assign(task_.grid.size(), 0);
      for (std::size_t e = 0; e < n_; ++e)
        state_.slipping[elements_[e]] = slipping_[e];
      project(t);
      for (int d = 0; d < 2; ++d)
        {
          state_.traction[d].assign(task_.grid.size(), 0.);
          state_.slip[d].assign(task_.grid.size(), 0.);
          for (std::size_t e = 0; e < n_; ++e)
            {
              state_.traction[d][elements_[e]] = t[2 * e + d];
              state_.slip[d][elements_[e]]     = slip_[2 * e + d];
            }
        }
      for (std::size_t f = 0; f < forces_.size(); ++f)
        state_.creepage[forces_[f]] = t[2 * n_ + f];
    }
  } // namespace

  void
  solve_tangential(InfluenceProducts &products, const TangentialTask &task, TangentialState &state)
  {
    Newton(products, task, state).run();
  }
} // namespace wheelrail
