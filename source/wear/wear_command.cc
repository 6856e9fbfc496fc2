#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/progress.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/commands/halfspace_results.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/input/cross_checks.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/input/scene_files.h>
#include <wheelrail/input/without_effect.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/state/checkpoint_checks.h>
#include <wheelrail/wear/wear_command.h>
#include <wheelrail/wear/wear_files.h>
#include <wheelrail/wear/wear_mix.h>
#include <wheelrail/wheel/given_distance.h>
#include <wheelrail/wheel/wheel_load.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    namespace fs = std::filesystem;

    std::string
    reached(const WearStep &step)
    {
      std::string text_of;
      if (std::isfinite(step.gross_load))
        text_of += text("%.4g Mt", 1e-9 * step.gross_load);
      if (std::isfinite(step.distance))
        text_of += (text_of.empty() ? "" : ", ") + text("%.4g km", 1e-3 * step.distance);
      return text_of;
    }

    void
    print_traffic(const Scene               &scene,
                  const std::vector<MixRow> &rows,
                  const double               weights,
                  std::ostream              &out)
    {
      if (rows.size() == 1)
        print_head(rows.front().scene, rows.front().scene.wheel_load, out);
      else
        out << text("%zu kinds of traffic of %s, on ", rows.size(), scene.wear_plan.mix.c_str())
            << (scene.both_wheels ? "wheelsets" : "one wheel") << '\n';
      if (std::abs(weights - 1) > 1e-6 && std::abs(weights - 100) > 1e-4)
        out << text("note: the weights of the mix add up to %.6g; each row has its share of that\n", weights);
    }

    double
    share_of_plan(const WearStep &step, const WearPlan &plan)
    {
      return plan.worn == WornBody::wheel ? step.distance / plan.distance : step.gross_load / plan.gross_load;
    }

    void
    print_step(const WearState &state, const WearPlan &plan, const Progress &progress, std::ostream &out)
    {
      const WornBody  worn = plan.worn;
      const WearStep &step = state.steps.back();
      std::string     depths;
      if (worn != WornBody::wheel)
        depths = text("rail %.4f mm", 1e3 * step.rail_depth);
      if (worn != WornBody::rail)
        depths += text("%swheel %.4f mm", depths.empty() ? "" : ", ", 1e3 * step.wheel_depth);
      out << text("%5zu  %-22s %s worn; mean of the mix: peak pressure %.0f MPa, T-gamma %.2f N; %s",
                  state.steps.size() - 1,
                  reached(step).c_str(),
                  depths.c_str(),
                  1e-6 * step.mean_pressure,
                  step.mean_t_gamma,
                  progress.at(share_of_plan(step, plan)).c_str())
          << std::endl;
    }

    void
    print_machining(const MachiningEvent &done, std::ostream &out)
    {
      out
        << text(
             "       %s to %s: at most %.3f mm off, %.2f mm2 in all; the profile stands %.3f mm %s than new",
             done.of_rail ? "rail ground" : "wheel turned",
             done.to.c_str(),
             1e3 * done.depth,
             1e6 * done.section,
             1e3 * done.shift,
             done.of_rail ? "lower" : "higher")
        << std::endl;
    }

    void
    write_state(const fs::path    &folder,
                const WearState   &state,
                const WornBody     worn,
                const std::string &digest)
    {
      const bool        first  = state.steps.size() == 1;
      const std::string number = text("%04zu", state.steps.size() - 1), at = reached(state.steps.back());
      const auto        write = [&](const std::string &body, const WornShape &shape) {
        replace_file((folder / "profiles" / (body + "_" + number + ".txt")).string(),
                     shape_as_text(shape, body + " after " + at));
      };
      write("rail", state.rail);
      if (first || worn != WornBody::rail)
        write("wheel", state.wheel);
      wear_table(state).write_csv((folder / "wear.csv").string());
      replace_file((folder / "wear.json").string(), wear_state_as_text(state, digest));
    }

    constexpr double same_share = 1e-9;

    /// Of all that states depend on: how far the plan goes is none of that.
    std::string
    digest_of_states(Scene scene)
    {
      scene.wear_plan.gross_load = scene.wear_plan.distance = 0;
      return scene_digest(scene, WHEELRAIL_VERSION);
    }

    /// The states in the folder, where there are some; throws InputError where they are of another scene, or
    /// beyond its plan.
    std::optional<WearState>
    kept_states(const Scene &scene, const std::string &digest, const fs::path &folder)
    {
      std::optional<KeptWear> kept = read_wear_state((folder / "wear.json").string());
      if (!kept)
        return {};
      const double share = share_of_plan(kept->state.steps.back(), scene.wear_plan);
      if (kept->digest == digest && share < 1 + same_share)
        {
          kept->state.finished = kept->state.finished && share > 1 - same_share;
          return std::move(kept->state);
        }
      const fs::path    old = folder / "parameters.prm";
      const std::string other =
        fs::exists(old) ? other_entries(read_whole_file(old.string()), print_parameters(scene), false) : "";
      throw InputError(
        folder.string() + ": holds states of another scene, up to " + reached(kept->state.steps.back()) +
        ": " + (other.empty() ? "a profile or the mix has changed, or the program" : other) +
        "; set it back to continue with them, choose another Output/Folder, or give --overwrite to "
        "start anew");
    }

    void
    print_end(const WearState &state, const WornBody worn, std::ostream &out)
    {
      const WearStep &first = state.steps.front(), &last = state.steps.back();
      const auto      row = [&](const std::string &label,
                           const double       from,
                           const double       to,
                           const char        *unit,
                           const Interval    &within = {Measures::none, Measures::none},
                           const double       factor = 1) {
        out << text("  %-44s %9.3f  %9.3f  %s", label.c_str(), from, to, unit);
        if (std::isfinite(within.low) && std::isfinite(within.high))
          out << text(" (%.3f to %.3f)", factor * within.low, factor * within.high);
        out << '\n';
      };
      out << text("after %-40s %9s  %9s\n", reached(last).c_str(), "new", "worn");
      if (worn != WornBody::wheel)
        {
          row("rail: section lost", 0, 1e6 * last.rail_section, "mm2", last.rail_within, 1e6);
          row("rail: height lost at its axis", 0, 1e3 * last.dimensions.rail_height, "mm");
          row("rail: gauge side, 14 mm below the top", 0, 1e3 * last.dimensions.rail_side, "mm");
          row("rail: largest damage (1: cracks)", 0, last.rail_damage, "");
          row("rail: net of cracks and wear", 0, last.rail_cracks, "");
          if (last.rail_ground > 0)
            row("rail: section ground off, of that", 0, 1e6 * last.rail_ground, "mm2");
        }
      if (worn != WornBody::rail)
        {
          row("wheel: section lost", 0, 1e6 * last.wheel_section, "mm2", last.wheel_within, 1e6);
          row("wheel: flange height Sh",
              1e3 * first.dimensions.flange_height,
              1e3 * last.dimensions.flange_height,
              "mm");
          row("wheel: flange thickness Sd",
              1e3 * first.dimensions.flange_thickness,
              1e3 * last.dimensions.flange_thickness,
              "mm");
          row("wheel: flange gradient qR",
              1e3 * first.dimensions.flange_gradient,
              1e3 * last.dimensions.flange_gradient,
              "mm");
          row("wheel: largest damage (1: cracks)", 0, last.wheel_damage, "");
          row("wheel: net of cracks and wear", 0, last.wheel_cracks, "");
          if (last.wheel_turned > 0)
            row("wheel: section turned off, of that", 0, 1e6 * last.wheel_turned, "mm2");
        }
      row("equivalent conicity at 3 mm", first.conicity, last.conicity, "");
      row("peak pressure, mean of the mix",
          1e-6 * first.mean_pressure,
          1e-6 * last.mean_pressure,
          "MPa",
          last.pressure_within,
          1e-6);
      row("T-gamma, mean of the mix", first.mean_t_gamma, last.mean_t_gamma, "N", last.t_gamma_within);
      for (const std::string &note : {state.note, beside_bodies(state)})
        if (!note.empty())
          out << "note: " << note << '\n';
    }

    /// `torn`: why it stopped before the plan was done, or nothing.
    void
    print_judged_end(const Scene &scene, const WearState &state, const std::string &torn, std::ostream &out)
    {
      print_end(state, scene.wear_plan.worn, out);
      if (!torn.empty())
        out << "stopped: " << torn << '\n';
      const Verdict verdict = wear_verdict(state);
      out << "verdict: " << grade_word(verdict.grade()) << (verdict.findings.empty() ? "" : ": ")
          << verdict.doubts() << '\n';
    }

    void
    print_kept(const std::optional<WearState> &kept, const fs::path &folder, std::ostream &out)
    {
      if (kept)
        out << (kept->finished ? "everything is there: " : "resuming from step ")
            << (kept->finished ? folder.string() : std::to_string(kept->steps.size() - 1)) << '\n';
    }

    int
    run_wear_command(const Scene &scene, const bool draws, const bool overwrite, std::ostream &screen)
    {
      const RowTeam                       team  = team_of_job();
      const bool                          leads = team.rank == 0; // who writes and speaks for all
      std::ostringstream                  unheard;
      std::ostream                       &out = leads ? screen : unheard;
      const std::unique_ptr<ResultFolder> held =
        leads ? std::make_unique<ResultFolder>(scene.folder, "-wear") : nullptr;
      const SceneProfiles       profiles = read_profiles(scene);
      const double              load     = static_wheel_load(scene, profiles.wheel);
      double                    weights  = 1;
      const std::vector<MixRow> rows     = mix_rows(scene, load, weights);
      print_traffic(scene, rows, weights, out);
      const std::string        digest = digest_of_states(scene);
      const fs::path           folder = folder_beside(scene.folder, "-wear");
      std::optional<WearState> kept   = overwrite ? std::nullopt : kept_states(scene, digest, folder);
      WearState                state  = kept ? *kept : begin_wear(profiles);
      print_kept(kept, folder, out);
      state.files = profiles.files;
      if (kept && !kept->finished)
        take_back_last(state);
      std::string torn;
      bool        begun = false;
      Progress    progress(state.steps.empty() ? 0 : share_of_plan(state.steps.back(), scene.wear_plan));
      const auto  keep = [&](const WearState &now) {
        if (!leads)
          return;
        if (!begun) // not before the first state is computed: bad input changes nothing
          {
            if (!kept)
              fs::remove_all(folder / "profiles");
            fs::create_directories(folder / "profiles");
            replace_file((folder / "parameters.prm").string(), print_parameters(scene));
            begun = true;
          }
        write_state(folder, now, scene.wear_plan.worn, digest);
        print_step(now, scene.wear_plan, progress, out);
      };
      try
        {
          wear_on(
            scene, rows, keep, state, [&](const MachiningEvent &done) { print_machining(done, out); }, team);
        }
      catch (const InputError &error)
        {
          if (state.steps.empty())
            throw;
          torn = error.what();
        }
      catch (const Interrupted &)
        {
          const WearState &known = state.steps.empty() && kept ? *kept : state;
          if (known.steps.empty())
            throw;
          throw Interrupted("the states up to " + reached(known.steps.back()) + " are kept in " +
                            folder.string() + ": the same command resumes there");
        }
      print_judged_end(scene, state, torn, out);
      out << "Results in " << folder.string() << std::endl;
      if (draws && leads)
        draw_results("wear_evolution.py", folder.string());
      return torn.empty() ? 0 : 2;
    }
  } // namespace


  int
  act_wear(const po::variables_map &options, const RunFunction &, std::ostream &out)
  {
    require_file(options, "wear");
    SceneInput input = file_input_of(options);
    require_one_scene(input);
    input.scene.motion   = "none";
    const Findings found = contact_checks(input.scene);
    require_none(found.errors, input);
    if (input.scene.halfspace_bodies == ContactBodies::automatic)
      input.scene.halfspace_bodies = ContactBodies::half_spaces;
    const Scene &scene = input.scene;
    if (distance_is_given(scene))
      throw InputError(
        "wear takes the distance of wheel and rail: set Half-space/Undeformed distance = profiles");
    for (const char *const name : {"Wheel left", "Rail left"})
      if (const std::string text = entry_text(scene, "Profiles", name);
          text.find("as right") == std::string::npos)
        throw InputError(text +
                         ": both sides wear alike, as on a line with as many curves to the left as to the "
                         "right; write as right");
    if (team_of_job().rank == 0)
      {
        for (const std::string &warning : found.warnings)
          out << "warning: " << warning << "\n";
        print_notes(entries_without_effect(input, "wear"), out);
      }
    return run_wear_command(scene, !options.count("no-pictures"), options.count("overwrite") > 0, out);
  }
} // namespace wheelrail
