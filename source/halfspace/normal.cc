#include <wheelrail/base/interrupt.h>
#include <wheelrail/halfspace/added_influence.h>
#include <wheelrail/halfspace/normal.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Normal problem of two half-spaces: e = h - approach + A p >= 0, p >= 0, e p = 0 (doc/theory/halfspace.md,
// Equations), which is the minimum of p'A p/2 + p'(h - approach) over p >= 0.
// Conjugate gradients of Polonsky and Keer (1999), because they ask for products A p alone, one FFT and its
// inverse; active sets by elimination (NORM of Kalker 1990) solve dense equations. Checked: Hertz's ellipses,
// peak and approach within 0.07 % of the closed form (doc/theory/halfspace.md, Verification).

namespace wheelrail
{
  namespace
  {
    /// Mean of a field over the elements in contact (p > 0).
    double
    contact_mean(const std::vector<double> &field, const std::vector<double> &p)
    {
      double sum = 0;
      int    n   = 0;
      for (std::size_t k = 0; k < p.size(); ++k)
        if (p[k] > 0)
          {
            sum += field[k];
            ++n;
          }
      return n > 0 ? sum / n : 0;
    }

    double
    total(const std::vector<double> &p)
    {
      double sum = 0;
      for (const double v : p)
        sum += v;
      return sum;
    }

    /// Scales pressures to a force [N].
    void
    scale_to(const double force, const double element_area, std::vector<double> &p)
    {
      // [Pa] so that sum(p) dA = force: an equality that each step keeps
      const double factor = force / (total(p) * element_area);
      for (double &v : p)
        v *= factor;
    }

    /// A first pressure: the overlap at an approach which gives a patch of plausible size.
    void
    first_pressure(const HalfspaceGrid       &grid,
                   const std::vector<double> &distance,
                   const bool                 force_given,
                   const double               force,
                   NormalContact             &contact)
    {
      const std::size_t n     = grid.size();
      double            level = contact.approach;
      if (force_given)
        {
          // no need for a good one: conjugate gradients take a few steps more
          std::vector<double> sorted(distance);
          std::nth_element(sorted.begin(), sorted.begin() + n / 4, sorted.end());
          level = sorted[n / 4]; // the approach at which a quarter of the grid overlaps
        }
      contact.pressure.assign(n, 0.);
      for (std::size_t k = 0; k < n; ++k)
        contact.pressure[k] = std::max(0., level - distance[k]);
      const double sum = total(contact.pressure) * grid.element_area();
      if (force_given)
        for (double &p : contact.pressure)
          p = sum > 0 ? p * force / sum : force / (n * grid.element_area());
    }

    /// The gap e = h - approach + u_n of all elements; a given force has the approach that makes it 0 in the
    /// mean of the contact. Returns the sum of its squares over the contact; the largest gap within the
    /// contact, or overlap beside it, goes into `residual`.
    double
    find_gap(const std::vector<double> &distance,
             const bool                 force_given,
             NormalContact             &contact,
             std::vector<double>       &e)
    {
      const std::vector<double> &p = contact.pressure, &u = contact.displacement;
      for (std::size_t k = 0; k < e.size(); ++k)
        e[k] = u[k] + distance[k];
      if (force_given) // the multiplier of sum(p) dx dy = F
        contact.approach = contact_mean(e, p);
      // G = sum of e^2 over the contact, for the factor of the direction
      double norm = 0, worst = 0;
      for (std::size_t k = 0; k < e.size(); ++k)
        {
          e[k] -= contact.approach;
          if (p[k] > 0)
            // G of Polonsky and Keer: sum of e^2 over the contact
            norm += e[k] * e[k];
          // errors of the three conditions: in the contact e = 0, beside it e >= 0 (p >= 0 holds always)
          worst = std::max(worst, p[k] > 0 ? std::abs(e[k]) : -e[k]);
        }
      contact.residual = worst;
      return norm;
    }

    /// Step 4 of solve_normal(): p - alpha t, cut at 0. An overlapping element comes back with the pressure
    /// -alpha e; the result says whether one did.
    bool
    step_along(const std::vector<double> &t,
               const std::vector<double> &e,
               const double               alpha,
               std::vector<double>       &p)
    {
      bool grows = false;
      for (std::size_t k = 0; k < p.size(); ++k)
        if (p[k] > 0)
          p[k] = std::max(0., p[k] - alpha * t[k]);
        else if (e[k] < 0)
          {
            p[k]  = -alpha * e[k];
            grows = true;
          }
      return grows;
    }
  } // namespace

  void
  solve_normal(const NormalProduct       &product,
               const HalfspaceGrid       &grid,
               const std::vector<double> &distance,
               const bool                 force_given,
               const double               force,
               const double               tolerance,
               const int                  max_iterations,
               NormalContact             &contact)
  {
    const std::size_t n = grid.size();
    if (contact.pressure.size() != n || total(contact.pressure) <= 0)
      first_pressure(grid, distance, force_given, force, contact);
    std::vector<double> &p = contact.pressure, &u = contact.displacement;
    // e gap [m], t direction [m], r = A t with A in m/Pa, so that alpha is in Pa/m. A is symmetric and
    // positive definite: one minimum.
    std::vector<double> e(n), t(n, 0.), r(n);
    if (force_given)
      scale_to(force, grid.element_area(), p);
    // residuals are relative to the depth of interpenetration, approach less the lowest distance: the zero
    // of the approach is that of the distances, which is anywhere
    const double lowest   = *std::min_element(distance.begin(), distance.end());
    double       old_norm = 1, beta = 0;
    contact.converged = false;
    // conjugate gradients on what presses, with projection on p >= 0 (Polonsky and Keer 1999)
    for (contact.iterations = 0;; ++contact.iterations)
      {
        leave_if_interrupted();
        // 1. gaps of the present pressure
        product(p, u);
        const double norm  = find_gap(distance, force_given, contact, e);
        const double scale = std::abs(contact.approach - lowest);
        contact.residual   = scale > 0 ? contact.residual / scale : 0;
        contact.converged  = contact.residual <= tolerance;
        if (contact.converged || contact.iterations == max_iterations)
          return;

        // 2. direction t = e + beta (G/G before) t within the contact; beta = 0 restarts it when the contact
        // has grown
        for (std::size_t k = 0; k < n; ++k)
          t[k] = p[k] > 0 ? e[k] + beta * norm / old_norm * t[k] : 0;
        old_norm = norm > 0 ? norm : 1;
        product(t, r);
        // 3. length alpha = (e, t)/(A t - mean, t): without its mean A t keeps the force to first order
        const double mean = force_given ? contact_mean(r, p) : 0;
        double       et = 0, rt = 0;
        for (std::size_t k = 0; k < n; ++k)
          {
            et += e[k] * t[k];
            rt += (r[k] - mean) * t[k];
          }
        // 4. the step
        beta = step_along(t, e, rt > 0 ? et / rt : 0, p) ? 0 : 1;
        // 5. the given force, exactly
        if (force_given)
          scale_to(force, grid.element_area(), p);
      }
  }


  void
  solve_normal_problem(const HalfspaceProblem &problem,
                       HalfspaceKernels       &kernels,
                       const bool              coupled,
                       const VectorField      &traction,
                       NormalContact          &normal)
  {
    using Spectrum              = InfluenceProducts::Spectrum;
    InfluenceProducts &products = kernels.products();
    // h [m], to which displacements under tractions add
    std::vector<double> distance = problem.undeformed_distance;
    if (problem.added && !traction[0].empty())
      problem.added->add_displacement({{&traction[0], &traction[1], nullptr}},
                                      {{nullptr, nullptr, &distance}});
    if (coupled && !traction[0].empty())
      {
        Spectrum            x, y;
        std::vector<double> u;
        products.forward(traction[0], x);
        products.forward(traction[1], y);
        const Spectrum &under_x = kernels.of(2, 0, 0), &under_y = kernels.of(2, 1, 0);
        for (std::size_t m = 0; m < x.size(); ++m)
          // u_n = A_nx t_x + A_ny t_y (Kalker 1990), K/G of unlike materials
          x[m] = times(x[m], under_x[m]) + times(y[m], under_y[m]);
        products.backward(x, u);
        for (std::size_t e = 0; e < u.size(); ++e)
          distance[e] += u[e];
      }
    // Conformal contact: where the normal makes the angle a to the approach, e = h - approach cos a + u_n.
    // With e/cos a for the gap and p cos a for the pressure the approach has the factor 1, the load is
    // their sum, and A(1/cos .)/cos stays symmetric, as conjugate gradients need.
    const std::vector<double> &cosine = problem.normal_cosine;
    // gaps along the approach, so that conjugate gradients meet one lowering for all elements: pressures
    // times their cosine stand for pressures
    const auto scale = [&](std::vector<double> &field, const bool up) {
      for (std::size_t e = 0; e < std::min(cosine.size(), field.size()); ++e)
        field[e] *= up ? cosine[e] : 1 / cosine[e];
    };
    const Spectrum     &kernel  = kernels.of(2, 2, 0);
    const NormalProduct product = [&](const std::vector<double> &v, std::vector<double> &result) {
      Spectrum            s;
      std::vector<double> p = v;
      scale(p, false);
      products.forward(p, s);
      for (std::size_t m = 0; m < s.size(); ++m)
        s[m] = times(s[m], kernel[m]);
      products.backward(s, result);
      for (std::size_t e = 0; problem.normal_compliance > 0 && e < p.size(); ++e)
        result[e] += problem.normal_compliance * p[e];
      if (problem.added)
        problem.added->add_displacement({{nullptr, nullptr, &p}}, {{nullptr, nullptr, &result}});
      scale(result, false);
    };
    scale(distance, false);
    scale(normal.pressure, true);
    normal.approach = problem.approach;
    solve_normal(product,
                 problem.grid,
                 distance,
                 problem.force_given,
                 problem.normal_force,
                 problem.normal_tolerance,
                 problem.max_normal_iterations,
                 normal);
    scale(normal.pressure, false);
    scale(normal.displacement, true);
  }
} // namespace wheelrail
