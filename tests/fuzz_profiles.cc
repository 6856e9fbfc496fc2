// label: fast

// Some hundred mutants of profile files; fuzz_profiles_long.cc has many more.

#include "fuzz_profiles.h"

BOOST_AUTO_TEST_CASE(fuzz_profiles_300)
{
  test::fuzz_profiles(300);
}
