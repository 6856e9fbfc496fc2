#include <wheelrail/reference/contact_reference.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  WheelsetForces
  wheelset_forces(const ContactSections   &sections,
                  const PressureMeans     &means,
                  const HalfspaceSolution &solution)
  {
    const HalfspaceGrid &grid = solution.grid;
    const double         c = std::cos(means.rail_angle), s = std::sin(means.rail_angle);
    const Point2        &middle = sections.geometry().axis.middle;
    WheelsetForces       sum;
    for (int j = 0; j < grid.my; ++j)
      {
        const Point2 place = sections.rail_place(grid.y(j));
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


  ContactReference
  contact_reference(const ContactSections   &sections,
                    const PressureMeans     &means,
                    const WheelMotion       &motion,
                    const HalfspaceSolution &solution)
  {
    const HalfspaceGrid   &grid     = solution.grid;
    const ContactGeometry &geometry = sections.geometry();
    ContactReference       reference;
    double                 sum = 0, s = 0, x = 0, angle = 0, wheel_angle = 0;
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
    ContactSections::Slice slice = sections.slice(s);
    slice.wheel_angle            = wheel_angle / sum; // the plane of the patch is that of its mean angle
    const Vector3 &axle          = geometry.axis.direction;
    const double   level         = std::hypot(axle[0], axle[2]);
    reference.place              = sections.rail_place(s);
    reference.along              = sections.region().along + x;
    reference.ahead =
      (reference.along * axle[0] - (reference.place.x - geometry.axis.middle.x) * axle[2]) / level;
    reference.angle = -angle / sum;

    const RigidSlip slip       = rigid_slip(sections, slice, motion, solution.xi);
    const double    creepage   = solution.xi + slip.along;
    reference.speed            = 1 + 0.5 * creepage;
    reference.creepage         = creepage / reference.speed;
    reference.lateral_creepage = -slip.lateral / reference.speed;
    reference.spin =
      (motion.one_spin && !std::isnan(motion.spin) ? motion.spin
                                                   : wheel_spin(sections, slice, motion, solution.xi)) /
      reference.speed;
    reference.spin_moment = solution.spin_moment - x * solution.fy + s * solution.fx;

    const auto [force, moment] = wheelset_forces(sections, means, solution);
    reference.traction         = -solution.fy;
    reference.driving          = (force[2] * axle[0] - force[0] * axle[2]) / level;
    reference.across           = (force[0] * axle[0] + force[2] * axle[2]) / level;
    reference.torque           = -dot(moment, axle);
    reference.yaw_moment       = moment[1];
    return reference;
  }
} // namespace wheelrail
