#include <wheelrail/halfspace/turned_rows.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

// Element J displaces I by w = A(I - J) t(J) in the directions of J: x along, s across, n normal, the latter
// two turned by a_J. In those of I: u_s = w_s cos d + w_n sin d, u_n = w_n cos d - w_s sin d, d = a_I - a_J,
// u_x = w_x. Sines and cosines of a difference are sums of products, so that FFTs of t cos a_J and t sin a_J
// do. What half-spaces in a plane have is taken off.

namespace wheelrail
{
  TurnedRows::TurnedRows(const HalfspaceProblem &problem, const std::vector<double> &angles)
    : grid_(problem.grid)
    , kernels_(problem)
  {
    // from y towards n [rad]: of a row that rises to one side
    for (const double angle : angles)
      {
        cosine_.push_back(std::cos(angle));
        sine_.push_back(std::sin(angle));
      }
    // y and n turn, x does not. Of like bodies pressure displaces along n alone, tractions in the plane
    // alone.
    const bool   coupled = kernels_.constants().coupling != 0;
    const double step    = problem.step > 0 ? problem.step : grid_.dx;
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 3; ++b)
        if (coupled || (a == 1) == (b == 2))
          {
            // y and n under x, y, n: a + 1 is their number among (x, y, n)
            const auto component      = std::size_t(a);
            here_[component][b]       = kernels_.of(a + 1, b, 0);
            Spectrum       &slip      = slip_[component][b];
            const Spectrum &displaced = here_[component][b], &before = kernels_.of(a + 1, b, step);
            // of the slip: (A - A')/dq, A' with the loads seen a step dq ahead
            slip.resize(displaced.size());
            for (std::size_t m = 0; m < slip.size(); ++m)
              slip[m] = (displaced[m] - before[m]) / step;
          }
  }


  void
  TurnedRows::add(const Spectra &spectra, const Given &traction, const Fields &result) const
  {
    const std::size_t mx = std::size_t(grid_.mx), n = std::size_t(grid_.size());
    // displacements y, n of the tractions themselves, times their cosines and times their sines
    std::array<std::array<Spectrum, 2>, 3> sums;
    // 1. Displacements in the directions of the loaded element, with cos a_J and sin a_J taken into the
    // tractions: a_I - a_J is no function of the distance I - J, as the FFT needs it, but its sine and cosine
    // are sums of products
    for (std::size_t b = 0; b < 3; ++b)
      {
        if (!traction[b])
          continue;
        for (std::size_t kind = 0; kind < 3; ++kind)
          {
            // kind 0: as it is; 1: times cos a_J; 2: times sin a_J
            std::vector<double> field = *traction[b];
            for (std::size_t e = 0; kind > 0 && e < n; ++e)
              field[e] *= kind == 1 ? cosine_[e / mx] : sine_[e / mx];
            Spectrum modes;
            kernels_.products().forward(field, modes);
            for (std::size_t a = 0; a < 2; ++a)
              {
                const Spectrum &kernel = spectra[a][b];
                if (kernel.empty())
                  continue;
                sums[kind][a].resize(modes.size(), 0.);
                for (std::size_t m = 0; m < modes.size(); ++m)
                  sums[kind][a][m] += times(kernel[m], modes[m]);
              }
          }
      }
    // 2. Back to fields: three kinds of y, three of n
    const auto field_of = [&](std::size_t kind, std::size_t a) {
      std::vector<double> field(n, 0.);
      if (!sums[kind][a].empty())
        kernels_.products().backward(sums[kind][a], field);
      return field;
    };
    const auto y = field_of(0, 0), n_flat = field_of(0, 1), y_cos = field_of(1, 0), n_cos = field_of(1, 1),
               y_sin = field_of(2, 0), n_sin = field_of(2, 1);
    for (std::size_t e = 0; e < n; ++e)
      {
        // 3. Sum and turn
        const double c = cosine_[e / mx], s = sine_[e / mx];
        // sum over J of w turned by a_J into the plane: w_s cos a_J - w_n sin a_J, w_s sin a_J + w_n cos a_J
        const double across = y_cos[e] - n_sin[e], down = y_sin[e] + n_cos[e];
        // and by -a_I into the directions of the row, less the half-space in a plane
        if (result[1])
          (*result[1])[e] += c * across + s * down - y[e];
        if (result[2])
          (*result[2])[e] += c * down - s * across - n_flat[e];
      }
  }


  void
  TurnedRows::add_displacement(const Given &traction, const Fields &displacement) const
  {
    add(here_, traction, displacement);
  }


  void
  TurnedRows::add_slip(const Given &traction, const Fields &slip) const
  {
    add(slip_, traction, slip);
  }


  HalfspaceSolution
  solve_turned(HalfspaceProblem                   problem,
               const std::vector<double>         &angles,
               const int                          rounds,
               std::shared_ptr<HalfspaceKernels> &kernels,
               const HalfspaceSolution           *guess)
  {
    // tractions shift surfaces along the normal by the guess of the round before: hence rounds
    problem.added         = std::make_shared<TurnedRows>(problem, angles);
    HalfspaceSolution now = solve_rolling(problem, kernels, guess);
    for (int round = 1; round < rounds; ++round)
      {
        const HalfspaceSolution before = now;
        now                            = solve_rolling(problem, kernels, &before);
        double change                  = 0;
        for (std::size_t e = 0; e < now.pressure.size(); ++e)
          change = std::max(change, std::abs(now.pressure[e] - before.pressure[e]));
        if (change <= problem.coupling_tolerance * now.peak_pressure)
          break;
      }
    return now;
  }
} // namespace wheelrail
