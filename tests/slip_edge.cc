// label: fast

// The peak of the shear traction between the nodes, where stick and slip meet.
#include "near.h"

#include <wheelrail/sampling/patch_measures.h>
#include <wheelrail/sampling/slip_edge.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace wheelrail;
using test::near;

namespace
{
  constexpr double friction = 0.5, top = 1e9;

  /// Strip theory (Haines and Ollerton, 1963) of an ellipse with semi-axes a along and b, rolling towards
  /// +along, on a grid of cells h moved by u h and v h: each strip is a Carter contact (Carter, 1926) whose
  /// sticking part reaches from the leading edge `shift` short of twice its own half length.
  PatchFields
  strip_patch(const double a,
              const double b,
              const double shift,
              const double h,
              const double u,
              const double v)
  {
    PatchFields patch;
    patch.n_along   = static_cast<unsigned int>(2 * a / h) + 5;
    patch.n_lateral = static_cast<unsigned int>(2 * b / h) + 5;
    for (unsigned int i = 0; i < patch.n_along; ++i)
      for (unsigned int j = 0; j < patch.n_lateral; ++j)
        {
          const double x = (i + u - 0.5 * patch.n_along) * h, y = (j + v - 0.5 * patch.n_lateral) * h;
          const double half  = a * std::sqrt(std::max(0., 1 - y * y / (b * b)));
          const double p     = std::abs(x) < half ? top / a * std::sqrt(half * half - x * x) : 0;
          const double stick = half - shift, from_middle = x - shift;
          const bool   sticks = p > 0 && stick > 0 && std::abs(from_middle) < stick;
          double       shear  = friction * p;
          if (sticks)
            shear -= friction * top / a * std::sqrt(stick * stick - from_middle * from_middle);
          patch.along.push_back(x);
          patch.lateral.push_back(y);
          patch.pressure.push_back(p);
          patch.gap.push_back(p > 0 ? -1e-7 : 1e-6);
          patch.traction_along.push_back(-0.8 * shear);
          patch.traction_lateral.push_back(0.6 * shear);
          patch.slip_along.push_back(0);
          patch.slip_lateral.push_back(0);
          patch.state.push_back(p > 0 ? (sticks ? 1 : 2) : 0);
          patch.area.push_back(h * h);
        }
    return patch;
  }

  double
  largest_nodal(const PatchFields &patch)
  {
    double largest = 0;
    for (std::size_t k = 0; k < patch.pressure.size(); ++k)
      largest = std::max(largest, std::hypot(patch.traction_along[k], patch.traction_lateral[k]));
    return largest;
  }

  /// The peak of strip theory lies on the middle line, at along = 2 shift - a, under the bound there.
  void
  test_strips(const double a, const double b, const double shift, const double h, const double tolerance)
  {
    const double place = 2 * shift / a - 1, exact = friction * top * std::sqrt(1 - place * place);
    double       worst = 0, worst_nodal = 0;
    for (int n = 0; n < 50; ++n)
      {
        const double u = std::fmod(0.754877666 * n, 1.), v = std::fmod(0.569840291 * n, 1.);
        const auto   patch = strip_patch(a, b, shift, h, u, v);
        worst              = std::max(worst, std::abs(largest_shear(patch) / exact - 1));
        worst_nodal        = std::max(worst_nodal, std::abs(largest_nodal(patch) / exact - 1));
      }
    BOOST_TEST(
      near(worst, 0, tolerance, "largest relative error of the peak shear, h/a = " + std::to_string(h / a)));
    BOOST_TEST(worst_nodal > 3 * worst, "the largest nodal value is off by " + std::to_string(worst_nodal));
  }

  void
  test_limits()
  {
    const auto all_slip = strip_patch(6e-3, 9e-3, 7e-3, 1e-3, 0.3, 0.2);
    BOOST_TEST(near(largest_shear(all_slip), largest_nodal(all_slip), 0, "nothing sticks: the nodal value"));
    const auto all_stick = strip_patch(6e-3, 9e-3, 0, 1e-3, 0.3, 0.2);
    BOOST_TEST(near(largest_shear(all_stick), largest_nodal(all_stick), 0, "nothing slips: the nodal value"));
    BOOST_TEST(near(measure_patch(strip_patch(6e-3, 9e-3, 1.7e-3, 1e-3, 0, 0)).max_traction,
                    largest_shear(strip_patch(6e-3, 9e-3, 1.7e-3, 1e-3, 0, 0)),
                    0,
                    "the measures of a patch hold this peak"));
    // the points that pages draw lie where theory has the line
    const SlipEdge edge  = slip_edge(strip_patch(6e-3, 9e-3, 1.7e-3, 0.5e-3, 0.4, 0.5));
    double         worst = 0;
    std::size_t    inner = 0;
    for (std::size_t k = 0; k < edge.along.size(); ++k)
      if (const double y = edge.lateral[k]; std::abs(y) < 5e-3 && ++inner)
        worst = std::max(worst, std::abs(edge.along[k] - (3.4e-3 - 6e-3 * std::sqrt(1 - y * y / 81e-6))));
    BOOST_TEST((inner > 15 && worst < 0.1e-3),
               std::to_string(inner) + " points, off by " + std::to_string(1e3 * worst) + " mm");
    // against the rolling direction
    auto         turned = strip_patch(6e-3, 9e-3, 1.7e-3, 1e-3, 0.4, 0.1);
    const double before = largest_shear(turned);
    for (double &x : turned.along)
      x = -x;
    for (auto *field : {&turned.along,
                        &turned.lateral,
                        &turned.pressure,
                        &turned.traction_along,
                        &turned.traction_lateral,
                        &turned.state})
      std::reverse(field->begin(), field->end());
    BOOST_TEST(near(largest_shear(turned), before, 1e-6 * before, "rolling the other way"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(stick_meets_slip)
{
  test_strips(6e-3, 9e-3, 1.7e-3, 1e-3, 0.002);
  test_strips(6e-3, 9e-3, 1.7e-3, 0.5e-3, 0.001);
  test_strips(6e-3, 9e-3, 1e-3, 1e-3, 0.005);
  test_limits();
}
