#include <wheelrail/halfspace/added_influence.h>
#include <wheelrail/halfspace/normal_problem.h>

#include <algorithm>
#include <vector>

namespace wheelrail
{
  void
  solve_normal_problem(const HalfspaceProblem &problem,
                       HalfspaceKernels       &kernels,
                       const bool              coupled,
                       const VectorField      &traction,
                       NormalContact          &normal)
  {
    using Spectrum               = InfluenceProducts::Spectrum;
    InfluenceProducts  &products = kernels.products();
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
