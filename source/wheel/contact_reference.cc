#include <wheelrail/wheel/contact_reference.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  WheelsetForces
  wheelset_forces(const ContactSections            &sections,
                  const std::vector<RowOfElements> &rows,
                  const HalfspaceSolution          &solution)
  {
    const HalfspaceGrid &grid   = solution.grid;
    const Point2        &middle = sections.geometry().axis.middle;
    WheelsetForces       sum;
    for (int j = 0; j < grid.my; ++j)
      {
        const Point2 &place = rows[j].place;
        const double  c = std::cos(rows[j].angle), s = std::sin(rows[j].angle);
        for (int i = 0; i < grid.mx; ++i)
          {
            const int e = i + grid.mx * j;
            if (solution.pressure[e] <= 0)
              continue;
            // tractions of the solution are those on the rail
            const Vector3 f =
              grid.element_area() * Vector3{-s * solution.pressure[e] - c * solution.traction_y[e],
                                            c * solution.pressure[e] - s * solution.traction_y[e],
                                            -solution.traction_x[e]};
            const Vector3 r = {place.x - middle.x, place.y - middle.y, sections.region().along + grid.x(i)};
            add(sum.force, 1, f);
            add(sum.moment, 1, cross(r, f));
          }
      }
    return sum;
  }


  WheelsetForces
  wheelset_forces(const ContactSections   &sections,
                  const PressureMeans     &means,
                  const HalfspaceSolution &solution)
  {
    std::vector<RowOfElements> rows;
    for (int j = 0; j < solution.grid.my; ++j)
      rows.push_back({sections.rail_place(solution.grid.y(j)), means.rail_angle});
    return wheelset_forces(sections, rows, solution);
  }


  ContactReference
  reference_at(const ContactSections   &sections,
               const ReferencePoint    &point,
               const WheelsetForces    &forces,
               const WheelMotion       &motion,
               const HalfspaceSolution &solution)
  {
    const ContactGeometry &geometry = sections.geometry();
    const Vector3         &axle     = geometry.axis.direction;
    const double           level    = std::hypot(axle[0], axle[2]);
    ContactReference       reference;
    reference.place = point.place;
    reference.along = sections.region().along + point.x;
    reference.ahead =
      (reference.along * axle[0] - (reference.place.x - geometry.axis.middle.x) * axle[2]) / level;
    reference.angle  = -point.angle;
    reference.radius = point.slice.radius;

    const RigidSlip slip       = rigid_slip(point.slice, motion, solution.xi);
    const double    creepage   = solution.xi + slip.along;
    reference.speed            = 1 + 0.5 * creepage;
    reference.creepage         = creepage / reference.speed;
    reference.lateral_creepage = -slip.lateral / reference.speed;
    reference.spin =
      (motion.one_spin && !std::isnan(motion.spin) ? motion.spin
                                                   : wheel_spin(point.slice, motion, solution.xi)) /
      reference.speed;
    reference.spin_moment = solution.spin_moment - point.x * solution.fy + point.y * solution.fx;

    reference.traction   = -solution.fy;
    reference.driving    = (forces.force[2] * axle[0] - forces.force[0] * axle[2]) / level;
    reference.across     = (forces.force[0] * axle[0] + forces.force[2] * axle[2]) / level;
    reference.torque     = -dot(forces.moment, axle);
    reference.yaw_moment = forces.moment[1];
    return reference;
  }


  ContactReference
  contact_reference(const ContactSections   &sections,
                    const PressureMeans     &means,
                    const WheelMotion       &motion,
                    const HalfspaceSolution &solution)
  {
    const HalfspaceGrid &grid = solution.grid;
    double               sum = 0, s = 0, x = 0, angle = 0, wheel_angle = 0;
    for (int j = 0; j < grid.my; ++j)
      {
        const double                 here  = std::clamp(grid.y(j), sections.s_min(), sections.s_max());
        const ContactSections::Slice slice = sections.slice(here);
        for (int i = 0; i < grid.mx && here == grid.y(j); ++i)
          {
            const double overlap = std::max(0., solution.approach - sections.distance(here, grid.x(i))),
                         weight  = overlap * overlap;
            sum += weight;
            s += weight * here;
            x += weight * grid.x(i);
            angle += weight * slice.rail_angle;
            wheel_angle += weight * slice.wheel_angle;
          }
      }
    s /= sum;
    x /= sum;
    ReferencePoint point{x, s, sections.rail_place(s), angle / sum, sections.slice(s)};
    point.slice.wheel_angle = wheel_angle / sum; // the plane of the patch is that of its mean angle
    return reference_at(sections, point, wheelset_forces(sections, means, solution), motion, solution);
  }


  void
  set_reference_figures(const ContactReference &at, const bool determined, Summary &summary)
  {
    const double of_motion = determined ? 1 : Summary::none;
    set_figure(summary, "reference_ahead_of_axle_m", at.ahead);
    set_figure(summary, "reference_angle_rad", at.angle);
    set_figure(summary, "reference_creepage", of_motion * at.creepage);
    set_figure(summary, "reference_lateral_creepage", of_motion * at.lateral_creepage);
    set_figure(summary, "reference_spin_per_m", of_motion * at.spin);
  }
} // namespace wheelrail
