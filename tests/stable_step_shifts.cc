// label: long

// The table of stable_step, at more lateral shifts.

#include "parallel.h"
#include "stable_step.h"


BOOST_FIXTURE_TEST_CASE(stable_step_shifts, test::Parallel)
{
  test::check_step(1e-3, 1e-3, 0.87);
  test::check_step(-2e-3, 1e-3, 0.87);
  test::check_step(-3.5e-3, 1e-3, 0.75);
}
