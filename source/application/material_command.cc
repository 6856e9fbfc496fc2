#include <wheelrail/application/material_command.h>
#include <wheelrail/application/material_path.h>
#include <wheelrail/application/report_script.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/model.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Extremes of a value over a cycle.
    struct Extent
    {
      double low = HUGE_VAL, high = -HUGE_VAL;

      void
      add(const double value)
      {
        low  = std::min(low, value);
        high = std::max(high, value);
      }
      double
      mean() const
      {
        return 0.5 * (low + high);
      }
    };

    /// What a cycle shows, shear strains as changes of the angle.
    struct Cycle
    {
      Extent axial_strain, axial_stress, shear_strain, shear_stress;
      double accumulated = 0, work = 0, stored = 0; ///< at its end

      void
      add(const MaterialPoint &point)
      {
        axial_strain.add(point.strain()[0]);
        axial_stress.add(point.stress()[0]);
        shear_strain.add(2 * point.strain()[5]);
        shear_stress.add(point.stress()[5]);
        accumulated = point.accumulated();
        work        = point.plastic_work();
        stored      = point.hardening_energy();
      }
    };

    /// The tables have stresses in MPa and energies in MJ/m3, as material laws are told.
    void
    add_column(FigureTable &table, const std::string &name, const bool in_mpa = false)
    {
      table.add(in_mpa ? name + "_MPa" : name, in_mpa ? "MPa" : "1", {});
    }

    void
    add_state_columns(FigureTable &table)
    {
      add_column(table, "accumulated");
      for (const char *energy : {"plastic_work_MJ_m3", "hardening_energy_MJ_m3"})
        table.add(energy, "MJ/m3", {});
    }

    FigureTable
    step_table()
    {
      FigureTable table;
      add_column(table, "cycle");
      for (const char *kind : {"E_", "S_", "Ep_"})
        for (const char *component : {"xx", "yy", "zz", "yz", "xz", "xy"})
          add_column(table, std::string(kind) + component, *kind == 'S');
      add_state_columns(table);
      return table;
    }

    void
    add_step(FigureTable &table, const unsigned int cycle, const MaterialPoint &point)
    {
      std::vector<double> row = {static_cast<double>(cycle)};
      row.insert(row.end(), point.strain().begin(), point.strain().end());
      for (const double stress : point.stress())
        row.push_back(1e-6 * stress);
      const SixNumbers plastic = point.plastic_strain();
      row.insert(row.end(), plastic.begin(), plastic.end());
      row.insert(row.end(),
                 {point.accumulated(), 1e-6 * point.plastic_work(), 1e-6 * point.hardening_energy()});
      table.add_row(row);
    }

    /// Ratcheting of a cycle: by how much the middle of the strains has moved since the one before.
    FigureTable
    cycle_table(const std::vector<Cycle> &cycles)
    {
      FigureTable table;
      add_column(table, "cycle");
      for (const std::string kind : {"axial", "shear"})
        {
          for (const char *figure : {"_strain_min", "_strain_max", "_ratcheting"})
            add_column(table, kind + figure);
          for (const char *figure : {"_stress_min", "_stress_max"})
            add_column(table, kind + figure, true);
        }
      add_state_columns(table);
      for (std::size_t i = 0; i < cycles.size(); ++i)
        {
          const Cycle &c = cycles[i], &before = cycles[i > 0 ? i - 1 : 0];
          table.add_row({i + 1.,
                         c.axial_strain.low,
                         c.axial_strain.high,
                         c.axial_strain.mean() - before.axial_strain.mean(),
                         1e-6 * c.axial_stress.low,
                         1e-6 * c.axial_stress.high,
                         c.shear_strain.low,
                         c.shear_strain.high,
                         c.shear_strain.mean() - before.shear_strain.mean(),
                         1e-6 * c.shear_stress.low,
                         1e-6 * c.shear_stress.high,
                         c.accumulated,
                         1e-6 * c.work,
                         1e-6 * c.stored});
        }
      return table;
    }

    /// The first cycles, then some, and the last one.
    void
    print_cycles(const std::vector<Cycle> &cycles, std::ostream &out)
    {
      char line[200];
      std::snprintf(line,
                    sizeof(line),
                    "%7s %27s %25s %27s %25s %13s\n",
                    "cycle",
                    "axial strain [1e-3]",
                    "stress [MPa]",
                    "shear strain [1e-3]",
                    "stress [MPa]",
                    "accumulated");
      out << line;
      std::size_t next = 1;
      for (std::size_t i = 1; i <= cycles.size(); ++i)
        if (i == next || i == cycles.size())
          {
            const Cycle &c = cycles[i - 1];
            std::snprintf(line,
                          sizeof(line),
                          "%7zu %12.4f to %11.4f %11.2f to %10.2f %12.4f to %11.4f %11.2f to %10.2f %13.5g\n",
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
            out << line;
            next = i < 5 ? i + 1 : 2 * i;
          }
      if (cycles.size() > 1)
        {
          const Cycle &last = cycles.back(), &before = cycles[cycles.size() - 2];
          std::snprintf(line,
                        sizeof(line),
                        "Ratcheting of the last cycle: axial %.6g, shear %.6g (1e-3)\n",
                        1e3 * (last.axial_strain.mean() - before.axial_strain.mean()),
                        1e3 * (last.shear_strain.mean() - before.shear_strain.mean()));
          out << line;
        }
    }

    /// Goes from one target to the next in even steps; what is driven another way than before starts from
    /// where it is.
    void
    go(MaterialPoint     &point,
       const PointTarget &target,
       const unsigned int steps,
       const unsigned int number,
       Cycle             &cycle,
       FigureTable       &table)
    {
      const SixNumbers strain = point.strain(), stress = point.stress();
      PointTarget      part = target;
      for (unsigned int n = 1; n <= steps; ++n)
        {
          for (std::size_t k = 0; k < 6; ++k)
            {
              const double from = target.of_stress[k] ? stress[k] : strain[k];
              part.value[k]     = n == steps ? target.value[k] : from + (target.value[k] - from) * n / steps;
            }
          point.go_to(part);
          cycle.add(point);
          add_step(table, number, point);
        }
    }
  } // namespace


  int
  run_material_command(const Scene &scene, const bool draws, std::ostream &out)
  {
    const MaterialTest            &test = scene.material_test;
    const std::vector<PointTarget> path = material_path(test);
    MaterialPoint point(material_law(test.body == Body::rail ? scene.rail_material : scene.wheel_material));
    std::vector<Cycle> cycles(test.cycles);
    FigureTable        steps = step_table();
    for (unsigned int i = 0; i < test.cycles; ++i)
      for (const PointTarget &target : path)
        go(point, target, test.steps, i + 1, cycles[i], steps);
    out << "Steel of the " << body_name(test.body) << ", " << test.cycles << " cycles, " << test.steps
        << " steps from value to value\n";
    print_cycles(cycles, out);

    const std::filesystem::path folder = folder_beside(scene.folder, "-material");
    replace_file((folder / "parameters.prm").string(), print_parameters(scene));
    steps.write_csv((folder / "material.csv").string());
    cycle_table(cycles).write_csv((folder / "cycles.csv").string());
    out << "Results in " << folder.string() << std::endl;
    if (draws)
      draw_results("material.py", folder.string());
    return 0;
  }
} // namespace wheelrail
