// label: long
// Many mutants of profile files.

#include "fuzz_profiles.h"

int
main(int argc, char **argv)
{
  return test::fuzz_profiles(argc, argv, 12000);
}
