// label: fast

// doc/manual/parameters.md is what the program prints, and what it prints holds every entry.

#include "near.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/run/simulation.h>

#include <iostream>
#include <sstream>

using namespace wheelrail;
using test::same_text;

namespace
{
  /// The first line in which two texts differ, from both.
  void
  show_difference(const std::string &found, const std::string &expected)
  {
    std::istringstream a(found), b(expected);
    std::string        line_a, line_b;
    for (int number = 1; a || b; ++number)
      {
        line_a.clear();
        line_b.clear();
        std::getline(a, line_a);
        std::getline(b, line_b);
        if (line_a == line_b)
          continue;
        std::cout << "  line " << number << " of the file:    " << line_a << "\n  line " << number
                  << " of the program: " << line_b << std::endl;
        return;
      }
  }
} // namespace


BOOST_AUTO_TEST_CASE(page)
{
  const std::string expected = parameter_reference();
  const std::string found    = read_whole_file(WHEELRAIL_SOURCE_DIR "/doc/manual/parameters.md");
  BOOST_TEST((found == expected),
             "doc/manual/parameters.md is up to date (./wheelrail parameters --markdown > "
             "doc/manual/parameters.md renews it)");
  if (found != expected)
    show_difference(found, expected);

  for (const Entry &entry : entries())
    {
      if (entry.repeats || entry.section == "Wheel material")
        continue; // as the subsection with the number 1, or as Rail material
      const std::string heading =
        "\n## " + (entry.section.empty() ? "Outside all subsections" : entry.section) + "\n";
      const std::size_t begin = expected.find(heading), end = expected.find("\n## ", begin + 1);
      const std::string part = begin == std::string::npos ? "" : expected.substr(begin, end - begin);
      BOOST_TEST(
        (part.find("| " + entry.name + " | ") != std::string::npos &&
         part.find(" | " + printed_range(entry) + " | " + entry.meaning + " |") != std::string::npos),
        entry.path() + " stands in its section");
    }

  std::ostringstream out;
  const RunFunction  run = [](const Scene &, const SceneGeometry &, const RunOptions &) { return 0; };
  BOOST_TEST((execute({"parameters", "--markdown"}, run, out) == 0), "parameters --markdown");
  BOOST_TEST(same_text(out.str(), expected, "parameters --markdown prints the reference"));
}
