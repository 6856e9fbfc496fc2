// label: fast

// Line ends of LF, CR LF and CR: the same lines, also after a comment.

#include "near.h"

#include <wheelrail/base/read_file.h>
#include <wheelrail/input/flat_input.h>

#include <string>

using namespace wheelrail;
using test::same_text;

namespace
{
  std::string
  with_ends(const std::string &text, const std::string &end)
  {
    std::string result;
    for (const char c : text)
      result += c == '\n' ? end : std::string(1, c);
    return result;
  }
} // namespace


BOOST_AUTO_TEST_CASE(line_ends)
{
  BOOST_TEST(
    same_text(with_line_feeds("a\r\nb\rc\nd\r\re\n\rf\r"), "a\nb\nc\nd\n\ne\n\nf\n", "all kinds mixed"));
  const std::string text =
    "# a scene\nsubsection Wheelset\n  set Velocity = 100 km/h # slower\n"
    "  set Traction coefficient = 0.1\nend\n";
  for (const char *end : {"\n", "\r\n", "\r"})
    {
      const FlatInput   input = flatten_input(with_ends(text, end), "scene.prm");
      const std::string what  = end[0] == '\n' ? "LF" : end[1] == '\n' ? "CR LF" : "CR";
      BOOST_REQUIRE_MESSAGE(input.problems.empty() && input.assignments.size() == 2,
                            what + ": two entries after a comment");
      BOOST_TEST(same_text(input.assignments[0].value, "100 km/h", what + ": value before a comment"));
      BOOST_TEST(same_text(input.assignments[1].place.text, "scene.prm:4", what + ": line"));
    }
}
