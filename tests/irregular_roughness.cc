// label: fast
// Roughness: the spectrum of the surface against the levels of the file, and what is refused.
#include "messages.h"

#include <wheelrail/geometry/roughness.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/profiles/roughness_file.h>

#include <gsl/gsl_fft_real.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;

namespace
{
  // nominal middles of bands [mm] and levels [dB over 1 um]
  const std::vector<std::pair<double, double>> levels = {{100, 4},
                                                         {80, 3.5},
                                                         {63, 2},
                                                         {50, 1},
                                                         {40, 0},
                                                         {31.5, -4},
                                                         {25, -3},
                                                         {20, -5},
                                                         {16, -6},
                                                         {12.5, -6},
                                                         {10, -8}};

  void
  write_levels(const char *name)
  {
    std::ofstream file(name);
    file << "# rail of a test track\nwavelength_mm,level_dB\n";
    for (const auto &[wavelength, level] : levels)
      file << wavelength << "," << level << "\n";
  }

  Scene
  rough_scene(const unsigned int seed)
  {
    Scene             scene;
    IrregularityData &one = scene.irregularities[0];
    one.kind              = IrregularKind::roughness;
    one.file              = "levels.csv";
    one.length            = 1;
    one.place             = 0.6;
    one.seed              = seed;
    return scene;
  }

  /// Heights of the rail under the contact line over the length that is rough [m].
  std::vector<double>
  heights(const unsigned int seed, const std::size_t n)
  {
    const SceneGeometry   geometry = make_geometry(rough_scene(seed));
    const RunningSurface &rail     = geometry.surfaces.rail;
    std::vector<double>   values;
    for (std::size_t k = 0; k < n; ++k)
      values.push_back(rail.at(0, 0.1 + double(k) / n).n - rail.smooth(0).n);
    return values;
  }

  void
  test_spectrum()
  {
    constexpr std::size_t     n        = 4096;
    const std::vector<double> line     = heights(1, n);
    std::vector<double>       spectrum = line;
    gsl_fft_real_radix2_transform(spectrum.data(), 1, n);
    double all = 0, of_bands = 0, worst = 0;
    for (const double h : line)
      all += h * h / n;
    for (const auto &[wavelength, level] : levels)
      {
        const double middle = std::pow(10, std::round(10 * std::log10(1e-3 * wavelength)) / 10),
                     part   = std::pow(10, 0.05);
        double power        = 0;
        for (std::size_t k = 1; k < n / 2; ++k)
          if (const double of_line = 1. / k; of_line > middle / part && of_line < middle * part)
            power += 2 * (std::pow(spectrum[k], 2) + std::pow(spectrum[n - k], 2)) / (double(n) * n);
        worst = std::max(worst, std::abs(10 * std::log10(power / 1e-12) - level));
        of_bands += power;
      }
    BOOST_TEST(worst < 0.5, "each band has its level within 0.5 dB: " + std::to_string(worst));
    BOOST_TEST(near(of_bands / all, 1, 1e-3, "nothing lies outside of the bands"));
    // phases are random: the highest of many waves is a few times their root mean square
    const double crest = *std::max_element(line.begin(), line.end()) / std::sqrt(all);
    BOOST_TEST((crest > 2 && crest < 5), "crest factor of random phases: " + std::to_string(crest));
  }

  void
  test_seeds()
  {
    const std::vector<double> one = heights(1, 64), same = heights(1, 64), other = heights(2, 64);
    BOOST_TEST((one == same), "a seed gives the same surface");
    double difference = 0;
    for (std::size_t k = 0; k < one.size(); ++k)
      difference += std::pow(one[k] - other[k], 2);
    BOOST_TEST(difference > 0, "another seed another one");
    const SceneGeometry   geometry = make_geometry(rough_scene(1));
    const RunningSurface &rail     = geometry.surfaces.rail;
    const Irregularity   &shape    = rail.irregularities().front();
    BOOST_TEST(near(shape.begin, 0.05, 1e-9, "it begins half its longest wave before [m]"));
    for (const double z : {shape.begin, shape.end})
      {
        BOOST_TEST(near(1e6 * (rail.at(0, z).n - rail.smooth(0).n), 0, 1e-3, "no step at its ends [um]"));
        BOOST_TEST(near(1e3 * rail.at(0, z).slope_along, 0, 1e-3, "nor a kink [1e-3]"));
      }
    // slopes are those of the heights
    constexpr double h     = 1e-6;
    double           worst = 0;
    for (double z = shape.begin + 2e-3; z < shape.end; z += 7.3e-3)
      worst = std::max(
        worst, std::abs((rail.at(0, z + h).n - rail.at(0, z - h).n) / (2 * h) - rail.at(0, z).slope_along));
    BOOST_TEST(worst < 1e-7, "slopes belong to heights: " + std::to_string(1e9 * worst) + "e-9");
  }

  void
  refused(const std::vector<RoughnessBand> &bands, const std::string &part)
  {
    const std::string message = test::message_of([&] { roughness({0, 0, 0.2, 0, 0}, bands, 1); });
    BOOST_TEST((message.find(part) != std::string::npos), "\"" + part + "\" in \"" + message + "\"");
  }

  void
  test_refused()
  {
    refused({}, "no band");
    refused({{0.035, 0}}, "35 mm is the middle of no one-third-octave band; the nearest is 31.62 mm");
    refused({{0.0315, 0}, {0.0316, 1}}, "the band of 31.6 mm is given twice");
    refused(
      {{0.5, 0}},
      "the band of 501.19 mm has no line of the spectrum, since these lie 1/length apart: take a Length of ");
    const auto file = [](const char *text, const std::string &part) {
      std::ofstream("bad.csv") << text;
      const std::string message = test::message_of([] {
        std::vector<std::string> notes;
        read_roughness_file("bad.csv", notes);
      });
      BOOST_TEST((message.find(part) != std::string::npos), "\"" + part + "\" in \"" + message + "\"");
    };
    file("", "bad.csv: no rows; such a table has a first line with names and units, and rows of numbers");
    file("wavelength_mm\n10\n",
         "bad.csv:1: no column level; roughness is a row for each one-third-octave band under the names "
         "wavelength_mm, level_dB");
    file("wavelength_mm,level_dB\n10,loud\n",
         "bad.csv:2: \"loud\" of level is not a number; units belong in the first line");
    file("wavelength_mm,level_dB\n-10,3\n",
         "bad.csv:2: wavelength = -10 is out of range; a length above 0, up to 1 km, is accepted");
    file("wavelength_mm,level_dB\n10,300\n",
         "level = 300 is out of range; -60 dB to 60 dB over a root mean square height of 1 um is accepted");
    file("wavelength_mm,level_dB\n", "bad.csv: no rows");
  }

  void
  test_wheel()
  {
    Scene scene                  = rough_scene(1);
    scene.irregularities[0].body = IrregularBody::wheel;
    BOOST_TEST(!make_geometry(scene).surfaces.wheel.irregularities().empty(),
               "a wheel that is rough over 1 m");
    scene.irregularities[0].length = 2.85;
    const std::string message      = test::message_of([&] { make_geometry(scene); });
    BOOST_TEST(
      (message.find("Irregularity 1/File: levels.csv: with its ends it is longer than the circumference "
                    "of the wheel, ") != std::string::npos),
      message);
  }

  void
  test_cells()
  {
    const std::string one   = "Irregularity 1/";
    const Findings    found = check_scene(scene_from_text("",
                                                       "none",
                                                       {one + "Kind = roughness",
                                                           one + "File = levels.csv",
                                                           one + "Length = 0.5 m",
                                                           one + "Place = 350 mm",
                                                           "Mesh/Solution cell size = 3 mm",
                                                           "Mesh/Coarse cell size = 12 mm"})
                                         .scene)
                             .found;
    std::string errors;
    for (const std::string &error : found.errors)
      errors += error + "\n";
    BOOST_TEST(
      (errors.find("rises and falls within 10 mm, which cells of 3 mm cannot follow") != std::string::npos),
      "bands below four cells are refused: " + errors);
  }
} // namespace


BOOST_AUTO_TEST_CASE(irregular_roughness)
{
  write_levels("levels.csv");
  test_spectrum();
  test_seeds();
  test_refused();
  test_wheel();
  test_cells();
}
