// label: fast

// The input for CONTACT: the control lines of an input that CONTACT has read, every element of the problem,
// and the problem read back from the text solves to the same.

#include "messages.h"
#include "quadratic_distance.h"

#include <wheelrail/base/format_text.h>
#include <wheelrail/contactfiles/contact_input.h>

#include <sstream>

using namespace wheelrail;
using test::near;
using test::quadratic_distance;
using test::same_text;

namespace
{
  /// A rolling ellipse with slip and distance in every element; creepage 0.1 %, or 25 kN given.
  HalfspaceProblem
  ellipse(const bool force_given)
  {
    HalfspaceProblem problem;
    problem.grid                     = centred_grid(7e-3, 6e-3, 0.5e-3, 0.5e-3);
    problem.undeformed_distance      = quadratic_distance(problem.grid, 0.46, 0.3);
    problem.normal_force             = 100e3;
    problem.velocity                 = 30;
    problem.longitudinal_force_given = force_given;
    problem.fx                       = -25e3;
    problem.xi                       = 1e-3;
    problem.rigid_slip_x = sampled_distance(problem.grid, [](double, double y) { return 0.1 * y; });
    problem.rigid_slip_y = sampled_distance(problem.grid, [](double x, double) { return -0.1 * x; });
    return problem;
  }

  /// Lines without comments, cut at the names behind the numbers.
  std::vector<std::vector<std::string>>
  read_lines(const std::string &text)
  {
    std::vector<std::vector<std::string>> lines;
    std::istringstream                    in(text);
    for (std::string line; std::getline(in, line);)
      if (line[0] != '%')
        {
          std::istringstream       words(line);
          std::vector<std::string> numbers;
          for (std::string word; words >> word && word.find_first_of("0123456789") < 2;)
            numbers.push_back(word);
          lines.push_back(numbers);
        }
    return lines;
  }

  std::string
  joined(const std::vector<std::string> &words)
  {
    std::string text;
    for (const std::string &word : words)
      text += (text.empty() ? "" : " ") + word;
    return text;
  }

  BOOST_AUTO_TEST_CASE(test_control_lines)
  {
    const auto                     lines = read_lines(contact_input(ellipse(true), "two lines\nof a title"));
    const std::vector<std::string> expected = split_list(
      "3, 203110, 022029, 0001211, 999 200 50 1 1e-06, 100000 -0.5 0 0, 0.5 0.5, 0d 0.5 30000, 0.3 0.3 "
      "80769.2308 80769.2308, 1, 29 25 -7.25 -6.25 0.5 0.5, 9 1");
    for (std::size_t i = 0; i < expected.size(); ++i)
      BOOST_TEST(same_text(joined(lines[i]), expected[i], "line " + std::to_string(i + 1)));
    BOOST_TEST(same_text(joined(lines.back()), "0", "last line"));
    const auto given = read_lines(contact_input(ellipse(false), ""));
    BOOST_TEST(same_text(joined(given[1]), "203100", "control digits with a creepage"));
    BOOST_TEST(same_text(joined(given[5]), "100000 0.001 0 0", "kinematics with a creepage"));
  }

  BOOST_AUTO_TEST_CASE(test_read_back)
  {
    HalfspaceProblem    problem = ellipse(true);
    const auto          before  = solve_rolling(problem);
    const auto          lines   = read_lines(contact_input(problem, "x"));
    std::vector<double> numbers;
    for (std::size_t i = 12; i + 1 < lines.size(); ++i)
      for (const std::string &word : lines[i])
        numbers.push_back(std::stod(word));
    const std::size_t n = problem.grid.size();
    BOOST_TEST(near(numbers.size(), 3 * n, 0, "numbers of the elements"));
    if (numbers.size() != 3 * n)
      return;
    for (std::size_t e = 0; e < n; ++e)
      {
        problem.undeformed_distance[e] = numbers[e] * 1e-3;
        problem.rigid_slip_x[e]        = numbers[n + 2 * e];
        problem.rigid_slip_y[e]        = numbers[n + 2 * e + 1];
      }
    const auto after = solve_rolling(problem);
    BOOST_TEST(near(after.peak_pressure / before.peak_pressure, 1, 1e-6, "peak pressure from the file"));
    BOOST_TEST(near(after.fy, before.fy, 1, "lateral force from the file"));
    BOOST_TEST(near(after.xi, before.xi, 1e-8, "creepage from the file"));
  }

  BOOST_AUTO_TEST_CASE(test_refused)
  {
    HalfspaceProblem problem = ellipse(true);
    problem.friction         = {0.5, FrictionKind::exponential, 0.4, 0.05};
    BOOST_TEST(same_text(test::message_of([&]() { contact_input(problem, "x"); }),
                         "--contact-input writes constant friction only: set Contact/Friction law = constant",
                         "friction over speed"));
  }
} // namespace
