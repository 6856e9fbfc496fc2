#include <wheelrail/application/material_command.h>
#include <wheelrail/application/material_drive.h>
#include <wheelrail/application/material_path.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// The first cycles, then some, and the last one.
    void
    print_cycles(const std::vector<MaterialCycle> &cycles, std::ostream &out)
    {
      char line[200];
      out << "  cycle         axial strain [1e-3]              stress [MPa]         shear strain [1e-3]      "
             "        stress [MPa]   accumulated\n";
      std::size_t next = 1;
      for (std::size_t i = 1; i <= cycles.size(); ++i)
        if (i == next || i == cycles.size())
          {
            const MaterialCycle &c = cycles[i - 1];
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
          const MaterialCycle &last = cycles.back(), &before = cycles[cycles.size() - 2];
          std::snprintf(line,
                        sizeof(line),
                        "Ratcheting of the last cycle: axial %.6g, shear %.6g (1e-3)\n",
                        1e3 * (last.axial_strain.mean() - before.axial_strain.mean()),
                        1e3 * (last.shear_strain.mean() - before.shear_strain.mean()));
          out << line;
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
} // namespace wheelrail
