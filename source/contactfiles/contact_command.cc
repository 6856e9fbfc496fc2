#include <wheelrail/base/errors.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/contactfiles/case_bodies.h>
#include <wheelrail/contactfiles/case_tables.h>
#include <wheelrail/contactfiles/contact_command.h>
#include <wheelrail/contactfiles/inp_file.h>
#include <wheelrail/contactfiles/printed_blocks.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/verdict/rules.h>
#include <wheelrail/wheel/halfspace_parts.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <ostream>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// What is asked of the file: all its cases, or one and those before that it may go on from, which come
    /// back without a result.
    std::vector<CaseResult>
    asked_results(const ContactFileTask &task, std::vector<ContactCase> &cases)
    {
      if (task.only < 0 || task.only > int(cases.size()))
        throw InputError("--case " + std::to_string(task.only) + ": " + task.file + " has cases 1 to " +
                         std::to_string(cases.size()));
      if (task.only > 0)
        cases.resize(std::size_t(task.only));
      std::vector<CaseResult> results = solve_cases(cases);
      if (task.only > 0 && results.size() == cases.size())
        for (std::size_t k = 0; k + 1 < results.size(); ++k)
          results[k] = {};
      return results;
    }

    /// The table of the true bodies, which is printed; `without`: on cases that have no answer.
    FigureTable
    answer_of_bodies(const std::vector<ContactCase> &cases,
                     const std::vector<CaseResult>  &results,
                     std::vector<std::string>       &without,
                     std::ostream                   &out)
    {
      FigureTable table = bodies_table(cases, results, without);
      if (table.rows() > 0)
        print_bodies(table, out);
      if (!without.empty())
        out << "\nCases without an answer of true bodies:\n";
      for (const std::string &sentence : without)
        out << sentence << '\n';
      return table;
    }

    /// Whether the grid cuts a contact off. Line contacts always reach its edge.
    bool
    cut_off(const HalfspaceSolution &s)
    {
      return s.touches_grid_edge && s.grid.mx > 1 && s.grid.my > 1;
    }

    /// Whether so few elements lie across a contact that its peak may be off by 5 % and more.
    bool
    is_coarse(const HalfspaceSolution &s)
    {
      return s.fn > 0 && s.grid.mx > 1 && s.grid.my > 1 && elements_across(s) < least_elements_across;
    }

    /// In which cases a contact that carries more than `share` of their load is so: " 9, 12"; empty: in none.
    std::string
    cases_that_are(bool (*const so)(const HalfspaceSolution &),
                   const double                   share,
                   const std::vector<CaseResult> &results)
    {
      std::string cases;
      for (std::size_t k = 0; k < results.size(); ++k)
        {
          std::vector<const HalfspaceSolution *> contacts;
          if (results[k].solved)
            contacts = {&results[k].solved->solution};
          if (results[k].wheel_rail)
            for (const WheelRailPatch &patch : results[k].wheel_rail->patches)
              contacts.push_back(&patch.solution);
          double load = 0;
          for (const HalfspaceSolution *s : contacts)
            load += s->fn;
          const auto is = [&](const auto *s) { return s->fn >= share * load && so(*s); };
          if (std::any_of(contacts.begin(), contacts.end(), is))
            cases += (cases.empty() ? " " : ", ") + std::to_string(k + 1);
        }
      return cases;
    }

    /// Rows and warnings of the cases of a module; returns how many were not solved as they should.
    std::size_t
    print_results(const int                       module,
                  const std::vector<ContactCase> &cases,
                  const std::vector<CaseResult>  &results,
                  std::ostream                   &out)
    {
      std::size_t poor = 0, printed = 0;
      for (std::size_t k = 0; k < cases.size(); ++k)
        if (cases[k].module == module && (results[k].solved || results[k].wheel_rail))
          {
            if (printed++ == 0)
              module == 1 ? print_wheel_rail_heading(out) : print_heading(out);
            std::string missed;
            if (module == 1)
              {
                print_wheel_rail(k + 1, cases[k], *results[k].wheel_rail, out);
                missed = results[k].wheel_rail->not_reached;
              }
            else
              {
                const HalfspaceSolution &s = results[k].solved->solution;
                print_case(k + 1, cases[k], s, out);
                if (cut_off(s))
                  out << "warning: case " << k + 1 << ": the contact reaches the edge of the grid\n";
                missed = s.converged() && s.within_friction ? "" : s.not_reached;
              }
            if (missed.empty())
              continue;
            ++poor;
            out << "warning: case " << k + 1 << ": " << missed << '\n';
          }
      return poor;
    }

    /// Removes what an earlier call wrote: a case that is refused now has no fields.
    void
    remove_earlier(const std::filesystem::path &folder)
    {
      std::vector<std::filesystem::path> own;
      for (const auto &entry : std::filesystem::directory_iterator(folder))
        if (const std::string name = entry.path().filename().string();
            name.rfind("case_", 0) == 0 || name.rfind("cases.", 0) == 0 ||
            name.rfind("wheel_rail.", 0) == 0 || name.rfind("patches.", 0) == 0 ||
            name.rfind("points.", 0) == 0 || name.rfind("bodies.", 0) == 0 || name == "summary.json" ||
            name == "contact.html" || entry.path().extension() == ".out")
          own.push_back(entry.path());
      for (const auto &path : own)
        std::filesystem::remove(path);
    }

    /// The fields of a case, in the form and with the signs of a run's patch, a tick a patch.
    void
    write_fields(const CaseResult &result, const std::string &path)
    {
      if (!result.solved && (!result.wheel_rail || result.wheel_rail->patches.empty()))
        return;
      TickFile file(path, false, 0);
      if (result.solved)
        append_patch(file, halfspace_patch(result.solved->solution));
      else
        for (const WheelRailPatch &patch : result.wheel_rail->patches)
          append_patch(file, halfspace_patch(patch.solution));
    }

    Summary
    file_summary(const std::string              &file,
                 const std::vector<ContactCase> &cases,
                 const std::vector<CaseResult>  &results,
                 const std::size_t               poor)
    {
      Summary summary;
      summary.title    = file;
      summary.finished = true;
      double solved = 0, refused = 0, wheel_rail = 0, simplified = 0, peak = 0;
      for (std::size_t k = 0; k < results.size(); ++k)
        {
          const CaseResult &result = results[k];
          solved += result.solved || result.wheel_rail;
          refused += !result.refused.empty();
          wheel_rail += result.wheel_rail.has_value();
          simplified += result.solved && cases[k].digits.material / 2 == 1; // M = 2, 3
          if (result.solved)
            peak = std::max(peak, result.solved->solution.peak_pressure);
          if (result.wheel_rail)
            for (const WheelRailPatch &patch : result.wheel_rail->patches)
              peak = std::max(peak, patch.solution.peak_pressure);
        }
      summary.max_pressure = peak;
      set_figure(summary, "cases", double(results.size()));
      set_figure(summary, "cases_solved", solved);
      set_figure(summary, "cases_refused", refused);
      set_figure(summary, "cases_not_converged", double(poor));
      Verdict           verdict;
      const std::string cut    = cases_that_are(cut_off, 0, results),
                        coarse = cases_that_are(is_coarse, 0.1, results);
      if (poor > 0)
        add(verdict,
            Grade::not_trusted,
            "Cases were not solved to their tolerance: see column converged of the tables.");
      if (!cut.empty())
        add(verdict,
            Grade::not_trusted,
            "The contact reaches the edge of the grid in case" + cut +
              ": what lies beyond carries nothing; take a larger grid.");
      if (!coarse.empty())
        add(verdict,
            Grade::not_trusted,
            "Fewer than eight elements lie across the contact in case" + coarse + "; take smaller ones.");
      if (wheel_rail > 0)
        add(verdict,
            Grade::with_care,
            "Wheel and rail are half-spaces, as in CONTACT; true bodies differ (--bodies real).");
      if (simplified > 0)
        add(verdict, Grade::with_care, "FASTSIM (M = 2, 3) is an approximation, of forces to some 10 %.");
      set_verdict(summary, verdict);
      return summary;
    }

    void
    write_table(const FigureTable &table, const std::filesystem::path &folder, const std::string &name)
    {
      if (table.rows() == 0)
        return;
      table.write_csv((folder / (name + ".csv")).string());
      table.write_hdf5((folder / (name + ".h5")).string());
    }
  } // namespace


  std::string
  contact_folder(const std::string &file)
  {
    return "output/" + std::filesystem::path(file).stem().string() + "-contact";
  }


  int
  run_contact_command(const ContactFileTask &task, std::ostream &out)
  {
    std::vector<ContactCase>      cases   = read_inp_file(task.file);
    const std::vector<CaseResult> results = asked_results(task, cases);
    std::size_t                   refused = 0;
    std::string                   why;
    for (const CaseResult &result : results)
      {
        refused += result.refused.empty() ? 0 : 1;
        for (const std::string &sentence : result.refused)
          why += (why.empty() ? "" : "\n") + sentence;
      }
    const bool left = results.size() < cases.size();
    if (left && (results.empty() || task.only > 0))
      throw Interrupted();
    cases.resize(results.size());
    if (std::none_of(
          results.begin(), results.end(), [](const CaseResult &r) { return r.solved || r.wheel_rail; }))
      throw InputError(why.empty() ? task.file + " has no case to compute: R = 2 and 3 only check" : why);

    const std::string  stem = std::filesystem::path(task.file).stem().string();
    const ResultFolder held(contact_folder(task.file), "");
    const std::size_t  poor = print_results(1, cases, results, out) + print_results(3, cases, results, out);
    for (const ContactCase &one : cases)
      for (const std::string &note : one.notes)
        out << "note: " << note << '\n';
    if (!why.empty())
      out << '\n' << refused << " of " << cases.size() << " cases are not computed:\n" << why << '\n';
    remove_earlier(held.path());
    write_table(case_table(cases, results), held.path(), "cases");
    write_table(wheel_rail_table(cases, results), held.path(), "wheel_rail");
    write_table(patch_table(cases, results), held.path(), "patches");
    write_table(point_table(results), held.path(), "points");
    for (std::size_t k = 0; k < results.size(); ++k)
      write_fields(results[k], (held.path() / ("case_" + std::to_string(k + 1) + ".h5")).string());
    const Summary summary = file_summary(task.file, cases, results, poor);
    write_summary(summary, (held.path() / "summary.json").string());
    if (task.printed)
      replace_file((held.path() / (stem + ".out")).string(), printed_blocks(cases, results));
    std::vector<std::string> without;
    if (task.bodies)
      try
        {
          write_table(answer_of_bodies(cases, results, without, out), held.path(), "bodies");
        }
      catch (const Interrupted &)
        {
          throw Interrupted("the cases are kept in " + held.path().string() +
                            ", but not their true bodies; the same command solves all, --case K one");
        }
    out << verdict_line(summary) << "\nTables in " << held.path().string() << std::endl;
    if (left)
      throw Interrupted("the cases before case " + std::to_string(results.size() + 1) + " are kept in " +
                        held.path().string() + "; the same command solves all, --case K one");
    return refused + poor == 0 && without.empty() ? 0 : 2;
  }
} // namespace wheelrail
