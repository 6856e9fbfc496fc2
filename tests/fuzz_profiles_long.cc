// label: long
// Many mutants of profile files.

#include "fuzz_profiles.h"

BOOST_AUTO_TEST_CASE(fuzz_profiles_12000)
{
  test::fuzz_profiles(12000);
}
