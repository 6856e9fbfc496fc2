#include <wheelrail/base/errors.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/log.h>
#include <wheelrail/model/profile_copies.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/root.h>
#include <wheelrail/run/end_screen.h>
#include <wheelrail/run/moving_mesh.h>
#include <wheelrail/run/passages.h>
#include <wheelrail/run/run_end.h>
#include <wheelrail/run/run_output.h>
#include <wheelrail/run/run_start.h>
#include <wheelrail/run/run_texts.h>
#include <wheelrail/run/simulation.h>
#include <wheelrail/state/checkpoint_files.h>
#include <wheelrail/state/rail_state.h>
#include <wheelrail/state/saved_states.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include <unistd.h>

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

    /// One run from the static start, or from a saved state, to the summary.
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
        model_ = make_model(scene_, geometry_, communicator_);
        folder_->begin(options_.parameters_text, resume_point_.has_value());
        if (!resume_point_)
          on_root(communicator_, [&]() { keep_profiles(scene_, scene_.folder); });
        Stop stop;
        try
          {
            set_out();
            stop = roll();
            end(stop);
          }
        catch (const RunError &error)
          {
            if (rank_ == 0)
              write_failure(scene_, options_.program_version, recorder_.get(), axle_.get(), error.what());
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
      set_out();
      void
      start_rolling();
      void
      resume_rolling();
      void
      make_rolling(double lift, double rate);
      Stop
      roll();
      void
      end(const Stop &stop);
      MovingParts
      moving();
      void
      record();
      void
      keep_state();
      void
      tick();
      bool
      must_stop() const;
      void
      finish(const std::string &stop_reason);
      void
      leave_rail() const;

      Scene                         scene_;
      const RunOptions             &options_;
      double                        start_;
      MPI_Comm                      communicator_ = MPI_COMM_WORLD;
      int                           rank_ = 0, size_ = 1;
      std::vector<std::string>      warnings_; ///< what the machine may lack
      Log                           log_;
      std::unique_ptr<OutputFolder> folder_;
      SceneGeometry                 geometry_;
      Model                         model_;
      std::optional<ResumePoint>    resume_point_;
      std::optional<Checkpoint>     rail_; ///< of an earlier run
      SavedStates                   states_;
      std::unique_ptr<Axle>         axle_;
      std::unique_ptr<Rolling>      rolling_;
      std::unique_ptr<Recorder>     recorder_;
      std::unique_ptr<RunParts>     parts_;
      std::unique_ptr<RunOutput>    output_;
      unsigned int                  tick_           = 0;
      unsigned int                  mesh_changes_   = 0;                   ///< of this part of the run
      double                        loop_start_     = 0;                   ///< of this part of the run [s]
      unsigned long                 first_step_     = 0;                   ///< steps before this part
      double                        first_distance_ = 0, wall_before_ = 0; ///< the same [m], [s]
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
        }
      else if (scene_.rail_from != "new")
        {
          rail_              = read_rail(scene_, options_.parameters_text, communicator_);
          scene_.fine_margin = rail_->fine_margin;
        }
    }


    /// To the first step: the header, then the static start or the saved state.
    void
    Simulation::set_out()
    {
      on_root(communicator_, [&]() { log_ = Log(scene_.folder + "/log.txt", resume_point_.has_value()); });
      write_header(log_, scene_, model_, size_, options_.note, geometry_.notes, warnings_);
      log_.value("set-up", format_duration(seconds() - start_));
      if (options_.resume && !resume_point_)
        log_.warning("the run in this folder had not saved a state yet; it starts anew");
      if (resume_point_)
        resume_rolling();
      else
        start_rolling();
    }


    void
    Simulation::start_rolling()
    {
      const RunStart start =
        start_on_wide_mesh(scene_, geometry_, model_, rail_ ? &*rail_ : nullptr, log_, communicator_);
      rail_.reset(); // its memory
      make_rolling(start.lift, start.rate);
      use_window(moving());
      if (scene_.volume_fields)
        output_->volume("volume_start", nodal_stress(model_.solid, communicator_));
      keep_state();
      states_.save();
    }


    void
    Simulation::resume_rolling()
    {
      const Checkpoint &whole = resume_point_->whole;
      tick_                   = whole.ticks;
      model_.time_step        = whole.time_step; // another Run/Rolling distance would round it otherwise
      if (model_.swept)
        {
          model_.window = whole.window;
          model_.forest.reset();
          prepare_window(model_, communicator_);
        }
      make_rolling(0, 0);
      restore_checkpoint(whole, model_, *axle_, *rolling_, *recorder_, communicator_);
      lengthen_way(moving());
      first_step_     = rolling_->steps();
      first_distance_ = axle_->travelled();
      wall_before_    = whole.wall_time;
      for (const std::string &note : resume_point_->notes)
        log_.warning(note);
      log_.value("resumed", text("at %.3f mm rolled, after %lu steps", 1e3 * first_distance_, first_step_));
      resume_point_->whole = Checkpoint(); // its memory
      keep_state();
    }


    void
    Simulation::make_rolling(const double lift, const double rate)
    {
      axle_    = std::make_unique<Axle>(model_.axle, lift, rate, communicator_);
      rolling_ = std::make_unique<Rolling>(
        model_.solid, *model_.contact, *axle_, time_scheme(scene_, model_), communicator_);
      recorder_ = std::make_unique<Recorder>(model_);
      parts_ =
        std::make_unique<RunParts>(RunParts{scene_, model_, *axle_, *rolling_, *recorder_, communicator_});
      // the start and the place of evaluation stay, the end is written anew
      const bool evaluated =
        resume_point_ && scene_.evaluate_at > 0 && resume_point_->whole.axle.travelled >= scene_.evaluate_at;
      output_ = std::make_unique<RunOutput>(*parts_, resume_point_.has_value(), tick_, evaluated ? 2 : 1);
    }


    MovingParts
    Simulation::moving()
    {
      return {scene_, model_, *rolling_, *axle_, communicator_};
    }


    bool
    Simulation::must_stop() const
    {
      int requested = interrupt_requested() ? 1 : 0;
      MPI_Allreduce(MPI_IN_PLACE, &requested, 1, MPI_INT, MPI_MAX, communicator_);
      return requested > 0;
    }


    /// Steps to the end; gives why it stopped before, if it did.
    Stop
    Simulation::roll()
    {
      const unsigned long n_steps = std::lround(model_.duration / model_.time_step);
      const unsigned long every   = std::max<unsigned long>(1, n_steps / 1000);
      Stop                stop;
      loop_start_ = seconds();
      for (unsigned long n = first_step_ + 1; n <= n_steps && stop.reason.empty(); ++n)
        {
          mesh_changes_ += follow_wheel(moving());
          const bool   record_now = n % every == 0 || n == 1 || n == n_steps;
          const double before     = axle_->travelled();
          rolling_->step(record_now);
          if (before < scene_.evaluate_at && axle_->travelled() >= scene_.evaluate_at && scene_.volume_fields)
            output_->volume("volume_evaluated", nodal_stress(model_.solid, communicator_));
          if (record_now)
            {
              record();
              stop = reason_to_stop(*parts_);
            }
          const bool good = stop.reason.empty();
          if (good && (n == options_.stop_after_steps || (n % 20 == 0 && must_stop())))
            stop.reason = interrupted;
          const bool regular = n * scene_.ticks / n_steps > (n - 1) * scene_.ticks / n_steps;
          if (regular || n == n_steps || !stop.reason.empty())
            tick();
          tick_ += regular; // a resumed run writes the tick of an interruption over
          if (good && (regular || stop.reason == interrupted))
            keep_state();
          if (record_now && stop.reason.empty() && n < n_steps && states_.due())
            {
              keep_state();
              states_.save();
            }
        }
      return stop;
    }


    void
    Simulation::record()
    {
      recorder_->add(*rolling_, *axle_);
      recorder_->add_patch(patch_fields(*model_.contact, *axle_, rolling_->time()));
    }


    void
    Simulation::keep_state()
    {
      states_.keep(*parts_, tick_, wall_before_ + seconds() - start_);
    }


    void
    Simulation::tick()
    {
      log_.tick(tick_line(*parts_, first_step_, first_distance_, seconds() - loop_start_));
      output_->tick(tick_);
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
        write_way_on(
          log_, scene_, stop, states_.any() ? &states_.kept().axle.travelled : nullptr, bytes, size_);
    }


    void
    Simulation::finish(const std::string &stop_reason)
    {
      const RunTally tally{wall_before_ + seconds() - start_, seconds() - loop_start_, first_step_};
      const auto     residual =
        stop_reason.empty() ? take_loads_off(moving(), log_, [&]() { leave_rail(); }) : std::nullopt;
      const auto stress = nodal_stress(model_.solid, communicator_);
      if (scene_.volume_fields)
        output_->volume("volume_end", stress, residual ? &residual->stress : nullptr);
      if (residual)
        output_->residual(*residual);
      Summary summary = summary_of(*parts_, tally, stress);
      if (residual)
        {
          summary.max_residual_von_mises = residual->largest;
          add_residual(*residual, summary);
        }
      summary.program_version = options_.program_version;
      summary.finished        = stop_reason.empty();
      summary.stop_reason     = stop_reason;
      write_timing(log_, *parts_, summary, mesh_changes_);
      log_.value("saving states", text("%.2f s", states_.seconds_saving()));
      if (summary.finished)
        for (const std::string &warning : judge(scene_, geometry_, summary))
          log_.warning(warning);
      on_root(communicator_, [&]() { write_summary(summary, scene_.folder + "/summary.json"); });
      for (const std::string &line : end_screen(summary, scene_.folder))
        log_.line(line);
    }


    /// The rail for a next run.
    void
    Simulation::leave_rail() const
    {
      if (!model_.solid.blocks.rail.plastic())
        return;
      Checkpoint part  = take_checkpoint(model_, *axle_, *rolling_, *recorder_);
      part.parameters  = options_.parameters_text;
      part.fine_margin = scene_.fine_margin;
      save_rail(part, scene_.folder, communicator_);
    }
  } // namespace


  int
  run_simulation(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options)
  {
    if (scene.several_passages())
      return run_passages(scene, geometry, options);
    Simulation simulation(scene, geometry, options);
    return simulation.run();
  }
} // namespace wheelrail
