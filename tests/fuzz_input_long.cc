// label: long
// Many mutants of parameter files.

#include "fuzz_input.h"

int
main(int argc, char **argv)
{
  return test::fuzz_input(argc, argv, 10000);
}
