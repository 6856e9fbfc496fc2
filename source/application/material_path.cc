#include <wheelrail/application/material_path.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/file_kind.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/base/shown_text.h>
#include <wheelrail/base/split_list.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>

namespace wheelrail
{
  namespace
  {
    /// What a column of a file drives.
    struct Column
    {
      std::size_t component = 0;
      bool        of_stress = false;
    };

    Column
    column_of(const std::string &name, const std::string &where)
    {
      for (std::size_t k = 0; k < component_names.size(); ++k)
        {
          if (name == std::string("E_") + component_names[k])
            return {k, false};
          if (name == std::string("S_") + component_names[k] + "_MPa")
            return {k, true};
        }
      throw InputError(
        where + "\"" + shown_text(name) +
        "\" is no column; names are E_xx, E_yy, E_zz, E_yz, E_xz, E_xy and S_xx_MPa, ... S_xy_MPa");
    }

    double
    number(const std::string &text, const std::string &where)
    {
      try
        {
          return parse_quantity(text, Dimension::none);
        }
      catch (const InputError &)
        {
          throw InputError(where + "\"" + shown_text(text) + "\" is no number");
        }
    }

    std::vector<Column>
    columns_of(const std::vector<std::string> &names, const std::string &where)
    {
      std::vector<Column> columns;
      for (const std::string &name : names)
        {
          columns.push_back(column_of(name, where));
          for (std::size_t i = 0; i + 1 < columns.size(); ++i)
            if (columns[i].component == columns.back().component)
              throw InputError(where + "two columns for the component " +
                               component_names[columns[i].component] +
                               "; a strain and its stress cannot both be given");
        }
      return columns;
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
      if (const std::string other = other_than_a_file(path); !other.empty())
        throw InputError(path + ": " + other + "; rows of strains and stresses are needed");
      std::ifstream file(path);
      if (!file)
        throw InputError(path + ": the file cannot be read; rows of strains and stresses are needed");
      std::vector<PointTarget> targets;
      std::vector<Column>      columns;
      std::string              line;
      for (unsigned int n = 1; std::getline(file, line); ++n)
        {
          line.resize(std::min(line.size(), line.find('#')));
          std::replace(line.begin(), line.end(), '\r', ' ');
          std::replace(line.begin(), line.end(), '\t', ' ');
          if (line.find_first_not_of(' ') == std::string::npos)
            continue;
          const std::string              where = path + ":" + std::to_string(n) + ": ";
          const std::vector<std::string> words = split_list(line, ',');
          if (columns.empty())
            {
              columns = columns_of(words, where);
              continue;
            }
          if (words.size() != columns.size())
            throw InputError(where + std::to_string(words.size()) + " values for " +
                             std::to_string(columns.size()) + " columns");
          PointTarget target;
          target.of_stress.fill(true);
          for (std::size_t i = 0; i < words.size(); ++i)
            {
              target.of_stress[columns[i].component] = columns[i].of_stress;
              target.value[columns[i].component] = number(words[i], where) * (columns[i].of_stress ? 1e6 : 1);
            }
          check_strains(target, where);
          targets.push_back(target);
        }
      if (targets.empty())
        throw InputError(path + ": no rows; a line of names and rows of numbers are needed");
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
