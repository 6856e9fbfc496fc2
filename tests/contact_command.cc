// label: fast

// The command contact: rows of its cases, what it refuses, its table, exit codes and messages.

#include "contact_inputs.h"

#include <wheelrail/base/errors.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/contactfiles/contact_command.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

using namespace wheelrail;
using test::basic;
using test::replaced;
using test::same_text;

namespace
{
  /// Exit code of a call, and its screen or message.
  std::pair<int, std::string>
  call(const std::string &file, const int only = 0)
  {
    std::ostringstream out;
    try
      {
        const int code = run_contact_command({file, only}, out);
        return {code, out.str()};
      }
    catch (const InputError &error)
      {
        return {1, error.what()};
      }
  }

  bool
  holds(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace


BOOST_AUTO_TEST_CASE(contact_command)
{
  std::filesystem::remove_all("output");
  const std::string given = std::string(WHEELRAIL_TEST_DIR) + "/contact_files/basic.inp";
  const auto        all   = call(given);
  BOOST_TEST(
    (all.first == 0 && holds(all.second, "\n    23 ") && holds(all.second, "Tables in output/basic-contact")),
    "all cases are solved");
  const std::string cut = "he contact reaches the edge of the grid",
                    why = "T" + cut + " in case 9: what lies beyond carries nothing; take a larger grid.";
  BOOST_TEST((holds(all.second, "warning: case 9: t" + cut + "\n") &&
              holds(all.second, "\nverdict: not trusted: " + why + "\n")),
             "a grid that cuts a contact off is no verdict but not trusted");
  const std::string summary = read_whole_file("output/basic-contact/summary.json");
  BOOST_TEST((holds(summary, why) && holds(summary, "\"trusted\": false")),
             "so the summary, and thus the page");
  const std::string table = read_whole_file("output/basic-contact/cases.csv");
  BOOST_TEST(
    (table.rfind("case,line,normal_force_N,longitudinal_force_N,tangential_lateral_force_N,", 0) == 0 &&
     holds(table, "\n1,6,35780,6955.4") && holds(table, "\n23,")),
    "the table has a row of each");
  const auto third = call(given, 13);
  BOOST_TEST((third.first == 0 && holds(third.second, "\n    13 ") && !holds(third.second, "\n    12 ") &&
              holds(third.second, "\nverdict: trusted\n")),
             "one case alone, which the grid holds");
  BOOST_TEST(same_text(
    call(given, 24).second, "--case 24: " + given + " has cases 1 to 23", "a case that is not there"));

  std::ofstream("coarse.inp")
    << "3 MODULE\n203110\n022020\n0001211\n999 200 50 1 1e-6\n1e5 0.5 0 0\n0.5 0.5\n"
       "0d 5 3e4\n0.3 0.3 8e4 8e4\n1\n5 5 -12.5 -12.5 5 5\n1 1\n"
       "1.087e-3 0 1.667e-3 0 0 0\n0 MODULE\n";
  BOOST_TEST(
    holds(call("coarse.inp").second,
          "\nverdict: not trusted: Fewer than eight elements lie across the contact in case 1; take smaller "
          "ones.\n"),
    "three elements across a contact");

  std::ofstream("fastsim.inp") << "3 MODULE\n233100\n022320\n0001211\n999 200 50 1 1e-6\n82000 0 -0.000625 "
                                  "0.000625\n0.3 0.3\n0 0.4 3e4\n0.28 0.28 82000 "
                                  "82000\n1 1 1\n-3\n44 44 8 4 1.1\n0 MODULE\n";
  BOOST_TEST(holds(call("fastsim.inp").second,
                   "\nverdict: with care: FASTSIM (M = 2, 3) is an approximation, of forces to some 10 %.\n"),
             "simplified theory");

  std::filesystem::remove_all("output");
  std::ofstream("some.inp") << replaced(basic, "0.4013  0.4013 ", "0.4013 0.4013 0.5 ");
  const auto some = call("some.inp");
  BOOST_TEST((some.first == 2 && holds(some.second, "\n1 of 3 cases are not computed:\nsome.inp:") &&
              holds(some.second, "note: some.inp:8: the numbers from 0.5 on are not read")),
             "a file of which some cases are refused");
  std::filesystem::remove_all("output");
  test::make_profiles();
  std::ofstream("none.inp") << test::wheel_rail;
  const auto none = call("none.inp");
  BOOST_TEST((none.first == 1 && holds(none.second, "rail of 54.prr")), "a profile that is none is refused");
  std::string only_checked = replaced(basic, "0001341", "0001343");
  only_checked.resize(only_checked.find("% Case 2"));
  std::ofstream("checked.inp") << only_checked << " 0 MODULE\n";
  BOOST_TEST(same_text(call("checked.inp").second,
                       "checked.inp has no case to compute: R = 2 and 3 only check",
                       "cases that are only checked"));
  BOOST_TEST(!std::filesystem::exists("output"), "bad input leaves no folder");
}
