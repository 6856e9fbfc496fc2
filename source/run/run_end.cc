#include <deal.II/base/mpi.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/bodies/run_intervals.h>
#include <wheelrail/bodies/run_reference.h>
#include <wheelrail/damage/wear_profile.h>
#include <wheelrail/geometry/made_up_part.h>
#include <wheelrail/geometry/track.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/coarser_cells.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/scene_motion.h>
#include <wheelrail/model/section_file.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/run/run_end.h>
#include <wheelrail/run/run_kinks.h>
#include <wheelrail/run/run_texts.h>
#include <wheelrail/sampling/body_figures.h>
#include <wheelrail/scene/steels.h>
#include <wheelrail/verdict/agreement.h>
#include <wheelrail/verdict/verdict.h>
#include <wheelrail/wheel/contact_reference.h>
#include <wheelrail/wheel/noise_effect.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Peak memory of all ranks together [bytes].
    double
    peak_memory(MPI_Comm communicator)
    {
      rusage usage;
      getrusage(RUSAGE_SELF, &usage);
      return dealii::Utilities::MPI::sum(1024. * usage.ru_maxrss, communicator);
    }
  } // namespace


  Stop
  reason_to_stop(const RunParts &run)
  {
    const double error = run.rolling.energy().error(), rolled = 1e3 * run.axle.travelled();
    Stop         stop;
    stop.rolled_distance = run.axle.travelled();
    if (!std::isfinite(error))
      {
        stop.reason =
          text("a value is not finite after %lu steps, at %.3f mm rolled", run.rolling.steps(), rolled);
        stop.cure = "take a smaller Run/Time step factor";
      }
    else if (error > run.scene.energy_limit)
      {
        stop.reason = text(
          "the energy balance is off by %.1f %% of strain plus dissipated energy at %.3f mm rolled "
          "(Run/Energy limit is %.1f %%)",
          100 * error,
          rolled,
          100 * run.scene.energy_limit);
        stop.cure         = "take a smaller Run/Time step factor";
        stop.energy_error = error;
      }
    else if (run.rolling.contact_sums().at_border)
      {
        stop.reason = text("the patch reaches the edge of the fine cells at %.3f mm rolled", rolled);
        stop.cure   = text("raise Mesh/Fine margin above %g mm", 1e3 * run.scene.fine_margin);
      }
    return stop;
  }


  namespace
  {
    /// Whether the run is steady, where it was to roll until it is, and what is not.
    void
    add_end(Summary &summary, const RunParts &run)
    {
      const double rolled = run.axle.travelled();
      if (!run.scene.until_steady())
        {
          summary.ended         = "distance";
          summary.ended_because = path_entry(run.scene) + " is rolled";
          return;
        }
      const Steadiness known = run.recorder.steadiness(run.scene);
      summary.ended          = known.steady() ? "steady" : "not steady";
      summary.ended_because =
        known.steady()
          ? "all results are steady and known after " + in_mm(std::round(1e4 * rolled) / 1e4) +
              ", over the last " + in_mm(std::round(1e4 * (known.stretch.s1 - known.stretch.s0)) / 1e4)
          : "the run is not steady after " + in_mm(std::round(1e4 * rolled) / 1e4) + ": " + known.open;
    }

    /// What friction carries of what it could, positive when driving: kappa of Ma et al. (2017), equation 7,
    /// as it came out; how far the force is from the one that balances the torque at the radius of the patch;
    /// and a patch that slides.
    void
    add_drive(Summary &summary, const Scene &scene, const double radius)
    {
      const double force = summary.longitudinal_force;
      if (scene.friction.at(0) > 0)
        set_figure(summary, "traction_over_friction", force / (scene.friction.at(0) * summary.normal_force));
      if (scene.drive != Drive::torque)
        return;
      // a wheel that is hardly driven is judged by half of what friction carries: a force that is lost there
      // changes creepage and T-gamma as little as it does in a driven wheel
      const double asked   = get_figure(summary, "drive_torque_Nm") / radius;
      const double carried = std::max(0.05, 0.5 * scene.friction.at(0)) * std::abs(summary.normal_force);
      set_figure(summary, "torque_miss", (force - asked) / std::max(std::abs(asked), carried));
    }

    /// Wear and cracks, from the means of forces, of the patch and of the wear across the rail.
    void
    add_wear(Summary &summary, const Scene &scene, const WearProfile &wear)
    {
      const double across = get_figure(summary, "tangential_lateral_force_N");
      set_wear_figures(wear,
                       std::hypot(summary.longitudinal_force, std::isfinite(across) ? across : 0),
                       yield_strength(scene.rail_material),
                       scene.wear,
                       summary);
    }

    /// How the wheelset stood in the middle of the stretch of the means.
    void
    add_motion(Summary &summary, const GuidedPath &path, const Range &stretch)
    {
      const double middle = 0.5 * (stretch.s0 + stretch.s1);
      set_figure(summary, "motion_distance_m", middle);
      set_figure(summary, "lateral_shift_m", path.lateral_shift.at(middle));
      set_figure(summary, "wheelset_roll_rad", path.roll.at(middle));
      set_figure(summary, "yaw_rad", path.yaw.at(middle));
      summary.velocity = path.velocity.at(middle);
    }

    /// Holds the peak pressure against that of half-spaces, and adds both figures. Solves the noise of
    /// measured surfaces, too, with the wheel where the means were taken.
    NoiseEffect
    compare_peak(const Scene &scene, const SceneGeometry &geometry, Summary &summary, Measures &measures)
    {
      NoiseEffect noise;
      try
        {
          const HalfspacePressure halfspace = halfspace_pressure(
            scene, geometry, summary.normal_force, offsets_of_run(summary), summary.creepage);
          if (std::isfinite(get_figure(summary, "yaw_rad")))
            set_reference_figures(halfspace.reference, true, summary); // from its pitch rate and pose
          measure_against(halfspace, scene, summary, measures);
          set_figure(summary, "halfspace_max_pressure_Pa", halfspace.peak);
          set_figure(summary, "relative_difference_max_pressure", measures.peak_difference);
          const bool   drawn = draws_irregularities(geometry) && !measures.off_rail();
          const double there = drawn ? middle_of_means(scene, summary, measures) : 0;
          noise              = noise_effect(
            scene, standing(geometry, there, -there / geometry.contact.rolling_radius), summary.normal_force);
          if (std::isfinite(noise.peak))
            set_figure(summary, "noise_effect_max_pressure", noise.peak);
        }
      catch (const InputError &error)
        {
          measures.no_reference =
            std::string("the peak pressure could not be held against half-spaces: ") + error.what();
        }
      return noise;
    }

    /// A band of plastic flow that reaches below the fine cells; empty where it does not.
    std::string
    flow_below_fine_cells(const MeshSettings &scene, const Summary &summary)
    {
      const double band = get_figure(summary, "plastic_band_depth_m"), fine = scene.depth_of_fine_cells();
      if (!(band > fine + scene.cell_size)) // where cell sizes meet, fine ones go on for a cell
        return "";
      return text(
        "steel has flowed down to %.1f mm, below the fine cells, which are %.1f mm deep: the depth of the "
        "plastic zone and the stresses left there are those of coarser cells; raise Mesh/Fine depth to %.0f "
        "mm",
        1e3 * band,
        1e3 * fine,
        std::ceil(1e3 * (band + scene.cell_size)));
    }

    /// The means are those of a place of the path.
    NoiseEffect
    compare_peak_on_path(const Scene         &scene,
                         const SceneGeometry &geometry,
                         Summary             &summary,
                         Measures            &measures)
    {
      const Scene there = scene_on_path(scene, get_figure(summary, "motion_distance_m"));
      return compare_peak(
        there, make_geometry(there, {geometry.rail, geometry.wheel, {}, geometry.files}), summary, measures);
    }

    /// By the run on larger cells; nothing where it is not there.
    Contributions
    by_two_meshes(const Scene &scene, const Summary &run, const Measures &measures)
    {
      const std::string folder = scene_on_coarser_cells(scene).folder;
      if (scene.error_estimate != ErrorEstimate::two_meshes || measures.off_rail() ||
          !holds_finished_run(folder))
        return {};
      return two_mesh_contributions(scene, run, read_summary(folder + "/summary.json"), measures.cells);
    }
  } // namespace


  std::vector<std::string>
  judge(const Scene &scene, const SceneGeometry &geometry, Summary &summary, Contributions &contributions)
  {
    Measures     measures = measures_of_run(scene, summary);
    const double centre   = summary.patch_centre_lateral;
    const Point2 place    = geometry.contact.frame.to_track({centre, geometry.rail_heights().at(centre).n});
    set_patch_place(head_place(geometry.contact.rail, scene.track, place), summary);
    measures.place         = place_in_words(place.x);
    measures.made_up       = made_up_part(geometry, place);
    measures.expected_loss = expected_loss(scene, expected_patch(scene, geometry));
    measure_kinks(scene, geometry, summary, measures);
    NoiseEffect noise;
    if (scene.motion != "none")
      noise = compare_peak_on_path(scene, geometry, summary, measures);
    else if (!measures.off_rail())
      noise = compare_peak(scene, geometry, summary, measures);
    // elastic bodies are no reference of steel that has flowed
    const Contributions bodies =
      measures.has_yielded() ? Contributions() : measure_against_bodies(scene, geometry, summary, measures);
    const Contributions meshes = by_two_meshes(scene, summary, measures);
    contributions              = run_contributions(scene, summary, measures, noise, bodies, meshes);
    set_intervals(contributions, summary);
    measures.peak  = std::isinf(noise.peak) ? Known{noise.peak, "measured input"} : known_peak(summary);
    measures.creep = known_creep_of_run(scene, summary);
    const Verdict verdict = judge_run(scene, measures);
    set_verdict(summary, verdict);
    if (summary.note.empty() && !measures.off_rail())
      for (const std::string &sentence :
           {wear_doubt(scene, summary), without_intervals(scene, measures, bodies, meshes)})
        if (!sentence.empty())
          summary.note += (summary.note.empty() ? "" : " ") + sentence;
    std::vector<std::string> warnings;
    for (const std::string &warning :
         {difference_of_models(measures, verdict), flow_below_fine_cells(scene, summary)})
      if (!warning.empty())
        warnings.push_back(warning);
    return warnings;
  }


  void
  add_residual(const Residual &residual, Summary &summary)
  {
    summary.max_residual_von_mises = residual.largest;
    if (std::isfinite(residual.forward))
      set_figure(summary, "residual_forward_flow_m", residual.forward);
    for (const Slice &slice : residual.slices)
      {
        if (slice.name != "BB_behind_rail")
          continue;
        const auto largest = [&](const SliceField field) {
          double most = 0;
          for (const double value : slice.values[field])
            if (std::abs(value) > std::abs(most))
              most = value;
          return most;
        };
        set_figure(summary, "residual_lateral_stress_Pa", largest(slice_stress_xx));
        set_figure(summary, "residual_longitudinal_stress_Pa", largest(slice_stress_zz));
        if (slice.values.size() > slice_plastic_strain)
          set_figure(summary, "rail_plastic_strain", largest(slice_plastic_strain));
      }
  }


  Summary
  summary_of(const RunParts &run, const RunTally &tally, const NodalStress &stress)
  {
    const Model &model = run.model;
    Summary      summary;
    summary.title = run.scene.title;
    run.recorder.fill(summary, run.scene);
    add_end(summary, run);
    summary.friction_coefficient = run.scene.friction.at(0);
    if (!run.scene.irregular()) // there it is a mean of the stretch, for at the end an impact is over
      summary.max_von_mises = largest_von_mises(model.solid, run.communicator);
    const PlasticFigures plastic = plastic_figures(model.solid, model.contact->surfaces(), run.communicator);
    set_figure(summary, "max_von_mises_nodal_Pa", largest_von_mises(stress, run.communicator));
    summary.max_plastic_strain = plastic.max_strain;
    for (const Body body : both_bodies)
      if (model.solid.blocks[body].plastic())
        set_figure(summary, std::string("plastic_work_") + body_name(body) + "_J", plastic.work[body]);
    if (std::isfinite(plastic.band_depth))
      {
        set_figure(summary, "plastic_band_width_m", plastic.band_width);
        set_figure(summary, "plastic_band_depth_m", plastic.band_depth);
        set_figure(summary, "plastic_band_centre_lateral_m", plastic.band_centre);
      }
    // the same turning of the wheel, counted at another of its radii
    const double centre_radius = model.contact->surfaces().local_radius(summary.patch_centre_lateral);
    set_figure(summary,
               "creepage_at_patch_centre",
               (1 + summary.creepage) * centre_radius / model.geometry.forward_radius - 1);
    add_drive(summary, run.scene, centre_radius);
    summary.rolled_distance = run.axle.travelled();
    summary.velocity        = run.scene.velocity;
    add_wear(summary, run.scene, run.recorder.wear(run.scene));
    summary.elements   = double(model.solid.quality.elements);
    summary.time_steps = double(run.rolling.steps());
    summary.time_step  = model.time_step;
    if (const PerBody<double> &scaled = model.solid.quality.scaled_share; run.scene.mass_scaling)
      set_figure(summary, "mass_scaling", std::max(scaled.rail, scaled.wheel));
    summary.element_updates_per_second =
      summary.elements * double(run.rolling.steps() - tally.first_step) / tally.loop_seconds;
    summary.ranks = dealii::Utilities::MPI::n_mpi_processes(run.communicator);
    set_figure(summary, "wheel_load_N", model.wheel_load);
    const History &history = run.recorder.state().history;
    for (std::size_t c = 0; c < history.names.size(); ++c)
      if (history.names[c] == "vertical_force" && !history.columns[c].empty())
        set_figure(summary, "first_force_over_load", history.columns[c].front() / model.wheel_load);
    set_figure(summary, "rolling_radius_m", model.geometry.rolling_radius);
    set_figure(summary, "contact_angle_rad", model.geometry.angle);
    if (model.geometry.yaw != 0 || model.axle.lateral_creepage != 0)
      set_figure(summary, "yaw_rad", model.geometry.yaw);
    if (model.axle.path)
      add_motion(summary, *model.axle.path, run.recorder.averaging_stretch(run.scene));
    for (const std::string tail : {"", "_error"}) // P = T-gamma V
      set_figure(summary,
                 "frictional_power" + tail + "_W",
                 get_figure(summary, "t_gamma" + tail + "_N") * summary.velocity);
    add_pose(summary, run.scene, model, run.axle, run.communicator);
    summary.peak_memory = peak_memory(run.communicator);
    summary.wall_time   = tally.wall_time;
    return summary;
  }


  void
  write_failure(const Scene       &scene,
                const std::string &program_version,
                const RunState    *run,
                const std::string &error)
  {
    try
      {
        Summary summary;
        summary.title           = scene.title;
        summary.program_version = program_version;
        if (run)
          {
            run->recorder.fill(summary, scene);
            summary.rolled_distance = run->axle.travelled();
          }
        summary.stop_reason = error;
        write_summary(summary, scene.folder + "/summary.json");
      }
    catch (const std::exception &)
      {
        // the failure itself is reported on the screen
      }
  }
} // namespace wheelrail
