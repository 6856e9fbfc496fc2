// label: fast

// Some hundred mutants of profile files; fuzz_profiles_long.cc has many more.

#include "fuzz_profiles.h"

int
main(int argc, char **argv)
{
  return test::fuzz_profiles(argc, argv, 300);
}
