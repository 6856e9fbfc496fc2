// label: fast

// What the program answers to faulty slices of a rail along the track, word by word.

#include "messages.h"
#include "slices_files.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/sections/touching_places.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace wheelrail;
using test::message_of;
using test::same_text;

namespace
{
  /// A head of 40 mm with sides of 20 mm, `aside` to the field side and wider there by `wide` [mm].
  void
  write_section(const std::string &name, const double aside, const double wide = 0, const double mirror = 1)
  {
    std::ofstream out(name);
    for (int k = 0; k <= 20; ++k)
      out << mirror * (aside - 20 - 0.01 * (20 - k)) << ' ' << 20 - k << '\n';
    for (int k = 1; k <= 40; ++k)
      out << mirror * (aside - 20 + (40 + wide) * k / 40) << " 0\n";
    for (int k = 1; k <= 20; ++k)
      out << mirror * (aside + 20 + wide + 0.01 * k) << ' ' << k << '\n';
  }

  std::string
  slices(const std::vector<std::string> &sections,
         const std::string              &counts,
         const std::string              &features = "")
  {
    std::string text = "0 1 U_OFFSET U_SCALE\n" + std::to_string(sections.size()) + " NSLC\n" + counts +
                       " NFEAT NKINK NACCEL\n1 U_INTPOL\n";
    for (std::size_t k = 0; k < sections.size(); ++k)
      text += std::to_string(20 * k) + " '" + sections[k] + "'\n";
    return text + features;
  }

  void
  write(const std::string &name, const std::string &text)
  {
    std::ofstream(name) << text;
  }

  /// What the command geometry answers.
  std::string
  geometry(const std::vector<std::string> &sets, const std::string &places, std::string *printed = nullptr)
  {
    std::vector<std::string> words{"geometry"};
    if (!places.empty())
      words.insert(words.end(), {"--places", places});
    for (const std::string &set : sets)
      words.insert(words.end(), {"--set", set});
    const RunFunction  run = [](const Scene &, const SceneGeometry &, const RunOptions &) { return 0; };
    std::ostringstream out;
    std::string        message = message_of([&]() { execute(words, run, out); });
    if (printed != nullptr)
      *printed = out.str();
    return message;
  }

  void
  answers(const std::string &text, const std::string &expected)
  {
    write("faulty.slcs", text);
    BOOST_TEST(
      same_text(geometry({"Profiles/Rail = faulty.slcs"}, "10 mm"),
                "Profiles/Rail: faulty.slcs" + std::string(expected[0] == ':' ? "" : ": ") + expected,
                expected));
  }

  void
  test_features(const std::vector<std::string> &even)
  {
    const std::string three = "3 0 0", good = "0 0 40 999\n20 0 40 999\n40 0 40 999\n";
    answers(slices(even, three, good + "61 0 40 999\n80 0 40 999\n"),
            ": features of slice 4: the place 61 is not that of the slice in the list above");
    answers(
      slices(even, three, good + "60 0 -1 999\n80 0 40 999\n"),
      ": features of slice 4: feature 3 follows absent ones (-1); only leading and trailing features may be "
      "absent");
    answers(slices(even, three, good + "60 0 40 40\n80 0 40 999\n"),
            ": features of slice 4: feature 3 does not lie behind the one before");
    answers(slices(even, three, good + "60 -1 -1 -1\n80 0 40 999\n"),
            ": features of slice 4: all are absent (-1); leave the slice out");
    answers(slices(even, three, good + "60 0 90 999\n80 0 40 999\n"),
            "slice 4: feature 2 at 90 mm lies behind the end of the slice, 80.002 mm long; only the last "
            "feature may");
    answers(slices(even, three, good + "60 0 40 -1\n80 0 40 -1\n"),
            "a part that begins at slice 1 ends after 3; it needs at least 4 slices in a row");
    answers(slices(even, three, good), "ends before place and 3 features of slice 4");
  }

  void
  test_commands()
  {
    const std::string rail = "Profiles/Rail = good.slcs";
    BOOST_TEST(same_text(
      geometry({rail}, ""),
      "Profiles/Rail = good.slcs: slices along the track are for run, compare, and --places of geometry and "
      "halfspace; give a rail of one section",
      "slices without --places"));
    BOOST_TEST(same_text(geometry({}, "10 mm"),
                         "Profiles/Rail = 54E1: slices are needed, a file that ends in .slcs",
                         "a plain rail with --places"));
    BOOST_TEST(
      same_text(geometry({"Profiles/Rail = wheel.slcw"}, "10 mm"),
                "Profiles/Rail: wheel.slcw: slices of a wheel; a rail has them in a file that ends in .slcs",
                "slices of a wheel"));
    BOOST_TEST(same_text(
      geometry({rail, "Irregularity 1/Kind = dent"}, "10 mm"),
      "Profiles/Rail = good.slcs: rails by slices have no irregularities: leave the subsections Irregularity "
      "out",
      "irregularities"));
    BOOST_TEST(
      same_text(geometry({rail, "Wheelset/Roll = from contact"}, "10 mm"),
                "Wheelset/Roll = from contact: the rail of the other wheel is not known beside rails by "
                "slices; give an "
                "angle or none",
                "roll from contact"));
    BOOST_TEST(same_text(
      geometry({rail}, "90 mm"),
      "--places \"90 mm\": the wheel at 90 mm along the rail does not stand on the slices, which reach from "
      "0 mm to 80 mm; Profiles/Rail place is 0 mm",
      "a place beyond the slices"));
    BOOST_TEST(
      same_text(geometry({"Profiles/Rail = aside.slcs"}, "40 mm"),
                "wheel and rails by slices do not lie over each other: at this place and lateral shift no "
                "part of a rail "
                "is below the running surface of the wheel",
                "a rail beside the wheel"));
    const RunFunction  run = [](const Scene &, const SceneGeometry &, const RunOptions &) { return 0; };
    std::ostringstream out;
    BOOST_TEST(same_text(
      message_of([&]() {
        execute({"halfspace", "slices.prm"}, run, out);
      }),
      "slices.prm:2: Profiles/Rail = good.slcs: of slices along the track halfspace takes one wheel "
      "at places: "
      "give --places "
      "\"0:600:20 mm\"",
      "halfspace without --places"));
    const auto validated = [&](const std::vector<std::string> &sets) {
      std::vector<std::string> words{"run", "plain.prm", "--validate"};
      for (const std::string &set : sets)
        words.insert(words.end(), {"--set", set});
      return message_of([&]() { execute(words, run, out); });
    };
    BOOST_TEST(
      same_text(validated({"Profiles/Second rail = good.slcs"}),
                "--set: Profiles/Second rail = good.slcs: a second rail stands beside one by slices (.slcs); "
                "Profiles/Rail is 54E1",
                "a second rail beside a plain one"));
    BOOST_TEST(same_text(
      validated({"Profiles/Rail = before.slcs",
                 "Profiles/Rail unit = mm",
                 "Mesh/Solution cell size = 2 mm",
                 "Profiles/Second rail = thin.slcs",
                 "Profiles/Rail place = -100 mm"}),
      "--set: Profiles/Second rail = thin.slcs: its head is thinner than three cells, 6 mm, all along "
      "the path, or is not there; take a smaller Mesh/Solution cell size",
      "a nose thinner than three cells"));
    BOOST_TEST(
      same_text(validated({rail, "Profiles/Rail place = 50 mm", "Run/Rolling distance = 40 mm"}),
                "--set: Profiles/Rail place: the path from 50 mm to 90 mm along the rail leaves the slices, "
                "which reach from 0 mm to 80 mm; begin it elsewhere, or roll a shorter Run/Rolling "
                "distance",
                "a path that leaves the slices"));
    const std::string second = "Profiles/Second rail = behind.slcs", before = "Profiles/Rail = before.slcs",
                      place = "Profiles/Rail place = -24 mm";
    BOOST_TEST(same_text(
      validated({before, second, place, "Mesh/Solution cell size = 4 mm", "Mesh/Fine margin = 4 mm"}),
      "--set: Profiles/Second rail = behind.slcs: the gap of 2 mm in front of it is narrower than a "
      "cell; take Mesh/Solution cell size = 0.5 mm",
      "a gap narrower than a cell"));
    const auto noted = [&](const std::vector<std::string> &sets, const std::string &note) {
      out.str("");
      BOOST_TEST(same_text(validated(sets), "no message", note));
      BOOST_TEST((out.str().find(note) != std::string::npos), "is said: " + note);
    };
    noted({before, second, place},
          "Profiles/Second rail = behind.slcs: the gap of 2 mm in front of it is fewer than four cells wide: "
          "it ends up to half a cell off");
    noted(
      {"Profiles/Rail = before.slcs",
       "Profiles/Rail unit = mm",
       "Mesh/Solution cell size = 2 mm",
       "Profiles/Second rail = growing.slcs",
       "Profiles/Rail place = -150 mm"},
      "Profiles/Second rail = growing.slcs: what lies in front of -80 mm of it is cut off, where its head "
      "is "
      "thinner than three cells, 6 mm, 5 mm below its top");
    noted(
      {"Profiles/Rail = before.slcs", "Profiles/Second rail = beside.slcs", "Profiles/Rail place = -150 mm"},
      "Profiles/Second rail = beside.slcs: begins at -100 mm within reach of the wheel: its surface sinks "
      "there "
      "over 10 mm, and what the wheel does there is not that of a square end");
    noted(
      {"Profiles/Rail = before.slcs", "Profiles/Second rail = guard.slcs", "Profiles/Rail place = -150 mm"},
      "Profiles/Second rail = guard.slcs: the wheel comes nowhere near it on the path");
    BOOST_TEST(
      same_text(validated({"Profiles/Rail = before.slcs",
                           "Profiles/Second rail = hanging.slcs",
                           "Profiles/Rail place = -150 mm"}),
                "--set: Profiles/Second rail: hanging.slcs: the highest point of all slices is one of their "
                "ends: z points "
                "down; set Profiles/Rail upside down = yes for slices whose z points up",
                "a rail upside down"));
    BOOST_TEST(same_text(
      validated(
        {"Profiles/Rail = before.slcs", "Profiles/Second rail = gone.slcs", "Profiles/Rail place = -150 mm"}),
      "--set: Profiles/Second rail: gone.slcs:5: The file \"gone.txt\" cannot be read: No such file or "
      "directory.",
      "a slice of the second rail that is not there"));
    const std::string filled =
      "the section of the mesh is what both rails have where the path begins, filled up to 0.6 mm below the "
      "wheel; the body is 54E1 widened in its middle by ";
    BOOST_TEST((out.str().find(filled) != std::string::npos), "is said of these rails, too: " + filled);
    BOOST_TEST(same_text(validated({"Profiles/Rail = sinking.slcs"}), "no message", "a start on a slope"));
    const std::string sections = WHEELRAIL_SOURCE_DIR "/prm/sections/";
    const std::string size =
      " wide, and those of rails are 3 mm to 400 mm; set Profiles/Rail unit to that of its "
      "files, mm, m or inch";
    BOOST_TEST(same_text(validated({"Profiles/Rail = before.slcs", "Profiles/Rail unit = m"}),
                         "--set: Profiles/Rail: before.slcs: its widest slice is 70578.548 mm" + size,
                         "millimetres taken for metres"));
    BOOST_TEST(same_text(validated({"Profiles/Rail = before.slcs",
                                    "Profiles/Second rail = metres.slcs",
                                    "Profiles/Rail unit = mm",
                                    "Profiles/Rail place = -150 mm"}),
                         "--set: Profiles/Second rail: metres.slcs: its widest slice is 0.071 mm" + size,
                         "metres taken for millimetres"));
    const auto runs_into = [&](const std::string &place, const std::string &rail) {
      return "--set: Profiles/Rail: at " + place + " along the rails the flange runs into Profiles/" + rail +
             "; y of all slices should point to the field side (Profiles/Rail mirror); else move the wheel "
             "by "
             "Wheelset/Lateral shift, or roll a shorter Run/Rolling distance";
    };
    for (const std::string inclination : {"0", "1:40"})
      BOOST_TEST(same_text(validated({"Profiles/Rail = " + sections + "wing.slcs",
                                      "Profiles/Second rail = " + sections + "nose.slcs",
                                      "Profiles/Rail place = 360 mm",
                                      "Profiles/Rail mirror = yes",
                                      "Track/Rail inclination = " + inclination,
                                      "Mesh/Solution cell size = 2 mm",
                                      "Run/Rolling distance = 200 mm"}),
                           runs_into("360 mm", "Rail = " + sections + "wing.slcs"),
                           "both rails mirrored"));
    BOOST_TEST(same_text(validated({"Profiles/Rail = " + sections + "wing.slcs",
                                    "Profiles/Second rail = " + sections + "nose.slcs",
                                    "Profiles/Rail place = 360 mm",
                                    "Wheelset/Lateral shift = 5 mm",
                                    "Track/Rail inclination = 0",
                                    "Mesh/Solution cell size = 2 mm",
                                    "Run/Rolling distance = 120 mm"}),
                         "no message",
                         "a shift on a crossing, whose other wheel stands on a plain rail"));
    BOOST_TEST(same_text(validated({"Profiles/Rail = " + sections + "wing.slcs",
                                    "Profiles/Second rail = " + sections + "nose.slcs",
                                    "Profiles/Rail place = 360 mm",
                                    "Wheelset/Lateral shift = -5 mm",
                                    "Track/Rail inclination = 0",
                                    "Mesh/Solution cell size = 2 mm",
                                    "Run/Rolling distance = 120 mm"}),
                         runs_into("380 mm", "Second rail = " + sections + "nose.slcs"),
                         "a shift towards the nose"));
    BOOST_TEST(
      same_text(validated({"Profiles/Rail = " + sections + "wing.slcs",
                           "Profiles/Second rail = " + sections + "nose.slcs",
                           "Profiles/Rail place = 600 mm",
                           "Track/Rail inclination = 0",
                           "Mesh/Solution cell size = 2 mm",
                           "Run/Rolling distance = 120 mm"}),
                "--set: Profiles/Rail: at 690 mm along the rails the wheel stands on its field-side edge, "
                "54.25 mm beside the middle of the section, beyond the fine cells; end the path before, by a "
                "shorter Run/Rolling distance",
                "a path behind the end of the nose"));
    BOOST_TEST(same_text(
      validated({"Profiles/Rail = deep.slcs"}),
      "--set: Profiles/Rail = deep.slcs: between -100 mm and 160 mm its sections do not lie over each other "
      "5 mm on both sides of the contact, or are more than 12 mm apart: such a rail is for --places "
      "of geometry and halfspace",
      "sections far apart"));
    std::string printed;
    BOOST_TEST(same_text(
      geometry({"Profiles/Rail = jump.slcs"}, "90 mm", &printed), "no message", "away from a jump"));
    const std::string warning =
      "warning: jump.slcs: the arc length jumps from 80.002 mm to 120.002 mm between slices 2 "
      "and 3: no surface lies between them\n";
    BOOST_TEST((printed.find(warning) != std::string::npos), warning);
    BOOST_TEST(same_text(
      geometry({"Profiles/Rail = jump.slcs"}, "30 mm"),
      "jump.slcs: the place 30 mm lies between slices 2 and 3, where the arc length jumps from 80.002 mm to "
      "120.002 mm; features have to tell which part begins there",
      "at a jump"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(messages_slices)
{
  write_section("even.txt", 5);
  write_section("mirrored.txt", 5, 0, -1);
  write_section("wide.txt", 5, 40);
  write_section("aside.txt", 300);
  const std::vector<std::string> even(5, "even.txt");
  write("good.slcs", slices(even, "0 0 0"));
  write("wheel.slcw", slices(even, "0 0 0"));
  write("aside.slcs", slices(std::vector<std::string>(5, "aside.txt"), "0 0 0"));
  write("jump.slcs",
        slices({"even.txt", "even.txt", "wide.txt", "wide.txt", "wide.txt", "wide.txt"}, "0 0 0"));
  const auto head = [](const std::string &name, const double down) {
    std::vector<Point2> points = test::head_points();
    for (Point2 &p : points)
      p.y += down;
    test::write_points(name, points);
  };
  head("head.txt", 0);
  head("sunk.txt", 1);
  head("deep.txt", 14);
  test::write_slices("before.slcs", "head.txt", -200, 0);
  test::write_slices("behind.slcs", "head.txt", 2, 200);
  write_section("thin.txt", 60, -36);
  write_section("thicker.txt", 60, -30);
  test::write_slices("thin.slcs", "thin.txt", -200, 0);
  write(
    "growing.slcs",
    "0 1 U_OFFSET U_SCALE\n5 NSLC\n0 0 0 NFEAT NKINK NACCEL\n1 U_INTPOL\n-200 'thin.txt'\n-150 'thin.txt'\n"
    "-100 'thin.txt'\n-50 'thicker.txt'\n0 'thicker.txt'\n");
  std::vector<Point2> high = test::head_points();
  for (Point2 &p : high)
    p = p + Point2{62, -2};
  test::write_points("high.txt", high);
  test::write_slices("beside.slcs", "high.txt", -100, 0);
  const auto changing =
    [](const std::string &last) { // slices from -200 mm on each 50 mm, another one from 0 on
      std::string file = "0 1 U_OFFSET U_SCALE\n9 NSLC\n0 0 0 NFEAT NKINK NACCEL\n1 U_INTPOL\n";
      for (int k = 0; k < 9; ++k)
        file += std::to_string(50 * k - 200) + " '" + (k < 4 ? "head.txt" : last) + "'\n";
      return file;
    };
  write("sinking.slcs", changing("sunk.txt"));
  std::vector<Point2> metres = high;
  for (Point2 &p : metres)
    p = 1e-3 * p;
  test::write_points("metres.txt", metres);
  test::write_slices("metres.slcs", "metres.txt", -100, 0);
  for (Point2 &p : high)
    p.y += 30;
  test::write_points("guard.txt", high);
  test::write_slices("guard.slcs", "guard.txt", -300, 100);
  for (Point2 &p : high)
    p.y = -p.y;
  test::write_points("hanging.txt", high);
  test::write_slices("hanging.slcs", "hanging.txt", -300, 100);
  test::write_slices("gone.slcs", "gone.txt", -300, 100);
  write("deep.slcs", changing("deep.txt"));
  write("plain.prm", "set Title = plain\n");
  write("slices.prm", "subsection Profiles\n  set Rail = good.slcs\nend\n");
  answers(slices({"even.txt", "even.txt", "mirrored.txt", "even.txt"}, "0 0 0"),
          "slice 3 lies mirrored to the slice before; y of all slices points to the field side");
  std::string approximating = slices(even, "0 0 0");
  approximating.replace(approximating.find("1 U_INTPOL"), 1, "2");
  std::string uneven = approximating;
  answers(uneven.replace(uneven.find("\n20 '"), 4, "\n25 "),
          "U_INTPOL = 2 (an approximating spline) on slices that are not equally far apart");
  std::string ends = slices(std::vector<std::string>(6, "even.txt"),
                            "3 0 0",
                            "0 0 40 999\n20 0 40 999\n40 0 40 999\n60 0 40 999\n80 0 40 -1\n100 0 40 -1\n");
  answers(ends.replace(ends.find("1 U_INTPOL"), 1, "2"),
          "U_INTPOL = 2 (an approximating spline) with parts that begin or end");
  test_features(even);
  test_commands();
}
