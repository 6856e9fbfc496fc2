// label: long
// Many mutants of parameter files.

#include "fuzz_input.h"

BOOST_AUTO_TEST_CASE(fuzz_input_10000)
{
  test::fuzz_input(10000);
}
