// Some hundred mutants of parameter files; fuzz_input_long.cc has many more.

#include "fuzz_input.h"

BOOST_AUTO_TEST_CASE(fuzz_input_400)
{
  test::fuzz_input(400);
}
