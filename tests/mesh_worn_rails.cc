// label: fast

// Sections of rails whose heads are worn, have a lip or are joined to another body: the places that divide
// them are found whatever angles their sides pass through, and no block or cell of the true bodies is folded.

#include <wheelrail/bodies/body_table.h>
#include <wheelrail/bodies/wave_element.h>
#include <wheelrail/mesh/fine_strip.h>
#include <wheelrail/mesh/rail_section.h>
#include <wheelrail/profiles/measured_profiles.h>

#include "near.h"
#include "profile_samples.h"
#include "section_quality.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace wheelrail;

namespace
{
  /// How a head differs from the standard one, gauge side first [m].
  struct Wear
  {
    std::string rail;
    double      gauge, slope; ///< wear of the gauge side 14 mm below the top, and its slope against upright
    double      crown;
    double      field;    ///< by how much the field side is narrower
    double      low, far; ///< where the points end below the top, on the gauge and on the field side
    double      tilt = 0; ///< of the measuring device [rad]
  };

  /// Means over neighbours, which round the edges as wear does.
  std::vector<Point2>
  rounded(const std::vector<Point2> &points)
  {
    constexpr int       reach = 10, kept = 6;
    const int           n      = points.size();
    std::vector<Point2> result = points;
    for (int i = kept; i + kept < n; ++i)
      {
        const int m = std::min({reach, i, n - 1 - i});
        Point2    sum;
        for (int k = i - m; k <= i + m; ++k)
          sum = sum + points[k];
        result[i] = (1. / (2 * m + 1)) * sum;
      }
    return result;
  }

  /// The rail of a profile as a device measured it.
  RailProfile
  measured(const std::vector<Point2> &points, const std::string &rail)
  {
    ProfileFileOptions options;
    options.kind                     = ProfileKind::rail;
    options.mirror                   = ProfileMirror::no;
    MeasuredProfile          profile = read_profile_text(test::columns(points), "worn.txt", options);
    std::vector<std::string> notes;
    return measured_rail(profile, rail, notes);
  }

  RailProfile
  worn(const Wear &wear)
  {
    const std::vector<Point2> whole = test::sampled(rail_profile(wear.rail).head, 0.5e-3, 0, 1);
    double                    side  = 0;
    for (const Point2 &p : whole)
      side = std::max(side, p.x);
    // profiles have the gauge side at negative x
    std::vector<Point2> points;
    for (Point2 p : whole)
      {
        p.y = std::min(p.y, -wear.crown - p.x * p.x / 0.6);
        p.x = std::min(p.x, side - wear.field);
        if (wear.gauge > 0)
          p.x = std::max(p.x, -(side - wear.gauge + wear.slope * (-14e-3 - wear.crown - p.y)));
        if (p.y > -wear.crown - (p.x < 0 ? wear.low : wear.far))
          points.push_back(p);
      }
    points = rounded(points);
    for (Point2 &p : points)
      p = {p.x - wear.tilt * p.y, p.y + wear.tilt * p.x};
    return measured(points, wear.rail);
  }

  void
  check_section(const Wear &wear, const double block)
  {
    const std::string name = wear.rail + " worn by " + std::to_string(std::lround(1e3 * wear.gauge)) +
                             " and " + std::to_string(std::lround(1e3 * wear.crown)) + " mm, points to " +
                             std::to_string(std::lround(1e3 * wear.low)) + " and " +
                             std::to_string(std::lround(1e3 * wear.far)) + " mm, blocks of " +
                             std::to_string(std::lround(1e3 * block)) + " mm";
    const WheelProfile    wheel   = wheel_profile("S1002");
    const RailProfile     rail    = worn(wear);
    const ContactGeometry contact = find_contact(rail, wheel, TrackDimensions(), {0, RollMode::none});
    const FrameProfile    wheel_top(wheel.tread, contact.wheel, contact.frame),
      rail_top(rail.head, contact.rail, contact.frame);
    try
      {
        const FineStrip strip   = make_fine_strip(contact, wheel_top, rail_top, 1e-4, 0.003, block);
        const Section   section = make_rail_section(rail, contact.rail, strip, block);
        BOOST_TEST(test::section_quality(section, 4).min_scaled_jacobian > 0.05,
                   name + ": smallest sine of a corner " +
                     std::to_string(test::section_quality(section, 4).min_scaled_jacobian));
      }
    catch (const std::exception &error)
      {
        BOOST_TEST(false, name + ": " + error.what());
      }
  }

  /// A gauge side with steel that has flowed out to a lip of `height` by bells of the widths `above` and
  /// `below` its ridge at `depth` below the top [m].
  void
  check_lip(const std::string &rail,
            const double       height,
            const double       depth,
            const double       above,
            const double       below)
  {
    std::vector<Point2> points = test::sampled(rail_profile(rail).head, 0.2e-3, 0, 1);
    for (Point2 &p : points)
      if (const double h = -depth - p.y; p.x < -20e-3)
        p.x -= height * std::exp(-0.5 * std::pow(h / (h > 0 ? below : above), 2));
    points.erase(std::remove_if(points.begin(), points.end(), [](const Point2 &p) { return p.y < -30e-3; }),
                 points.end());
    const std::string name = rail + ", a lip of " + std::to_string(1e3 * height) + " mm, " +
                             std::to_string(std::lround(1e3 * depth)) + " mm below the top, widths " +
                             std::to_string(1e3 * above) + " and " + std::to_string(1e3 * below) + " mm";
    try
      {
        const RailProfile profile = measured(points, rail);
        const SectionMesh mesh =
          mesh_section(make_rail_section(profile, {{0, 0}, 0}, {{{0, 0}, 0}, {-16e-3, 0, 16e-3}}, 16e-3),
                       Boundary::foot,
                       3);
        for (const auto &cell : mesh.cells)
          for (int point = 0; point < 9; ++point)
            wave_point(mesh, cell, point); // throws where it is folded
        std::vector<double> arcs;
        for (const SurfaceRow &row : rows_on_profile(mesh, profile.head, false, 0, 1))
          if (row.place.x > -15e-3 && row.place.x < 15e-3)
            arcs.push_back(row.place.x);
        BOOST_TEST(arcs.size() >= 14,
                   name + ": the crown stays exact, with " + std::to_string(arcs.size()) + " rows");
      }
    catch (const std::exception &error)
      {
        BOOST_TEST(false, name + ": " + error.what());
      }
  }
} // namespace


BOOST_AUTO_TEST_CASE(mesh_worn_rails)
{
  for (const std::string rail : {"54E1", "60E1"})
    for (const double height : {0.2e-3, 0.7e-3, 2e-3})
      for (const double depth : {9e-3, 11.5e-3, 18e-3})
        for (const double above : {1e-3, 4e-3})
          for (const double below : {0.4e-3, 1e-3})
            check_lip(rail, height, depth, above, below);

  for (const double block : {16e-3, 8e-3})
    for (const Wear &wear : std::vector<Wear>{
           // points end high, low, or on one side only
           {"60E1", 0, 0, 0, 0, 25e-3, 25e-3},
           {"54E1", 6e-3, 0.2, 0, 0, 32e-3, 15e-3},
           // a gauge face that leans, deeper than the lower corner; a crown that is nearly worn out
           {"60E1", 6e-3, 0.3, 12e-3, 3e-3, 32e-3, 15e-3},
           {"54E1", 12e-3, 0.2, 12e-3, 3e-3, 25e-3, 32e-3, 0.02},
           // another, narrower rail on the body
           {"60E1", 3e-3, 0.1, 12e-3, 8e-3, 32e-3, 32e-3},
           {"54E1", 0, 0, 8e-3, 6e-3, 18e-3, 25e-3},
           {"60E1", 9e-3, 0.1, 8e-3, 0, 32e-3, 32e-3, -0.02}})
      check_section(wear, block);
}
