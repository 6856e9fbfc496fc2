#include <wheelrail/mesh/fine_window.h>

#include <cmath>

namespace wheelrail
{
  Range
  window_range(const SweepPlan &plan, const int column)
  {
    const double block = plan.block_length();
    return {plan.fine_begin + column * block, plan.fine_end + column * block};
  }


  FineZone
  window_zone(const SweepPlan &plan, const int column, const std::vector<int> &kept)
  {
    const double block = plan.block_length();
    FineZone     zone  = {window_range(plan, column)};
    for (const int k : kept)
      zone.push_back({k * block, (k + 1) * block});
    return zone;
  }


  bool
  follow(FineWindow &window, const SweepPlan &plan, const PerBody<double> &place)
  {
    const double block = plan.block_length();
    const auto   has   = [&](const Body body) {
      // a wheel that stands at a border does not go to and fro
      const double within = place[body] / block - window.column[body];
      return within >= -0.5 && within < 1;
    };
    if (has(Body::rail) && has(Body::wheel))
      return false;
    for (const Body body : both_bodies)
      {
        const bool leaves = !has(body);
        const bool close  = place[body] / block - window.column[body] >= 0.75;
        if (leaves || close)
          window.column[body] = static_cast<int>(std::floor(place[body] / block + (leaves ? 0 : 0.25)));
      }
    return true;
  }
} // namespace wheelrail
