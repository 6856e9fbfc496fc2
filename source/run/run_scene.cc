#include <wheelrail/base/errors.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/log.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/coarser_cells.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/model/scene_irregularities.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/root.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/run/passage_list.h>
#include <wheelrail/run/passage_table.h>
#include <wheelrail/run/run_scene.h>
#include <wheelrail/run/staggered_starts.h>
#include <wheelrail/state/checkpoint_checks.h>
#include <wheelrail/state/checkpoint_files.h>
#include <wheelrail/wheel/coarse_halfspaces.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <unistd.h>

namespace wheelrail
{
  namespace
  {
    /// The first of two meshes, in a folder beside that of the run, which is held meanwhile. One that is
    /// finished is kept, unless it had other entries or all starts anew. Returns the exit code.
    int
    run_on_coarser_cells(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options)
    {
      const Scene coarser        = scene_on_coarser_cells(scene);
      RunOptions  of_coarser     = options;
      of_coarser.parameters_text = print_parameters(coarser);
      of_coarser.whole_folder    = scene.folder;
      const std::string size     = "cells of " + in_mm(coarser.cell_size);
      of_coarser.note            = "the first of two meshes, " + size;
      const auto   mode          = options.resume      ? FolderMode::resume
                                   : options.overwrite ? FolderMode::overwrite
                                                       : FolderMode::fresh;
      OutputFolder whole(scene.folder, mode, options.prm_text, MPI_COMM_WORLD);
      int          there[2] = {0, 0}; // finished; with the same entries
      on_root(MPI_COMM_WORLD, [&]() {
        if (mode == FolderMode::fresh)
          protect_saved_states(scene.folder);
        const std::string path = coarser.folder + "/parameters.prm";
        there[0]               = holds_finished_run(coarser.folder);
        there[1]               = std::filesystem::exists(path) &&
                   other_entries(read_whole_file(path), of_coarser.parameters_text, false).empty();
      });
      MPI_Bcast(there, 2, MPI_INT, 0, MPI_COMM_WORLD);
      whole.begin(options.parameters_text, options.resume);
      if (there[0] && there[1] && !options.overwrite)
        return 0;
      of_coarser.resume    = options.resume && there[1];
      of_coarser.overwrite = !of_coarser.resume;
      try
        {
          return run_simulation(coarser, geometry, of_coarser);
        }
      catch (const RunError &error)
        {
          throw RunError("Run/Error estimate = two meshes: the run on " + size + ": " + error.what());
        }
    }
  } // namespace


  int
  run_scene(const Scene &given, const SceneGeometry &geometry, const RunOptions &options)
  {
    const Scene scene = scene_of_run(given);
    save_when_interrupted();
    if (scene.several_passages())
      return run_passages(scene, geometry, options);
    if (scene.error_estimate == ErrorEstimate::two_meshes)
      if (const int code = run_on_coarser_cells(scene, geometry, options); code != 0)
        return code;
    return run_simulation(scene, geometry, options);
  }


  namespace
  {
    namespace fs = std::filesystem;

    /// What is known of a passage before it is computed.
    enum class Stage
    {
      none,    ///< nothing is there
      begun,   ///< it may be gone on with
      finished ///< with its rail
    };

    /// Collective.
    Stage
    stage_of(const std::string &folder, MPI_Comm communicator)
    {
      int stage = 0;
      on_root(communicator, [&]() {
        if (holds_finished_run(folder) && fs::exists(folder + "/rail.h5"))
          stage = 2;
        else if (fs::exists(folder + "/parameters.prm") && !holds_finished_run(folder))
          stage = 1;
      });
      MPI_Bcast(&stage, 1, MPI_INT, 0, communicator);
      return static_cast<Stage>(stage);
    }

    /// One family of passages in a folder.
    class Passages
    {
    public:
      Passages(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options)
        : scene_(scene)
        , options_(options)
        , wheels_(passing_wheels(scene, geometry))
        , starts_(scene, geometry)
        , most_(scene.passages == 0 ? scene.most_passages : of_round() * scene.passages)
      {
      }

      int
      run();

    private:
      void
      open(OutputFolder &whole, FolderMode mode);
      int
      pass(unsigned int k, bool &computed);
      bool
      enough();
      void
      write() const;
      void
      require_same(const OutputSettings &one, const std::string &parameters) const;
      unsigned int
      of_round() const
      {
        return static_cast<unsigned int>(wheels_.size());
      }

      const Scene              &scene_;
      const RunOptions         &options_;
      MPI_Comm                  communicator_ = MPI_COMM_WORLD;
      std::vector<PassingWheel> wheels_; ///< of a round
      StaggeredStarts           starts_;
      unsigned int              most_;
      unsigned int              passed_ = 0; ///< passages so far
      std::string               verdict_;    ///< where the passages lead to
    };


    /// Holds the folder; refuses what cannot be computed before the first wheel rolls.
    void
    Passages::open(OutputFolder &whole, const FolderMode mode)
    {
      if (mode == FolderMode::fresh &&
          stage_of(passage_folder(scene_.folder, 1), communicator_) != Stage::none)
        throw InputError(
          "Output/Folder = " + scene_.folder +
          ": the folder holds passages of an earlier run; --resume continues them, --overwrite starts "
          "anew");
      on_root(communicator_, [&]() {
        for (const PassingWheel &wheel : wheels_)
          if (const Findings found = check_scene(wheel.scene, wheel.geometry, {}); !found.errors.empty())
            throw InputError((wheel.name.empty() ? "" : wheel.name + ": ") + found.errors.front());
      });
      whole.begin(options_.parameters_text, options_.resume);
    }


    /// A finished passage may only be kept where it is the one that is asked for.
    void
    Passages::require_same(const OutputSettings &one, const std::string &parameters) const
    {
      on_root(communicator_, [&]() {
        const std::string path  = one.folder + "/parameters.prm";
        const std::string other = fs::exists(path) ? other_entries(read_whole_file(path), parameters) : "";
        if (!other.empty())
          throw InputError(one.folder + ": this passage was computed with other entries: " + other +
                           "; set them back, or start anew with --overwrite or in another Output/Folder");
      });
    }


    /// Computes passage k, or goes on with it, or keeps it. Returns the exit code.
    int
    Passages::pass(const unsigned int k, bool &computed)
    {
      const PassingWheel &wheel = wheels_[(k - 1) % of_round()];
      Scene               one   = wheel.scene;
      one.passages              = 1;
      one.rolling_distance      = wheel.scene.path();
      one.passage_list          = "none";
      one.staggered_starts      = 1;
      one.start_offset          = starts_.offset(k);
      if (one.irregular() && one.evaluate_at > 0) // the same place of the rail in all passages
        one.evaluate_at =
          std::max(0.5 * one.averaging_distance, one.evaluate_at - (starts_.offset(k) - starts_.offset(1)));
      one.folder = passage_folder(scene_.folder, k);
      if (k > 1)
        one.rail_from = passage_folder(scene_.folder, k - 1);
      RunOptions of_one      = options_;
      of_one.parameters_text = print_parameters(one);
      of_one.whole_folder    = scene_.folder;
      if (k > 1)
        of_one.note.clear(); // the first wheel has told it
      const Stage stage = options_.resume ? stage_of(one.folder, communicator_) : Stage::none;
      computed          = stage != Stage::finished;
      if (!computed)
        {
          require_same(one, of_one.parameters_text);
          return 0;
        }
      of_one.resume    = stage == Stage::begun;
      of_one.overwrite = options_.overwrite || (options_.resume && stage == Stage::none);
      on_root(communicator_, [&]() {
        print(STDOUT_FILENO,
              "Passage " + std::to_string(k) + " of " + (scene_.passages == 0 ? "at most " : "") +
                std::to_string(most_) + "\n");
      });
      try
        {
          SceneGeometry geometry = wheel.geometry;
          add_irregularities(one, geometry); // as seen from where this wheel starts
          return run_simulation(one, geometry, of_one);
        }
      catch (const RunError &error)
        {
          throw RunError("passage " + std::to_string(k) + ": " + error.what() +
                         (k == 1 ? std::string()
                                 : "; the " + std::to_string(k - 1) +
                                     " before it are kept, with their results in " + scene_.folder +
                                     "/passages.csv"));
        }
    }


    /// Whether no wheel is to follow. Collective.
    bool
    Passages::enough()
    {
      int done = passed_ >= most_ ? 1 : 0;
      if (passed_ % of_round() == 0 && (scene_.passages == 0 || done != 0))
        {
          on_root(communicator_, [&]() {
            const auto         growths = round_growths(scene_.folder, passed_, of_round());
            const PassageTrend trend   = trend_of(growths, scene_.settled_growth, scene_.settled_change);
            verdict_                   = "After " + std::to_string(passed_) + " passages " +
                       in_words(trend, growths.empty() ? RoundGrowth() : growths.back());
            done = done || trend != PassageTrend::open;
            if (growths.empty()) // a single round tells no trend
              verdict_.clear();
          });
          MPI_Bcast(&done, 1, MPI_INT, 0, communicator_);
        }
      return done != 0;
    }


    /// The figures and fields of the passages so far. To be called on one rank.
    void
    Passages::write() const
    {
      const FigureTable table = passage_table(scene_.folder, passed_);
      table.write_csv(scene_.folder + "/passages.csv");
      write_passage_fields(scene_.folder, passed_, table);
    }


    int
    Passages::run()
    {
      const auto   mode = options_.resume      ? FolderMode::resume
                          : options_.overwrite ? FolderMode::overwrite
                                               : FolderMode::fresh;
      OutputFolder whole(scene_.folder, mode, options_.prm_text, communicator_);
      open(whole, mode);
      bool computed = false;
      do
        {
          if (const int code = pass(passed_ + 1, computed); code != 0)
            return code;
          ++passed_;
          if (computed)
            on_root(communicator_, [&]() { write(); });
        }
      while (!enough());
      on_root(communicator_, [&]() {
        if (!computed) // all passages were there
          write();
        Summary summary = read_summary(passage_folder(scene_.folder, passed_) + "/summary.json");
        if (!verdict_.empty())
          summary.note = verdict_ + ".";
        write_summary(summary, scene_.folder + "/summary.json");
        print(STDOUT_FILENO,
              (verdict_.empty() ? "" : verdict_ + ".\n") +
                passage_verdicts(passage_table(scene_.folder, passed_)) + "Results of all passages in " +
                scene_.folder + "/passages.csv\n");
      });
      return 0;
    }
  } // namespace


  int
  run_passages(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options)
  {
    return Passages(scene, geometry, options).run();
  }
} // namespace wheelrail
