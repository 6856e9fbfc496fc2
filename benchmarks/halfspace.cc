// Time of the half-space solver over grid size, one core: Hertzian ellipse and S1002 on 54E1 (100 kN, steady
// rolling with 25 kN given), and the difference to CONTACT's results at the same grid and step.

#include "../tests/quadratic_distance.h"
#include "../tests/wheel_rail_contact.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

using namespace wheelrail;

namespace
{
  struct Reference
  {
    double dx, peak, area, shear, xi, seconds; // mm, MPa, mm2, MPa, -, s of CONTACT
  };

  double
  seconds_of(const HalfspaceProblem &problem, HalfspaceSolution &solution)
  {
    double best = 1e9;
    for (int repeat = 0; repeat < 3; ++repeat)
      {
        const std::clock_t start = std::clock();
        solution                 = solve_rolling(problem);
        best                     = std::min(best, double(std::clock() - start) / CLOCKS_PER_SEC);
      }
    return best;
  }

  void
  print(const char *name, const HalfspaceProblem &problem, const Reference &r)
  {
    HalfspaceProblem  normal = problem;
    HalfspaceSolution s;
    normal.motion            = HalfspaceMotion::none;
    const double normal_time = seconds_of(normal, s), time = seconds_of(problem, s);
    std::printf("%-10s %6.3f %6d %8.3f %8.3f %8.2f %6d %6d %6d %8.3f %8.3f %8.3f %8.3f %s\n",
                name,
                r.dx,
                s.contact_elements,
                normal_time,
                time,
                r.seconds,
                s.normal_iterations,
                s.newton_steps,
                s.krylov_iterations,
                100 * (s.peak_pressure / (r.peak * 1e6) - 1),
                100 * (s.area / (r.area * 1e-6) - 1),
                100 * (s.peak_shear / (r.shear * 1e6) - 1),
                100 * (s.xi / r.xi - 1),
                s.not_reached.c_str());
  }
} // namespace

int
main()
{
  std::printf("%-10s %6s %6s %8s %8s %8s %6s %6s %6s %8s %8s %8s %8s\n",
              "case",
              "dx mm",
              "elems",
              "normal s",
              "all s",
              "CONTACT",
              "CG",
              "Newton",
              "GMRES",
              "peak %",
              "area %",
              "shear %",
              "creep %");
  for (const Reference &r : {Reference{0.5, 1238.03, 123.25, 513.597, -2.056e-3, 0.265},
                             Reference{0.25, 1237.65, 121.9375, 520.1498, -2.084e-3, 5.11},
                             Reference{0.125, 1237.58, 121.8281, 525.4217, -2.091e-3, 98.1}})
    {
      HalfspaceProblem problem;
      problem.grid                     = centred_grid(7.7e-3, 5.9e-3, r.dx * 1e-3, r.dx * 1e-3);
      problem.undeformed_distance      = test::quadratic_distance(problem.grid, 0.46, 0.3);
      problem.normal_force             = 100e3;
      problem.longitudinal_force_given = true;
      problem.fx                       = 25e3;
      print("ellipse", problem, r);
    }
  for (const Reference &r : {Reference{0.5, 1285.96, 179.75, 572.8267, 0.001689, 0.667},
                             Reference{0.25, 1288.51, 177.5, 576.0276, 0.001716, 7.01},
                             Reference{0.125, 1288.28, 176.6406, 580.7715, 0.001728, 181.3}})
    print("S1002/54E1", test::wheel_rail_contact(r.dx * 1e-3, -25e3, -0.1107), r);
}
