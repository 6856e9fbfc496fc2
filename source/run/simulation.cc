#include <wheelrail/base/errors.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/log.h>
#include <wheelrail/model/profile_copies.h>
#include <wheelrail/model/section_file.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/root.h>
#include <wheelrail/run/end_screen.h>
#include <wheelrail/run/run_end.h>
#include <wheelrail/run/run_in.h>
#include <wheelrail/run/run_output.h>
#include <wheelrail/run/run_resonances.h>
#include <wheelrail/run/run_schedule.h>
#include <wheelrail/run/run_start.h>
#include <wheelrail/run/run_state.h>
#include <wheelrail/run/run_texts.h>
#include <wheelrail/run/simulation.h>
#include <wheelrail/run/unloaded_rail.h>
#include <wheelrail/state/checkpoint_files.h>
#include <wheelrail/state/rail_state.h>
#include <wheelrail/state/saved_states.h>

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Why a run stops that was asked to, by a signal.
    const std::string interrupted = "interrupted";

    double
    seconds()
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    }

    /// One run from the static start, or from a saved state, to the summary: a state (RunState), a schedule
    /// (RunSchedule), and what they are written to.
    class Simulation
    {
    public:
      Simulation(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options)
        : scene_(scene)
        , options_(options)
        , start_(seconds())
        , geometry_(geometry)
        , states_(scene, options.parameters_text, scene.checkpoint_interval, communicator_)
      {
        MPI_Comm_rank(communicator_, &rank_);
        MPI_Comm_size(communicator_, &size_);
      }

      int
      run()
      {
        warnings_ = check_on_machine(scene_, geometry_, communicator_);
        open_folder();
        Model model = make_model(scene_, geometry_, communicator_);
        folder_->begin(options_.parameters_text, resume_point_.has_value());
        if (!resume_point_)
          on_root(communicator_, [&]() {
            keep_profiles(scene_, scene_.folder);
            write_sections(geometry_, scene_.track, scene_.folder + "/sections.json");
          });
        Stop stop;
        try
          {
            set_out(std::move(model));
            stop = roll();
            end(stop);
          }
        catch (const RunError &error)
          {
            if (rank_ == 0)
              write_failure(scene_, options_.program_version, run_.get(), error.what());
            throw;
          }
        if (!stop.reason.empty() && stop.reason != interrupted)
          throw RunError("the run stopped: " + sentence(stop));
        return stop.reason.empty() ? 0 : 3;
      }

    private:
      void
      open_folder();
      void
      set_out(Model model);
      Stop
      roll();
      void
      end(const Stop &stop);
      void
      keep_state();
      bool
      must_stop() const;
      bool
      is_steady() const;
      void
      finish(const std::string &stop_reason);
      std::optional<Residual>
      residual();

      Scene                         scene_;
      const RunOptions             &options_;
      double                        start_; ///< of this part of the run [s]
      MPI_Comm                      communicator_ = MPI_COMM_WORLD;
      int                           rank_ = 0, size_ = 1;
      std::vector<std::string>      warnings_; ///< what the machine may lack
      Log                           log_;
      std::unique_ptr<OutputFolder> folder_;
      SceneGeometry                 geometry_;
      std::optional<ResumePoint>    resume_point_;
      std::optional<Checkpoint>     rail_; ///< of an earlier run
      std::unique_ptr<RunState>     run_;
      std::unique_ptr<RunOutput>    output_;
      SavedStates                   states_;
      double                        loop_start_ = 0; ///< [s]
    };


    /// Holds the output folder, and reads the state to go on from.
    void
    Simulation::open_folder()
    {
      const auto mode = options_.resume      ? FolderMode::resume
                        : options_.overwrite ? FolderMode::overwrite
                                             : FolderMode::fresh;
      folder_         = std::make_unique<OutputFolder>(scene_.folder, mode, options_.prm_text, communicator_);
      if (mode == FolderMode::fresh)
        on_root(communicator_, [&]() { protect_saved_states(scene_.folder); });
      if (mode == FolderMode::resume)
        resume_point_ = read_checkpoint(scene_, options_.parameters_text, communicator_);
      if (resume_point_)
        {
          scene_.prepared_distance = resume_point_->whole.prepared_distance;
          scene_.fine_margin       = resume_point_->whole.fine_margin;
          if (scene_.rail_by_slices()) // its section depends on how far the mesh reaches
            geometry_ = make_geometry(scene_);
        }
      else if (scene_.rail_from != "new")
        {
          rail_              = read_rail(scene_, options_.parameters_text, communicator_);
          scene_.fine_margin = rail_->fine_margin;
        }
    }


    /// To the first step: the header, then the static start or the saved state.
    void
    Simulation::set_out(Model model)
    {
      const bool resumed = resume_point_.has_value();
      on_root(communicator_, [&]() { log_ = Log(scene_.folder + "/log.txt", resumed); });
      write_header(log_, scene_, model, size_, options_.note, geometry_.notes, warnings_);
      log_.value("set-up", format_duration(seconds() - start_));
      if (options_.resume && !resumed)
        log_.warning("the run in this folder had not saved a state yet; it starts anew");
      bool evaluated = false; // a volume file that stays beside that of the start; the end is written anew
      if (resumed)
        {
          run_ = resume_run(scene_, std::move(model), resume_point_->whole, communicator_);
          for (const std::string &note : resume_point_->notes)
            log_.warning(note);
          log_.value(
            "resumed",
            text("at %.3f mm rolled, after %lu steps", 1e3 * run_->first_distance, run_->first_step));
          evaluated = scene_.evaluate_at > 0 && run_->first_distance >= scene_.evaluate_at;
        }
      else
        {
          run_ = start_run(scene_, geometry_, std::move(model), rail_, log_, communicator_);
          rail_.reset(); // its memory
        }
      resume_point_.reset();
      scene_  = run_->scene;
      output_ = std::make_unique<RunOutput>(run_->parts(), resumed, run_->ticks, evaluated ? 2 : 1);
      if (!resumed && scene_.volume_fields)
        output_->volume("volume_start");
      keep_state();
      if (!resumed)
        states_.save();
    }


    bool
    Simulation::must_stop() const
    {
      int requested = interrupt_requested() ? 1 : 0;
      MPI_Allreduce(MPI_IN_PLACE, &requested, 1, MPI_INT, MPI_MAX, communicator_);
      return requested > 0;
    }


    /// Whether the rows so far are enough; all ranks have the same ones, and rank 0 decides.
    bool
    Simulation::is_steady() const
    {
      int steady = 0;
      if (rank_ == 0)
        steady = run_->recorder.steadiness(scene_).steady() ? 1 : 0;
      MPI_Bcast(&steady, 1, MPI_INT, 0, communicator_);
      return steady != 0;
    }


    /// Steps to the end; gives why it stopped before, if it did.
    Stop
    Simulation::roll()
    {
      RunState         &run = *run_;
      const RunSchedule schedule(scene_, run.model, options_.stop_after_steps);
      Stop              stop;
      loop_start_ = seconds();
      bool ended  = false; // by itself
      for (unsigned long n = run.first_step + 1; n <= schedule.steps() && stop.reason.empty() && !ended; ++n)
        {
          run.mesh_changes += follow_wheel(run);
          const bool   record = schedule.record(n), regular = schedule.tick(n);
          const double before = run.axle.travelled();
          run.rolling.step(record);
          if (schedule.evaluate(before, run.axle.travelled()) && scene_.volume_fields)
            output_->volume("volume_evaluated");
          if (record)
            {
              run.record();
              stop = reason_to_stop(run.parts());
            }
          run_in(run, before);
          const bool good = stop.reason.empty();
          ended           = good && schedule.judge(n) && is_steady();
          if (good && !ended && (schedule.break_off(n) || (schedule.listen(n) && must_stop())))
            stop.reason = interrupted;
          if (regular || ended || n == schedule.steps() || !stop.reason.empty())
            {
              log_.tick(tick_line(run.parts(), run.first_step, run.first_distance, seconds() - loop_start_));
              output_->tick(run.ticks);
            }
          run.ticks += regular; // a resumed run writes the tick of an interruption over
          if (good && (regular || stop.reason == interrupted))
            keep_state();
          if (record && stop.reason.empty() && !ended && n < schedule.steps() && states_.due())
            {
              keep_state();
              states_.save();
            }
        }
      return stop;
    }


    void
    Simulation::keep_state()
    {
      states_.keep(run_->parts(), run_->ticks, run_->wall_before + seconds() - start_);
    }


    /// Writes the figures, and the last good state when the run stopped.
    void
    Simulation::end(const Stop &stop)
    {
      const bool   finished = stop.reason.empty();
      const double bytes    = finished ? 0 : states_.save(stop);
      finish(sentence(stop));
      if (finished)
        on_root(communicator_, [&]() { remove_checkpoints(scene_.folder); });
      else
        {
          const double kept = states_.any() ? states_.kept().travelled() : 0;
          write_path_on(log_,
                        scene_,
                        options_.whole_folder.empty() ? scene_.folder : options_.whole_folder,
                        stop,
                        states_.any() ? &kept : nullptr,
                        bytes,
                        size_);
        }
    }


    /// What the run leaves in bodies that may yield; leaves the rail for a next run.
    std::optional<Residual>
    Simulation::residual()
    {
      const auto unloaded = take_loads_off(*run_, log_);
      if (!unloaded)
        return {};
      const WhileUnloaded without(run_->model.solid, *unloaded);
      const Residual      residual = residual_of(run_->model, run_->axle, communicator_);
      if (run_->model.solid.blocks.rail.plastic())
        save_rail(run_->parts(), options_.parameters_text);
      return residual;
    }


    void
    Simulation::finish(const std::string &stop_reason)
    {
      RunState      &run      = *run_;
      const bool     finished = stop_reason.empty();
      const double   now      = seconds();
      const RunTally tally{run.wall_before + now - start_, now - loop_start_, run.first_step};
      const auto     left = finished ? residual() : std::nullopt;
      if (scene_.volume_fields)
        output_->volume("volume_end", left ? &left->stress : nullptr);
      if (left)
        output_->residual(*left);
      Summary summary = summary_of(run.parts(), tally, output_->stress());
      if (finished)
        if (!scene_.irregular()) // they are those of the end of the path
          set_stress_below(output_->stress_below(), summary);
      if (left)
        add_residual(*left, summary);
      summary.program_version = options_.program_version;
      summary.finished        = finished;
      summary.stop_reason     = stop_reason;
      if (finished)
        log_.value("ended", summary.ended_because);
      else
        summary.ended = summary.ended_because = "";
      write_timing(log_, run.parts(), summary, run.mesh_changes);
      log_.value("saving states", text("%.2f s", states_.seconds_saving()));
      Contributions contributions;
      if (finished)
        for (const std::string &warning : judge(scene_, geometry_, summary, contributions))
          log_.warning(warning);
      on_root(communicator_, [&]() {
        if (finished && scene_.irregular())
          add_resonances(scene_, geometry_, run.model, summary);
        write_summary(summary, scene_.folder + "/summary.json");
        write_wear(run.recorder.wear(scene_), scene_.folder + "/wear.csv");
        if (finished)
          replace_file(scene_.folder + "/intervals.csv", contributions_as_csv(contributions));
      });
      for (const std::string &line : end_screen(summary, scene_.folder))
        log_.line(line);
    }
  } // namespace


  int
  run_simulation(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options)
  {
    return Simulation(scene, geometry, options).run();
  }
} // namespace wheelrail
