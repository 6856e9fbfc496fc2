#include <wheelrail/halfspace/krylov.h>
#include <wheelrail/halfspace/tangential.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace wheelrail
{
  SlipKernels
  slip_kernels(InfluenceProducts        &products,
               const HalfspaceConstants &constants,
               const HalfspaceGrid      &grid,
               const double              step,
               const bool                steady)
  {
    SlipKernels k;
    k.step               = step;
    k.steady             = steady;
    const auto component = [&](const int a, const int b, const bool difference) {
      return products.kernel([&](const double x, const double y) {
        const double here = influence_coefficients(constants, grid.dx, grid.dy, x, y)[a][b];
        return difference
                 ? (here - influence_coefficients(constants, grid.dx, grid.dy, x + step, y)[a][b]) / step
                 : here;
      });
    };
    InfluenceProducts::Spectrum xx = component(0, 0, false), xy = component(0, 1, false),
                                yy = component(1, 1, false);
    k.inverse_xx                   = xx;
    k.inverse_xy                   = xx;
    k.inverse_yy                   = xx;
    // kernel() holds the factor 1 / size that belongs to the way back: it must stand in the inverse, too.
    const double scale = 1. / std::pow(double(products.padded_size()), 2);
    for (std::size_t m = 0; m < xx.size(); ++m)
      {
        const double a = std::abs(xx[m].real()), b = xy[m].real(), d = std::abs(yy[m].real());
        const double det = std::max(a * d - b * b, 0.01 * a * d);
        k.inverse_xx[m]  = scale * d / det;
        k.inverse_xy[m]  = -scale * b / det;
        k.inverse_yy[m]  = scale * a / det;
      }
    const auto c0 = influence_coefficients(constants, grid.dx, grid.dy, 0, 0);
    if (steady)
      {
        k.xx          = component(0, 0, true);
        k.xy          = component(0, 1, true);
        k.yy          = component(1, 1, true);
        const auto c1 = influence_coefficients(constants, grid.dx, grid.dy, step, 0);
        k.diagonal    = (c0[0][0] - c1[0][0] + c0[1][1] - c1[1][1]) / (2 * step);
      }
    else
      {
        for (auto *s : {&xx, &xy, &yy})
          for (auto &v : *s)
            v /= step;
        k.xx       = std::move(xx);
        k.xy       = std::move(xy);
        k.yy       = std::move(yy);
        k.diagonal = (c0[0][0] + c0[1][1]) / (2 * step);
      }
    return k;
  }

  namespace
  {
    using Spectrum = InfluenceProducts::Spectrum;

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
      }

      void
      run();

    private:
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
      linearise(const std::vector<double> &t, const std::vector<double> &slip, std::vector<double> &rhs);
      void
      jacobian(const std::vector<double> &dt, std::vector<double> &result);
      void
      precondition(const std::vector<double> &r, std::vector<double> &result);
      void
      inverse_block(const double *r, std::vector<double> &result);
      void
      project(std::vector<double> &t) const;

      InfluenceProducts               &products_;
      const TangentialTask            &task_;
      TangentialState                 &state_;
      const SlipKernels               &kernels_;
      std::vector<int>                 elements_, forces_;
      std::size_t                      n_       = 0;
      double                           largest_ = 0;
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
              q[d]            = t[2 * e + d] - slip[2 * e + d] / kernels_.diagonal;
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
    Newton::linearise(const std::vector<double> &t, const std::vector<double> &slip, std::vector<double> &rhs)
    {
      slipping_.assign(n_, 0);
      nx_.assign(n_, 0);
      ny_.assign(n_, 0);
      stiffness_.assign(n_, 0);
      rhs.assign(2 * n_ + forces_.size(), 0.);
      const double b = kernels_.diagonal;
      for (std::size_t e = 0; e < n_; ++e)
        {
          const double *te = &t[2 * e], *s = &slip[2 * e];
          const double  g  = task_.bound[elements_[e]];
          const double  qx = te[0] - s[0] / b, qy = te[1] - s[1] / b, q = std::hypot(qx, qy);
          if (q <= g)
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
          double sum = 0;
          for (std::size_t e = 0; e < n_; ++e)
            sum += t[2 * e + forces_[f]];
          rhs[2 * n_ + f] =
            (task_.force[forces_[f]] / task_.grid.element_area() - sum) * b / std::sqrt(double(n_));
        }
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
            s[d] = image_[d][k] + creepage[d];
          if (slipping_[e])
            {
              const double normal  = kernels_.diagonal * (dt[2 * e] * nx_[e] + dt[2 * e + 1] * ny_[e]);
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
          result[2 * n_ + f] = sum * kernels_.diagonal / std::sqrt(double(n_));
        }
    }

    void
    Newton::inverse_block(const double *r, std::vector<double> &result)
    {
      for (auto &w : work_)
        std::fill(w.begin(), w.end(), 0.);
      result.assign(2 * n_, 0.);
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
        if (slipping_[e])
          {
            const double normal = (r[2 * e] * nx_[e] + r[2 * e + 1] * ny_[e]) / kernels_.diagonal;
            const double tangent =
              (-r[2 * e] * ny_[e] + r[2 * e + 1] * nx_[e]) / (kernels_.diagonal + stiffness_[e]);
            result[2 * e]     = normal * nx_[e] - tangent * ny_[e];
            result[2 * e + 1] = normal * ny_[e] + tangent * nx_[e];
          }
        else
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
      const double scale   = kernels_.diagonal / std::sqrt(double(n_));
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

    void
    Newton::run()
    {
      const bool          log = std::getenv("HS_LOG");
      std::vector<double> t(2 * n_ + forces_.size(), 0.), slip, rhs, step, trial, trial_slip;
      if (int(state_.traction[0].size()) == task_.grid.size())
        for (std::size_t e = 0; e < n_; ++e)
          for (int d = 0; d < 2; ++d)
            t[2 * e + d] = state_.traction[d][elements_[e]];
      for (std::size_t f = 0; f < forces_.size(); ++f)
        t[2 * n_ + f] = state_.creepage[forces_[f]];
      project(t);
      state_.residual        = residual(t, slip);
      const auto force_error = [&](const std::vector<double> &v) {
        double error = 0;
        for (std::size_t f = 0; f < forces_.size(); ++f)
          {
            double sum = 0;
            for (std::size_t e = 0; e < n_; ++e)
              sum += v[2 * e + forces_[f]];
            error = std::max(
              error, std::abs(task_.force[forces_[f]] / task_.grid.element_area() - sum) / (n_ * largest_));
          }
        return error;
      };
      const LinearMap A = [&](const std::vector<double> &v, std::vector<double> &r) { jacobian(v, r); };
      const LinearMap M = [&](const std::vector<double> &v, std::vector<double> &r) { precondition(v, r); };
      for (state_.newton_steps = 0;; ++state_.newton_steps)
        {
          const double fe  = force_error(t);
          state_.converged = state_.residual <= task_.tolerance && fe <= task_.tolerance;
          if (state_.converged || state_.newton_steps == task_.max_steps)
            break;
          linearise(t, slip, rhs);
          double    reached;
          const int its = solve_gmres(A, M, rhs, 1e-3, 200, step, reached);
          state_.krylov_iterations += its;
          double length = 1, best = 0;
          for (int cut = 0; cut < 6; ++cut, length *= 0.5)
            {
              trial = t;
              for (std::size_t k = 0; k < t.size(); ++k)
                trial[k] += length * step[k];
              project(trial);
              best = residual(trial, trial_slip);
              if (best < 1.5 * state_.residual || state_.newton_steps == 0)
                break;
            }
          if (log)
            std::printf("%3d slip %6d gmres %3d (%.1e) length %.3f residual %.3e -> %.3e force %.2e xi %g\n",
                        state_.newton_steps,
                        int(std::count(slipping_.begin(), slipping_.end(), 1)),
                        its,
                        reached,
                        length,
                        state_.residual,
                        best,
                        fe,
                        forces_.empty() ? 0. : trial[2 * n_]);
          t               = trial;
          slip            = trial_slip;
          state_.residual = best;
        }
      for (int d = 0; d < 2; ++d)
        {
          state_.traction[d].assign(task_.grid.size(), 0.);
          state_.slip[d].assign(task_.grid.size(), 0.);
          for (std::size_t e = 0; e < n_; ++e)
            {
              state_.traction[d][elements_[e]] = t[2 * e + d];
              state_.slip[d][elements_[e]]     = slip[2 * e + d];
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
