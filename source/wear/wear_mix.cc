#include <wheelrail/base/errors.h>
#include <wheelrail/base/parallel.h>
#include <wheelrail/bodies/shift_effect.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/wear/wear_mix.h>
#include <wheelrail/wheel/halfspace_parts.h>
#include <wheelrail/wheel/noise_effect.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace wheelrail
{
  namespace
  {
    /// A shape with its arc lengths, and what it loses.
    struct WearingSurface
    {
      WearingSurface(const WornShape     &of,
                     std::vector<double> &sections_taken,
                     std::vector<double> &damage_added,
                     std::vector<double> &cracks_added)
        : shape(of)
        , arc(arc_of(of.points))
        , cells(cell_lengths(arc))
        , sections(sections_taken)
        , damage(damage_added)
        , cracks(cracks_added)
      {
        sections.assign(arc.size(), 0);
        damage.assign(arc.size(), 0);
        cracks.assign(arc.size(), 0);
      }

      const WornShape          &shape;
      const std::vector<double> arc, cells;
      std::vector<double>      &sections, &damage, &cracks;
    };

    /// Adds what a patch does to a body that stands at `placement`: depths `worn`, `damage` and `cracks`, as
    /// much as all passages have in the mean of it. Returns whether it lies on the end of the shape.
    bool
    add_patch(const WheelRailSolution   &patch,
              const std::vector<double> &worn,
              const double               damage,
              const double               cracks,
              const Placement           &placement,
              WearingSurface            &surface)
    {
      const auto path_at = [&](const Point2 &track) {
        return arc_next_to(surface.shape.points, surface.arc, placement.to_section(track));
      };
      double low = surface.arc.back(), high = 0;
      for (std::size_t j = 0; j < worn.size(); ++j)
        {
          bool pressed = false;
          for (std::size_t i = 0; i < patch.patch.n_along && !pressed; ++i)
            pressed = patch.patch.pressure[j + patch.patch.n_lateral * i] > 0;
          if (!pressed)
            continue;
          const double from = path_at(patch.row_edges[j]), to = path_at(patch.row_edges[j + 1]);
          low  = std::min({low, from, to});
          high = std::max({high, from, to});
          if (worn[j] > 0)
            spread_section(surface.cells, from, to, worn[j] * patch.solution.grid.dy, surface.sections);
        }
      for (std::size_t k = 0; k < surface.arc.size(); ++k)
        if (surface.arc[k] >= low && surface.arc[k] <= high)
          {
            surface.damage[k] += damage;
            surface.cracks[k] += cracks;
          }
      return low == 0 || high == surface.arc.back();
    }

    /// A wheel as it was solved.
    struct Solved
    {
      std::optional<WheelRailSolution> solution;
      SceneGeometry                    geometry;
      Scene                            scene;
      double                           share = 0;
    };

    /// A wheel that locks wears at one place, one that spins up as fast as it likes: neither is traffic.
    void
    require_rolling(const std::vector<Solved> &wheels)
    {
      for (const Solved &wheel : wheels)
        if (wheel.solution && !wheel.solution->solution.within_friction &&
            !wheel.solution->problem.friction.frictionless())
          throw InputError(
            "friction does not carry the traction, so that the wheel locks or spins up; take less traction, "
            "or "
            "give the creepage of a wheel that slides");
    }

    std::vector<Solved>
    solve_row(const MixRow &row, const SceneProfiles &profiles)
    {
      std::vector<Solved> wheels;
      if (row.scene.both_wheels)
        {
          const WheelsetSolution wheelset =
            solve_wheelset(row.scene, row.left, {profiles, profiles}, std::nullopt);
          wheels = {{wheelset.axle.right, wheelset.right.geometry, wheelset.right.scene, 0.5 * row.share},
                    {wheelset.axle.left, wheelset.left.geometry, wheelset.left.scene, 0.5 * row.share}};
        }
      else
        {
          const SceneGeometry geometry = make_geometry(row.scene, profiles);
          wheels = {{solve_alone({row.scene, geometry, row.scene.wheel_load}, std::nullopt),
                     geometry,
                     row.scene,
                     row.share}};
        }
      for (Solved &wheel : wheels)
        if (wheel.solution)
          find_noise_effect(wheel.scene, wheel.geometry, *wheel.solution);
      return wheels;
    }

    void
    add_wheel(const Solved &wheel, WearingSurface &rail, WearingSurface &tread, MixWear &sum)
    {
      std::vector<const WheelRailSolution *> patches = {&*wheel.solution};
      for (const WheelRailSolution &other : wheel.solution->others)
        patches.push_back(&other);
      double t_gamma = 0, peak = 0;
      for (const WheelRailSolution *patch : patches)
        {
          const double work   = wear_number(patch->problem, patch->solution);
          const double damage = wheel.share * burstow_damage(work, wheel.scene.wear),
                       cracks = wheel.share * crack_growth(work, wheel.scene.wear);
          std::vector<double> depth =
            halfspace_wear(patch->problem, patch->solution, wheel.scene.velocity, wheel.scene.wear).depth;
          for (double &d : depth)
            d *= wheel.share;
          const bool on_rail  = add_patch(*patch, depth, damage, cracks, wheel.geometry.contact.rail, rail),
                     on_tread = add_patch(*patch, depth, damage, cracks, wheel.geometry.contact.wheel, tread);
          sum.at_end          = sum.at_end || on_rail || on_tread;
          t_gamma += work;
          peak = std::max(peak, patch->solution.peak_pressure);
        }
      sum.mean_pressure += wheel.share * peak;
      sum.peak_pressure = std::max(sum.peak_pressure, peak);
      sum.mean_t_gamma += wheel.share * t_gamma;
      sum.peak_t_gamma = std::max(sum.peak_t_gamma, t_gamma);
    }

    void
    add_range(const double low, const double high, MixWear &sum)
    {
      sum.bodies_low  = std::fmin(sum.bodies_low, low);
      sum.bodies_high = std::fmax(sum.bodies_high, high);
    }

    /// Adds the interval of a row to that of the mean: rows err to the same side.
    void
    add_interval(const Interval &row, const double share, Interval &mean)
    {
      mean.low += share * row.low;
      mean.high += share * row.high;
    }

    /// Judges a wheel, and keeps what is off where it is the worst so far, and how well it is known.
    void
    add_verdict(Solved &wheel, const std::string &row, const bool held, MixWear &sum)
    {
      if (held)
        hold_against_bodies(wheel.scene, wheel.geometry, *wheel.solution);
      else
        find_shift_effect(wheel.scene, wheel.geometry, *wheel.solution);
      add_range(wheel.solution->bodies_effect, wheel.solution->bodies_effect, sum);
      const Summary judged = halfspace_summary(wheel.scene, *wheel.solution);
      const auto    within = [&](const char *low, const char *high) {
        return Interval{get_figure(judged, low), get_figure(judged, high)};
      };
      add_interval(within("max_pressure_low_Pa", "max_pressure_high_Pa"), wheel.share, sum.pressure_within);
      add_interval(within("t_gamma_low_N", "t_gamma_high_N"), wheel.share, sum.t_gamma_within);
      const std::string &unreached = wheel.solution->solution.not_reached;
      const Grade        grade     = unreached.empty() ? grade_of(judged) : Grade::not_trusted;
      if (grade == Grade::trusted)
        return;
      const bool worst = sum.doubts.empty() || (grade == Grade::not_trusted && sum.not_trusted == 0);
      (grade == Grade::not_trusted ? sum.not_trusted : sum.with_care) += wheel.share;
      if (worst)
        sum.doubts =
          row + ": " + judged.doubts + (unreached.empty() || judged.doubts.empty() ? "" : " ") + unreached;
    }

    MixWear
    empty_wear(const WornShape &rail, const WornShape &wheel)
    {
      const std::vector<double> of_rail(rail.points.size(), 0), of_wheel(wheel.points.size(), 0);
      MixWear                   wear;
      wear.rail_section = wear.rail_damage = wear.rail_cracks = of_rail;
      wear.wheel_section = wear.wheel_damage = wear.wheel_cracks = of_wheel;
      return wear;
    }

    /// What one row does; with a fault where it cannot be solved, so that all processes of a team learn it.
    MixWear
    wear_of_row(const MixRow        &row,
                const SceneProfiles &profiles,
                const WornShape     &rail,
                const WornShape     &wheel,
                const bool           held)
    {
      MixWear        wear = empty_wear(rail, wheel);
      WearingSurface on_rail(rail, wear.rail_section, wear.rail_damage, wear.rail_cracks),
        on_tread(wheel, wear.wheel_section, wear.wheel_damage, wear.wheel_cracks);
      try
        {
          std::vector<Solved> wheels = solve_row(row, profiles);
          require_rolling(wheels);
          for (Solved &one : wheels)
            {
              wear.axle_load += 2 * one.share * one.scene.wheel_load;
              if (!one.solution)
                continue;
              add_wheel(one, on_rail, on_tread, wear);
              add_verdict(one, row.name, held, wear);
            }
        }
      catch (const InputError &error)
        {
          wear.fault = row.name + ": " + error.what();
        }
      return wear;
    }

    void
    add_row(const MixWear &row, MixWear &sum)
    {
      const auto each = [](const std::vector<double> &from, std::vector<double> &to) {
        for (std::size_t k = 0; k < to.size(); ++k)
          to[k] += from[k];
      };
      each(row.rail_section, sum.rail_section);
      each(row.wheel_section, sum.wheel_section);
      each(row.rail_damage, sum.rail_damage);
      each(row.wheel_damage, sum.wheel_damage);
      each(row.rail_cracks, sum.rail_cracks);
      each(row.wheel_cracks, sum.wheel_cracks);
      sum.mean_pressure += row.mean_pressure;
      sum.peak_pressure = std::max(sum.peak_pressure, row.peak_pressure);
      sum.mean_t_gamma += row.mean_t_gamma;
      sum.peak_t_gamma = std::max(sum.peak_t_gamma, row.peak_t_gamma);
      add_interval(row.pressure_within, 1, sum.pressure_within);
      add_interval(row.t_gamma_within, 1, sum.t_gamma_within);
      sum.axle_load += row.axle_load;
      sum.at_end = sum.at_end || row.at_end;
      if (sum.doubts.empty() || (sum.not_trusted == 0 && row.not_trusted > 0))
        sum.doubts = row.doubts;
      add_range(row.bodies_low, row.bodies_high, sum);
      sum.with_care += row.with_care;
      sum.not_trusted += row.not_trusted;
    }
  } // namespace


  std::vector<MixRow>
  mix_rows(const Scene &scene, const double wheel_load, double &weights)
  {
    Scene base        = scene;
    base.wheel_load   = wheel_load;
    weights           = 1;
    const Scene right = wheel_of_wheelset(base, false), left = wheel_of_wheelset(base, true);
    if (scene.wear_plan.mix == "none")
      return {{scene.both_wheels || !scene.left_wheel ? right : left, left, 1, "the scene"}};
    const MotionFile  table   = read_mix_file(scene.wear_plan.mix);
    const auto *const given   = table.find(MotionQuantity::weight);
    const auto        free_if = [&](Scene at) {
      if (!has_drive(table))
        {
          at.drive                = Drive::torque;
          at.traction_coefficient = at.creepage = 0;
        }
      return at;
    };
    std::vector<MixRow> rows;
    weights = 0;
    for (std::size_t k = 0; k < table.rows(); ++k)
      {
        const double weight = given ? (*given)[k] : 1;
        weights += weight;
        if (weight == 0)
          continue;
        const Scene on_right = scene_at(free_if(right), of_wheel(table, false), k),
                    on_left  = scene_at(free_if(left), of_wheel(table, true), k);
        rows.push_back({scene.both_wheels || !scene.left_wheel ? on_right : on_left,
                        on_left,
                        weight,
                        "Wear/Mix = " + scene.wear_plan.mix + ", row " + std::to_string(k + 1)});
      }
    for (MixRow &row : rows)
      row.share /= weights;
    weights = given ? weights : 1;
    return rows;
  }


  MixWear
  wear_of_mix(const std::vector<MixRow> &rows,
              const SceneProfiles       &profiles,
              const WornShape           &rail,
              const WornShape           &wheel,
              const RowTeam             &team,
              const bool                 held)
  {
    std::vector<MixWear> of_rows(rows.size());
    const std::size_t    own = rows.size() / team.size + (team.rank < rows.size() % team.size ? 1 : 0);
    parallel_for(
      own,
      [&](const std::size_t k) {
        const std::size_t row = team.rank + k * team.size;
        of_rows[row]          = wear_of_row(rows[row], profiles, rail, wheel, held);
      },
      team.size > 1 ? processors_of_process() : 0);
    if (team.share)
      team.share(of_rows);
    MixWear sum = empty_wear(rail, wheel);
    for (const MixWear &row : of_rows)
      {
        if (!row.fault.empty())
          throw InputError(row.fault);
        add_row(row, sum);
      }
    return sum;
  }
} // namespace wheelrail
