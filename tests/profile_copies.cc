// needs: sections
// label: fast

// Copies of profile files in the output folder, which a scene finds again.

#include <wheelrail/model/profile_copies.h>

#include "near.h"
#include "slices_files.h"

#include <filesystem>
#include <fstream>

using namespace wheelrail;
using namespace test;

namespace
{
  BOOST_AUTO_TEST_CASE(test_copies)
  {
    namespace fs = std::filesystem;
    fs::remove_all("kept");
    fs::create_directories("kept/here");
    std::ofstream("kept/same.txt") << "a profile";
    Scene scene;
    scene.wheel_profile = "kept/same.txt";
    keep_profiles(scene, "kept/here");
    scene.rail_profile = "kept/same.txt";
    BOOST_TEST(
      (fs::exists("kept/here/profiles/wheel_same.txt") && !fs::exists("kept/here/profiles/rail_54E1")),
      "a file is kept, a standard profile needs no copy");
    fs::remove("kept/same.txt");
    use_kept_profiles(scene, "kept/here");
    BOOST_TEST((scene.wheel_profile == "kept/here/profiles/wheel_same.txt"), "the copy is used");
    BOOST_TEST((scene.rail_profile == "kept/same.txt"), "without a copy the entry stays");
  }

  /// What a run that is gone on with has to find as it was: one rule for profiles and motion.
  BOOST_AUTO_TEST_CASE(test_changes)
  {
    std::filesystem::create_directories("kept/changed");
    Scene scene;
    scene.rail_profile = "kept/rail.txt";
    scene.motion       = "kept/motion.csv";
    const auto write   = [](const char *path, const char *text) { std::ofstream(path) << text; };
    write("kept/rail.txt", "a rail");
    write("kept/motion.csv", "a motion");
    BOOST_TEST(same_text(
      changed_since_start(scene, "kept/changed"), "", "without copies nothing is known to have changed"));
    keep_profiles(scene, "kept/changed");
    BOOST_TEST(same_text(changed_since_start(scene, "kept/changed"), "", "all is as it was"));
    write("kept/motion.csv", "another motion");
    BOOST_TEST(same_text(
      changed_since_start(scene, "kept/changed"),
      "Wheelset/Motion = kept/motion.csv: this file has changed since the run began, which has kept it as "
      "kept/changed/profiles/motion_motion.csv; set it back to that, or start anew in another Output/Folder",
      "a motion that has changed"));
    write("kept/rail.txt", "another rail");
    BOOST_TEST(changed_since_start(scene, "kept/changed")
                   .find("Profiles/Rail = kept/rail.txt: this file has changed") == 0,
               "a rail that has changed");
    scene              = Scene();
    scene.rail_profile = "kept/even.slcs";
    write_slices("kept/even.slcs", "section.txt", 0, 100);
    write_points("kept/section.txt", head_points());
    keep_profiles(scene, "kept/changed");
    use_kept_profiles(scene, "kept/changed");
    BOOST_TEST(same_text(scene.rail_profile, "kept/even.slcs", "slices stay where they are"));
    BOOST_TEST(same_text(changed_since_start(scene, "kept/changed"), "", "and are as they were"));
    write("kept/section.txt", "0 0\n1 0\n2 0\n3 0\n");
    BOOST_TEST(same_text(
      changed_since_start(scene, "kept/changed"),
      "Profiles/Rail = kept/even.slcs: this file or one of its slices has changed since the run "
      "began, which has kept it as kept/changed/profiles/rail_even.slcs.txt; set it back to that, or "
      "start anew in another Output/Folder",
      "a slice that has changed"));
  }
} // namespace
