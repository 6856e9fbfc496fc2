#include <wheelrail/base/hints.h>
#include <wheelrail/model/scene_head.h>
#include <wheelrail/run/run_texts.h>
#include <wheelrail/sampling/pose.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  std::string
  mesh_text(const MeshQuality &q)
  {
    return text("%zu hexahedra (rail %zu, wheel %zu), %zu of the finest size, %zu nodes",
                q.elements,
                q.rail_elements,
                q.wheel_elements,
                q.finest_elements,
                q.nodes);
  }


  std::string
  time_step_text(const double duration, const double step, const StableStep &limit)
  {
    return text(
      "%.4g us, %.0f steps; the limit %.4g us comes from a %.3f mm cell of the %s at X %.1f, Y "
      "%.1f, Z %.1f mm%s%s%s",
      1e6 * step,
      duration / step,
      1e6 * limit.step,
      1e3 * limit.length,
      body_name(limit.body),
      1e3 * limit.place[0],
      1e3 * limit.place[1],
      1e3 * limit.place[2],
      limit.scaled ? ", raised to that of a cube by mass scaling; what that adds to the bodies is checked "
                     "when a run starts"
                   : "",
      limit.lowered_by_edges ? ", lowered since free edges vibrate faster" : "",
      limit.of_parts > 1e-3 ? text(", by %.1f %% by pads and ballast", 100 * limit.of_parts).c_str() : "");
  }


  void
  write_header(Log                            &log,
               const Scene                    &scene,
               const Model                    &model,
               const int                       ranks,
               const std::string              &note,
               const std::vector<std::string> &profile_notes,
               const std::vector<std::string> &warnings)
  {
    const MeshQuality     &q       = model.solid.quality;
    const ContactGeometry &g       = model.geometry;
    const Lattice         &lattice = model.contact->lattice();
    log.value("scene", scene.title);
    for (const HeadLine &line : scene_head(scene, model.wheel_load, HeadOf::run))
      log.value(line.name, line.text);
    if (!note.empty())
      log.line("note: " + note);
    log.value("output", scene.folder);
    log.value("ranks", std::to_string(ranks));
    log.value(
      "contact point",
      text("of the rigid profiles: %.3f mm to the %s side of the rail's axis, %.3f mm to the %s side of "
           "the running circle, angle %.3f degrees",
           1e3 * std::abs(g.rail_x),
           g.rail_x > 0 ? "field" : "gauge",
           1e3 * std::abs(g.wheel_x),
           g.wheel_x > 0 ? "field" : "gauge",
           g.angle * 180 / M_PI));
    log.value("rolling radius", text("%.4f mm", 1e3 * g.rolling_radius));
    log.value("mesh", mesh_text(q));
    log.value("cell sizes",
              text("%.3f to %.1f mm; in the fine zone %.4f mm along, %.4f mm across",
                   1e3 * q.smallest,
                   1e3 * q.largest,
                   1e3 * lattice.spacing_along,
                   1e3 * lattice.spacing_lateral));
    log.value("worst cell", text("smallest corner Jacobian is %.2f of the mean", q.worst_jacobian));
    log.value("time step", time_step_text(model.duration, model.time_step, model.solid.stable));
    if (scene.mass_scaling)
      log.value("mass scaling",
                text("adds %.2g %% to the mass of the rail, %.2g %% to that of the wheel",
                     100 * q.scaled_share.rail,
                     100 * q.scaled_share.wheel));
    log.value(
      "contact",
      text("penalty %.3g N/m3 (penalty scale %g) on the nodes of the rail; added surface mass keeps the step",
           model.contact->law().stiffness,
           scene.penalty_scale));
    for (const std::string &note : profile_notes)
      log.value("profile", note);
    for (const std::string &warning : warnings)
      log.warning(warning);
  }


  TickLine
  tick_line(const RunParts     &run,
            const unsigned long first_step,
            const double        first_distance,
            const double        elapsed)
  {
    const double travelled = run.axle.travelled();
    const Point2 normal    = run.model.geometry.frame.normal();
    const auto  &force     = run.rolling.contact_sums().force;
    const double updates   = (run.rolling.steps() - first_step) * double(run.model.solid.quality.elements);
    TickLine     line;
    line.rolled_distance    = travelled;
    line.normal_force       = force[0] * normal.x + force[1] * normal.y;
    line.longitudinal_force = force[2];
    line.lateral_force      = force[0];
    line.energy_error       = run.rolling.energy().error();
    line.updates_per_second = updates / elapsed;
    line.seconds_left = elapsed * std::max(0., run.scene.path() - travelled) / (travelled - first_distance);
    return line;
  }


  void
  write_timing(Log &log, const RunParts &run, const Summary &summary, const unsigned int mesh_changes)
  {
    const auto &t = run.rolling.timing();
    log.value("time per step",
              text("%.2f ns per element update of all ranks together; elements %.1f s, exchange %.1f s, "
                   "contact and axle %.1f s, update %.1f s",
                   1e9 / summary.element_updates_per_second,
                   t.elements,
                   t.exchange,
                   t.parts,
                   t.update));
    if (run.model.discretization->plan().moving)
      log.value("changes of the mesh", text("%u, %.2f s", mesh_changes, t.mesh));
  }


  void
  write_path_on(Log               &log,
                const RunSettings &scene,
                const std::string &folder,
                const Stop        &stop,
                const double      *saved,
                const double       bytes,
                const int          ranks)
  {
    if (saved == nullptr)
      {
        log.value("saved", "no state: already the first one holds values that are not finite");
        return;
      }
    log.value("saved", text("the state at %.3f mm rolled (%.1f MB)", 1e3 * *saved, 1e-6 * bytes));
    const std::string obstacle = obstacle_of_stop(stop, *saved, scene);
    if (obstacle.empty())
      log.value("to resume",
                own_call() + " run " + shell_word(folder + "/parameters.prm") + " --ranks " +
                  std::to_string(ranks) + " --resume");
    else
      log.value("no resume", obstacle);
  }


  void
  add_pose(Summary                &summary,
           const WheelsetSettings &scene,
           const Model            &model,
           const Axle             &axle,
           MPI_Comm                communicator)
  {
    PoseQuery query;
    query.axle_reference = model.axle.centre;
    query.axis           = model.axle.axis;
    query.wheel_place    = Axle::Motion(axle);
    query.contact = {model.geometry.frame.origin.x, model.geometry.frame.origin.y, axle.contact_along()};
    query.rim_inner_radius = scene.wheel.rim_inner_radius;
    const ContactPose pose = fit_pose(model.solid, query, communicator);
    set_pose_figures(pose, summary);
    if (scene.motion == "none")
      set_figure(summary, "relative_lateral_m", pose.relative_lateral() + axle.aside());
  }
} // namespace wheelrail
