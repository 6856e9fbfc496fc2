// label: fast

// Tables of a vehicle simulation: what a motion file may hold, those of other programs, messages.

#include "messages.h"
#include "motion_table.h"

#include <wheelrail/input/motion_file.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

using namespace wheelrail;
using test::File;
using test::near;

namespace
{
  void
  refused(const std::string &text, const std::string &expected)
  {
    const File file(text);
    BOOST_TEST(test::same_text(
      test::message_of([&]() { read_motion_file(file.path()); }), file.path() + expected, text));
  }

  BOOST_AUTO_TEST_CASE(test_messages)
  {
    const std::string there =
      "; there are time, distance, lateral shift, roll, yaw, load, load right, load left, velocity, torque, "
      "traction, creepage, lateral creepage, radius, curvature and cant, each with its unit in brackets, "
      "such as \"time "
      "[s]\"";
    refused("time [s],jaw [mrad]\n0,1\n",
            ":1: column \"jaw [mrad]\" is not known, perhaps yaw is meant" + there);
    refused("time [s],yaw\n0,1\n",
            ":1: column \"yaw\" has no unit; write it in brackets, such as \"yaw [rad]\"");
    refused(
      "time [s],yaw [mm]\n0,1\n",
      ":1: column \"yaw [mm]\": the unit \"mm\" is one of length; an angle takes one of rad, mrad, deg");
    refused("time [s],torque [kN]\n0,1\n",
            ":1: column \"torque [kN]\": the unit \"kN\" is one of force; a torque takes one of N m, kN m, "
            "Nm, kNm");
    refused("time [s],creepage [mm]\n0,1\n",
            ":1: column \"creepage [mm]\": \"mm\" is no unit of a creepage; %, or 1 is accepted");
    refused("time [s],time [s]\n0,1\n", ":1: two columns of time; leave one out");
    refused("time [s],yaw [mrad]\n0,1\n0.1\n", ":3: a row of 1 values, the first line names 2 columns");
    refused("time [s],yaw [mrad]\n0,\n",
            ":2: no value of yaw; rows cannot have gaps: fill it or leave the column out");
    refused("time [s],yaw [mrad]\n0,1 mrad\n",
            ":2: \"1 mrad\" of yaw is not a number; units belong in the first line");
    refused("time [s],yaw [rad]\n0,5\n",
            ":2: yaw = 5 is out of range; -50 mrad to 50 mrad is accepted, in the unit of the first line");
    refused("time [s]\n0\n2\n1\n", ":4: time = 1 is less than in the row before; sort the rows");
    refused("time [s]\n0\n2\n2\n", ":4: time = 2 is in the row before, too; leave one of them out");
    refused("yaw [mrad]\n1\n",
            ": neither time nor distance; one of them must be a column, such as \"time [s]\"");
    refused("time [s],torque [N m],creepage [%]\n0,1,1\n",
            ": torque and creepage; one follows from the other: leave one of the columns out");
    refused("time [s],load right [kN]\n0,80\n",
            ": load right without load left; write both, or load for a load that both wheels have");
    refused("time [s],load [kN],load right [kN],load left [kN]\n0,1,1,1\n",
            ": load beside load right and load left; leave it out, or the two others");
    refused(
      "time [s],radius [m]\n0,0\n1,-12\n",
      ":3: radius = -12 is out of range; 20 m to 100 km on either side, or 0 is accepted, in the unit of "
      "the first line");
    refused("# nothing\n",
            ": no rows; such a table has a first line with names and units, and rows of numbers");
    BOOST_TEST(test::same_text(test::message_of([]() { read_motion_file("no_such.csv"); }),
                               "no_such.csv: no such file; a motion is a table of rows over time or distance",
                               "no file"));
  }

  /// Tables as other programs write them: decimal commas, a line of units, columns and names of their own.
  BOOST_AUTO_TEST_CASE(test_foreign_tables)
  {
    const auto value = [](const MotionFile &rows, const MotionQuantity quantity) {
      const auto *const column = rows.find(quantity);
      return column && column->size() == 1 ? column->front() : std::nan("");
    };
    using Q = MotionQuantity;
    const File commas("time [s];yaw [mrad]\n0,5;1,25\n");
    BOOST_TEST(near(value(read_motion_file(commas.path()), Q::time), 0.5, 1e-15, "a decimal comma"));
    BOOST_TEST(near(value(read_motion_file(commas.path()), Q::yaw), 1.25e-3, 1e-15, "another one"));
    const File tabs("time [s]\tyaw [mrad]\n0,5\t1,25\n");
    BOOST_TEST(
      near(value(read_motion_file(tabs.path()), Q::yaw), 1.25e-3, 1e-15, "decimal commas between tabs"));
    const File units("distance;yaw;traction\nm;[mrad];1\n10;2;0.1\n");
    BOOST_TEST(
      near(value(read_motion_file(units.path()), Q::distance), 10, 1e-15, "units in a line of their own"));
    BOOST_TEST(near(value(read_motion_file(units.path()), Q::yaw), 2e-3, 1e-15, "with brackets, too"));

    const File       more("time [s];Y_11 [N];y_ws;acceleration [m/s2]\n0;3;2,5;1\n");
    const MotionFile left = read_vehicle_file(more.path());
    BOOST_TEST((left.quantities.size() == 1 && left.notes.size() == 1),
               "columns that are not known are left out");
    BOOST_TEST(test::same_text(
      left.notes.at(0),
      more.path() + ": columns that are not used: \"Y_11 [N]\", \"y_ws\", \"acceleration [m/s2]\"; a "
                    "table of names says what they are called here (--columns)",
      "and named"));
    refused(
      "time [s];acceleration [m/s2]\n0;1\n",
      ":1: column \"acceleration [m/s2]\" is not known; there are time, distance, lateral shift, roll, "
      "yaw, load, load right, load left, velocity, torque, traction, creepage, lateral creepage, radius, "
      "curvature and cant, each with its unit in brackets, such as \"time [s]\"");
    const File none("acceleration [m/s2]\n1\n");
    BOOST_TEST(
      (test::message_of([&]() {
         read_vehicle_file(none.path());
       }).find("no column is known; there are time") != std::string::npos &&
       test::message_of([&]() { read_vehicle_file(none.path()); }).find("(--columns)") != std::string::npos),
      "a table of other quantities");
    const File alike("time [s];jaw [mrad]\n0;1\n");
    BOOST_TEST((test::message_of([&]() { read_vehicle_file(alike.path()); }).find("perhaps yaw is meant") !=
                std::string::npos),
               "a name like a known one is refused");
    const File swapped("time [s];laod [kN]\n0;1\n");
    BOOST_TEST((test::message_of([&]() {
                  read_vehicle_file(swapped.path());
                }).find("perhaps load is meant") != std::string::npos),
               "two letters swapped count as one");

    std::ofstream("names.csv") << "# there; here\ny_ws;-lateral shift [mm]\n";
    BOOST_TEST(near(value(read_vehicle_file(more.path(), "names.csv"), Q::lateral_shift),
                    -2.5e-3,
                    1e-15,
                    "a name of another program, whose sign is turned"));
    const auto here = [&](const std::string &rows, const char *const names) {
      std::ofstream("names.csv") << names;
      return read_vehicle_file(File(rows).path(), "names.csv");
    };
    const auto shift = [&](const std::string &rows, const char *const names) {
      return value(here(rows, names), Q::lateral_shift);
    };
    BOOST_TEST(near(shift("time;y_ws\ns;mm\n0;2\n", "y_ws;lateral shift\n"), 2e-3, 1e-15, "a line of units"));
    BOOST_TEST(near(shift("time;y_ws\ns;mm\n0;2\n", "y_ws;lateral shift [mm]\n"),
                    2e-3,
                    1e-15,
                    "a line of units beside one in the table of names"));
    BOOST_TEST(near(shift("time [s];y_ws\n0;2\n", "y_ws;-0.5 * lateral shift [mm]\n"),
                    -1e-3,
                    1e-15,
                    "a factor in the table of names, with a sign"));
    for (const char *const rows : {"time [s];y_ws [m]\n0;2\n", "time;y_ws\ns;m\n0;2\n"})
      BOOST_TEST((test::message_of([&]() {
                    shift(rows, "y_ws;lateral shift [mm]\n");
                  }).find("\" is in m here and in mm in the table of names; leave one of them out") !=
                  std::string::npos),
                 "two units of one column");
    BOOST_TEST(near(value(here("time [s];kappa\n0;-0.002\n", "kappa;curvature [1/m]\n"), Q::radius),
                    -500,
                    1e-9,
                    "a curvature in place of a radius"));
    BOOST_TEST(near(value(here("time [s];kappa\n0;1e-9\n", "kappa;0.001 * curvature [1/m]\n"), Q::radius),
                    0,
                    0,
                    "a straight track"));
    refused("time [s],radius [m],curvature [1/m]\n0,500,0.002\n",
            ": radius and curvature; one follows from the other: leave one of the columns out");
    std::ofstream("names.csv") << "y_ws;shift\n";
    BOOST_TEST(
      test::same_text(test::message_of([&]() { read_vehicle_file(more.path(), "names.csv"); }).substr(0, 40),
                      "names.csv:1: \"shift\" is no column; there",
                      "a name that is not known here"));
    std::ofstream("names.csv") << "y_ws\n";
    BOOST_TEST(test::same_text(
      test::message_of([&]() { read_vehicle_file(more.path(), "names.csv"); }),
      "names.csv:1: a line holds two names with a comma, semicolon or tab between: that in the "
      "rows and that here, such as \"y_ws;lateral shift [mm]\"",
      "one name"));
    std::ofstream("names.csv") << "y_ws;yaw\ny_ws;roll\n";
    BOOST_TEST(test::same_text(test::message_of([&]() { read_vehicle_file(more.path(), "names.csv"); }),
                               "names.csv:2: \"y_ws\" is in a line before, too; leave one of them out",
                               "a name twice"));
    std::filesystem::remove("names.csv");
  }
} // namespace
