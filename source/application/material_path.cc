#include <wheelrail/application/material_path.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/tables/table.h>
#include <wheelrail/tables/text_rows.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace wheelrail
{
  namespace
  {
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
