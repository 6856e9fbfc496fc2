#include <wheelrail/sections/section_contacts.h>

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    constexpr double deepest = 2e-3; ///< places that further lowering of the wheel may close [m]
    constexpr double one     = 4e-3; ///< places nearer than this belong to one patch [m]

    class Contacts
    {
    public:
      Contacts(const std::vector<SectionsSurface> &rails,
               const PosedWheel                   &wheel,
               const SectionRolling               &rolling,
               const double                        at)
        : rails_(rails)
        , wheel_(wheel)
        , rolling_(rolling)
        , at_(at)
      {
        result.touching = touching_places(rails, wheel, at, deepest);
      }

      /// Lays the planes of all places that overlap, and those that nearly do.
      void
      lay(const double height)
      {
        result.patches.clear();
        std::vector<const TouchingPlace *> taken;
        for (const TouchingPlace &place : result.touching)
          {
            const bool near = std::any_of(taken.begin(), taken.end(), [&](const TouchingPlace *other) {
              return other->rail == place.rail && norm(other->place - place.place) < one;
            });
            if (near || place.height <= height)
              continue;
            taken.push_back(&place);
            result.patches.emplace_back(rails_[place.rail], wheel_, rolling_, place, at_, height);
          }
      }

      /// Vertical force of the pressures.
      double
      press(const double height)
      {
        result.height = height;
        double sum    = 0;
        for (SectionPatch &patch : result.patches)
          {
            patch.press(height);
            sum += patch.normal_force() * patch.normal[1];
          }
        return sum;
      }

      void
      roll()
      {
        for (SectionPatch &patch : result.patches)
          if (patch.normal_force() > 0)
            patch.roll();
      }

      /// Lowers the wheel in the planes that there are until the pressures carry a force, from `height` on.
      double
      lower(const double force, double height)
      {
        const double   first = result.touching.front().height;
        const auto     close = [](const double a, const double b) { return std::abs(b - a) < 1e-9; };
        std::uintmax_t steps = 40;
        // depth below the first touch: it is positive, and the force grows with it
        const auto missed = [&](const double depth) {
          const double f = press(first - depth) - force;
          return std::abs(f) < 2e-5 * force ? 0 : f;
        };
        const auto range = boost::math::tools::bracket_and_solve_root(
          missed, std::max(1e-7, first - height), 1.3, true, close, steps);
        height = first - 0.5 * (range.first + range.second);
        press(height);
        return height;
      }

      SectionContacts result;

    private:
      const std::vector<SectionsSurface> &rails_;
      const PosedWheel                   &wheel_;
      const SectionRolling               &rolling_;
      double                              at_;
    };

    void
    leave_out_empty(SectionContacts &contacts)
    {
      contacts.patches.erase(std::remove_if(contacts.patches.begin(),
                                            contacts.patches.end(),
                                            [](const SectionPatch &p) { return !(p.normal_force() > 0); }),
                             contacts.patches.end());
    }
  } // namespace


  Vector3
  SectionContacts::force() const
  {
    Vector3 sum{};
    for (const SectionPatch &patch : patches)
      sum = sum + patch.force();
    return sum;
  }


  SectionContacts
  contacts_under_load(const std::vector<SectionsSurface> &rails,
                      const PosedWheel                   &wheel,
                      const SectionRolling               &rolling,
                      const double                        at,
                      const double                        load)
  {
    constexpr int    most   = 12;
    constexpr double enough = 1e-4, far = 0.02; // of the load; of the approach that the planes are laid for
    Contacts         contacts(rails, wheel, rolling, at);
    const double     first = contacts.result.touching.front().height;
    // the approach of a patch of usual curvatures, for a first guess (Hertz 1882)
    double height = first - 3e-5 * std::pow(load / 1e4, 2. / 3), laid = 0;
    double of_pressures = load; // friction adds to their vertical force, or takes from it
    for (int round = 0; round < most; ++round)
      {
        if (round == 0 || std::abs(height - laid) > far * (first - laid))
          {
            contacts.lay(height);
            laid = height;
          }
        height = contacts.lower(of_pressures, height);
        if (std::abs(height - laid) > far * (first - laid))
          continue; // planes and grids first
        contacts.roll();
        const double carried  = -contacts.result.force()[1];
        contacts.result.found = std::abs(carried - load) < enough * load;
        if (contacts.result.found || !(carried > 0))
          break;
        of_pressures *= load / carried;
      }
    leave_out_empty(contacts.result);
    return contacts.result;
  }
} // namespace wheelrail
