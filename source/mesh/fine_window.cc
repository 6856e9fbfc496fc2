#include <wheelrail/mesh/fine_window.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  Range
  window_range(const SweepPlan &plan, const FineWindow &window, const Body body)
  {
    if (!plan.moving)
      return plan.fine;
    const double block = plan.block_length(), at = window.column[body] * block;
    Range        range = {at + plan.around_block.s0, at + plan.around_block.s1};
    if (window.column[body] >= window.start[body])
      range.s0 = std::max(range.s0, window.start[body] * block - plan.reach);
    // later a cut end would leave little to divide ahead of the wheel, and the few cells would take up what
    // momentum chords lack: measured, the normal force then swings by 0.2 % in place of 0.1 %
    if (window.column[body] <= window.start[body])
      range.s1 = std::min(range.s1, window.path_end[body] + plan.reach);
    return range;
  }


  Range
  window_across(const SweepPlan &plan, const FineWindow &window)
  {
    if (plan.across.empty())
      return plan.whole_strip();
    const int last = static_cast<int>(plan.across.size()) - 1;
    return plan.across[std::clamp(window.column.rail, 0, last)];
  }


  FineZone
  window_zone(const SweepPlan &plan, const FineWindow &window, const Body body)
  {
    const double block = plan.block_length();
    FineZone     zone  = {{window_range(plan, window, body), window_across(plan, window)}};
    for (const int k : window.kept[body])
      zone.emplace_back(Range{k * block, (k + 1) * block});
    return zone;
  }


  bool
  follow(FineWindow &window, const SweepPlan &plan, const PerBody<double> &place)
  {
    const double block = plan.block_length();
    bool         ended = false; // a range that was cut at the end of the path no longer is
    for (const Body body : both_bodies)
      if (place[body] > window.path_end[body] + block / (1 << plan.levels))
        {
          const double before   = window_range(plan, window, body).s1;
          window.path_end[body] = std::numeric_limits<double>::max();
          ended                 = ended || window_range(plan, window, body).s1 > before;
        }
    const auto has = [&](const Body body) {
      // a wheel that stands at a border does not go to and fro
      const double within = place[body] / block - window.column[body];
      return within >= -0.5 && within < 1;
    };
    if (has(Body::rail) && has(Body::wheel))
      return ended;
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
