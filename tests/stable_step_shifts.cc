// label: long

// The table of stable_step, at more lateral shifts.

#include "parallel.h"
#include "stable_step.h"

int
main(int argc, char **argv)
{
  test::Parallel parallel(argc, argv);
  test::check_step(1e-3, 1e-3, 0.87);
  test::check_step(-2e-3, 1e-3, 0.87);
  test::check_step(-3.5e-3, 1e-3, 0.75);
  return parallel.report();
}
