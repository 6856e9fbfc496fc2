#include <deal.II/base/symmetric_tensor.h>

#include <wheelrail/base/parallel.h>
#include <wheelrail/model/moved_cells.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// A reference point below a running surface, over its place along [m].
    Vector3
    below_surface(const SweepPlan &plan,
                  const Body       body,
                  const double     s,
                  const double     depth,
                  const double     along)
    {
      const RunningSurface &surface = plan.surfaces[body];
      const double          n       = surface.smooth(s).n + (body == Body::rail ? -depth : depth);
      const Point2          p       = surface.frame().to_track({s, n});
      if (body == Body::rail)
        return {p.x, p.y, along};
      const WheelPose &pose    = surface.pose();
      const Point2     section = pose.section.to_section(p);
      return pose.position(section.x, pose.nominal_radius - section.y, along / plan.surfaces.rolling_radius);
    }

    /// The least stretch of a cell on the surface.
    double
    least_stretch(const SweepPlan &plan,
                  const Body       body,
                  const double     s,
                  const double     along,
                  const double     cell)
    {
      const RunningSurface &surface = plan.surfaces[body];
      const auto            at      = [&](const double ahead, const double aside, const double depth) {
        const auto place =
          surface.place(surface.moved(below_surface(plan, body, s + aside, depth, along + ahead)));
        return Vector3{place.s, place.n - surface.smooth(s + aside).n, place.along};
      };
      const Vector3 corner   = at(0, 0, 0);
      const Vector3 edges[3] = {at(0, cell, 0) - corner, corner - at(0, 0, cell), at(cell, 0, 0) - corner};
      dealii::SymmetricTensor<2, 3> squared;
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
          squared[i][j] = dot(edges[i], edges[j]) / (cell * cell);
      return std::sqrt(std::max(0., dealii::eigenvalues(squared)[2]));
    }

    /// Where irregularities move nodes on the path, along [m].
    Range
    moved_stretch(const SweepPlan &plan, const Body body)
    {
      Range stretch{HUGE_VAL, -HUGE_VAL};
      for (const Irregularity &one : plan.surfaces[body].irregularities())
        if (one.carried == CarriedBy::mesh)
          stretch = {std::min(stretch.s0, one.begin), std::max(stretch.s1, one.end)};
      if (body == Body::rail)
        stretch = {std::max(stretch.s0, -plan.reach), std::min(stretch.s1, plan.longest_path + plan.reach)};
      return stretch;
    }
  } // namespace


  double
  thinnest_cells(const SweepPlan &plan)
  {
    const double cell  = plan.block_length() / std::pow(2., plan.levels);
    double       least = 1;
    for (const Body body : both_bodies)
      {
        const Range stretch = moved_stretch(plan, body);
        if (!(stretch.s1 > stretch.s0))
          continue;
        std::vector<double> rows(static_cast<std::size_t>(std::ceil((stretch.s1 - stretch.s0) / cell)), 1.);
        parallel_for(rows.size(), [&](const std::size_t k) {
          for (double s = plan.strip.s.front(); s < plan.strip.s.back() - 0.5 * cell; s += cell)
            rows[k] = std::min(
              rows[k], least_stretch(plan, body, s, stretch.s0 + static_cast<double>(k) * cell, cell));
        });
        least = std::min(least, *std::min_element(rows.begin(), rows.end()));
      }
    return least;
  }
} // namespace wheelrail
