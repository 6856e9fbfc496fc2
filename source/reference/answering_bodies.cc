#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/reference/answering_bodies.h>

#include <cmath>

namespace wheelrail
{
  std::string
  solve_with_bodies(Scene &scene, const std::function<void()> &solve)
  {
    if (scene.halfspace_bodies != ContactBodies::automatic)
      {
        solve();
        return "";
      }
    scene.halfspace_bodies = ContactBodies::real;
    std::string why;
    try
      {
        solve();
        return "";
      }
    catch (const RunError &error)
      {
        why = error.what();
      }
    catch (const InputError &error) // what half-spaces do not take either they say themselves
      {
        why = error.what();
      }
    scene.halfspace_bodies = ContactBodies::half_spaces;
    solve();
    return "By half-spaces, since true bodies have no answer: " + why;
  }


  void
  add_halfspaces(const Scene         &scene,
                 const SceneGeometry &geometry,
                 const WheelRailLoad &load,
                 Summary             &bodies)
  {
    Scene alone            = scene;
    alone.halfspace_bodies = ContactBodies::half_spaces;
    try
      {
        const Summary figures =
          halfspace_summary(alone, solve_wheel_rail(alone, geometry, load, scene_offsets(alone)));
        for (const char *name : {"max_pressure", "contact_area", "creepage", "lateral_force"})
          {
            const std::string key = figure_named(name).key();
            set_figure(bodies, "halfspace_" + key, get_figure(figures, key));
          }
        set_figure(
          bodies, "relative_difference_max_pressure", bodies.max_pressure / figures.max_pressure - 1);
      }
    catch (const InputError &)
      {
      }
  }


  void
  add_halfspaces(const WheelOnAxle           &wheel,
                 const double                 rate,
                 const std::optional<double> &torque,
                 Summary                     &bodies)
  {
    add_halfspaces(wheel.scene, wheel.geometry, load_of_wheel(wheel, rate, torque), bodies);
  }


  std::string
  halfspaces_beside(const Summary &bodies)
  {
    const double peak = get_figure(bodies, "halfspace_max_pressure_Pa");
    if (!std::isfinite(peak))
      return "";
    std::string line = "Half-spaces beside them:";
    for (const char *name : {"max_pressure", "contact_area", "creepage", "lateral_force"})
      {
        const Figure     &figure = figure_named(name);
        const std::string mark   = line.back() == ':' ? " " : ", ",
                          unit   = *figure.unit ? std::string(" ") + figure.unit : "";
        if (const double value = get_figure(bodies, "halfspace_" + figure.key()); std::isfinite(value))
          line.append(mark).append(figure.label).append(" ").append(figure.shown(value)).append(unit);
        if (figure.key() == "max_pressure_Pa")
          line += text(" (%+.1f %%)", 100 * (peak / bodies.max_pressure - 1));
      }
    return line;
  }
} // namespace wheelrail
