#include <wheelrail/halfspace/influence.h>
#include <wheelrail/reference/several_patches.h>

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// Where the surfaces are farthest apart between the point of a region and another place of its frame, or
    /// where the profiles end on the way there.
    double
    border(const ContactSections &sections, const double other)
    {
      const double end  = std::clamp(other, sections.s_min(), sections.s_max()),
                   step = std::copysign(1e-5, end);
      double place = end, largest = 0;
      for (double s = 0; std::abs(s) < std::abs(end); s += step)
        if (const double d = sections.distance(s); d > largest)
          {
            largest = d;
            place   = s;
          }
      return place;
    }

    /// Divides the region from another one, whose point lies at s = other.
    void
    divide(ContactRegion &region, const ContactSections &sections, const double other)
    {
      const double place = border(sections, other);
      if (other > 0)
        region.s_max = std::min(region.s_max, place);
      else
        region.s_min = std::max(region.s_min, place);
    }

    /// Whether elements at s carry pressure.
    bool
    presses_at(const HalfspaceSolution &solution, const double s)
    {
      const HalfspaceGrid &grid = solution.grid;
      const auto           j    = std::lround((s - grid.y0) / grid.dy);
      if (j < 0 || j >= grid.my)
        return false;
      const auto row = solution.pressure.begin() + j * grid.mx;
      return std::any_of(row, row + grid.mx, [](const double p) { return p > 0; });
    }

    double
    squared(const double x)
    {
      return x * x;
    }

    /// The contacts of a wheel that share its position and its load.
    class SharedLoad
    {
    public:
      SharedLoad(const Scene                      &scene,
                 const SceneGeometry              &geometry,
                 const SectionOffsets             &offsets,
                 const std::vector<ContactRegion> &regions)
        : direction_(geometry.contact.yaw)
      {
        contacts_.reserve(regions.size()); // they refer to each other
        for (const ContactRegion &region : regions)
          contacts_.emplace_back(scene, geometry, offsets, region);
        const HalfspaceProblem &problem = contacts_.front().problem;
        compliance_                     = halfspace_constants(problem.body1, problem.body2).normal;
        for (std::size_t k = 0; k < contacts_.size(); ++k)
          contacts_[k].added_distance = [this, k](const double x, const double s) {
            return pressed_down(k, x, s);
          };
      }

      void
      find(const WheelRailLoad &load, const PlaneContact &one);

      WheelRailSolution
      result() const;

    private:
      /// What the point loads add to the distance of patch k [m].
      double
      pressed_down(std::size_t k, double x, double s) const;

      /// Lowers the wheel [m]; what the normal forces carry vertically, or of a load that is normal to the
      /// planes their sum [N].
      double
      lower(double lowering, bool vertical);

      /// Lowers the wheel until the normal forces carry `force` [N].
      void
      press(double force, bool vertical);

      /// Rolls with a creepage; what is missing of the force that drives [N].
      double
      roll(double creepage, double driving);

      /// Finds the creepage for a force that drives [N]; whether friction carries it.
      bool
      drive(double driving, double tolerance);

      double
      sum(double (PlaneContact::*force)() const) const;

      /// A patch as the others feel it.
      struct PointLoad
      {
        double force = 0; ///< normal [N]
        Point2 place;     ///< in the track plane [m]
      };

      std::vector<PlaneContact> contacts_;
      std::vector<PointLoad>    points_;         ///< from the round before
      double                    direction_;      ///< of the force that drives against the track [rad]
      double                    compliance_ = 0; ///< displacement times distance over force [m2/N]
      double                    lowering_   = 0; ///< of the wheel [m]
      double                    creepage_   = 0;
      bool                      carried_ = true, found_ = true;
    };


    double
    SharedLoad::pressed_down(const std::size_t k, const double x, const double s) const
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
    SharedLoad::lower(const double lowering, const bool vertical)
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
    SharedLoad::press(const double force, const bool vertical)
    {
      constexpr double enough = 2e-5, settled = 5e-4; // of the force
      const auto       missed = [&](const double lowering) {
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
      found_ = false;
    }


    double
    SharedLoad::roll(const double creepage, const double driving)
    {
      creepage_ = creepage;
      for (PlaneContact &contact : contacts_)
        if (contact.solution.fn > 0)
          contact.roll(creepage);
      double along = 0;
      for (const PlaneContact &contact : contacts_)
        along -= contact.solution.fx;
      return along * std::cos(direction_) + sum(&PlaneContact::lateral) * std::sin(direction_) - driving;
    }


    bool
    SharedLoad::drive(const double driving, const double tolerance)
    {
      const auto missed = [&](const double creepage) {
        const double f = roll(creepage, driving);
        return std::abs(f) < tolerance ? 0 : f;
      };
      double low = creepage_, f_low = missed(low), high = low, f_high = f_low;
      for (double step = 1e-4; f_high * f_low > 0; step *= 4)
        {
          low   = high;
          f_low = f_high;
          high  = std::clamp(low - std::copysign(step, f_low), -1., 1.);
          if (high == low)
            return false; // locked, or twice as fast, and still not enough
          f_high = missed(high);
        }
      if (f_high == 0)
        return true;
      if (high < low)
        {
          std::swap(low, high);
          std::swap(f_low, f_high);
        }
      const auto     close = [](const double a, const double b) { return std::abs(b - a) < 1e-10; };
      std::uintmax_t steps = 40;
      const auto range = boost::math::tools::toms748_solve(missed, low, high, f_low, f_high, close, steps);
      found_ = found_ && std::abs(roll(0.5 * (range.first + range.second), driving)) < 10 * tolerance;
      return true;
    }


    double
    SharedLoad::sum(double (PlaneContact::*force)() const) const
    {
      double sum = 0;
      for (const PlaneContact &contact : contacts_)
        if (contact.solution.fn > 0)
          sum += (contact.*force)();
      return sum;
    }


    void
    SharedLoad::find(const WheelRailLoad &load, const PlaneContact &one)
    {
      constexpr double enough = 1e-3, enough_driven = 1e-4; // of the load
      if (load.along_track)
        direction_ = 0;
      lowering_ =
        (one.solution.approach + one.sections.least_distance()) / std::cos(one.sections.region().frame.angle);
      creepage_      = one.solution.within_friction ? one.solution.xi : 0;
      double pressed = load.force, pressed_before = 0, missed = 0, missed_before = 0;
      for (int round = 0; round < 12; ++round)
        {
          press(pressed, load.vertical);
          if (load.rate_held)
            roll(load.creepage, 0);
          else if (load.slides)
            {
              roll(std::copysign(1, load.longitudinal), 0);
              carried_ = false;
            }
          else
            carried_ = drive(load.longitudinal, enough_driven * load.force);
          missed_before = missed;
          missed        = load.vertical ? sum(&PlaneContact::vertical) - load.force : 0;
          if (std::abs(missed) < enough * load.force)
            return;
          const double now = pressed;
          pressed -= round < 1 ? missed : missed * (now - pressed_before) / (missed - missed_before);
          pressed_before = now;
        }
      found_ = false;
    }


    WheelRailSolution
    SharedLoad::result() const
    {
      std::vector<WheelRailSolution> patches;
      for (const PlaneContact &contact : contacts_)
        if (contact.solution.fn > 0)
          {
            patches.push_back(contact.result());
            patches.back().solution.within_friction = carried_;
          }
      WheelRailSolution first = std::move(patches.front());
      first.others.assign(std::make_move_iterator(patches.begin() + 1),
                          std::make_move_iterator(patches.end()));
      if (!found_)
        {
          first.solution.coupling_converged = false;
          first.solution.not_reached += "How the patches share the load was not found. ";
        }
      return first;
    }
  } // namespace


  std::vector<ContactRegion>
  separate_regions(const SceneGeometry  &geometry,
                   const SectionOffsets &offsets,
                   const PlaneContact   &one,
                   const double          least_turn)
  {
    const ContactFrame        &frame = one.sections.region().frame;
    std::vector<ContactRegion> regions{one.sections.region()};
    const double lowering = (one.solution.approach + one.sections.least_distance()) / std::cos(frame.angle);
    for (const FurtherPoint &point : geometry.contact.further)
      {
        const double other = frame.to_frame(point.frame.origin).x;
        if (std::abs(point.frame.angle - frame.angle) < least_turn ||
            presses_at(one.solution, border(one.sections, other)))
          continue;
        ContactRegion region{point.frame, point.along, point.ahead};
        divide(region, ContactSections(geometry, offsets, region), point.frame.to_frame(frame.origin).x);
        const ContactSections there(geometry, offsets, region);
        if (lowering * std::cos(point.frame.angle) > there.least_distance())
          {
            regions.push_back(region);
            divide(regions.front(), one.sections, other);
          }
      }
    // two further points on one side of the first one
    for (std::size_t k = 1; k < regions.size(); ++k)
      for (std::size_t l = 1; l < regions.size(); ++l)
        if (k != l)
          divide(regions[k],
                 ContactSections(geometry, offsets, regions[k]),
                 regions[k].frame.to_frame(regions[l].frame.origin).x);
    return regions;
  }


  WheelRailSolution
  solve_together(const Scene                      &scene,
                 const SceneGeometry              &geometry,
                 const WheelRailLoad              &load,
                 const SectionOffsets             &offsets,
                 const std::vector<ContactRegion> &regions,
                 const PlaneContact               &one)
  {
    SharedLoad shared(scene, geometry, offsets, regions);
    shared.find(load, one);
    return shared.result();
  }


  std::string
  patch_prefix(const std::size_t number)
  {
    return "patch_" + std::to_string(number) + "_";
  }
} // namespace wheelrail
