#include <wheelrail/base/quantity.h>
#include <wheelrail/model/rise_over_section.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Makes the surface keep the section of the start within the lead-in, where sections change there.
    /// `origin`: of the path, along.
    void
    lead_into(Irregularity             &shape,
              const HeightGrid         &grid,
              const double              origin,
              const std::string        &rail,
              std::vector<std::string> &notes)
    {
      constexpr double even     = 1e-6;
      double           at_start = 0;
      for (const double x : grid.across)
        for (const double u : {-lead_in.s0, 0., lead_in.s0})
          at_start = std::max(at_start, std::abs(shape.at(x, origin + u).height));
      if (at_start < even)
        return;
      shape.at = [whole = shape.at, origin](const double across, const double along) {
        IrregularHeight h         = whole(across, along);
        const auto [share, slope] = passing_over(std::abs(along - origin), lead_in.s0, lead_in.s1);
        h.along                   = share * h.along + std::copysign(slope, along - origin) * h.height;
        h.height *= share;
        h.across *= share;
        return h;
      };
      notes.push_back("Profiles/Rail = " + rail +
                      ": its section changes where the run starts: the surface "
                      "goes over to the slices between " +
                      in_mm(lead_in.s0) + " and " + in_mm(lead_in.s1));
    }
  } // namespace


  std::vector<Foot>
  feet_of(const TouchingProfiles &profiles)
  {
    constexpr double    spacing = 0.5e-3, steepest = 4;
    const Placement    &section = profiles.contact.rail;
    const ContactFrame &frame   = profiles.contact.frame;
    const FrameProfile  head(profiles.rail.head, section, frame, steepest);
    const int           n = static_cast<int>((head.s_max() - head.s_min()) / spacing);
    std::vector<Foot>   feet;
    for (int i = 0; i <= n; ++i)
      {
        const double              s      = head.s_max() + (head.s_min() - head.s_max()) * i / n;
        const FrameProfile::Value height = head.at(s);
        const double              secant = std::sqrt(1 + height.slope * height.slope);
        const auto   to_section = [&](const Point2 &q) { return section.to_section(frame.to_track(q)); };
        const Point2 at         = to_section({s, height.n});
        feet.push_back({at,
                        to_section({s + 1 / secant, height.n + height.slope / secant}) - at,
                        to_section({s - height.slope / secant, height.n + 1 / secant}) - at});
      }
    return feet;
  }


  std::pair<double, double>
  passing_over(const double at, const double from, const double to)
  {
    const double length = to - from, t = std::clamp((at - from) / length, 0., 1.);
    return {t * t * t * (10 - t * (15 - 6 * t)), 30 * t * t * (1 - t) * (1 - t) / length};
  }


  Irregularity
  rise_irregularity(const HeightGrid         &grid,
                    const double              begin,
                    const double              start,
                    const std::string        &rail,
                    std::vector<std::string> &notes)
  {
    Irregularity shape = grid_irregularity(grid, -begin - start, 0, 0);
    shape.name         = "Profiles";
    shape.endless      = true;
    shape.kinks.clear(); // between slices the sections are interpolated
    lead_into(shape, grid, -start, rail, notes);
    return shape;
  }
} // namespace wheelrail
