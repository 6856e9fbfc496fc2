// The stable time step of the refined meshes: the finest cells below the strip govern it, or come close
// to doing so, and not thin cells of the blocks beside it. Other lateral shifts: stable_step_shifts.

#include "stable_step.h"
#include "parallel.h"


BOOST_FIXTURE_TEST_CASE(stable_step, test::Parallel)
{
  test::check_step(0, 1e-3, 0.96);
  test::check_step(0, 2e-3, 0.96);
  test::check_step(3.5e-3, 2e-3, 0.96);
  test::check_step(-5.5e-3, 1e-3, 0.75);
}
