#include <wheelrail/halfspace/measures.h>
#include <wheelrail/halfspace/sliding_paths.h>

#include <algorithm>
#include <cmath>
#include <sstream>

// Sums over elements, exact for constant tractions: F = sum t dA, Mz = sum (x t_y - y t_x) dA, T-gamma = -(Fx
// xi + Fy eta + Mz phi) besides rigid slip by rows [N] = [J/m].

namespace wheelrail
{
  namespace
  {
    /// Work of friction over the path rolled, from what its tractions are against: creepage, spin and other
    /// rigid slip; NaN where the motion is not steady [N].
    double
    creepage_work(const HalfspaceProblem &problem, const HalfspaceSolution &s)
    {
      if (problem.motion != HalfspaceMotion::steady)
        return std::nan("");
      // signs: tractions on body 1, slip of body 1 against body 2, so that friction's power is -t . s,
      // positive
      const auto of = [](const std::vector<double> &field, const int e) {
        return field.empty() ? 0 : field[e];
      };
      const HalfspaceGrid &grid = s.grid;
      // [N] = [J/m]
      double work = 0;
      for (int j = 0; j < grid.my; ++j)
        for (int i = 0; i < grid.mx; ++i)
          {
            const int e = i + grid.mx * j;
            // T-gamma = -sum of t . w dA, w_x = xi - phi y, w_y = eta + phi x: creep force times creepage
            // plus spin moment times spin. The spin counts at the element, not at x + dq/6 as in the
            // solution, so that the sum is Mz phi (doc/theory/halfspace.md, Algorithm).
            work -= s.traction_x[e] * (s.xi - s.phi * grid.y(j) + of(problem.rigid_slip_x, e)) +
                    s.traction_y[e] * (s.eta + s.phi * grid.x(i) + of(problem.rigid_slip_y, e));
          }
      return work * grid.element_area();
    }
  } // namespace


  void
  measure(const HalfspaceProblem &problem, const std::vector<char> &slipping, HalfspaceSolution &s)
  {
    // whole elements with constant tractions: sums are integrals
    const HalfspaceGrid &grid    = s.grid;
    const double         area    = grid.element_area();
    int                  first_x = grid.mx, last_x = -1, first_y = grid.my, last_y = -1;
    s.state.assign(grid.size(), HalfspaceSolution::exterior);
    for (int j = 0; j < grid.my; ++j)
      for (int i = 0; i < grid.mx; ++i)
        {
          const int    e = i + grid.mx * j;
          const double p = s.pressure[e], tx = s.traction_x[e], ty = s.traction_y[e];
          if (p <= 0)
            continue;
          // 1 slides, 2: the layer yields in place of sliding
          const char slips = slipping.empty() ? 0 : slipping[e];
          s.state[e]       = slips == 2   ? HalfspaceSolution::plastic
                             : slips == 1 ? HalfspaceSolution::slip
                                          : HalfspaceSolution::adhesion;
          (slips == 2 ? s.plastic_area : slips == 1 ? s.slip_area : s.adhesion_area) += area;
          ++s.contact_elements;
          s.fn += p * area;
          s.fx += tx * area;
          s.fy += ty * area;
          // moment about n at (0, 0): x t_y - y t_x
          s.spin_moment += (grid.x(i) * ty - grid.y(j) * tx) * area;
          s.peak_pressure = std::max(s.peak_pressure, p);
          s.peak_shear    = std::max(s.peak_shear, std::hypot(tx, ty));
          first_x         = std::min(first_x, i);
          last_x          = std::max(last_x, i);
          first_y         = std::min(first_y, j);
          last_y          = std::max(last_y, j);
        }
    // areas of whole elements: 0.5 to 0.7 % of error at 0.125 mm (doc/theory/halfspace.md, Verification)
    s.area = s.adhesion_area + s.slip_area + s.plastic_area;
    if (s.contact_elements > 0)
      {
        // whole elements: by up to one element larger than the contact ellipse
        s.length_x          = (last_x - first_x + 1) * grid.dx;
        s.width_y           = (last_y - first_y + 1) * grid.dy;
        s.touches_grid_edge = first_x == 0 || first_y == 0 || last_x == grid.mx - 1 || last_y == grid.my - 1;
      }
    // the same work twice: from the motion, and from where it is done; of like bodies they agree but for the
    // half cell of the spin
    s.creepage_work = creepage_work(problem, s);
    s.friction_work = friction_work(problem, s);
  }


  std::string
  not_reached(const HalfspaceProblem &problem, const HalfspaceSolution &s)
  {
    std::ostringstream text;
    if (!s.normal_converged)
      text << "The normal problem reached " << s.normal_residual << " of its tolerance "
           << problem.normal_tolerance << " in " << s.normal_iterations << " iterations. ";
    if (!s.tangential_converged && s.within_friction)
      text << "The tangential problem reached " << s.tangential_residual << " of its tolerance "
           << problem.tangential_tolerance << " in " << s.newton_steps << " steps. ";
    if (!s.within_friction)
      text << "Friction does not carry the tangential force of " << std::hypot(problem.fx, problem.fy)
           << " N that is asked for. ";
    else if (!s.coupling_converged)
      text << "Pressure, tractions and friction coefficients did not settle to each other in "
           << s.coupling_rounds << " rounds. ";
    return text.str();
  }
} // namespace wheelrail
