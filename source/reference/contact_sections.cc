#include <wheelrail/reference/contact_sections.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    // between two such places a profile of 10 mm radius moves by less than 2 nm [m]
    constexpr double sample_step = 1e-5;

    /// Section turned by `roll` about `centre` and moved by `lateral` along X.
    Placement
    moved(const Placement &placement, const Point2 &centre, const double roll, const double lateral)
    {
      const Point2 d = placement.origin - centre;
      const double c = std::cos(roll), s = std::sin(roll);
      return {{centre.x + c * d.x - s * d.y + lateral, centre.y + s * d.x + c * d.y}, placement.angle + roll};
    }

    double
    squared(const double x)
    {
      return x * x;
    }
  } // namespace


  ContactRegion
  whole_region(const ContactGeometry &geometry)
  {
    return {geometry.frame, geometry.along, geometry.ahead};
  }


  ContactSections::ContactSections(const TouchingProfiles &profiles,
                                   const SectionOffsets   &offsets,
                                   const ContactRegion    &region)
    : profiles_(profiles)
    , region_(region)
    , axle_(profiles.contact.axis)
    , rail_(profiles.rail.head,
            moved(profiles.contact.rail, profiles.contact.frame.origin, offsets.rail_roll, 0),
            region.frame)
    , wheel_(
        profiles.contact.outline.curve,
        moved(profiles.contact.wheel, profiles.contact.frame.origin, offsets.wheel_roll, offsets.lateral),
        region.frame)
  {
    axle_.middle.x += offsets.lateral;
    lowest_ = undeformed_distance(wheel_, rail_, 0);
    for (double s = s_min(); s <= s_max(); s += sample_step)
      {
        samples_.push_back(undeformed_distance(wheel_, rail_, s));
        if (samples_.back() < lowest_)
          {
            lowest_   = samples_.back();
            lowest_s_ = s;
          }
      }
  }


  double
  ContactSections::s_min() const
  {
    return std::max({rail_.s_min(), wheel_.s_min(), region_.s_min});
  }


  double
  ContactSections::s_max() const
  {
    return std::min({rail_.s_max(), wheel_.s_max(), region_.s_max});
  }


  double
  ContactSections::distance(const double s) const
  {
    return undeformed_distance(wheel_, rail_, s) - lowest_;
  }


  Point2
  ContactSections::rail_place(const double s) const
  {
    return region_.frame.to_track({s, rail_.at(s).n});
  }


  ContactSections::Slice
  ContactSections::slice(const double s) const
  {
    const ContactFrame       &frame = region_.frame;
    const FrameProfile::Value wheel = wheel_.at(s);
    const double              slope = std::atan(wheel.slope);
    const Point2              place = frame.to_track({s, wheel.n});

    Slice slice;
    slice.wheel_tangent                 = frame.angle + slope;
    const AxleLine::SurfacePoint lowest = axle_.surface_point(place, slice.wheel_tangent);
    slice.along                         = lowest.along - region_.along;
    slice.radius                        = lowest.radius;
    slice.wheel_angle                   = lowest.slope;
    slice.rail_angle                    = frame.angle + std::atan(rail_.at(s).slope);
    slice.from_middle                   = {place.x - axle_.middle.x, place.y - axle_.middle.y, lowest.along};
    slice.rolling                       = cross(axle_.direction, slice.from_middle);
    // curvature of the surface in the direction of the track, from those around the axle and along the tread
    // (Euler 1760); the distance along n at fixed s follows from the slope
    const double c = std::cos(slice.wheel_angle), share = squared(axle_.direction[2] / c);
    double       curvature = c / slice.radius;
    if (share > 0)
      {
        const double t = geometry().outline.on_tread(wheel_.parameter(s));
        curvature      = (1 - share) * curvature - share * profiles_.wheel.tread.at(t).curvature;
      }
    slice.curvature = curvature / std::cos(slope);
    return slice;
  }


  HalfspaceGrid
  ContactSections::grid(const double approach, const double element) const
  {
    double low = lowest_s_, high = lowest_s_;
    double s = s_min();
    for (const double sample : samples_)
      {
        if (sample - lowest_ < approach)
          {
            low  = std::min(low, s);
            high = std::max(high, s);
          }
        s += sample_step;
      }
    // the lowest places of the slices lie one behind the other, as the angle grows across the patch
    double back = 0, front = 0;
    for (const double place : {low, lowest_s_, high})
      {
        const double along = slice(place).along;
        back               = std::min(back, along);
        front              = std::max(front, along);
      }
    const double half = std::sqrt(2 * geometry().rolling_radius * approach);
    const int    n0   = int(std::ceil((half - back) / element)) + 2,
              n1 = int(std::ceil((half + front) / element)) + 2, y0 = int(std::floor(low / element)) - 2,
              y1 = int(std::ceil(high / element)) + 2;
    return {n0 + n1 + 1, y1 - y0 + 1, element, element, -n0 * element, y0 * element};
  }


  void
  ContactSections::set_distance(HalfspaceProblem &problem) const
  {
    constexpr double far = 0.1; // where there is no profile: farther than any approach [m]
    problem.undeformed_distance.assign(problem.grid.size(), far);
    for (int j = 0; j < problem.grid.my; ++j)
      {
        const double s = problem.grid.y(j);
        if (s < s_min() || s > s_max())
          continue;
        const Slice  here = slice(s);
        const double d    = distance(s);
        for (int i = 0; i < problem.grid.mx; ++i)
          problem.undeformed_distance[i + problem.grid.mx * j] =
            d + 0.5 * here.curvature * squared(problem.grid.x(i) - here.along);
      }
  }


  PressureMeans
  pressure_means(const ContactSections &sections, const HalfspaceSolution &solution)
  {
    PressureMeans means;
    double        sum = 0;
    for (int j = 0; j < solution.grid.my; ++j)
      {
        double p = 0;
        for (int i = 0; i < solution.grid.mx; ++i)
          p += solution.pressure[i + solution.grid.mx * j];
        if (!(p > 0))
          continue;
        const double                 s     = solution.grid.y(j);
        const ContactSections::Slice slice = sections.slice(s);
        sum += p;
        means.s += p * s;
        means.rail_angle += p * slice.rail_angle;
        means.wheel_angle += p * slice.wheel_angle;
      }
    return {means.s / sum, means.rail_angle / sum, means.wheel_angle / sum};
  }


  RigidSlip
  rigid_slip(const ContactSections        &sections,
             const ContactSections::Slice &slice,
             const WheelMotion            &motion,
             const double                  creepage)
  {
    const double rate = 1 / (sections.geometry().rolling_radius * std::cos(sections.geometry().yaw));
    const double c = std::cos(slice.wheel_tangent), s = std::sin(slice.wheel_tangent);
    return {-(1 - motion.curvature * slice.from_middle[0]) - rate * slice.rolling[2],
            -(1 + creepage) * rate * (c * slice.rolling[0] + s * slice.rolling[1]) -
              (motion.lateral_creepage + motion.curvature * slice.from_middle[2]) * c};
  }


  double
  wheel_spin(const ContactSections        &sections,
             const ContactSections::Slice &slice,
             const WheelMotion            &motion,
             const double                  creepage)
  {
    const ContactGeometry &geometry = sections.geometry();
    return (1 + creepage) * std::sin(slice.wheel_angle) / (geometry.rolling_radius * std::cos(geometry.yaw)) -
           motion.curvature * std::cos(slice.wheel_tangent);
  }


  void
  set_slip(const ContactSections &sections,
           const PressureMeans   &means,
           const WheelMotion     &motion,
           const double           creepage,
           HalfspaceProblem      &problem)
  {
    const HalfspaceGrid         &grid   = problem.grid;
    const ContactSections::Slice centre = sections.slice(means.s);
    const RigidSlip              mean   = rigid_slip(sections, centre, motion, creepage);
    problem.rigid_slip_x.assign(grid.size(), 0.);
    problem.rigid_slip_y.assign(grid.size(), 0.);
    problem.eta = mean.lateral;
    if (motion.one_spin)
      {
        problem.phi = std::isnan(motion.spin)
                        ? std::sin(means.wheel_angle) / (centre.radius * std::cos(sections.geometry().yaw)) -
                            motion.curvature * std::cos(centre.wheel_tangent)
                        : motion.spin;
        problem.rigid_slip_x.assign(grid.size(), mean.along + problem.phi * means.s);
        problem.rigid_slip_y.assign(grid.size(), -problem.phi * centre.along);
        return;
      }
    const double offset = problem.spin_offset * grid.dx;
    for (int j = 0; j < grid.my; ++j)
      {
        const double                 s     = std::clamp(grid.y(j), sections.s_min(), sections.s_max());
        const ContactSections::Slice slice = sections.slice(s);
        const RigidSlip              slip  = rigid_slip(sections, slice, motion, creepage);
        const double                 turn  = wheel_spin(sections, slice, motion, 0);
        for (int i = 0; i < grid.mx; ++i)
          {
            problem.rigid_slip_x[i + grid.mx * j] = slip.along;
            problem.rigid_slip_y[i + grid.mx * j] =
              slip.lateral - mean.lateral + turn * (grid.x(i) - slice.along + offset);
          }
      }
  }
} // namespace wheelrail
