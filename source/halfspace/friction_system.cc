#include <wheelrail/halfspace/added_influence.h>
#include <wheelrail/halfspace/friction_system.h>

#include <algorithm>
#include <cmath>

// The linear equations of one Newton step (doc/theory/halfspace.md, Algorithm). Symbols: t traction [Pa], s
// slip, g = mu p `bound`, b = `b_` influence of an element on its own slip [1/Pa], q = t - s/b, n = q/|q| =
// (`nx_`, `ny_`), tau = (-n_y, n_x), `stiffness_` = b (|q| - g)/g.
//   sticks, |q| <= g:   B dt = -s
//   slips, along n:     b n . dt = -b n . (t - g n)
//   slips, along tau:   tau . B dt + stiffness tau . dt = -b |q|/g tau . (t - g n)
// A layer that yields has the bound g + h |s| in place of g, h = `rise_`, so that t + h s = g n in slip: rows
// above with t + h s for t. In steady rolling g holds the rise of what yields ahead.
//   force given:        sum(dt) = force/area - sum(t), with d(creepage) added to all B dt
// B is A/dq of a shift, (A - A')/dq of steady rolling, which is not symmetric: hence GMRES.

namespace wheelrail
{
  FrictionSystem::FrictionSystem(InfluenceProducts           &products,
                                 const TangentialTask        &task,
                                 const std::array<double, 2> &creepage)
    : products_(products)
    , task_(task)
    , kernels_(*task.kernels)
    , creepage_(creepage)
    , b_(task.kernels->diagonal)
  {
    for (int k = 0; k < task.grid.size(); ++k)
      if (task.bound[k] > 0)
        {
          // the contact is where mu p > 0
          elements.push_back(k);
          largest_ = std::max(largest_, task.bound[k]);
        }
    for (int d = 0; d < 2; ++d)
      if (task.force_given[d])
        forces.push_back(d);
    n_ = elements.size();
    for (auto &w : work_)
      w.assign(task.grid.size(), 0.);
  }

  void
  FrictionSystem::apply_slip()
  {
    // B t of half-spaces, and what bodies add (added_influence.h)
    apply(kernels_.xx, kernels_.xy, kernels_.yy, work_, image_);
    if (task_.added)
      task_.added->add_slip({{&work_[0], &work_[1], nullptr}}, {{&image_[0], &image_[1], nullptr}});
    // s = w + (u - u at the leading edge)/(share dq) (Vollebregt 2009); that of the state before is in w
    VectorField u; // over dq
    if (task_.displacement && !task_.run_in.empty())
      apply(task_.displacement->xx, task_.displacement->xy, task_.displacement->yy, work_, u);
    for (const RunIn &r : task_.run_in)
      for (int d = 0; d < 2; ++d)
        image_[d][r.element] =
          (task_.displacement ? u[d][r.element] - u[d][r.edge] : image_[d][r.element]) / r.share;
  }

  void
  FrictionSystem::hold(const double c, const std::vector<double> &before)
  {
    // c in the unit of b, slip for each Pa
    c_ = c;
    // b is the influence of an element on its own slip, to which the proximal term adds c
    b_      = kernels_.diagonal + c;
    before_ = before;
  }

  double
  FrictionSystem::creepage_grip() const
  {
    // of the order of sum(dt)/d(creepage) = n/b for elements that stick, times c/b; a tenth of it is enough
    return 0.1 * c_ * n_ / (b_ * b_);
  }

  void
  FrictionSystem::set_bounds(const std::vector<double> &t, const std::vector<double> &slip)
  {
    bound_.resize(n_);
    rise_.assign(n_, 0.);
    if (task_.yield.empty())
      {
        for (std::size_t e = 0; e < n_; ++e)
          bound_[e] = task_.bound[elements[e]];
        return;
      }
    // Layer that yields (Hou, Kalousek and Magel 1997): from the leading edge on, so that what has hardened
    // ahead comes along.
    brought_.resize(n_);
    yielding_.assign(n_, none);
    double raised = 0;
    for (std::size_t e = n_; e-- > 0;)
      {
        const int    k     = elements[e];
        const double limit = task_.bound[k], rise = task_.hardening, least_yield = task_.least_yield;
        raised         = follows(e) ? raised : 0;
        brought_[e]    = std::max(least_yield, task_.yield[k] + raised);
        bound_[e]      = limit;
        const double c = brought_[e];
        if (c >= limit)
          continue;
        // on the way back from q the traction is (c + h b |q|)/(1 + h b)
        const double q    = std::hypot(t[2 * e] - slip[2 * e] / b_, t[2 * e + 1] - slip[2 * e + 1] / b_);
        const double back = q > c ? (c + rise * b_ * q) / (1 + rise * b_) : c;
        yielding_[e]      = back > limit ? slides : back < least_yield ? least : yields;
        if (yielding_[e] != slides)
          bound_[e] = yielding_[e] == least ? least_yield : c;
        if (yielding_[e] == yields)
          rise_[e] = rise;
        if (q > c)
          raised = yielded(e, slip).first - task_.yield[k];
      }
  }

  std::pair<double, double>
  FrictionSystem::yielded(const std::size_t e, const std::vector<double> &slip) const
  {
    // yield stress after the step, c + h |s|, and the part of the slip that the layer takes
    const double size = std::hypot(slip[2 * e], slip[2 * e + 1]), c = brought_[e];
    switch (yielding_[e])
      {
        case yields:
          return {std::max(task_.least_yield, c + rise_[e] * size), 1.};
        case least:
          return {task_.least_yield, 1.};
        case slides:
          return {bound_[e], size > 0 ? std::min(1., (bound_[e] - c) / (task_.hardening * size)) : 0.};
        default:
          return {c, 0.};
      }
  }

  double
  FrictionSystem::residual(const std::vector<double> &t, std::vector<double> &slip)
  {
    for (std::size_t e = 0; e < n_; ++e)
      for (int d = 0; d < 2; ++d)
        work_[d][elements[e]] = t[2 * e + d];
    apply_slip();
    // unknown creepages are dimensionless slips, tractions [Pa]
    std::array<double, 2> creepage = creepage_;
    for (std::size_t f = 0; f < forces.size(); ++f)
      // creepages behind the tractions in the vector of unknowns
      creepage[forces[f]] = t[2 * n_ + f];
    slip.resize(2 * n_);
    for (std::size_t e = 0; e < n_; ++e)
      {
        const int k = elements[e];
        for (int d = 0; d < 2; ++d)
          {
            // s = w + creepage + B t (+ c (t - t before) of a proximal point)
            slip[2 * e + d] = task_.rigid_slip[d][k] + creepage[d] + image_[d][k];
            if (c_ > 0)
              slip[2 * e + d] += c_ * (t[2 * e + d] - before_[2 * e + d]);
          }
      }
    set_bounds(t, slip);
    // residual: rms of t - P(q) over the elements, over the largest |P|
    double sum = 0, largest = 0;
    for (std::size_t e = 0; e < n_; ++e)
      {
        // q = t - s/b; t = P(q) holds exactly where s = 0 and |t| <= g, or t = -g s/|s|, for any b > 0
        const double q[2] = {t[2 * e] - slip[2 * e] / b_, t[2 * e + 1] - slip[2 * e + 1] / b_};
        // P cuts q to the length g = mu p
        const double size = std::hypot(q[0], q[1]), g = bound_[e];
        const double factor = size > g ? g / size : 1, rise = size > g ? rise_[e] : 0;
        largest = std::max(largest, factor * size);
        for (int d = 0; d < 2; ++d)
          sum += std::pow(t[2 * e + d] + rise * slip[2 * e + d] - factor * q[d], 2);
      }
    return std::sqrt(sum / n_) / (largest > 0 ? largest : 1); // tractions that are no numbers stay so
  }

  void
  FrictionSystem::linearise(const std::vector<double> &t,
                            const std::vector<double> &slip,
                            bool                       first,
                            std::vector<double>       &rhs)
  {
    // product and preconditioner use these sets until the next step
    slipping.assign(n_, 0);
    nx_.assign(n_, 0);
    ny_.assign(n_, 0);
    stiffness_.assign(n_, 0);
    rhs.assign(2 * n_ + forces.size(), 0.);
    // `first`: elements within their bound count as sticking, since t = 0 gives q = -s/b, and s is the rigid
    // slip alone
    const double b = b_;
    for (std::size_t e = 0; e < n_; ++e)
      {
        const double *te = &t[2 * e], *s = &slip[2 * e];
        const double  g = bound_[e], h = rise_[e];
        // q = t - s/b; |q| <= g: the element sticks, and its rows are B dt = -s
        const double qx = te[0] - s[0] / b, qy = te[1] - s[1] / b, q = std::hypot(qx, qy);
        // Before the first step only elements at their bound slip: the slip of others says nothing yet.
        if (q <= g || (first && std::hypot(te[0], te[1]) < g * (1 - 1e-6)))
          {
            rhs[2 * e]     = -s[0];
            rhs[2 * e + 1] = -s[1];
            continue;
          }
        slipping[e] = !yielding_.empty() && (yielding_[e] == yields || yielding_[e] == least) ? 2 : 1;
        // n = q/|q|, the direction of the traction against the slip; b (|q| - g)/g is |s|/g where t = g n
        nx_[e]        = qx / q;
        ny_[e]        = qy / q;
        stiffness_[e] = b * (q - g) / g;
        // Normal row: the bound, times b; tangential row: the direction, see doc/theory/halfspace.md.
        // f = t - g n. Along n: b n . dt = -b n . f. Across it, from t + dt = g (n + dn) with dn = (dq .
        // tau)/|q| tau and dq = dt - B dt/b: tau . B dt + b (|q| - g)/g tau . dt = -b |q|/g tau . f. The
        // factor b gives both rows the unit of a slip. tau = (-n_y, n_x).
        const double fx = te[0] + h * s[0] - g * nx_[e], fy = te[1] + h * s[1] - g * ny_[e];
        const double normal  = -b * (fx * nx_[e] + fy * ny_[e]);
        const double tangent = -b * q / g * (-fx * ny_[e] + fy * nx_[e]);
        rhs[2 * e]           = normal * nx_[e] - tangent * ny_[e];
        rhs[2 * e + 1]       = normal * ny_[e] + tangent * nx_[e];
      }
    for (std::size_t f = 0; f < forces.size(); ++f)
      {
        // sum(dt) = force asked for less that of t, over the area of an element; b/sqrt(n) makes the row as
        // long as those of the elements
        rhs[2 * n_ + f] = missing_force(t, f) * b / std::sqrt(double(n_));
        if (c_ > 0)
          rhs[2 * n_ + f] +=
            creepage_grip() * (t[2 * n_ + f] - before_[2 * n_ + f]) * b / std::sqrt(double(n_));
      }
    set_responses();
  }

  void
  FrictionSystem::multiply(const std::vector<double> &dt, std::vector<double> &result)
  {
    for (std::size_t e = 0; e < n_; ++e)
      for (int d = 0; d < 2; ++d)
        work_[d][elements[e]] = dt[2 * e + d];
    apply_slip();
    // a given creepage does not change in a Newton step
    std::array<double, 2> creepage{{0, 0}};
    for (std::size_t f = 0; f < forces.size(); ++f)
      creepage[forces[f]] = dt[2 * n_ + f];
    result.assign(dt.size(), 0.);
    double raised = 0; // change of the yield stress that the material brings along
    // against x: `raised` carries the hardening of a step from element to element
    for (std::size_t e = n_; e-- > 0;)
      {
        const int k = elements[e];
        double    s[2];
        raised = follows(e) ? raised : 0;
        for (int d = 0; d < 2; ++d)
          // change of slip, d s = B dt + d(creepage) + c dt
          s[d] = image_[d][k] + creepage[d] + c_ * dt[2 * e + d];
        if (slipping[e])
          {
            // the two rows of linearise(), turned back from (n, tau) to (x, y)
            const double rise = rise_[e], along = s[0] * nx_[e] + s[1] * ny_[e];
            const double normal =
              b_ * (dt[2 * e] * nx_[e] + dt[2 * e + 1] * ny_[e] + rise * along - (rise != 0 ? raised : 0));
            const double tangent = (1 + rise * (b_ + stiffness_[e])) * (-s[0] * ny_[e] + s[1] * nx_[e]) +
                                   stiffness_[e] * (-dt[2 * e] * ny_[e] + dt[2 * e + 1] * nx_[e]);
            // |s| = -n . s; what has hardened up to friction's limit, or fallen to the least, stays there
            raised = rise != 0                                    ? raised - rise * along
                     : !yielding_.empty() && yielding_[e] == none ? raised
                                                                  : 0;
            s[0]   = normal * nx_[e] - tangent * ny_[e];
            s[1]   = normal * ny_[e] + tangent * nx_[e];
          }
        result[2 * e]     = s[0];
        result[2 * e + 1] = s[1];
      }
    for (std::size_t f = 0; f < forces.size(); ++f)
      {
        double sum = 0;
        for (std::size_t e = 0; e < n_; ++e)
          sum += dt[2 * e + forces[f]];
        // row of the force; a held creepage lets some of it go
        result[2 * n_ + f] = (sum - creepage_grip() * dt[2 * n_ + f]) * b_ / std::sqrt(double(n_));
      }
  }

  void
  FrictionSystem::project(std::vector<double> &t) const
  {
    for (std::size_t e = 0; e < n_; ++e)
      {
        // a guess may come from other pressures, whose bound was wider
        const double g = task_.bound[elements[e]], size = std::hypot(t[2 * e], t[2 * e + 1]);
        if (size > g)
          for (int d = 0; d < 2; ++d)
            // P(t) = g t/|t|
            t[2 * e + d] *= g / size;
      }
  }

  double
  FrictionSystem::missing_force(const std::vector<double> &t, const std::size_t f) const
  {
    double sum = 0;
    for (std::size_t e = 0; e < n_; ++e)
      sum += t[2 * e + forces[f]];
    // sum(t) dA = force on body 1
    return task_.force[forces[f]] / task_.grid.element_area() - sum;
  }

  double
  FrictionSystem::force_error(const std::vector<double> &t) const
  {
    double error = 0;
    if (c_ > 0) // the held creepages take part of the force
      return error;
    for (std::size_t f = 0; f < forces.size(); ++f)
      // over n times the largest bound
      error = std::max(error, std::abs(missing_force(t, f)) / (n_ * largest_));
    return error;
  }
} // namespace wheelrail
