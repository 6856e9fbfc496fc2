#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/contactfiles/case_bodies.h>
#include <wheelrail/contactfiles/contact_command.h>
#include <wheelrail/contactfiles/inp_file.h>
#include <wheelrail/contactfiles/printed_blocks.h>
#include <wheelrail/contactfiles/wheel_rail_table.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/wheel/halfspace_parts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <ostream>

namespace wheelrail
{
  namespace
  {
    void
    print_case(const std::size_t place, const ContactCase &one, const HalfspaceSolution &s, std::ostream &out)
    {
      const bool   shift = one.digits.motion == 1;
      const double scale = shift ? 1e3 : 100; // shifts in mm, creepages in %
      // what is nothing beside the force that presses prints as nothing, as the solver leaves it
      const auto force = [&](const double value, const double unit) {
        return std::abs(value) < 1e-6 * s.fn * unit ? 0. : value;
      };
      out << text("%6zu %12.5g %12.5g %12.5g %12.5g %11.5f %11.5g %11.5f %11.5f %10.4g %8.1f\n",
                  place,
                  s.fn,
                  force(s.fx, 1),
                  force(s.fy, 1),
                  1e3 * force(s.spin_moment, std::sqrt(s.area)),
                  1e3 * s.approach,
                  1e-6 * s.peak_pressure,
                  scale * s.xi,
                  scale * s.eta,
                  1e6 * s.area,
                  s.area > 0 ? 100 * s.adhesion_area / s.area : 0.);
    }

    void
    print_heading(std::ostream &out)
    {
      out << "Forces on body 1; creepages, or shifts in mm\n\n"
             "  case           FN           FX           FY           MZ    approach        peak        CKSI "
             "       CETA       area    stick\n"
             "                  N            N            N         N mm          mm         MPa           % "
             "          %        mm2        %\n";
    }
  } // namespace


  FigureTable
  case_table(const std::vector<ContactCase> &cases, const std::vector<CaseResult> &results)
  {
    FigureTable table;
    table.add_columns(
      "case 1, line 1, normal_force_N N, longitudinal_force_N N, tangential_lateral_force_N N, "
      "spin_moment_Nm Nm, approach_m m, max_pressure_Pa Pa, max_shear_traction_Pa Pa, creepage 1, "
      "lateral_creepage 1, shift_m m, lateral_shift_m m, spin_per_m 1/m, area_of_whole_elements_m2 m2, "
      "stick_fraction 1, max_temperature_C C, converged 1");
    for (std::size_t k = 0; k < cases.size(); ++k)
      if (results[k].solved)
        {
          const HalfspaceSolution &s     = results[k].solved->solution;
          const bool               shift = cases[k].digits.motion == 1;
          const double             none  = Summary::none;
          table.add_row({double(k + 1),
                         double(cases[k].line),
                         s.fn,
                         s.fx,
                         s.fy,
                         s.spin_moment,
                         s.approach,
                         s.peak_pressure,
                         s.peak_shear,
                         shift ? none : s.xi,
                         shift ? none : s.eta,
                         shift ? s.xi : none,
                         shift ? s.eta : none,
                         shift ? none : s.phi,
                         s.area,
                         s.area > 0 ? s.adhesion_area / s.area : none,
                         hottest(s),
                         s.converged() ? 1. : 0.});
        }
    return table;
  }


  FigureTable
  point_table(const std::vector<CaseResult> &results)
  {
    FigureTable table;
    table.add_columns(
      "case 1, patch 1, block 1, x_m m, y_m m, z_m m, mean_stress_Pa Pa, von_mises_stress_Pa Pa, "
      "tresca_stress_Pa Pa, principal_1_Pa Pa, principal_2_Pa Pa, principal_3_Pa Pa, stress_xx_Pa Pa, "
      "stress_yy_Pa Pa, stress_zz_Pa Pa, stress_xy_Pa Pa, stress_xz_Pa Pa, stress_yz_Pa Pa");
    const auto add = [&](const std::size_t                            number,
                         const std::size_t                            patch,
                         const std::vector<std::vector<PointStress>> &blocks) {
      for (std::size_t b = 0; b < blocks.size(); ++b)
        for (const PointStress &p : blocks[b])
          table.add_row({double(number),
                         double(patch),
                         double(b + 1),
                         p.x,
                         p.y,
                         p.z,
                         p.mean(),
                         p.stress.von_mises(),
                         p.principal[0] - p.principal[2],
                         p.principal[0],
                         p.principal[1],
                         p.principal[2],
                         p.stress.xx,
                         p.stress.yy,
                         p.stress.nn,
                         p.stress.xy,
                         p.stress.xn,
                         p.stress.yn});
    };
    for (std::size_t k = 0; k < results.size(); ++k)
      if (results[k].solved)
        add(k + 1, 1, results[k].solved->points);
      else if (results[k].wheel_rail)
        for (std::size_t patch = 0; patch < results[k].wheel_rail->patches.size(); ++patch)
          add(k + 1, patch + 1, results[k].wheel_rail->patches[patch].points);
    return table;
  }

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
      return s.fn > 0 && s.grid.mx > 1 && s.grid.my > 1 && elements_across(s) < 8;
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
      const auto doubt = [&](const bool is, const std::string &sentence) {
        if (is)
          summary.doubts += (summary.doubts.empty() ? "" : " ") + sentence;
      };
      const std::string cut    = cases_that_are(cut_off, 0, results),
                        coarse = cases_that_are(is_coarse, 0.1, results);
      doubt(poor > 0, "Cases were not solved to their tolerance: see column converged of the tables.");
      doubt(!cut.empty(),
            "The contact reaches the edge of the grid in case" + cut +
              ": what lies beyond carries nothing; take a larger grid.");
      doubt(!coarse.empty(),
            "Fewer than eight elements lie across the contact in case" + coarse + "; take smaller ones.");
      summary.verdict = !summary.doubts.empty()       ? "not trusted"
                        : wheel_rail + simplified > 0 ? "with care"
                                                      : summary.verdict;
      doubt(wheel_rail > 0 && summary.verdict == "with care",
            "Wheel and rail are half-spaces, as in CONTACT; true bodies differ (--bodies real).");
      doubt(simplified > 0 && summary.verdict == "with care",
            "FASTSIM (M = 2, 3) is an approximation, of forces to some 10 %.");
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
