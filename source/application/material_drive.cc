#include <wheelrail/application/material_drive.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/quantity.h>

#include <cstddef>
#include <string>

namespace wheelrail
{
  namespace
  {
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
        for (const char *component : component_names)
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

    /// What the target asks for: "S_xx = 800 MPa", "E_xx = 0.01".
    std::string
    asked_by(const PointTarget &target)
    {
      std::string text;
      for (std::size_t k = 0; k < 6; ++k)
        if (target.value[k] != 0)
          text += (text.empty() ? "" : ", ") + std::string(target.of_stress[k] ? "S_" : "E_") +
                  component_names[k] + " = " +
                  (target.of_stress[k] ? format_number(std::round(1e-4 * target.value[k]) / 100) + " MPa"
                                       : about(target.value[k]));
      return text;
    }

    void
    go_to(MaterialPoint &point, const PointTarget &part, const PointTarget &target)
    {
      try
        {
          point.go_to(part);
        }
      catch (const RunError &error)
        {
          const std::string asked = asked_by(target);
          throw RunError(
            error.what() +
            std::string(asked.empty() ? "" : " (at " + asked_by(part) + ", on the way to " + asked + ")") +
            "; ask for less, or for strains");
        }
      for (std::size_t k = 0; k < 3; ++k)
        if (!(point.strain()[k] > -0.5))
          throw RunError("Material test: the strain comes to " + about(point.strain()[k]) + ", where " +
                         asked_by(part) + "; a Green strain of -0.5 is a length of zero: ask for less");
    }

    /// Goes from one target to the next in even steps.
    void
    go(MaterialPoint     &point,
       const PointTarget &target,
       const unsigned int steps,
       const unsigned int number,
       const unsigned int rows,
       MaterialCycle     &cycle,
       FigureTable       &table)
    {
      const SixNumbers   strain = point.strain(), stress = point.stress();
      const unsigned int every = rows == 0 ? steps + 1 : std::max(1u, steps / rows);
      PointTarget        part  = target;
      for (unsigned int n = 1; n <= steps; ++n)
        {
          leave_if_interrupted();
          for (std::size_t k = 0; k < 6; ++k)
            {
              const double from = target.of_stress[k] ? stress[k] : strain[k];
              part.value[k]     = n == steps ? target.value[k] : from + (target.value[k] - from) * n / steps;
            }
          go_to(point, part, target);
          cycle.add(point);
          if (n % every == 0 || (n == steps && rows > 0))
            add_step(table, number, point);
        }
    }

    /// By which part of itself, or of a hundredth of its range, a value differs.
    double
    difference(const double a, const double b, const double range)
    {
      const double scale = std::max({std::abs(a), std::abs(b), 0.01 * range});
      return scale > 0 ? std::abs(a - b) / scale : 0;
    }

    double
    difference(const std::vector<MaterialCycle> &a, const std::vector<MaterialCycle> &b)
    {
      const MaterialCycle &x = a.back(), &y = b.back();
      double               most  = difference(x.accumulated, y.accumulated, 0);
      const auto           judge = [&](Extent MaterialCycle::*member, const bool ratchets) {
        const Extent &p = x.*member, &q = y.*member;
        const double  range = q.high - q.low, size = std::max(std::abs(q.low), std::abs(q.high));
        most = std::max({most, difference(p.low, q.low, 100 * size), difference(p.high, q.high, 100 * size)});
        if (ratchets && a.size() > 1)
          most = std::max(most,
                          difference(p.mean() - (a[a.size() - 2].*member).mean(),
                                     q.mean() - (b[b.size() - 2].*member).mean(),
                                     range));
      };
      judge(&MaterialCycle::axial_strain, true);
      judge(&MaterialCycle::shear_strain, true);
      judge(&MaterialCycle::axial_stress, false);
      judge(&MaterialCycle::shear_stress, false);
      return most;
    }
  } // namespace


  void
  MaterialCycle::add(const MaterialPoint &point)
  {
    axial_strain.add(point.strain()[0]);
    axial_stress.add(point.stress()[0]);
    shear_strain.add(2 * point.strain()[5]);
    shear_stress.add(point.stress()[5]);
    accumulated = point.accumulated();
    work        = point.plastic_work();
    stored      = point.hardening_energy();
  }


  MaterialAnswer
  drive_material(const MaterialLaw              &law,
                 const std::vector<PointTarget> &path,
                 const unsigned int              cycles,
                 const unsigned int              steps,
                 const unsigned int              rows)
  {
    MaterialPoint  point(law);
    MaterialAnswer answer{std::vector<MaterialCycle>(cycles), step_table()};
    for (unsigned int i = 0; i < cycles; ++i)
      for (const PointTarget &target : path)
        go(point, target, steps, i + 1, rows, answer.cycles[i], answer.steps);
    return answer;
  }


  FigureTable
  cycle_table(const std::vector<MaterialCycle> &cycles)
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
        const MaterialCycle &c = cycles[i], &before = cycles[i > 0 ? i - 1 : 0];
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


  unsigned int
  enough_material_steps(const MaterialLaw              &law,
                        const std::vector<PointTarget> &path,
                        const unsigned int              cycles)
  {
    constexpr double       aim = 1e-3, room = 0.8;
    constexpr unsigned int least = 200, most = 100000, first_cycles = 5;
    const auto             answer = [&](const unsigned int steps) {
      return drive_material(law, path, std::min(cycles, first_cycles), steps, 0).cycles;
    };
    for (unsigned int steps = 2 * least; steps < most;)
      {
        const double missing = difference(answer(steps / 2), answer(steps));
        if (missing < aim)
          return missing < 0.5 * aim ? steps / 2 : steps;
        steps = 2 * static_cast<unsigned int>(
                      std::min(std::ceil(0.5 * steps * missing / (room * aim)), 0.5 * most));
      }
    return most;
  }
} // namespace wheelrail
