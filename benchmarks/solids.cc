// Time over error of both elements at three mesh sizes: a pulse in a bar, a ball on a rigid plane, a thick
// sphere loaded beyond yield. Prints a table; with a file name as argument also writes it as CSV, which
// benchmarks/plot_solids.py draws.

#include <deal.II/base/mpi.h>

#include "scenes/ball_impact.h"
#include "scenes/pulse.h"
#include "scenes/shapes.h"
#include "scenes/vessel.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <vector>

using namespace scenes;

namespace
{
  struct Row
  {
    std::string scene, element;
    std::size_t cells;
    double      wall, cpu; ///< [s]
    double      error;     ///< relative
  };

  /// Measures what returns an error.
  Row
  measure(const std::string             &scene,
          const Setup                   &setup,
          const std::size_t              cells,
          const std::function<double()> &run)
  {
    const auto   start = std::chrono::steady_clock::now();
    const auto   cpu   = std::clock();
    const double error = run();
    Row          row{scene,
            form_name(setup),
            cells,
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            double(std::clock() - cpu) / CLOCKS_PER_SEC,
            std::abs(error)};
    std::printf("%-8s %-8s %8zu %10.3f %10.3f %10.4f\n",
                scene.c_str(),
                row.element.c_str(),
                cells,
                row.wall,
                row.cpu,
                100 * row.error);
    std::fflush(stdout);
    return row;
  }

  /// Displacements of a reflected pulse, root mean square error.
  Row
  bar(const Setup &setup, const unsigned int cells)
  {
    Bar bar{setup, cells, true, End::free};
    return measure("bar", setup, cells, [&] {
      return pulse_error(bar, {1e-3, 0.5 * bar_length / bar.speed()}, 0.5 * bar_length / cells / bar.speed());
    });
  }

  /// Largest force of a Hertzian impact.
  Row
  ball(const Setup &setup, const double size)
  {
    const BallCells cells{size, 0.9e-3, 1.3, 10 * size, 4, false};
    return measure("ball", setup, quarter_ball(0.01, cells).cells.size(), [&] {
      return ball_impact(setup, 4, cells).force - 1;
    });
  }

  /// Radial stress under load, largest error over the yield stress; plastic front at 0.14 m.
  Row
  sphere(Setup setup, const unsigned int radial)
  {
    setup.plasticity.yield_stress = 240e6;
    const Vessel    exact{3, setup.plasticity.yield_stress};
    const LocalMesh mesh = sphere_octant(inner_radius, outer_radius, radial, radial / 2, 1.5);
    return measure("sphere", setup, mesh.cells.size(), [&] {
      return load_vessel(setup, exact, mesh, 0.14).radial / setup.plasticity.yield_stress;
    });
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::vector<Row>                               rows;
  std::printf(
    "%-8s %-8s %8s %10s %10s %10s\n", "scene", "element", "cells", "wall [s]", "CPU [s]", "error [%]");
  for (const Setup &setup : each_form(Setup()))
    {
      for (const unsigned int cells : {50, 100, 200})
        rows.push_back(bar(setup, cells));
      for (const double size : {0.25e-3, 0.18e-3, 0.12e-3})
        rows.push_back(ball(setup, size));
      for (const unsigned int radial : {8, 12, 16})
        rows.push_back(sphere(setup, radial));
    }
  if (argc > 1)
    {
      std::ofstream file(argv[1]);
      file << "scene,element,cells,wall_s,cpu_s,error\n";
      for (const Row &row : rows)
        file << row.scene << "," << row.element << "," << row.cells << "," << row.wall << "," << row.cpu
             << "," << row.error << "\n";
      if (!file)
        {
          std::cerr << "The table could not be written to " << argv[1] << ".\n";
          return 1;
        }
    }
}
