// The command material: paths from entries and files, tables, and what it says of faults.

#include <wheelrail/application/material_command.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/input/parameters.h>

#include "error_of.h"
#include "near.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;
using test::same_text;

namespace
{
  const std::string folder = "material_command_test";

  Scene
  scene_of(const std::string &entries)
  {
    return scene_from_text(
             "subsection Rail material\n  set Law = Chaboche\n  set Yield stress = 379 MPa\n"
             "  set Kinematic moduli = 24750 MPa\n  set Kinematic rates = 55\nend\n"
             "subsection Material test\n" +
               entries + "end\nsubsection Output\n  set Folder = " + folder + "\nend\n",
             "test",
             {})
      .scene;
  }

  /// The message of a path, empty when there is none.
  std::string
  fault(const MaterialTest &test)
  {
    return test::error_of<InputError>([&]() { material_path(test); });
  }

  MaterialTest
  with_file(const std::string &text)
  {
    std::ofstream("material_path_test.csv") << text;
    MaterialTest test;
    test.file = "material_path_test.csv";
    return test;
  }

  /// Rows of numbers below the head of a table.
  std::vector<std::vector<double>>
  rows_of(const std::string &path)
  {
    std::ifstream                    file(path);
    std::vector<std::vector<double>> rows;
    std::string                      line;
    std::getline(file, line);
    while (std::getline(file, line))
      {
        std::istringstream  words(line);
        std::string         word;
        std::vector<double> row;
        while (std::getline(words, word, ','))
          row.push_back(std::stod(word));
        rows.push_back(row);
      }
    return rows;
  }

  BOOST_AUTO_TEST_CASE(ratcheting)
  {
    const Scene scene = scene_of("  set Axial = 700 MPa, -500 MPa\n  set Cycles = 4\n  set Steps = 4000\n");
    std::ostringstream out;
    BOOST_TEST(run_material_command(scene, false, out) == 0, "the command ends well");
    const auto cycles = rows_of(folder + "-material/cycles.csv");
    BOOST_TEST((cycles.size() == 4 && rows_of(folder + "-material/material.csv").size() == 4 * 2 * 4000),
               "tables have all rows");
    BOOST_TEST(near(cycles[3][3] / 0.0115627, 1, 3e-3, "ratcheting of a cycle over the closed form"));
    BOOST_TEST(near(cycles[3][5], 700, 1e-6, "largest stress [MPa]"));
    BOOST_TEST((out.str().find("Ratcheting of the last cycle") != std::string::npos), "and it is told");
    std::filesystem::remove_all(folder + "-material");
  }

  /// As many steps as 0.1 % needs, against the closed form, at a stress that needs few and one that needs
  /// many; tables stay short.
  BOOST_AUTO_TEST_CASE(steps_without_an_entry)
  {
    const double yield = 379, C = 24750, gamma = 55;
    for (const double high : {600., 800.})
      {
        const double low = -500;
        const Scene  scene =
          scene_of("  set Axial = " + std::to_string(high) + " MPa, -500 MPa\n  set Cycles = 4\n");
        std::ostringstream out;
        run_material_command(scene, false, out);
        const auto cycles = rows_of(folder + "-material/cycles.csv");
        // ratcheting of a cycle between stresses that flow: Armstrong and Frederick (1966), integrated
        const double limit = C / gamma, a = high - yield, b = low + yield;
        const double exact =
          (std::log((limit - b) / (limit - a)) - std::log((limit + a) / (limit + b))) / gamma;
        BOOST_TEST(near(cycles[3][3] / exact, 1, 1e-3, "ratcheting over the closed form without Steps"));
        BOOST_TEST(
          (out.str().find(" steps from value to value, as many as 0.1 % needs") != std::string::npos),
          "the steps are told: " + out.str().substr(0, out.str().find('\n')));
        BOOST_TEST(rows_of(folder + "-material/material.csv").size() < 4 * 2 * 402, "a short table");
      }
    std::filesystem::remove_all(folder + "-material");
  }

  /// A tube that is pulled by a steady stress while it is twisted to and fro lengthens.
  BOOST_AUTO_TEST_CASE(tension_torsion)
  {
    const Scene scene =
      scene_of("  set Axial = 100 MPa\n  set Shear = 0.01, -0.01\n  set Cycles = 3\n  set Steps = 200\n");
    const auto path = material_path(scene.material_test);
    BOOST_TEST((path.size() == 2 && path[1].of_stress[0] && !path[1].of_stress[5] &&
                path[1].value[0] == 100e6 && path[1].value[5] == -0.005),
               "a stress that is held, and a change of the angle");
    std::ostringstream out;
    run_material_command(scene, false, out);
    const auto cycles = rows_of(folder + "-material/cycles.csv");
    BOOST_TEST(cycles[2][3] > 1e-4, "a tube that is twisted lengthens under a steady pull");
    BOOST_TEST(near(cycles[2][7], 0.01, 1e-12, "change of the angle"));
    std::filesystem::remove_all(folder + "-material");
  }

  BOOST_AUTO_TEST_CASE(files)
  {
    const auto path =
      material_path(with_file("# strains and a stress\nE_xx, S_xy_MPa\n0.001, 50\n-0.002, 0\n"));
    BOOST_TEST((path.size() == 2 && path[0].value[0] == 0.001 && !path[0].of_stress[0] &&
                path[0].of_stress[5] && path[0].value[5] == 50e6 && path[0].of_stress[1]),
               "rows of a file");
    BOOST_TEST(same_text(
      fault(with_file("E_xx, strain\n0.001, 50\n")),
      "material_path_test.csv:1: column \"strain\" is not known; there are E_xx, E_yy, E_zz, E_yz, "
      "E_xz, E_xy, S_xx, S_yy, S_zz, S_yz, S_xz and S_xy, each with its unit in brackets, such as \"S_xx "
      "[Pa]\"",
      "a column of another name"));
    BOOST_TEST(
      same_text(fault(with_file("E_xx, S_xx_MPa\n0.001, 50\n")),
                "material_path_test.csv: two columns for the component xx; a strain and its stress cannot "
                "both be given",
                "a component twice"));
    BOOST_TEST(same_text(fault(with_file("E_xx, E_yy\n0.001\n")),
                         "material_path_test.csv:2: a row of 1 values, the first line names 2 columns",
                         "a short row"));
    BOOST_TEST(
      same_text(fault(with_file("E_xx\n1 %\n")),
                "material_path_test.csv:2: \"1 %\" of E_xx is not a number; units belong in the first line",
                "no number"));
    BOOST_TEST(
      same_text(fault(with_file("E_xx\n")),
                "material_path_test.csv: no rows; such a table has a first line with names and units, and "
                "rows of numbers",
                "no rows"));
    std::filesystem::remove("material_path_test.csv");
    MaterialTest test;
    test.file = "missing.csv";
    BOOST_TEST(same_text(
      fault(test), "missing.csv: no such file; rows of strains and stresses are needed", "no file"));
    test.axial.values = {0.01};
    BOOST_TEST(same_text(
      fault(test),
      "Material test/File = missing.csv: Axial and Shear say how to go, too; leave them out, or the file",
      "file and lists"));
  }

  BOOST_AUTO_TEST_CASE(faults)
  {
    MaterialTest test;
    BOOST_TEST(
      same_text(fault(test),
                "Material test says nothing: set Material test/Axial, such as 0.01, -0.01 or 700 MPa, -500 "
                "MPa, or Shear, "
                "or File",
                "no path"));
    test.axial.values = {0.01, -0.01};
    test.shear.values = {0.01, 0, -0.01};
    BOOST_TEST(
      same_text(fault(test),
                "Material test/Axial has 2 values and Shear 3; as many of both are needed, or a single one "
                "that is held",
                "lists of unequal length"));
    std::ostringstream out;
    const auto fault_of_run = [&](const std::string &entries, const SteelLaw law = SteelLaw::chaboche) {
      Scene scene             = scene_of(entries);
      scene.rail_material.law = law;
      return test::error_of<RunError>([&]() { run_material_command(scene, false, out); });
    };
    const std::string beyond = fault_of_run("  set Axial = 900 MPa\n");
    BOOST_TEST(
      (beyond.rfind("no strain gives the stresses that are asked for, ", 0) == 0 &&
       beyond.find(" MPa are missing: the steel does not bear more (at S_xx = 8") != std::string::npos &&
       beyond.find(" MPa, on the way to S_xx = 900 MPa); ask for less, or for strains") != std::string::npos),
      beyond);
    const std::string pressed = fault_of_run("  set Axial = -200 GPa\n", SteelLaw::elastic);
    BOOST_TEST(
      (pressed.rfind("Material test: the strain comes to -0.5", 0) == 0 &&
       pressed.find("; a Green strain of -0.5 is a length of zero: ask for less") != std::string::npos),
      pressed);
    const std::string stretched = fault_of_run("  set Axial = 600\n");
    BOOST_TEST((stretched.find(", where E_xx = ") != std::string::npos), stretched);
    test              = {};
    test.axial.values = {0.01, -0.6};
    BOOST_TEST(same_text(
      fault(test),
      "Material test/Axial: a strain of -0.6; strains are Green's, where -0.5 is a length of zero: more "
      "than -0.5 is accepted",
      "a strain below that of no length"));
    BOOST_TEST(same_text(
      fault(with_file("E_xx, E_yy\n0.001, -0.5\n")),
      "material_path_test.csv:2: a strain of -0.5; strains are Green's, where -0.5 is a length of zero: "
      "more than -0.5 is accepted",
      "and in a file"));
    run_material_command(scene_of("  set Axial = 0.3\n  set Cycles = 1\n"), false, out);
    BOOST_TEST(
      (out.str().find("note: strains up to 0.3: beyond some per cent Green's strains") != std::string::npos),
      "large strains are told");
    std::filesystem::remove_all(folder + "-material");
  }
} // namespace
