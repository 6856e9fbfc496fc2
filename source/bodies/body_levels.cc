#include <wheelrail/bodies/body_contact.h>

#include <cmath>
#include <memory>
#include <vector>

// Rounds of pressure, tractions, stretch and motion (doc/theory/bodies.md, Contact): first on elements of
// twice the size, a quarter of them, then on the wanted ones from there; settled when slips change by less
// than 1e-7, pressures by 2e-4 of the peak, turns by 2e-6, v by 0.1 um.

namespace wheelrail
{
  namespace
  {
    /// Values of a grid at the places of another, bilinear; 0 outside.
    std::vector<double>
    onto(const HalfspaceGrid &to, const HalfspaceGrid &from, const std::vector<double> &values)
    {
      const auto at = [&](const int i, const int j) {
        return i < 0 || j < 0 || i >= from.mx || j >= from.my ? 0. : values[i + from.mx * j];
      };
      return sampled_distance(to, [&](const double x, const double y) {
        // places in elements of the other grid
        const double u = (x - from.x(0)) / from.dx, v = (y - from.y(0)) / from.dy;
        const int    i = int(std::floor(u)), j = int(std::floor(v));
        const double a = u - i, b = v - j;
        return (1 - b) * ((1 - a) * at(i, j) + a * at(i + 1, j)) +
               b * ((1 - a) * at(i, j + 1) + a * at(i + 1, j + 1));
      });
    }
  } // namespace


  void
  BodyContact::refine()
  {
    const HalfspaceSolution coarse = solution_;
    problem_.added.reset(); // what the coarse grid had need not wait beside that of the fine one
    added_.reset();
    kernels_.reset();
    wheel_kernels_.reset();
    // 1. The fine grid
    lay_grid(element_, reached_);
    // 2. Pressure and tractions of the coarse one as a guess; 3. rise and motions of the rows from these
    solution_      = coarse;
    solution_.grid = problem_.grid;
    for (const auto field :
         {&HalfspaceSolution::pressure, &HalfspaceSolution::traction_x, &HalfspaceSolution::traction_y})
      solution_.*field = onto(problem_.grid, coarse.grid, coarse.*field);
    kernels_ = std::make_shared<HalfspaceKernels>(problem_);
    // stretch and motions of the coarse solution, so that the first fine round begins settled
    rise_ = wheel_rise(tractions());
    move_rows();
  }


  bool
  BodyContact::settle(const WheelRailLoad &load, const double tolerance, const double loosely)
  {
    constexpr int    most_rounds = 40, most_enlargements = 6;
    constexpr double load_settled = 1e-4;
    // loose problems first: rounds change their data anyway
    problem_.tangential_tolerance = tolerance;
    for (rounds_ = 0; rounds_ < most_rounds; ++rounds_)
      {
        const double change = solve_round(load);
        if (solution_.touches_grid_edge && enlargements_ < most_enlargements)
          {
            // the patch reaches the edge: a grid for 1.5 times the gap
            reached_ *= 1.5;
            ++enlargements_;
            lay_grid(problem_.grid.dx, reached_);
            continue;
          }
        // tractions across change the load after each round: both settle together
        const double wanted = vertical_load(load), missed = std::abs(force().y - wanted) / wanted;
        if (change < loosely && missed < loosely * load_settled)
          return true;
      }
    return false;
  }


  void
  BodyContact::carry(const WheelRailLoad &load)
  {
    if (solution_.grid.size() == 0)
      {
        // what needs many rounds, load, slip and place, is nearly found on a quarter of the elements
        // `loosely` 100: to a hundred times what counts as settled, tractions to 1e-3
        lay_grid(2 * element_, reached_);
        settle(load, 1e-3, 100);
        refine();
      }
    // a solution that did not settle is given with a sentence, and judged as not converged
    if (settle(load, tolerance_, 1))
      return;
    solution_.coupling_converged = false;
    solution_.not_reached += "Pressure, load and the stretch of the tread did not settle to each other. ";
  }


  double
  BodyContact::stretch_under_pressure(const WheelRailLoad &load)
  {
    // one round: pressure alone, nothing rolls yet
    lay_grid(element_, reached_);
    solve_round(load);
    return stretch_of_tread();
  }
} // namespace wheelrail
