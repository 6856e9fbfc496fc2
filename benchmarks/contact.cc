// Speed against error of the contact: Hertz's contacts over cell size and penalty scale.
//   ./benchmark_contact [smallest cell in mm, default 1] [table.csv]
// benchmarks/plot_contact.py draws the table.

#include <deal.II/base/mpi.h>

#include "scenes/hertz_scene.h"

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace
{
  using namespace scenes;

  void
  run(const HertzShape shape, const double cell, const double scale, const bool filter, std::ostream &table)
  {
    const HertzRun    run     = run_hertz(shape, cell, scale, filter);
    const char *const names[] = {"point", "ellipse", "line"};
    std::cout << hertz_row(shape, cell, scale, &run) << (filter ? "" : "  no filter") << std::endl;
    table << names[int(shape)] << "," << (filter ? "consistent" : "none") << "," << 1e3 * cell << ","
          << scale;
    for (const double error : {run.peak, run.approach, run.area, run.mises, run.depth})
      table << "," << 100 * error;
    table << "," << run.elements << "," << run.steps << "," << run.seconds << std::endl;
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const double                                   smallest = argc > 1 ? 1e-3 * std::atof(argv[1]) : 1e-3;
  std::ofstream                                  table;
  if (argc > 2)
    table.open(argv[2]);
  table
    << "shape,filter,cell_mm,scale,peak_percent,approach_percent,area_percent,mises_percent,depth_percent,"
       "elements,steps,cpu_s\n";
  std::cout << hertz_row(HertzShape::point, 0, 0, nullptr) << std::endl;
  for (const HertzShape shape : {HertzShape::point, HertzShape::ellipse, HertzShape::line})
    for (double cell = 2e-3; cell > 0.99 * smallest; cell /= 2)
      {
        for (const double scale : {0.1, 0.3, 1., 3., 10., 30.})
          run(shape, cell, scale, true, table);
        run(shape, cell, 10, false, table);
      }
}
