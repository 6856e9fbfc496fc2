#include <wheelrail/application/material_command.h>
#include <wheelrail/application/material_drive.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/tables/table.h>
#include <wheelrail/tables/text_rows.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>

namespace wheelrail
{
  namespace
  {
    /// The first cycles, then some, and the last one.
    void
    print_cycles(const std::vector<MaterialCycle> &cycles, std::ostream &out)
    {
      out << "  cycle         axial strain [1e-3]              stress [MPa]         shear strain [1e-3]      "
             "        stress [MPa]   accumulated\n";
      std::size_t next = 1;
      for (std::size_t i = 1; i <= cycles.size(); ++i)
        if (i == next || i == cycles.size())
          {
            const MaterialCycle &c = cycles[i - 1];
            out << text("%7zu %12.4f to %11.4f %11.2f to %10.2f %12.4f to %11.4f %11.2f to %10.2f %13.5g\n",
                        i,
                        1e3 * c.axial_strain.low,
                        1e3 * c.axial_strain.high,
                        1e-6 * c.axial_stress.low,
                        1e-6 * c.axial_stress.high,
                        1e3 * c.shear_strain.low,
                        1e3 * c.shear_strain.high,
                        1e-6 * c.shear_stress.low,
                        1e-6 * c.shear_stress.high,
                        c.accumulated);
            next = i < 5 ? i + 1 : 2 * i;
          }
      if (cycles.size() > 1)
        {
          const MaterialCycle &last = cycles.back(), &before = cycles[cycles.size() - 2];
          out << text("Ratcheting of the last cycle: axial %.6g, shear %.6g (1e-3)\n",
                      1e3 * (last.axial_strain.mean() - before.axial_strain.mean()),
                      1e3 * (last.shear_strain.mean() - before.shear_strain.mean()));
        }
    }

    void
    print_large_strains(const std::vector<MaterialCycle> &cycles, std::ostream &out)
    {
      constexpr double large = 0.1;
      double           most  = 0;
      for (const MaterialCycle &c : cycles)
        for (const Extent &strain : {c.axial_strain, c.shear_strain})
          most = std::max({most, std::abs(strain.low), std::abs(strain.high)});
      if (most > large)
        out
          << "note: strains up to " << about(most)
          << ": beyond some per cent Green's strains and the second stresses of Piola and Kirchhoff are not "
             "those that a testing machine shows\n";
    }

    /// A Green strain of -0.5 is a length of zero.
    void
    check_strains(const PointTarget &target, const std::string &where)
    {
      for (std::size_t k = 0; k < 3; ++k)
        if (!target.of_stress[k] && !(target.value[k] > -0.5))
          throw InputError(
            where + "a strain of " + format_number(target.value[k]) +
            "; strains are Green's, where -0.5 is a length of zero: more than -0.5 is accepted");
    }

    std::vector<PointTarget>
    read_path(const std::string &path)
    {
      constexpr std::size_t          n     = component_names.size();
      const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const char *const of : {"E_", "S_"})
          for (const char *const component : component_names)
            list.push_back(std::string(of) + component);
        return list;
      }();
      std::vector<TableColumn> known;
      for (std::size_t k = 0; k < 2 * n; ++k)
        known.push_back(
          {names[k].c_str(), k < n ? Dimension::none : Dimension::stress, -1e15, 1e15, "a number"});
      const Table table =
        read_table(path, known, {"rows of strains and stresses are needed", false, {}, "#", ""});
      for (std::size_t k = 0; k < n; ++k)
        if (table.find(k) && table.find(k + n))
          throw InputError(path + ": two columns for the component " + component_names[k] +
                           "; a strain and its stress cannot both be given");
      std::vector<PointTarget> targets(table.lines.size());
      for (std::size_t row = 0; row < targets.size(); ++row)
        {
          targets[row].of_stress.fill(true);
          for (std::size_t i = 0; i < table.known.size(); ++i)
            {
              targets[row].of_stress[table.known[i] % n] = table.known[i] >= n;
              targets[row].value[table.known[i] % n]     = table.columns[i][row];
            }
          check_strains(targets[row], place(path, table.lines[row]));
        }
      return targets;
    }

    /// Value k of some stations.
    void
    set_target(PointTarget      &target,
               const std::size_t component,
               const Stations   &stations,
               const std::size_t k)
    {
      if (stations.values.empty())
        return;
      const double value          = stations.values[std::min(k, stations.values.size() - 1)];
      target.of_stress[component] = stations.of_stress;
      target.value[component]     = component > 2 && !stations.of_stress ? value / 2 : value;
    }
  } // namespace


  int
  run_material_command(const Scene &scene, const bool draws, std::ostream &out)
  {
    const ResultFolder             held(scene.folder, "-material");
    const std::filesystem::path   &folder = held.path();
    const MaterialTest            &test   = scene.material_test;
    const std::vector<PointTarget> path   = material_path(test);
    const MaterialLaw              law =
      material_law(test.body == Body::rail ? scene.rail_material : scene.wheel_material);
    const bool             given  = test.steps > 0;
    const unsigned int     steps  = given ? test.steps : enough_material_steps(law, path, test.cycles);
    constexpr unsigned int rows   = 200;
    const MaterialAnswer   answer = drive_material(law, path, test.cycles, steps, given ? steps : rows);
    out << "Steel of the " << body_name(test.body) << ", " << test.cycles << " cycles, " << steps
        << " steps from value to value" << (given ? "" : ", as many as 0.1 % needs") << "\n";
    print_cycles(answer.cycles, out);
    print_large_strains(answer.cycles, out);

    replace_file((folder / "parameters.prm").string(), print_parameters(scene));
    answer.steps.write_csv((folder / "material.csv").string());
    cycle_table(answer.cycles).write_csv((folder / "cycles.csv").string());
    out << "Results in " << folder.string() << std::endl;
    if (draws)
      draw_results("material.py", folder.string());
    return 0;
  }


  std::vector<PointTarget>
  material_path(const MaterialTest &test)
  {
    const std::size_t a = test.axial.values.size(), s = test.shear.values.size();
    if (test.file != "none")
      {
        if (a + s > 0)
          throw InputError("Material test/File = " + test.file +
                           ": Axial and Shear say how to go, too; leave them out, or the file");
        return read_path(test.file);
      }
    if (a + s == 0)
      throw InputError(
        "Material test says nothing: set Material test/Axial, such as 0.01, -0.01 or 700 MPa, -500 "
        "MPa, or Shear, or File");
    if (a > 1 && s > 1 && a != s)
      throw InputError("Material test/Axial has " + std::to_string(a) + " values and Shear " +
                       std::to_string(s) + "; as many of both are needed, or a single one that is held");
    std::vector<PointTarget> targets(std::max(a, s));
    for (std::size_t k = 0; k < targets.size(); ++k)
      {
        targets[k].of_stress.fill(true);
        set_target(targets[k], 0, test.axial, k);
        set_target(targets[k], 5, test.shear, k);
        check_strains(targets[k], "Material test/Axial: ");
      }
    return targets;
  }
} // namespace wheelrail
