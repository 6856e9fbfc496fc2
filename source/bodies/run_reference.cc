#include <wheelrail/bodies/answering_bodies.h>
#include <wheelrail/bodies/run_reference.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/output/figures.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

// A run against half-spaces and true bodies under its own load (doc/theory/accuracy.md): relative
// differences, run over reference, less 1.

namespace wheelrail
{
  void
  measure_against(const HalfspacePressure &halfspace,
                  const Scene             &scene,
                  const Summary           &run,
                  Measures                &measures)
  {
    // run over half-spaces, less 1: negative where cells lose of the peak
    measures.peak_difference = run.max_pressure / halfspace.peak - 1;
    // the penetration of the penalty layer under the peak, p/eps with eps = f K/h (doc/theory/contact.md,
    // Pressure), over the approach; K is the mean of both bodies, as in make_law()
    measures.penetration = run.max_pressure * scene.cell_size /
                           (scene.penalty_scale * mean_bulk_modulus(scene)) / halfspace.approach;
    // half-spaces are no reference where the surface turns across the patch, or where they have other patches
    measures.turn = halfspace.turn;
    if (const double patches = get_figure(run, "patches"); patches > 1 && patches != halfspace.patches)
      // separate ones of the run where half-spaces have another number
      measures.patches = patches;
  }


  bool
  force_is_a_result(const Scene &scene)
  {
    return scene.drive == Drive::rate && scene.motion == "none" && !scene.irregular();
  }


  namespace
  {
    /// What true bodies carry farther beside the patch of a run than its solution cells are sure to reach.
    void
    measure_beside(const MeshSettings      &scene,
                   const Summary           &run,
                   const HalfspaceSolution &bodies,
                   Measures                &measures)
    {
      // a second patch that true bodies have beside the first, where the run's fine cells end
      const HalfspaceGrid &grid   = bodies.grid;
      const double         half   = 0.5 * run.patch_lateral;
      double               beside = 0, all = 0, farthest = 0;
      for (int e = 0; e < grid.size(); ++e)
        {
          // beyond the edge of the run's patch [m]
          const double off = std::abs(grid.y(e / grid.mx) - run.patch_centre_lateral) - half;
          all += bodies.pressure[e];
          if (off < scene.fine_margin || !(bodies.pressure[e] > 0))
            continue;
          beside += bodies.pressure[e];
          farthest = std::max(farthest, off);
        }
      measures.beside = beside / all;
      // in whole millimetres, one more than needed
      measures.margin = 1e-3 * std::ceil(1e3 * farthest + 1);
    }
  } // namespace


  Contributions
  measure_against_bodies(const Scene         &scene,
                         const SceneGeometry &geometry,
                         const Summary       &run,
                         Measures            &measures)
  {
    // true bodies roll steadily, on smooth surfaces
    if (scene.motion != "none" || scene.irregular() || measures.off_rail())
      return {};
    // each slice rolls with its own radius, as it does in a run
    Scene bodies            = scene;
    bodies.halfspace_bodies = ContactBodies::real;
    bodies.halfspace_spin   = HalfspaceSpin::local_radius;
    WheelRailLoad load      = load_of_run(run);
    // the same question: the creepage is given, and the force is compared
    if (force_is_a_result(scene))
      {
        load.rate_held = true;
        load.creepage  = run.creepage;
      }
    Contributions contributions;
    fault_of([&]() {
      const std::optional<WheelRailSolution> real = solve_true_bodies(bodies, geometry, load);
      // no answer, no contribution: intervals come from elsewhere
      if (!real)
        return;
      const Summary reference = halfspace_summary(bodies, *real, &contributions);
      measure_beside(scene, run, real->solution, measures);
      // run over true bodies, less 1, under the run's own load
      measures.bodies_difference = run.max_pressure / reference.max_pressure - 1;
      if (force_is_a_result(scene))
        measures.force_difference =
          (run.longitudinal_force - reference.longitudinal_force) / run.vertical_force;
      const auto            of_elements = std::exchange(contributions, {});
      std::set<std::string> compared; // each result once, whatever elements have to say of it
      for (const Contribution &one : of_elements)
        // s of (1): true bodies less run; their elements give the spread
        if (const std::string key = figure_named(one.result).key(); std::isfinite(get_figure(run, key)))
          {
            contributions.push_back(one);
            if (compared.insert(one.result).second)
              contributions.push_back({one.result,
                                       "cells and penalty layer",
                                       get_figure(reference, key) - get_figure(run, key),
                                       0});
          }
    });
    return measures.plastic_strain > 0 ? Contributions() : contributions; // they do not yield
  }


  WheelRailLoad
  load_of_run(const Summary &run)
  {
    WheelRailLoad load;
    // means over the averaging distance, not the static load
    load.force        = run.vertical_force;
    load.vertical     = true;
    load.longitudinal = run.longitudinal_force;
    // forces of a run are along the track, not along a wheelset with yaw
    load.along_track = true;
    // a force at its bound says no more of the creepage; one that slides sideways, by its direction
    load.slides = run.stick_fraction < 1e-3 && std::abs(run.longitudinal_force) > 1e-3 * run.vertical_force &&
                  !std::isfinite(get_figure(run, "yaw_rad"));
    return load;
  }


  SectionOffsets
  offsets_of_run(const Summary &run)
  {
    const auto value = [&](const char *key) {
      const double figure = get_figure(run, key);
      return std::isfinite(figure) ? figure : 0;
    };
    // half-spaces of `compare` lie where the run's head and rim have moved to
    return {value("relative_lateral_m"), value("rail_head_roll_rad"), value("wheel_rim_roll_rad")};
  }
} // namespace wheelrail
