#include <wheelrail/application/checkpoint_files.h>
#include <wheelrail/application/fields.h>
#include <wheelrail/application/recorder.h>
#include <wheelrail/application/run_texts.h>
#include <wheelrail/application/simulation.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/log.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/dynamics/rolling_velocities.h>
#include <wheelrail/dynamics/static_start.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/root.h>
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

    /// Why a run ends before its distance is rolled.
    struct Stop
    {
      std::string reason;            ///< empty when it does not
      bool        can_go_on = false; ///< from the saved state
    };

    /// One run from the static start, or from a saved state, to the summary.
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
        if (options_.resume)
          good_ = read_checkpoint(scene_.folder, options_.parameters_text, communicator_);
        model_          = make_model(scene_, communicator_);
        const auto mode = options_.resume      ? FolderMode::resume
                          : options_.overwrite ? FolderMode::overwrite
                                               : FolderMode::fresh;
        prepare_folder(scene_.folder, mode, options_.prm_text, options_.parameters_text, communicator_);
        if (rank_ == 0)
          log_ = Log(scene_.folder + "/log.txt", options_.resume);
        write_header(log_, scene_, model_, size_);
        log_.value("set-up", format_duration(seconds() - start_));
        if (options_.resume)
          resume_rolling();
        else
          start_rolling();
        open_series();
        return roll();
      }

    private:
      void
      start_rolling();
      void
      resume_rolling();
      void
      make_rolling(double lift, double rate);
      void
      open_series();
      int
      roll();
      Stop
      record();
      void
      keep_state();
      double
      save_state();
      void
      tick();
      void
      write_fields();
      void
      write_volume(const std::string &name);
      bool
      must_stop() const;
      void
      finish(const std::string &stop_reason);

      bool
      root() const
      {
        return rank_ == 0;
      }

      const Scene               &scene_;
      const RunOptions          &options_;
      double                     start_;
      MPI_Comm                   communicator_ = MPI_COMM_WORLD;
      int                        rank_ = 0, size_ = 1;
      Log                        log_;
      Model                      model_;
      Checkpoint                 good_; ///< state of the last regular tick, or of an interruption
      std::unique_ptr<Axle>      axle_;
      std::unique_ptr<Rolling>   rolling_;
      std::unique_ptr<Recorder>  recorder_;
      std::unique_ptr<PatchFile> patch_file_;
      std::unique_ptr<PvdSeries> surface_series_, window_series_;
      unsigned int               tick_           = 0;
      double                     loop_start_     = 0;                   ///< of this part of the run [s]
      unsigned long              first_step_     = 0;                   ///< steps before this part
      double                     first_distance_ = 0, wall_before_ = 0; ///< the same [m], [s]
    };


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
      const double       begin   = seconds();
      const StaticResult result =
        static_start(*model_.forest, model_.solid, *model_.contact, loads, [&](const std::string &line) {
          log_.status(line);
        });
      const double rate = scene_.velocity / loads.rolling_radius * (1 + result.creepage);
      rolling_velocities(model_.solid, model_.axle, rate, communicator_);
      make_rolling(result.lift, rate);
      log_.value("static start",
                 text("%d Newton steps, %d CG steps, %s; axle lowered by %.4f mm, predicted creepage %.5f",
                      result.newton_steps,
                      result.cg_steps,
                      format_duration(seconds() - begin).c_str(),
                      -1e3 * result.lift,
                      result.creepage));
      keep_state();
      if (scene_.volume_fields)
        write_volume("volume_start");
    }


    void
    Simulation::resume_rolling()
    {
      make_rolling(0, 0);
      restore_checkpoint(good_, model_, *axle_, *rolling_, *recorder_, communicator_);
      tick_           = good_.ticks;
      first_step_     = rolling_->steps();
      first_distance_ = axle_->travelled();
      wall_before_    = good_.wall_time;
      log_.value("resumed", text("at %.3f mm rolled, after %lu steps", 1e3 * first_distance_, first_step_));
    }


    void
    Simulation::make_rolling(const double lift, const double rate)
    {
      axle_    = std::make_unique<Axle>(model_.axle, model_.solid, lift, rate, communicator_);
      rolling_ = std::make_unique<Rolling>(
        model_.solid, *model_.contact, *axle_, model_.time_step, scene_.bulk_viscosity, communicator_);
      recorder_ = std::make_unique<Recorder>(model_);
    }


    void
    Simulation::open_series()
    {
      on_root(communicator_, [&]() {
        patch_file_     = std::make_unique<PatchFile>(scene_.folder + "/patch.h5", options_.resume, tick_);
        surface_series_ = std::make_unique<PvdSeries>(scene_.folder + "/surface.pvd");
        window_series_  = std::make_unique<PvdSeries>(scene_.folder + "/window.pvd");
        for (const auto &series : {surface_series_.get(), window_series_.get()})
          if (options_.resume)
            series->load(tick_);
      });
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
      const unsigned long n_steps = std::lround(scene_.rolling_distance / scene_.velocity / model_.time_step);
      const unsigned long every   = std::max<unsigned long>(1, n_steps / 1000);
      const unsigned int  saves   = std::max(1u, scene_.ticks / 5); // ticks from one to the next
      Stop                stop;
      bool                interrupted = false;
      loop_start_                     = seconds();
      for (unsigned long n = first_step_ + 1; n <= n_steps; ++n)
        {
          const bool record_now = n % every == 0 || n == 1 || n == n_steps;
          rolling_->step(record_now);
          if (record_now)
            stop = record();
          interrupted        = n == options_.stop_after_steps || (n % 20 == 0 && must_stop());
          const bool regular = n * scene_.ticks / n_steps > (n - 1) * scene_.ticks / n_steps;
          const bool last    = n == n_steps || !stop.reason.empty() || interrupted;
          if (regular || last)
            tick();
          tick_ += regular; // a resumed run writes the tick of an interruption over
          if (stop.reason.empty() && (regular || interrupted))
            keep_state();
          if (last)
            break;
          if (regular && tick_ % saves == 0)
            save_state();
        }
      if (interrupted && stop.reason.empty())
        stop = {"interrupted", true};
      else
        interrupted = false;
      const double saved = stop.can_go_on ? save_state() : 0;
      finish(stop.reason);
      if (saved > 0)
        log_.value("saved",
                   text("the state at %.3f mm rolled (%.1f MB); go on with ",
                        1e3 * good_.axle.travelled,
                        1e-6 * saved) +
                     "./wheelrail run " + scene_.folder + "/parameters.prm --ranks " + std::to_string(size_) +
                     " --resume");
      if (stop.reason.empty() && root())
        remove_checkpoints(scene_.folder);
      if (!stop.reason.empty() && !interrupted)
        throw RunError("the run stopped: " + stop.reason);
      return interrupted ? 3 : 0;
    }


    /// Adds the step to the history and looks whether the run has to stop.
    Stop
    Simulation::record()
    {
      recorder_->add(*rolling_, *axle_);
      recorder_->add_patch(patch_fields(*model_.contact, model_.axle, rolling_->time(), axle_->travelled()));
      const double error = rolling_->energy().error, rolled = 1e3 * axle_->travelled();
      if (!std::isfinite(error))
        return {text("a value is not finite after %lu steps, at %.3f mm rolled", rolling_->steps(), rolled),
                false};
      if (error > scene_.energy_limit)
        return {
          text("the energy balance is off by %.1f %% of strain plus dissipated energy at %.3f mm rolled "
               "(Run/Energy limit is %.1f %%)",
               100 * error,
               rolled,
               100 * scene_.energy_limit),
          true};
      if (rolling_->contact_sums().at_border)
        return {text("the patch reaches the edge of the fine cells at %.3f mm rolled; raise Mesh/Fine margin",
                     rolled),
                false};
      return {};
    }


    void
    Simulation::keep_state()
    {
      good_            = take_checkpoint(model_, *axle_, *rolling_, *recorder_);
      good_.parameters = options_.parameters_text;
      good_.ticks      = tick_;
      good_.wall_time  = wall_before_ + seconds() - start_;
    }


    /// Gives the size of what it wrote [bytes].
    double
    Simulation::save_state()
    {
      return write_checkpoint(good_, scene_.folder, communicator_);
    }


    void
    Simulation::tick()
    {
      const double elapsed = seconds() - loop_start_;
      TickLine     line;
      line.rolled_distance    = axle_->travelled();
      const Point2 normal     = model_.geometry.frame.normal();
      const auto  &force      = rolling_->contact_sums().force;
      line.normal_force       = force[0] * normal.x + force[1] * normal.y;
      line.longitudinal_force = force[2];
      line.lateral_force      = force[0];
      line.energy_error       = rolling_->energy().error;
      line.updates_per_second =
        (rolling_->steps() - first_step_) * double(model_.solid.quality.elements) / elapsed;
      line.seconds_left =
        elapsed * (scene_.rolling_distance - axle_->travelled()) / (axle_->travelled() - first_distance_);
      log_.tick(line);
      if (root())
        {
          patch_file_->append(
            patch_fields(*model_.contact, model_.axle, rolling_->time(), axle_->travelled()));
          write_history(recorder_->history(), scene_.folder + "/history.h5");
        }
      write_fields();
    }


    void
    Simulation::write_fields()
    {
      const auto write = [&](const char *kind, const Selection selection, PvdSeries *series) {
        const std::string name = text("%s_%04u", kind, tick_);
        write_vtu(field_mesh(model_.solid, *axle_, *model_.contact, selection, communicator_),
                  scene_.folder,
                  name,
                  communicator_);
        if (root())
          series->add(rolling_->time(), name + ".vtu");
      };
      write("surface", Selection::surface, surface_series_.get());
      write("window", Selection::window, window_series_.get());
    }


    void
    Simulation::write_volume(const std::string &name)
    {
      write_vtu(field_mesh(model_.solid, *axle_, *model_.contact, Selection::all, communicator_),
                scene_.folder,
                name,
                communicator_);
    }


    void
    Simulation::finish(const std::string &stop_reason)
    {
      const double loop_seconds = seconds() - loop_start_;
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
      summary.time_steps           = double(rolling_->steps());
      summary.time_step            = model_.time_step;
      summary.element_updates_per_second =
        summary.elements * double(rolling_->steps() - first_step_) / loop_seconds;
      summary.ranks = size_;
      set_figure(summary, "wheel_load_N", model_.wheel_load);
      set_figure(summary, "rolling_radius_m", model_.geometry.rolling_radius);
      set_figure(summary, "contact_angle_rad", model_.geometry.angle);
      add_pose(summary, scene_, model_, *axle_, communicator_);
      rusage usage;
      getrusage(RUSAGE_SELF, &usage);
      double memory = 1024. * usage.ru_maxrss;
      MPI_Allreduce(MPI_IN_PLACE, &memory, 1, MPI_DOUBLE, MPI_SUM, communicator_);
      summary.peak_memory = memory;
      summary.wall_time   = wall_before_ + seconds() - start_;
      summary.finished    = stop_reason.empty();
      summary.stop_reason = stop_reason;
      const auto &t       = rolling_->timing();
      log_.value("time per step",
                 text("%.2f ns per element update of all ranks together; elements %.1f s, exchange %.1f s, "
                      "contact %.1f s, update %.1f s",
                      1e9 / summary.element_updates_per_second,
                      t.elements,
                      t.exchange,
                      t.contact,
                      t.update));
      if (!root())
        return;
      write_summary(summary, scene_.folder + "/summary.json");
      print_summary(summary, std::cout);
    }
  } // namespace


  int
  run_simulation(const Scene &scene, const RunOptions &options)
  {
    Simulation simulation(scene, options);
    return simulation.run();
  }
} // namespace wheelrail
