// What is said to be without effect in a command has none, all of it together; ready scenes have nothing of
// it.

#include "near.h"
#include "other_values.h"

#include <wheelrail/application/geometry_command.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/input/without_effect.h>
#include <wheelrail/vehicle/wheelset_contact.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  BOOST_AUTO_TEST_CASE(test_without_effect)
  {
    std::vector<std::string> sets;
    for (const auto &[path, value] : test::other_values())
      sets.emplace_back(path).append(" = ").append(value);
    const auto        told   = entries_without_effect(scene_from_text("", "x.prm", sets), "geometry");
    const std::string begin  = "without effect in geometry: ";
    const std::string unread = told.empty() ? "" : told.back().substr(begin.size());
    BOOST_TEST((unread.find("Wheelset/Velocity, ") != std::string::npos &&
                unread.find("Mesh/Solution cell size, ") != std::string::npos &&
                unread.find("Profiles") == std::string::npos),
               "geometry tells what it does not read");
    std::vector<std::string> without;
    for (const std::string &set : sets)
      if (unread.find(set.substr(0, set.find(" = ")) + ",") != std::string::npos)
        without.push_back(set);
    BOOST_TEST(without.size() > 100, std::to_string(without.size()) + " entries without effect in geometry");
    const auto answer = [](const Scene &scene) {
      std::ostringstream out;
      run_geometry_command(scene, read_profiles(scene), {0, 2e-3}, out);
      return out.str();
    };
    BOOST_TEST((answer(Scene()) == answer(scene_from_text("", "x.prm", without).scene)),
               "and the answer is the same");

    const auto left = entries_without_effect(
      scene_from_text("", "x.prm", {"Profiles/Wheel left = cone 1:40", "Contact/Friction decay = 0.5 s/m"}),
      "halfspace");
    BOOST_TEST((left ==
                std::vector<std::string>{
                  "Profiles/Wheel left = cone 1:40: without effect, since Wheelset/Wheels = one",
                  "Contact/Friction decay = 0.5 s/m: without effect, since Contact/Friction law = constant"}),
               "entries that another one leaves without effect");
    BOOST_TEST((entries_without_effect(
                  scene_from_text(
                    "", "x.prm", {"Wheel material/Steel = ER7", "Wheel material/Yield stress = 500 MPa"}),
                  "halfspace") ==
                std::vector<std::string>{
                  "Wheel material/Steel = ER7: without effect, since Wheel material/Yield stress = 500 MPa"}),
               "a yield stress stands in the place of that of a named steel");
    BOOST_TEST(entries_without_effect(
                 scene_from_text("", "x.prm", {"Profiles/Wheel left = cone 1:40", "Wheelset/Wheels = both"}),
                 "halfspace")
                 .empty(),
               "and that it does not");

    BOOST_TEST(
      (entries_without_effect(
         scene_from_text("", "x.prm", {"Half-space/Interface layer = 1 mm", "Half-space/Given spin = 1 1/m"}),
         "run") ==
       std::vector<std::string>{"without effect in run: Half-space/Given spin, Half-space/Interface "
                                "layer"}),
      "what half-spaces alone have, in a run");

    BOOST_TEST((entries_without_effect(
                  scene_from_text("", "x.prm", {"Wear/Grind to = 54E1", "Wear/Worn = wheel"}), "wear") ==
                std::vector<std::string>{"Wear/Grind to = 54E1: without effect, since Wear/Worn = wheel"}),
               "machines for what does not wear");

    MotionFile rows;
    rows.quantities = {MotionQuantity::yaw, MotionQuantity::creepage};
    BOOST_TEST((entries_under_rows(
                  scene_from_text("subsection Wheelset\n  set Yaw = 3 mrad\n  set Lateral shift = 1 mm\n"
                                  "  set Traction coefficient = 0.1\nend\n",
                                  "x.prm",
                                  {}),
                  rows,
                  "rows.csv") ==
                "without effect, since the rows of rows.csv have their own: Wheelset/Yaw (x.prm:2), "
                "Wheelset/Traction coefficient (x.prm:4)"),
               "entries that columns of rows replace");

    const auto of_study = [](const std::string &axes, const char *const more) {
      return entries_without_effect(
        scene_from_text("", "x.prm", {"Study/Axes = " + axes, "Study/Compute = halfspace", more}), "study");
    };
    BOOST_TEST(
      (of_study("Run/Rolling distance: 50 mm, 90 mm", "Wheelset/Axle = independent") ==
       std::vector<std::string>{"Wheelset/Axle = independent: without effect, since Wheelset/Wheels = one",
                                "without effect in halfspace: Run/Rolling distance"}),
      "an axis that its cases do not read");
    BOOST_TEST(
      of_study("Contact/Friction law: constant, exponential", "Contact/Friction decay = 0.5 s/m").empty(),
      "an entry that some cases read");

    // a file serves all commands
    namespace fs     = std::filesystem;
    unsigned int all = 0;
    for (const fs::directory_entry &file : fs::recursive_directory_iterator(WHEELRAIL_SOURCE_DIR "/prm"))
      if (file.path().extension() == ".prm")
        for (const std::string &command : split_list(
               "geometry, halfspace, vehicle, wear, receptance, material, compare, run, parameters, study"))
          {
            const auto notes = entries_without_effect(read_scene(file.path(), {}), command);
            BOOST_TEST(notes.empty(),
                       command + (" " + file.path().string()) + ": " +
                         (notes.empty() ? "no note" : notes.front()));
            ++all;
          }
    BOOST_TEST(all > 250, "all ready scenes");
  }
} // namespace
