#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/bodies/answering_bodies.h>
#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/output/figures.h>

#include <cmath>
#include <utility>

// Which model answers: true bodies where they have a solution, half-spaces else, each with the other beside
// it (doc/theory/bodies.md, Where half-spaces hold).

namespace wheelrail
{
  std::string
  fault_of(const std::function<void()> &solve)
  {
    try
      {
        solve();
      }
    // refusals are answers, given as a reason; all other exceptions are faults of the program and go on
    catch (const RunError &error)
      {
        return error.what();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }


  std::string
  solve_with_bodies(Scene &scene, const std::function<void()> &solve)
  {
    std::string note;
    if (scene.halfspace_bodies == ContactBodies::automatic)
      {
        scene.halfspace_bodies = ContactBodies::real;
        // 1. True bodies; why not, where they refuse (poses by hand, contact beside the tables)
        const std::string why = fault_of(solve);
        if (why.empty())
          return "";
        scene.halfspace_bodies =
          ContactBodies::half_spaces; // what these do not take either they say themselves
        note = "By half-spaces, since true bodies have no answer: " + why;
      }
    // 2. Half-spaces
    solve();
    return note;
  }


  std::optional<WheelRailSolution>
  solve_true_bodies(Scene scene, const SceneGeometry &geometry, const WheelRailLoad &load)
  {
    // no offsets: the bodies' own motion takes their place
    scene.halfspace_bodies    = ContactBodies::real;
    WheelRailSolution contact = solve_wheel_rail(scene, geometry, load, {});
    // a solution that did not reach its tolerance is no reference
    if (!contact.solution.converged() || contact.solution.touches_grid_edge)
      return {};
    return contact;
  }


  void
  add_halfspaces(const Scene         &scene,
                 const SceneGeometry &geometry,
                 const WheelRailLoad &load,
                 Summary             &bodies)
  {
    Scene alone = scene;
    // the same load; half-spaces lie in the rigid position, true bodies where their own displacements move
    // them
    alone.halfspace_bodies = ContactBodies::half_spaces;
    fault_of([&]() { // where half-spaces do not touch there is nothing to add
      const WheelRailSolution result = solve_wheel_rail(alone, geometry, load, scene_offsets(alone));
      const double            peak   = halfspace_pressure(result).peak;
      const auto              set    = [&](const char *name, const double value) {
        set_figure(bodies, "halfspace_" + figure_named(name).key(), value);
      };
      set("max_pressure", peak);
      set("contact_area", sum_over_patches(result, [](const auto &patch) { return patch.measures.area; }));
      set("creepage", steady_creepage(result));
      set("lateral_force", sum_over_patches(result, [](const auto &patch) { return patch.lateral; }));
      // true bodies over half-spaces, less 1; the other way round than bodies_effect
      set_figure(bodies, "relative_difference_max_pressure", bodies.max_pressure / peak - 1);
    });
  }


  std::string
  model_beside(const Summary &results)
  {
    std::string line;
    const auto  value_of = [&](const std::string &before, const char *name) {
      return get_figure(results, before + figure_named(name).key());
    };
    for (const auto &[before, model] :
         {std::pair<std::string, std::string>{"halfspace_", "Half-spaces"}, {"bodies_", "True bodies"}})
      {
        // finite for the model that was solved beside the one asked for
        const double peak = value_of(before, "max_pressure");
        if (!std::isfinite(peak))
          continue;
        line = model + " beside them:";
        for (const char *name : {"max_pressure", "contact_area", "creepage", "lateral_force"})
          {
            // one line for the screen: name, value, unit; the difference behind the peak
            const Figure     &figure = figure_named(name);
            const std::string mark   = line.back() == ':' ? " " : ", ",
                              unit   = *figure.unit ? std::string(" ") + figure.unit : "";
            // a creepage that is given, say, has no value beside it
            if (const double value = value_of(before, name); std::isfinite(value))
              line.append(mark).append(figure.label).append(" ").append(figure.shown(value)).append(unit);
            if (figure.key() == "max_pressure_Pa")
              line += text(" (%+.1f %%)", 100 * (peak / results.max_pressure - 1));
          }
      }
    return line;
  }
} // namespace wheelrail
