#include <wheelrail/base/errors.h>
#include <wheelrail/base/parallel.h>
#include <wheelrail/base/progress.h>
#include <wheelrail/base/value_list.h>
#include <wheelrail/wheel/irregular_places.h>
#include <wheelrail/wheel/noise_effect.h>
#include <wheelrail/wheel/plane_contact.h>

#include <cmath>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// Areas of elements with pressure that share an edge or a corner.
    int
    count_patches(const HalfspaceSolution &solution)
    {
      const HalfspaceGrid             &grid = solution.grid;
      std::vector<bool>                seen(grid.size(), false);
      std::vector<std::pair<int, int>> open;
      int                              patches = 0;
      const auto                       visit   = [&](const int i, const int j) {
        if (i < 0 || j < 0 || i >= grid.mx || j >= grid.my)
          return false;
        const std::size_t e = i + std::size_t(grid.mx) * j;
        if (seen[e] || !(solution.pressure[e] > 0))
          return false;
        seen[e] = true;
        open.push_back({i, j});
        return true;
      };
      for (int j = 0; j < grid.my; ++j)
        for (int i = 0; i < grid.mx; ++i)
          {
            if (!visit(i, j))
              continue;
            ++patches;
            while (!open.empty())
              {
                const auto [a, b] = open.back();
                open.pop_back();
                for (int da = -1; da <= 1; ++da)
                  for (int db = -1; db <= 1; ++db)
                    visit(a + da, b + db);
              }
          }
      return patches;
    }

    /// Presses the wheel down until the vertical force of the pressure is the load.
    void
    press_down(PlaneContact &contact, const double load)
    {
      double angle = contact.sections.region().frame.angle;
      for (int round = 0; round < 3; ++round)
        {
          contact.press(load / std::cos(angle));
          if (std::abs(contact.means.rail_angle - angle) < 1e-5)
            break;
          angle = contact.means.rail_angle;
        }
    }

    PlaceContact
    solve_place(const Scene         &scene,
                const SceneGeometry &geometry,
                const double         load,
                const NoiseEffect   &of_profiles)
    {
      PlaceContact result;
      PlaneContact contact(scene, geometry, scene_offsets(scene), whole_region(geometry.contact));
      press_down(contact, load);
      const HalfspaceSolution &solution = contact.solution;
      const HalfspaceGrid     &grid     = solution.grid;
      WheelRailSolution        whole    = contact.result();
      name_made_up(geometry, whole);
      whole.noise_effect =
        draws_irregularities(geometry) ? noise_effect(scene, geometry, solution.fn) : of_profiles;
      result.verdict        = judge_patch(scene, whole);
      result.patch          = whole.patch;
      result.peak_pressure  = solution.peak_pressure;
      result.width          = whole.measures.width;
      result.length         = whole.measures.length;
      result.centre_along   = whole.measures.centre_of_pressure_along;
      result.centre_lateral = whole.measures.centre_of_pressure_lateral;
      result.approach       = solution.approach;
      result.drop           = solution.approach + contact.sections.least_distance();
      result.normal_force   = solution.fn;
      result.area           = solution.contact_elements * grid.element_area();
      result.patches        = count_patches(solution);
      for (int j = 0; j < grid.my; ++j)
        for (int i = 0; i < grid.mx; ++i)
          if (const double p = solution.pressure[i + std::size_t(grid.mx) * j]; p > 0)
            result.slope_force -=
              p * grid.element_area() * contact.sections.rail_slope_along(grid.y(j), grid.x(i));
      if (solution.touches_grid_edge)
        result.fault = "the contact reaches the edge of the grid";
      return result;
    }
  } // namespace


  IrregularPlaces
  parse_irregular_places(const std::string &text, const bool pitch)
  {
    const std::string option = pitch ? "--pitch" : "--places";
    const auto        fail   = [&](const std::string &why) {
      throw InputError(
        option + " \"" + text + "\": " + why + "; write first:last:step or values with commas, and " +
        (pitch ? "deg, mrad or rad, such as \"-7:0:1 deg\"" : "mm or m, such as \"0:100:5 mm\""));
    };
    const std::size_t end = text.find_last_not_of(' ');
    const std::size_t word =
      end == std::string::npos ? end : text.find_last_not_of("abcdefghijklmnopqrstuvwxyz", end);
    if (word == std::string::npos || word == end)
      fail("the unit is missing");
    const std::string unit   = text.substr(word + 1, end - word);
    double            factor = 0;
    for (const auto &[name, value] :
         pitch ? std::vector<std::pair<std::string, double>>{{"deg", M_PI / 180}, {"mrad", 1e-3}, {"rad", 1.}}
               : std::vector<std::pair<std::string, double>>{{"mm", 1e-3}, {"m", 1.}})
      if (unit == name)
        factor = value;
    if (factor == 0)
      fail("the unit " + unit + " is unknown");
    const ValueList list = parse_value_list(text.substr(0, word + 1), 2000);
    if (!list.fault.empty())
      fail(list.fault);
    IrregularPlaces places{pitch, {}};
    for (const double value : list.values)
      places.values.push_back(factor * value);
    return places;
  }


  std::vector<PlaceContact>
  solve_places(const Scene           &scene,
               const SceneGeometry   &geometry,
               const double           load,
               const IrregularPlaces &places,
               TaskCount             *count)
  {
    SceneGeometry smooth = geometry;
    smooth.surfaces.rail.set_irregularities(nullptr);
    smooth.surfaces.wheel.set_irregularities(nullptr);
    const NoiseEffect         noise = noise_effect(scene, smooth, load); // holds for all places
    const double              level = solve_place(scene, smooth, load, noise).drop;
    std::vector<PlaceContact> results(places.values.size());
    parallel_for(results.size(), [&](const std::size_t k) {
      const double value = places.values[k], place = places.pitch ? 0 : value,
                   pitch = places.pitch ? value : -value / geometry.contact.rolling_radius;
      results[k]         = solve_place(scene, standing(geometry, place, pitch), load, noise);
      results[k].place   = place;
      results[k].pitch   = pitch;
      results[k].drop -= level;
      if (count)
        count->one_more();
    });
    return results;
  }
} // namespace wheelrail
