#include <wheelrail/wheel/load_search.h>
#include <wheelrail/wheel/several_patches.h>
#include <wheelrail/wheel/wheel_contacts.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Where the surfaces are farthest apart between the point of a region and another place of its frame, or
    /// where the profiles end before.
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
    constexpr double enough_driven = 1e-4; // of the load
    const double     direction     = load.along_track ? 0 : geometry.contact.yaw;
    WheelContacts    wheel(scene, geometry, offsets, regions, one);
    LoadSearch       search(load.force);
    double           creepage = one.solution.within_friction ? one.solution.xi : 0;
    const auto       missed   = [&](const double at) {
      wheel.roll(at);
      const double f = wheel.driving(direction) - load.longitudinal;
      return std::abs(f) < enough_driven * load.force ? 0 : f;
    };
    bool carried = true, driven = true;
    for (int round = 0; round < 12; ++round)
      {
        wheel.press(search.pressed(), load.vertical);
        if (load.rate_held)
          wheel.roll(load.creepage);
        else if (load.slides)
          {
            wheel.roll(std::copysign(1, load.longitudinal));
            carried = false;
          }
        else
          {
            const CreepageFound found = find_creepage(missed, creepage);
            creepage                  = found.creepage;
            carried                   = found.carried;
            wheel.roll(creepage);
            driven = !carried ||
                     std::abs(wheel.driving(direction) - load.longitudinal) < 10 * enough_driven * load.force;
          }
        if (!load.vertical || search.carried(wheel.vertical()))
          return wheel.result(carried, driven ? "" : patches_not_found);
      }
    return wheel.result(carried, patches_not_found);
  }


  std::string
  patch_prefix(const std::size_t number)
  {
    return "patch_" + std::to_string(number) + "_";
  }
} // namespace wheelrail
