#include <wheelrail/base/errors.h>
#include <wheelrail/base/print.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/root.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/run/passage_jump.h>
#include <wheelrail/run/passage_list.h>
#include <wheelrail/run/passage_table.h>
#include <wheelrail/run/passages.h>
#include <wheelrail/state/checkpoint_checks.h>
#include <wheelrail/state/rail_state.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace wheelrail
{
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

    /// Passages that are computed after each jump before the next one: the first still settles, the second is
    /// held against the jump, the third gives the rate of growth.
    constexpr unsigned int after_jump = 3;

    /// Passages at the begin of a family, whose growth falls fast.
    constexpr unsigned int before_jump = 4;

    /// One family of passages in a folder.
    class Passages
    {
    public:
      Passages(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options)
        : scene_(scene)
        , options_(options)
        , wheels_(passing_wheels(scene, geometry))
        , longest_jump_(scene.passage_jump)
      {
        const unsigned int most = static_cast<unsigned int>(wheels_.size()) * scene.passages;
        most_                   = scene.passages == 0 ? scene.most_passages : most;
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
      read_old_jumps();
      void
      learn_from(const PassageJump &jump);
      void
      judge_last_jump();
      void
      try_jump();
      bool
      jump_over(const JumpBasis &basis, unsigned int n);
      unsigned int
      stand() const;
      double
      strain_after(unsigned int passage) const;
      void
      require_same(const Scene &one, const std::string &parameters) const;

      const Scene              &scene_;
      const RunOptions         &options_;
      std::vector<PassingWheel> wheels_; ///< of a round
      unsigned int              most_;
      std::vector<unsigned int> computed_; ///< passages so far, those jumped over left out
      std::vector<PassageJump>  jumps_;
      unsigned int              longest_jump_; ///< that may still be tried
      std::string               verdict_;      ///< of passages until steady
      MPI_Comm                  communicator_ = MPI_COMM_WORLD;
    };


    /// Holds the folder; refuses what cannot be computed before the first wheel rolls.
    void
    Passages::open(OutputFolder &whole, const FolderMode mode)
    {
      if (mode == FolderMode::fresh &&
          stage_of(passage_folder(scene_.folder, 1), communicator_) != Stage::none)
        throw InputError(
          "Output/Folder = " + scene_.folder +
          ": the folder holds passages of an earlier run; --resume goes on with them, --overwrite starts "
          "anew");
      on_root(communicator_, [&]() {
        for (const PassingWheel &wheel : wheels_)
          if (const Findings found = check_scene(wheel.scene, wheel.geometry, {}); !found.errors.empty())
            throw InputError((wheel.name.empty() ? "" : wheel.name + ": ") + found.errors.front());
        if (mode != FolderMode::resume)
          fs::remove(scene_.folder + "/jumps.csv");
      });
      whole.begin(options_.parameters_text, options_.resume);
    }


    /// A finished passage may only be kept where it is the one that is asked for.
    void
    Passages::require_same(const Scene &one, const std::string &parameters) const
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
      const PassingWheel &wheel = wheels_[(k - 1) % wheels_.size()];
      Scene               one   = wheel.scene;
      one.passages              = 1;
      one.passage_list          = "none";
      one.passage_jump          = 0;
      one.folder                = passage_folder(scene_.folder, k);
      if (k > 1)
        one.rail_from = passage_folder(scene_.folder, k - 1);
      RunOptions of_one      = options_;
      of_one.parameters_text = print_parameters(one);
      const Stage stage      = options_.resume ? stage_of(one.folder, communicator_) : Stage::none;
      computed               = stage != Stage::finished;
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
          return run_simulation(one, wheel.geometry, of_one);
        }
      catch (const RunError &error)
        {
          throw RunError("passage " + std::to_string(k) + ": " + error.what() +
                         (k == 1 ? std::string()
                                 : "; the " + std::to_string(k - 1) +
                                     " before it are kept, with their figures in " + scene_.folder +
                                     "/passages.csv"));
        }
    }


    /// The passage that the rail has come to: the last computed one, or the one jumped to.
    unsigned int
    Passages::stand() const
    {
      const unsigned int last = computed_.empty() ? 0 : computed_.back();
      for (const PassageJump &jump : jumps_)
        if (jump.from == last && !(jump.judged && !jump.kept))
          return jump.to;
      return last;
    }


    /// Whether no wheel is to follow. Collective.
    bool
    Passages::enough()
    {
      const unsigned int k    = stand();
      int                done = k >= most_ ? 1 : 0;
      if (scene_.passages == 0 && k == computed_.back() && k % wheels_.size() == 0)
        {
          on_root(communicator_, [&]() {
            const auto growths =
              round_growths(scene_.folder, computed_, static_cast<unsigned int>(wheels_.size()));
            const PassageTrend trend = trend_of(growths, scene_.settled_growth, scene_.settled_change);
            verdict_                 = "After " + std::to_string(k) + " passages " +
                       in_words(trend, growths.empty() ? RoundGrowth() : growths.back());
            done = done || trend != PassageTrend::open;
          });
          MPI_Bcast(&done, 1, MPI_INT, 0, communicator_);
        }
      return done != 0;
    }


    /// The figures and fields of the passages so far. To be called on one rank.
    void
    Passages::write() const
    {
      const FigureTable table = passage_table(scene_.folder, computed_);
      table.write_csv(scene_.folder + "/passages.csv");
      write_passage_fields(scene_.folder, computed_, table);
    }


    /// Largest plastic strain in the rail [1].
    double
    Passages::strain_after(const unsigned int passage) const
    {
      return get_figure(read_summary(passage_folder(scene_.folder, passage) + "/summary.json"),
                        "rail_plastic_strain");
    }


    /// After a jump that was taken back the next one is half as long, after one that was kept up to twice.
    void
    Passages::learn_from(const PassageJump &jump)
    {
      const unsigned int n = jump.to - jump.from;
      longest_jump_        = jump.kept ? std::min(scene_.passage_jump, 2 * n) : n / 2;
    }


    /// Jumps of the family that is gone on with. Collective.
    void
    Passages::read_old_jumps()
    {
      jumps_ = read_jumps(scene_.folder);
      for (const PassageJump &jump : jumps_)
        if (jump.judged)
          learn_from(jump);
      MPI_Barrier(communicator_);
    }


    /// Holds the last jump against what was computed after it, and takes it back when it misses. Collective.
    void
    Passages::judge_last_jump()
    {
      if (jumps_.empty() || jumps_.back().judged || computed_.back() != jumps_.back().to + 2)
        return;
      PassageJump &jump   = jumps_.back();
      const double strain = strain_after(jump.to + 2);
      judge_jump(jump, strain - strain_after(jump.to + 1), strain, scene_.jump_error);
      MPI_Barrier(communicator_);
      on_root(communicator_, [&]() {
        char words[160];
        std::snprintf(
          words,
          sizeof(words),
          "Jump from passage %u to %u: the growth computed after it differs by %.2g %% of the strain",
          jump.from,
          jump.to,
          100 * jump.error);
        print(STDOUT_FILENO,
              std::string(words) +
                (jump.kept ? "\n"
                           : ", more than Run/Jump error; it is taken back, the next one is half as long\n"));
        write_jumps(jumps_, scene_.folder);
        if (!jump.kept)
          for (unsigned int k = jump.to; k <= jump.to + 2; ++k)
            fs::remove_all(passage_folder(scene_.folder, k));
      });
      learn_from(jump);
      if (!jump.kept)
        computed_.resize(computed_.size() - 2);
    }


    /// Extrapolates the rail over n passages from the last one; whether that is possible. Collective.
    bool
    Passages::jump_over(const JumpBasis &basis, const unsigned int n)
    {
      const unsigned int k = computed_.back();
      PassageJump        jump;
      jump.from   = k;
      jump.to     = k + n;
      jump.growth = basis.growth;
      jump.rate   = basis.rate;
      jumps_.push_back(jump);
      int done = 0;
      on_root(communicator_, [&]() {
        done = extrapolate_rail(passage_folder(scene_.folder, k - 1),
                                passage_folder(scene_.folder, k),
                                jump_factor(jump.rate, n),
                                passage_folder(scene_.folder, jump.to));
        if (!done)
          return;
        write_jumps(jumps_, scene_.folder);
        print(STDOUT_FILENO,
              "Passages " + std::to_string(k + 1) + " to " + std::to_string(jump.to) + " are extrapolated\n");
      });
      MPI_Bcast(&done, 1, MPI_INT, 0, communicator_);
      if (done == 0) // the cells that have flowed have changed
        jumps_.pop_back();
      return done != 0;
    }


    /// Jumps as far as the growths of the last passages allow, if they do. Collective.
    void
    Passages::try_jump()
    {
      if (longest_jump_ < 2 || stand() != computed_.back() || (!jumps_.empty() && !jumps_.back().judged))
        return;
      const unsigned int k    = computed_.back();
      const PassageJump *last = nullptr;
      for (const PassageJump &jump : jumps_)
        if (jump.kept)
          last = &jump;
      if (k < (last == nullptr ? before_jump : last->to + after_jump))
        return;
      JumpBasis    basis;
      const double now = strain_after(k), one = strain_after(k - 1), two = strain_after(k - 2);
      basis.strain = now;
      basis.growth = now - one;
      // growth does not go on growing
      const auto rate = [](const double of, const double over) {
        return over > 0 && of > 0 ? std::min(1., of / over) : 0;
      };
      basis.rate = rate(now - one, one - two);
      basis.before =
        last == nullptr ? rate(one - two, two - strain_after(k - 3)) : std::min(1., last->computed_rate);
      // enough passages must follow to judge it
      const unsigned int left = most_ > k + after_jump ? most_ - k - after_jump : 0;
      const unsigned int n    = jump_length(basis, std::min(longest_jump_, left), scene_.jump_error);
      if (basis.growth > 0 && n >= 2)
        jump_over(basis, n);
    }


    int
    Passages::run()
    {
      const auto   mode = options_.resume      ? FolderMode::resume
                          : options_.overwrite ? FolderMode::overwrite
                                               : FolderMode::fresh;
      OutputFolder whole(scene_.folder, mode, options_.prm_text, communicator_);
      open(whole, mode);
      if (options_.resume)
        read_old_jumps();
      bool computed = false;
      do
        {
          const unsigned int k    = stand() + 1;
          const int          code = pass(k, computed);
          if (code != 0)
            return code;
          computed_.push_back(k);
          judge_last_jump();
          if (computed)
            on_root(communicator_, [&]() { write(); });
          if (!enough())
            try_jump();
          else
            break;
        }
      while (true);
      on_root(communicator_, [&]() {
        if (!computed) // all passages were there
          write();
        Summary summary = read_summary(passage_folder(scene_.folder, computed_.back()) + "/summary.json");
        if (!verdict_.empty())
          summary.note = verdict_ + ".";
        write_summary(summary, scene_.folder + "/summary.json");
        print(STDOUT_FILENO,
              (verdict_.empty() ? "" : verdict_ + ".\n") + "Figures of all passages in " + scene_.folder +
                "/passages.csv\n");
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
