#include <wheelrail/planes/contact_sections.h>

#include <algorithm>
#include <cmath>

// Undeformed distance d(s, x), rolling radius and angles of the slices of a contact plane, and the rigid slip
// that follows. With yaw and irregularities the wheel is the surface of revolution in its position.

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
      // rotation about `centre`, then the lateral shift
      return {{centre.x + c * d.x - s * d.y + lateral, centre.y + s * d.x + c * d.y}, placement.angle + roll};
    }

    /// Where the wheel stands, turned by its roll and moved by the lateral offset, with Z from the point of
    /// the region.
    WheelPose
    moved_wheel(const ContactGeometry &contact, const SectionOffsets &offsets, const ContactRegion &region)
    {
      const Point2 &o = contact.frame.origin;
      const double  c = std::cos(offsets.wheel_roll), s = std::sin(offsets.wheel_roll);
      RigidMotion   roll;
      roll.rows = {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
      roll.move = {
        o.x - c * o.x + s * o.y + offsets.lateral, o.y - s * o.x - c * o.y, contact.along - region.along};
      WheelPose pose = contact.pose;
      pose.motion    = then(contact.pose.motion, roll);
      return pose;
    }

    /// The frame of the wheel's own section at a place of its tread, before the wheel is turned and moved.
    ContactFrame
    frame_on_tread(const ContactGeometry &contact, const CurvePoint &point)
    {
      const Point2 origin = contact.wheel.to_track(point.position),
                   along  = contact.wheel.to_track(point.position + point.tangent) - origin;
      return {origin, std::atan2(along.y, along.x)};
    }

    RunningSurfaces
    moved_surfaces(const TouchingProfiles &profiles,
                   const SectionOffsets   &offsets,
                   const ContactRegion    &region)
    {
      const ContactGeometry &contact = profiles.contact;
      const Point2          &point   = contact.frame.origin;
      const Placement        rail    = moved(contact.rail, point, offsets.rail_roll, 0);
      const FrameProfile     outline(contact.outline.curve,
                                 moved(contact.wheel, point, offsets.wheel_roll, offsets.lateral),
                                 region.frame);
      const CurvePoint   on_tread = profiles.wheel.tread.at(contact.outline.on_tread(outline.parameter(0)));
      const ContactFrame tread    = frame_on_tread(contact, on_tread);
      RunningSurfaces    surfaces{region.frame,
                               {FrameProfile(profiles.rail.head, rail, region.frame), region.frame, rail},
                               {FrameProfile(profiles.wheel.tread, contact.wheel, tread),
                                   tread,
                                   moved_wheel(contact, offsets, region),
                                   contact.rolling_radius},
                               SectionHeights(outline),
                               contact.rolling_radius,
                               contact.forward_radius};
      // places along count from the first contact point, arcs from the lowest line of the straight wheel
      surfaces.rail.take_irregularities(profiles.surfaces.rail, region.along - contact.along);
      surfaces.wheel.take_irregularities(profiles.surfaces.wheel);
      return surfaces;
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
    , surfaces_(moved_surfaces(profiles, offsets, region))
  {
    axle_.middle.x += offsets.lateral;
    lowest_ = undeformed_distance(outline(), rail(), 0);
    for (double s = s_min(); s <= s_max(); s += sample_step)
      {
        samples_.push_back(undeformed_distance(outline(), rail(), s));
        if (samples_.back() < lowest_)
          {
            lowest_   = samples_.back();
            lowest_s_ = s;
          }
      }
    if (surfaces_.irregular())
      sample_irregular();
  }


  /// The least distance of irregular surfaces may lie anywhere ahead of the smooth contact or behind it: they
  /// are sampled as far as wheel and rail come near each other.
  void
  ContactSections::sample_irregular()
  {
    constexpr double step = 0.25e-3, room = 0.5e-3; // along and across; beyond any approach [m]
    double           up = 0, down = 0;
    // heights alone tell how far to look: once coarsely over all that could matter
    const double    widest = half_length_bound(8e-3, geometry().rolling_radius);
    RunningSurfaces smooth = surfaces_;
    smooth.rail.set_irregularities(nullptr);
    smooth.wheel.set_irregularities(nullptr);
    for (double s = s_min(); s <= s_max(); s += 4 * step)
      for (double x = -widest; x <= widest; x += 4 * step)
        {
          // how far irregularities bring the surfaces nearer (> 0) or apart
          const double h = smooth.distance(s, x) - surfaces_.distance(s, x);
          up             = std::max(up, h);
          down           = std::min(down, h);
        }
    const double reach = up - down + room, half = half_length_bound(reach, geometry().rolling_radius);
    for (double s = s_min(); s <= s_max(); s += step)
      if (undeformed_distance(outline(), rail(), s) - lowest_ < reach)
        {
          const double middle = slice(s).along;
          for (double x = middle - half; x <= middle + half; x += step)
            irregular_.push_back({x, s, surfaces_.distance(s, x)});
        }
    lowest_ = irregular_.front().distance;
    for (const Sample &sample : irregular_)
      if (sample.distance < lowest_)
        {
          lowest_   = sample.distance;
          lowest_s_ = sample.s;
        }
  }


  HalfspaceGrid
  ContactSections::irregular_grid(const double approach, const double element) const
  {
    double x0 = HUGE_VAL, x1 = -HUGE_VAL, s0 = HUGE_VAL, s1 = -HUGE_VAL;
    for (const Sample &sample : irregular_)
      if (sample.distance - lowest_ < approach)
        {
          x0 = std::min(x0, sample.x);
          x1 = std::max(x1, sample.x);
          s0 = std::min(s0, sample.s);
          s1 = std::max(s1, sample.s);
        }
    const auto down = [element](const double value) { return int(std::floor(value / element)) - 2; };
    const auto up   = [element](const double value) { return int(std::ceil(value / element)) + 2; };
    const int  i0 = down(x0), i1 = up(x1), j0 = down(s0), j1 = up(s1);
    return {i1 - i0 + 1, j1 - j0 + 1, element, element, i0 * element, j0 * element};
  }


  double
  ContactSections::s_min() const
  {
    return std::max({rail().s_min(), outline().s_min(), region_.s_min});
  }


  double
  ContactSections::s_max() const
  {
    return std::min({rail().s_max(), outline().s_max(), region_.s_max});
  }


  double
  ContactSections::distance(const double s) const
  {
    return undeformed_distance(outline(), rail(), s) - lowest_;
  }


  double
  ContactSections::distance(const double s, const double x) const
  {
    return surfaces_.distance(s, x) - lowest_;
  }


  Point2
  ContactSections::rail_place(const double s) const
  {
    return region_.frame.to_track({s, rail().at(s).n});
  }


  SurfaceKinks
  ContactSections::kinks_under(const HalfspaceSolution &solution, const std::vector<double> &places) const
  {
    const HalfspaceGrid  &grid = solution.grid;
    std::vector<PatchRow> rows;
    for (int j = 0; j < grid.my; ++j)
      {
        PatchRow row{places[j], HUGE_VAL, -HUGE_VAL};
        for (int i = 0; i < grid.mx; ++i)
          if (solution.pressure[i + std::size_t(grid.mx) * j] > 0)
            {
              row.z0 = std::min(row.z0, grid.x(i));
              row.z1 = std::max(row.z1, grid.x(i));
            }
        if (row.z0 <= row.z1)
          rows.push_back(row);
      }
    return surface_kinks(surfaces_, rows, grid.dx);
  }


  ContactSections::Slice
  ContactSections::slice(const double s) const
  {
    const ContactFrame       &frame = region_.frame;
    const FrameProfile::Value wheel = outline().at(s);
    const Point2              place = frame.to_track({s, wheel.n});

    Slice slice;
    // angle of the wheel's section against X in the track plane; the surface of revolution touches its plane
    // at the lowest place of the circle through it, `along` ahead of the axle with yaw
    slice.wheel_tangent                 = frame.angle + std::atan(wheel.slope);
    const AxleLine::SurfacePoint lowest = axle_.surface_point(place, slice.wheel_tangent);
    slice.along                         = lowest.along - region_.along;
    slice.radius                        = lowest.radius;
    slice.wheel_angle                   = lowest.slope;
    slice.rail_angle                    = frame.angle + std::atan(rail().at(s).slope);
    slice.from_middle                   = {place.x - axle_.middle.x, place.y - axle_.middle.y, lowest.along};
    // velocity over the pitch rate: axis x arm
    slice.rolling = cross(axle_.direction, slice.from_middle);
    return slice;
  }


  HalfspaceGrid
  ContactSections::grid(const double approach, const double element) const
  {
    if (!irregular_.empty())
      return irregular_grid(approach, element);
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
    const double half = half_length_bound(approach, geometry().rolling_radius);
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
        for (int i = 0; i < problem.grid.mx; ++i)
          problem.undeformed_distance[i + problem.grid.mx * j] = distance(s, problem.grid.x(i));
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
        // means over the pressure; CONTACT forms others (doc/theory/accuracy.md, Position and angles)
        means.wheel_angle += p * slice.wheel_angle;
      }
    return {means.s / sum, means.rail_angle / sum, means.wheel_angle / sum};
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
    const RigidSlip              mean   = rigid_slip(centre, motion, creepage);
    problem.rigid_slip_x.assign(grid.size(), 0.);
    problem.rigid_slip_y.assign(grid.size(), 0.);
    problem.eta = mean.lateral;
    if (motion.one_spin)
      {
        problem.phi = std::isnan(motion.spin)
                        // one spin for all rows: sin(angle)/(r cos(yaw)) - kappa cos(angle)
                        ? std::sin(means.wheel_angle) / (centre.radius * std::cos(sections.geometry().yaw)) -
                            motion.curvature * std::cos(centre.wheel_tangent)
                        : motion.spin;
        // w_x = w_mean - phi (y - y_mean), w_s = w_mean + phi (x - x_mean): the solver has the spin about (0,
        // 0)
        problem.rigid_slip_x.assign(grid.size(), mean.along + problem.phi * means.s);
        problem.rigid_slip_y.assign(grid.size(), -problem.phi * centre.along);
        return;
      }
    const double offset = problem.spin_offset * grid.dx;
    for (int j = 0; j < grid.my; ++j)
      {
        const double  s    = std::clamp(grid.y(j), sections.s_min(), sections.s_max());
        const RowSlip slip = row_slip(sections.slice(s), motion, creepage);
        for (int i = 0; i < grid.mx; ++i)
          {
            problem.rigid_slip_x[i + grid.mx * j] = slip.along;
            // w_s at x + dq/6, less its mean, which is eta
            problem.rigid_slip_y[i + grid.mx * j] = slip.lateral_at(grid.x(i) + offset) - mean.lateral;
          }
      }
  }
} // namespace wheelrail
