#include <wheelrail/application/cross_checks.h>
#include <wheelrail/application/fields.h>
#include <wheelrail/application/recorder.h>
#include <wheelrail/application/simulation.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/log.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/dynamics/pose.h>
#include <wheelrail/dynamics/static_start.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/vtu.h>

#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace wheelrail
{
  namespace
  {
    double
    seconds()
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    }

    template <typename... Arguments>
    std::string
    text(const char *format, const Arguments... arguments)
    {
      char buffer[400];
      std::snprintf(buffer, sizeof buffer, format, arguments...);
      return buffer;
    }

    /// One run from the static start to the summary.
    class Simulation
    {
    public:
      Simulation(const Scene &scene, const RunOptions &options)
        : scene_(scene)
        , options_(options)
        , start_(seconds())
      {
        MPI_Comm_rank(communicator_, &rank_);
        MPI_Comm_size(communicator_, &size_);
      }

      int
      run()
      {
        model_ = make_model(scene_, communicator_);
        prepare_folder(scene_.folder, options_.overwrite ? FolderMode::overwrite : FolderMode::fresh, options_.prm_text,
                       options_.parameters_text, communicator_);
        if (rank_ == 0)
          log_ = Log(scene_.folder + "/log.txt");
        header();
        start_rolling();
        return roll();
      }

    private:
      void
      header();
      void
      start_rolling();
      int
      roll();
      void
      tick(const Rolling &rolling, double loop_start);
      void
      write_fields(const Rolling &rolling);
      void
      write_volume(const std::string &name);
      bool
      must_stop() const;
      void
      finish(const Rolling &rolling, double loop_seconds, const std::string &stop_reason);
      void
      add_pose(Summary &summary) const;

      bool
      root() const
      {
        return rank_ == 0;
      }

      const Scene      &scene_;
      const RunOptions &options_;
      double            start_;
      MPI_Comm          communicator_ = MPI_COMM_WORLD;
      int               rank_ = 0, size_ = 1;
      Log               log_;
      Model             model_;
      StaticResult      static_;
      std::unique_ptr<Axle>      axle_;
      std::unique_ptr<Recorder>  recorder_;
      std::unique_ptr<PatchFile> patch_file_;
      std::unique_ptr<PvdSeries> surface_series_, window_series_;
      unsigned int               tick_ = 0;
    };



    void
    Simulation::header()
    {
      const MeshQuality     &q = model_.solid.quality;
      const StableStep      &s = model_.solid.stable;
      const ContactGeometry &g = model_.geometry;
      const Lattice         &lattice = model_.contact->lattice();
      log_.value("scene", scene_.title);
      log_.value("output", scene_.folder);
      log_.value("ranks", std::to_string(size_));
      log_.value("contact point", text("rail x = %.3f mm, wheel x = %.3f mm (positive to the field side), angle %.3f degrees",
                                       1e3 * g.rail_x, 1e3 * g.wheel_x, g.angle * 180 / M_PI));
      log_.value("rolling radius", text("%.4f mm", 1e3 * g.rolling_radius));
      log_.value("wheel load", text("%.2f kN (sprung mass, axle and wheel)", 1e-3 * model_.wheel_load));
      log_.value("mesh", text("%zu hexahedra (rail %zu, wheel %zu), %zu of the finest size, %zu nodes", q.elements,
                              q.rail_elements, q.wheel_elements, q.finest_elements, q.nodes));
      log_.value("cell sizes", text("%.3f to %.1f mm; on the running band %.4f mm along, %.4f mm across", 1e3 * q.smallest,
                                    1e3 * q.largest, 1e3 * lattice.spacing_along, 1e3 * lattice.spacing_lateral));
      log_.value("worst cell", text("smallest corner Jacobian is %.2f of the mean", q.worst_jacobian));
      log_.value("time step",
                 text("%.4g us, %.0f steps; the limit %.4g us comes from a %.3f mm cell of the %s at X %.1f, Y %.1f, Z %.1f mm",
                      1e6 * model_.time_step, scene_.rolling_distance / scene_.velocity / model_.time_step, 1e6 * s.step,
                      1e3 * s.length, s.body == Body::rail ? "rail" : "wheel", 1e3 * s.place[0], 1e3 * s.place[1],
                      1e3 * s.place[2]));
      log_.value("contact", text("penalty %.3g N/m3 (f = %g) on the nodes of the rail; added surface mass keeps the step",
                                 model_.contact->law().stiffness, scene_.penalty_scale));
      for (const auto &note : scene_notes(scene_))
        log_.note(note);
      log_.value("set-up", format_duration(seconds() - start_));
    }



    void
    Simulation::start_rolling()
    {
      StaticLoads loads;
      loads.axle                 = model_.axle;
      loads.rolling_radius       = model_.geometry.rolling_radius;
      loads.traction_coefficient = scene_.traction_coefficient;
      loads.rate_held            = scene_.drive == Drive::rate;
      loads.creepage             = scene_.creepage;
      loads.first_approach       = model_.expected_approach;
      const double begin         = seconds();
      static_ = static_start(*model_.forest, model_.solid, *model_.contact, loads,
                             [&](const std::string &line) { log_.status(line); });
      const double rate = scene_.velocity / loads.rolling_radius * (1 + static_.creepage);
      rolling_velocities(model_.solid, model_.axle, rate, communicator_);
      axle_ = std::make_unique<Axle>(model_.axle, model_.solid, static_.lift, rate, communicator_);
      log_.value("static start", text("%d Newton steps, %d CG steps, %s; axle lowered by %.4f mm, predicted creepage %.5f",
                                      static_.newton_steps, static_.cg_steps, format_duration(seconds() - begin).c_str(),
                                      -1e3 * static_.lift, static_.creepage));
      recorder_ = std::make_unique<Recorder>(model_);
      if (root())
        {
          patch_file_    = std::make_unique<PatchFile>(scene_.folder + "/patch.h5");
          surface_series_ = std::make_unique<PvdSeries>(scene_.folder + "/surface.pvd");
          window_series_  = std::make_unique<PvdSeries>(scene_.folder + "/window.pvd");
        }
    }



    bool
    Simulation::must_stop() const
    {
      int requested = interrupt_requested() ? 1 : 0;
      MPI_Allreduce(MPI_IN_PLACE, &requested, 1, MPI_INT, MPI_MAX, communicator_);
      return requested > 0;
    }



    int
    Simulation::roll()
    {
      Rolling             rolling(model_.solid, *model_.contact, *axle_, model_.time_step, scene_.bulk_viscosity, communicator_);
      const unsigned long n_steps = std::lround(scene_.rolling_distance / scene_.velocity / model_.time_step);
      const unsigned long record  = std::max<unsigned long>(1, n_steps / 1000);
      const double        begin   = seconds();
      std::string         stop_reason;
      bool                interrupted = false;
      if (scene_.volume_fields)
        write_volume("volume_start");
      for (unsigned long n = 1; n <= n_steps; ++n)
        {
          const bool record_now = n % record == 0 || n == 1 || n == n_steps;
          rolling.step(record_now);
          if (record_now)
            {
              recorder_->add(rolling, *axle_);
              recorder_->add_patch(patch_fields(*model_.contact, model_.axle, rolling.time(), axle_->travelled()));
              const double error = rolling.energy().error;
              if (!std::isfinite(error))
                stop_reason = text("a value is not finite after %lu steps, at %.3f mm rolled", n, 1e3 * axle_->travelled());
              else if (error > scene_.energy_limit)
                stop_reason = text("the energy balance is off by %.1f %% of strain plus dissipated energy at %.3f mm rolled "
                                   "(Run/Energy limit is %.1f %%)",
                                   100 * error, 1e3 * axle_->travelled(), 100 * scene_.energy_limit);
              else if (rolling.contact_sums().at_border)
                stop_reason = text("the patch reaches the edge of the fine cells at %.3f mm rolled; raise Mesh/Fine margin",
                                   1e3 * axle_->travelled());
            }
          interrupted = n % 20 == 0 && must_stop();
          const bool last = n == n_steps || !stop_reason.empty() || interrupted;
          if (last || n * scene_.ticks / n_steps > (n - 1) * scene_.ticks / n_steps)
            tick(rolling, begin);
          if (last)
            break;
        }
      if (interrupted)
        stop_reason = "interrupted";
      finish(rolling, seconds() - begin, stop_reason);
      if (interrupted)
        return 3;
      if (!stop_reason.empty())
        throw RunError("the run stopped: " + stop_reason);
      return 0;
    }



    void
    Simulation::tick(const Rolling &rolling, const double loop_start)
    {
      const double elapsed = seconds() - loop_start;
      TickLine     line;
      line.rolled_distance    = axle_->travelled();
      const Point2 normal     = model_.geometry.frame.normal();
      const auto  &force      = rolling.contact_sums().force;
      line.normal_force       = force[0] * normal.x + force[1] * normal.y;
      line.longitudinal_force = force[2];
      line.lateral_force      = force[0];
      line.energy_error       = rolling.energy().error;
      line.updates_per_second = rolling.steps() * double(model_.solid.quality.elements) / elapsed;
      line.seconds_left       = elapsed * (scene_.rolling_distance / axle_->travelled() - 1);
      log_.tick(line);
      if (root())
        {
          patch_file_->append(patch_fields(*model_.contact, model_.axle, rolling.time(), axle_->travelled()));
          write_history(recorder_->history(), scene_.folder + "/history.h5");
        }
      write_fields(rolling);
      ++tick_;
    }



    void
    Simulation::write_fields(const Rolling &rolling)
    {
      const auto write = [&](const char *kind, const Selection selection, PvdSeries *series) {
        const std::string name = text("%s_%04u", kind, tick_);
        write_vtu(field_mesh(model_.solid, *axle_, *model_.contact, selection, communicator_), scene_.folder, name,
                  communicator_);
        if (root())
          series->add(rolling.time(), name + ".vtu");
      };
      write("surface", Selection::surface, surface_series_.get());
      write("window", Selection::window, window_series_.get());
    }



    void
    Simulation::write_volume(const std::string &name)
    {
      write_vtu(field_mesh(model_.solid, *axle_, *model_.contact, Selection::all, communicator_), scene_.folder, name,
                communicator_);
    }



    void
    Simulation::add_pose(Summary &summary) const
    {
      PoseQuery query;
      query.axle_reference   = model_.axle.centre;
      query.axle_now         = model_.axle.centre + Vector3{0, axle_->height(), axle_->travelled()};
      query.axis             = model_.axle.axis;
      query.angle            = axle_->pitch_angle();
      query.contact          = {model_.geometry.frame.origin.x, model_.geometry.frame.origin.y, axle_->travelled()};
      query.rim_inner_radius = scene_.wheel.rim_inner_radius;
      const ContactPose pose = fit_pose(model_.solid, query, communicator_);
      set_figure(summary, "rail_head_lateral_m", pose.rail_head.lateral);
      set_figure(summary, "rail_head_roll_rad", pose.rail_head.roll);
      set_figure(summary, "wheel_rim_lateral_m", pose.wheel_rim.lateral);
      set_figure(summary, "wheel_rim_roll_rad", pose.wheel_rim.roll);
      set_figure(summary, "relative_lateral_m", pose.relative_lateral());
      set_figure(summary, "relative_roll_rad", pose.relative_roll());
    }



    void
    Simulation::finish(const Rolling &rolling, const double loop_seconds, const std::string &stop_reason)
    {
      if (scene_.volume_fields)
        write_volume("volume_end");
      Summary summary;
      summary.title           = scene_.title;
      summary.program_version = options_.program_version;
      recorder_->fill(summary, scene_.averaging_distance);
      summary.friction_coefficient = scene_.friction_coefficient;
      summary.max_von_mises        = largest_von_mises(model_.solid, communicator_);
      summary.rolled_distance      = axle_->travelled();
      summary.velocity             = scene_.velocity;
      summary.elements             = double(model_.solid.quality.elements);
      summary.time_steps           = double(rolling.steps());
      summary.time_step            = model_.time_step;
      summary.element_updates_per_second = summary.elements * summary.time_steps / loop_seconds;
      summary.ranks                = size_;
      set_figure(summary, "wheel_load_N", model_.wheel_load);
      set_figure(summary, "rolling_radius_m", model_.geometry.rolling_radius);
      set_figure(summary, "contact_angle_rad", model_.geometry.angle);
      add_pose(summary);
      rusage usage;
      getrusage(RUSAGE_SELF, &usage);
      double memory = 1024. * usage.ru_maxrss;
      MPI_Allreduce(MPI_IN_PLACE, &memory, 1, MPI_DOUBLE, MPI_SUM, communicator_);
      summary.peak_memory = memory;
      summary.wall_time   = seconds() - start_;
      summary.finished    = stop_reason.empty();
      summary.stop_reason = stop_reason;
      const auto &t       = rolling.timing();
      log_.value("time per step", text("%.2f ns per element update of both ranks together; elements %.1f s, exchange %.1f s, "
                                       "contact %.1f s, update %.1f s",
                                       1e9 / summary.element_updates_per_second, t.elements, t.exchange, t.contact, t.update));
      if (!root())
        return;
      write_summary(summary, scene_.folder + "/summary.json");
      print_summary(summary, std::cout);
    }
  } // namespace



  int
  run_simulation(const Scene &scene, const RunOptions &options)
  {
    if (options.resume)
      throw InputError("--resume: this version writes no checkpoints to go on from; start the run anew with --overwrite");
    Simulation simulation(scene, options);
    return simulation.run();
  }
} // namespace wheelrail
