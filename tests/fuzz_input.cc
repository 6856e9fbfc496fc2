// Some hundred mutants of parameter files; fuzz_input_long.cc has many more.

#include "fuzz_input.h"

int
main(int argc, char **argv)
{
  return test::fuzz_input(argc, argv, 400);
}
