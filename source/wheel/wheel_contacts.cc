#include <wheelrail/halfspace/influence.h>
#include <wheelrail/wheel/contact_reference.h>
#include <wheelrail/wheel/wheel_contacts.h>

#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <iterator>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// Of the grid beyond the expected approach: tractions may widen a contact.
    constexpr double room_to_grow = 1.2;

    double
    squared(const double x)
    {
      return x * x;
    }
  } // namespace


  const std::string patches_not_found = "How the patches share the load was not found. ";


  WheelContacts::WheelContacts(const Scene                      &scene,
                               const SceneGeometry              &geometry,
                               const SectionOffsets             &offsets,
                               const std::vector<ContactRegion> &regions,
                               const PlaneContact               &one)
    : lowering_((one.solution.approach + one.sections.least_distance()) /
                std::cos(one.sections.region().frame.angle))
  {
    contacts_.reserve(regions.size()); // they refer to each other
    for (const ContactRegion &region : regions)
      contacts_.emplace_back(scene, geometry, offsets, region);
    const HalfspaceProblem &problem = contacts_.front().problem;
    compliance_                     = halfspace_constants(problem.body1, problem.body2).normal;
    if (contacts_.size() > 1)
      for (std::size_t k = 0; k < contacts_.size(); ++k)
        contacts_[k].added_distance = [this, k](const double x, const double s) {
          return pressed_down(k, x, s);
        };
  }


  double
  WheelContacts::pressed_down(const std::size_t k, const double x, const double s) const
  {
    const ContactSections &own   = contacts_[k].sections;
    const Point2           place = own.rail_place(s);
    const double           along = own.region().along + x;
    double                 sum   = 0;
    for (std::size_t other = 0; other < points_.size(); ++other)
      if (other != k && points_[other].force > 0)
        {
          const PointLoad       &load   = points_[other];
          const ContactSections &theirs = contacts_[other].sections;
          const double r = std::sqrt(squared(place.x - load.place.x) + squared(place.y - load.place.y) +
                                     squared(along - theirs.region().along));
          sum +=
            compliance_ * load.force * std::cos(own.region().frame.angle - theirs.region().frame.angle) / r;
        }
    return sum;
  }


  double
  WheelContacts::lower(const double lowering, const bool vertical)
  {
    lowering_  = lowering;
    double sum = 0;
    for (PlaneContact &contact : contacts_)
      {
        const double approach =
          lowering * std::cos(contact.sections.region().frame.angle) - contact.sections.least_distance();
        if (approach > 0)
          contact.press_by(approach);
        else
          contact.solution = {};
        sum += contact.solution.fn * (vertical ? std::cos(contact.means.rail_angle) : 1);
      }
    return sum;
  }


  void
  WheelContacts::press(const double force, const bool vertical)
  {
    if (contacts_.size() == 1)
      {
        PlaneContact &only = contacts_.front();
        const double  angle =
          only.solution.fn > 0 ? only.means.rail_angle : only.sections.region().frame.angle;
        only.press(force / (vertical ? std::cos(angle) : 1), room_to_grow);
        return;
      }
    constexpr double enough = 2e-5, settled = 5e-4; // of the force
    pressed_          = true;
    const auto missed = [&](const double lowering) {
      const double f = lower(lowering, vertical) - force;
      return std::abs(f) < enough * force ? 0 : f;
    };
    const auto close = [](const double a, const double b) { return std::abs(b - a) < 1e-7 * std::abs(a); };
    for (int round = 0; round < 20; ++round)
      {
        std::uintmax_t steps = 40;
        const auto     range =
          boost::math::tools::bracket_and_solve_root(missed, lowering_, 1.2, true, close, steps);
        lower(0.5 * (range.first + range.second), vertical);
        double change = 0;
        points_.resize(contacts_.size());
        for (std::size_t k = 0; k < contacts_.size(); ++k)
          {
            const PlaneContact &contact = contacts_[k];
            change += std::abs(contact.solution.fn - points_[k].force);
            points_[k] = {contact.solution.fn, contact.sections.rail_place(contact.means.s)};
          }
        if (change < settled * force)
          return;
      }
    pressed_ = false;
  }


  void
  WheelContacts::roll(const double creepage)
  {
    for (PlaneContact &contact : contacts_)
      if (contact.solution.fn > 0)
        contact.roll(creepage);
  }


  double
  WheelContacts::sum(const std::function<double(const PlaneContact &)> &of) const
  {
    double sum = 0;
    for (const PlaneContact &contact : contacts_)
      if (contact.solution.fn > 0)
        sum += of(contact);
    return sum;
  }


  double
  WheelContacts::lateral() const
  {
    return sum(&PlaneContact::lateral);
  }


  double
  WheelContacts::vertical() const
  {
    return sum(&PlaneContact::vertical);
  }


  double
  WheelContacts::driving(const double direction) const
  {
    return -sum([](const PlaneContact &contact) { return contact.solution.fx; }) * std::cos(direction) +
           lateral() * std::sin(direction);
  }


  double
  WheelContacts::torque() const
  {
    return sum([](const PlaneContact &contact) {
      const WheelsetForces on_wheelset = wheelset_forces(contact.sections, contact.means, contact.solution);
      return -dot(on_wheelset.moment, contact.sections.geometry().axis.direction);
    });
  }


  WheelRailSolution
  WheelContacts::result(const bool carried, const std::string &not_found) const
  {
    std::vector<WheelRailSolution> patches;
    for (const PlaneContact &contact : contacts_)
      if (contact.solution.fn > 0)
        {
          patches.push_back(contact.result());
          patches.back().solution.within_friction = carried;
        }
    WheelRailSolution first = std::move(patches.front());
    first.others.assign(std::make_move_iterator(patches.begin() + 1), std::make_move_iterator(patches.end()));
    if (!pressed_ || !not_found.empty())
      {
        first.solution.coupling_converged = false;
        first.solution.not_reached += not_found.empty() ? patches_not_found : not_found;
      }
    return first;
  }
} // namespace wheelrail
