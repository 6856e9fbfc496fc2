// Copies of profile files in the output folder, which a scene finds again.

#include <wheelrail/model/profile_copies.h>

#include "check.h"

#include <filesystem>
#include <fstream>

using namespace wheelrail;
using namespace test;

namespace
{
  void
  test_copies()
  {
    namespace fs = std::filesystem;
    fs::remove_all("kept");
    fs::create_directories("kept/here");
    std::ofstream("kept/same.txt") << "a profile";
    Scene scene;
    scene.wheel_profile = "kept/same.txt";
    keep_profiles(scene, "kept/here");
    scene.rail_profile = "kept/same.txt";
    check(fs::exists("kept/here/profiles/wheel_same.txt") && !fs::exists("kept/here/profiles/rail_54E1"),
          "a file is kept, a standard profile needs no copy");
    fs::remove("kept/same.txt");
    use_kept_profiles(scene, "kept/here");
    check(scene.wheel_profile == "kept/here/profiles/wheel_same.txt", "the copy is used");
    check(scene.rail_profile == "kept/same.txt", "without a copy the entry stays");
  }
} // namespace

int
main()
{
  test_copies();
  return report();
}
