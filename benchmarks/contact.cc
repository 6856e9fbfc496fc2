// Speed against error of the contact: Hertz's contacts over cell size and penalty scale.
//   ./benchmark_contact [smallest cell in mm, default 1]

#include "scenes/hertz_scene.h"

#include <cstdlib>
#include <iostream>

int
main(int argc, char **argv)
{
  using namespace scenes;
  Program      program(argc, argv);
  const double smallest = argc > 1 ? 1e-3 * std::atof(argv[1]) : 1e-3;
  std::cout << hertz_row(HertzShape::point, 0, 0, nullptr) << std::endl;
  for (const HertzShape shape : {HertzShape::point, HertzShape::ellipse, HertzShape::line})
    for (double cell = 2e-3; cell > 0.99 * smallest; cell /= 2)
      for (const double scale : {0.1, 0.3, 1., 3., 10., 30.})
        {
          const HertzRun run = run_hertz(shape, cell, scale);
          std::cout << hertz_row(shape, cell, scale, &run) << std::endl;
        }
}
