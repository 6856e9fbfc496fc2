// label: fast

// Block meshes of rail and wheel sections: area, shape, conformity, vertices on the exact profiles,
// and equal lateral positions on both bodies in the fine strip.

#include <wheelrail/base/errors.h>
#include <wheelrail/mesh/rail_section.h>
#include <wheelrail/mesh/wheel_section.h>

#include "error_of.h"
#include "near.h"
#include "section_properties.h"
#include "section_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <vector>

using namespace wheelrail;

namespace
{
  // Number of blocks at each edge.
  std::map<Section::EdgeKey, unsigned int>
  edge_use(const Section &section)
  {
    std::map<Section::EdgeKey, unsigned int> use;
    for (const auto &b : section.blocks)
      for (const auto &e : {std::array<unsigned int, 2>{{0, 1}}, {{1, 3}}, {{2, 3}}, {{0, 2}}})
        ++use[{{std::min(b.corner[e[0]], b.corner[e[1]]), std::max(b.corner[e[0]], b.corner[e[1]])}}];
    return use;
  }

  // Every edge is shared by two blocks or lies on the boundary, which is one closed chain per
  // section; marks and curves belong to edges that exist, marks to edges of the boundary.
  void
  check_conformity(const Section &section, const std::string &name)
  {
    const auto                           use = edge_use(section);
    std::map<unsigned int, unsigned int> ends;
    bool                                 good        = true;
    unsigned int                         on_boundary = 0;
    for (const auto &[edge, count] : use)
      {
        good = good && (count == 1 || count == 2);
        if (count == 1)
          {
            ++ends[edge[0]];
            ++ends[edge[1]];
            ++on_boundary;
          }
      }
    for (const auto &[corner, count] : ends)
      good = good && count == 2;
    for (const auto &entry : section.curved)
      good = good && use.count(entry.first) == 1;
    for (const auto &entry : section.boundary)
      good = good && use.count(entry.first) == 1 && use.at(entry.first) == 1;
    // Euler's formula of a region without holes
    good = good && section.corners.size() + section.blocks.size() == use.size() + 1;
    BOOST_TEST(good,
               name + ": blocks fit together, " + std::to_string(section.blocks.size()) + " blocks, " +
                 std::to_string(on_boundary) + " boundary edges");

    double jump = 0;
    for (const auto &[edge, curve] : section.curved)
      jump = std::max(
        {jump, norm(curve(0) - section.corners[edge[0]]), norm(curve(1) - section.corners[edge[1]])});
    BOOST_TEST(test::near(jump, 0, 1e-9, name + ": curved edges end in their corners"));
  }

  // Largest distance of points on edges with a mark from a profile.
  double
  distance_from(const Section                               &section,
                const Boundary                               boundary,
                const Curve                                 &curve,
                const std::function<Point2(const Point2 &)> &to_profile)
  {
    double largest = 0;
    for (const auto &[edge, mark] : section.boundary)
      if (mark == boundary)
        for (unsigned int i = 0; i <= 16; ++i)
          {
            const Point2 p = to_profile(section.curved.at(edge)(i / 16.));
            largest        = std::max(largest, norm(p - curve.at(curve.closest(p)).position));
          }
    return largest;
  }

  // Blocks with an edge in the strip, and the largest error of s along these edges: at the
  // sixteenths of each edge, s must divide the strip's blocks evenly.
  struct StripBlocks
  {
    std::vector<unsigned int> blocks;
    std::vector<unsigned int> edges; // on the running surface: bottom, right, top, left
    double                    error = 0;
  };

  StripBlocks
  strip_blocks(const Section                               &section,
               const FineStrip                             &strip,
               const std::function<Point2(const Point2 &)> &to_track)
  {
    StripBlocks  result;
    const auto   use   = edge_use(section);
    unsigned int found = 0;
    for (unsigned int b = 0; b < section.blocks.size(); ++b)
      {
        const auto  &c    = section.blocks[b].corner;
        unsigned int edge = 0;
        for (const auto &e : {std::array<unsigned int, 2>{{0, 1}}, {{1, 3}}, {{2, 3}}, {{0, 2}}})
          {
            const unsigned int     number = edge++;
            const Section::EdgeKey key{{std::min(c[e[0]], c[e[1]]), std::max(c[e[0]], c[e[1]])}};
            const auto             mark = section.boundary.find(key);
            if (mark == section.boundary.end() || mark->second != Boundary::running)
              continue;
            const auto s = [&](const double t) {
              return strip.frame.to_frame(to_track(section.curved.at(key)(t))).x;
            };
            for (unsigned int i = 0; i + 1 < strip.s.size(); ++i)
              {
                const double a = s(0) < s(1) ? strip.s[i] : strip.s[i + 1],
                             z = s(0) < s(1) ? strip.s[i + 1] : strip.s[i];
                if (std::abs(s(0) - a) > 1e-6 || std::abs(s(1) - z) > 1e-6)
                  continue;
                ++found;
                result.blocks.push_back(b);
                result.edges.push_back(number);
                for (unsigned int k = 0; k <= 16; ++k)
                  result.error = std::max(result.error, std::abs(s(k / 16.) - a - (z - a) * k / 16));
              }
          }
      }
    BOOST_TEST((found + 1 == strip.s.size()), "  the strip has its blocks: " + std::to_string(found));
    return result;
  }

  // Smallest width of the cells of the strip at 6 mm below the surface, at 16 x 16, as part of the width on
  // the surface across the strip: narrower cells would cut the stable time step.
  double
  width_below(const Section &section, const StripBlocks &strip, const double surface_width)
  {
    constexpr unsigned int n        = 16;
    double                 smallest = 1;
    for (unsigned int k = 0; k < strip.blocks.size(); ++k)
      {
        const auto point = [&](const unsigned int i, const unsigned int row) {
          const double t = i / double(n), d = row / double(n);
          switch (strip.edges[k])
            {
              case 0:
                return section.position(strip.blocks[k], t, d);
              case 1:
                return section.position(strip.blocks[k], 1 - d, t);
              case 2:
                return section.position(strip.blocks[k], t, 1 - d);
              default:
                return section.position(strip.blocks[k], d, t);
            }
        };
        const unsigned int row =
          std::min<long>(n - 1, std::lround(n * 0.006 / norm(point(0, n) - point(0, 0))));
        for (unsigned int i = 0; i < n; ++i)
          {
            const Point2 across =
              0.5 * (point(i + 1, row) - point(i, row) + point(i + 1, row + 1) - point(i, row + 1));
            const Point2 down = point(i, row + 1) - point(i, row) + point(i + 1, row + 1) - point(i + 1, row);
            smallest = std::min(smallest, std::abs(cross(across, down)) / (norm(down) * surface_width));
          }
      }
    return smallest;
  }

  // Smallest scaled Jacobian at 16 x 16, without the blocks that form a corner of the outline alone.
  // Such a corner is a rounding of 2 to 4 mm at the toe of the rail foot, where cells have angles
  // that tend to 180 degrees as they shrink; these blocks are never refined.
  double
  quality_without_outline_corners(const Section &section)
  {
    const auto                           use = edge_use(section);
    std::map<unsigned int, unsigned int> blocks_at;
    for (const auto &b : section.blocks)
      for (const unsigned int c : b.corner)
        ++blocks_at[c];

    double quality = 1;
    for (unsigned int b = 0; b < section.blocks.size(); ++b)
      {
        const auto &c = section.blocks[b].corner;
        if (std::none_of(c.begin(), c.end(), [&](const unsigned int k) { return blocks_at[k] == 1; }))
          quality = std::min(quality, block_quality(section, b, 16).min_scaled_jacobian);
      }
    return quality;
  }

  // Shape: the strip and the whole section at 16 x 16, 4 x 4 and undivided. Blocks of 16 mm stay well
  // shaped at 16 x 16 everywhere.
  void
  check_shape(const Section &section, const StripBlocks &strip, const double block, const std::string &name)
  {
    double strip_quality = 1, smallest = 1, largest = 0;
    for (const unsigned int b : strip.blocks)
      {
        const SectionQuality q = block_quality(section, b, 16);
        strip_quality          = std::min(strip_quality, q.min_scaled_jacobian);
        smallest               = std::min(smallest, q.min_edge);
        largest                = std::max(largest, q.max_edge);
      }
    const SectionQuality fine   = test::section_quality(section, 16),
                         coarse = test::section_quality(section, 4),
                         blocks = test::section_quality(section, 1);
    const double limit          = 0.3;
    const bool   good           = strip_quality > 0.7 && quality_without_outline_corners(section) > limit &&
                      (block < 0.015 || fine.min_scaled_jacobian > limit) &&
                      coarse.min_scaled_jacobian > limit && blocks.min_scaled_jacobian > limit;
    std::ostringstream text;
    text << std::setprecision(3) << name << ": scaled Jacobian, strip " << strip_quality << ", 16 x 16 "
         << fine.min_scaled_jacobian << ", 4 x 4 " << coarse.min_scaled_jacobian << ", blocks "
         << blocks.min_scaled_jacobian << "; edges in the strip " << smallest * 1e3 << " to " << largest * 1e3
         << " mm, block edges " << blocks.min_edge * 1e3 << " to " << blocks.max_edge * 1e3 << " mm";
    BOOST_TEST(good, text.str());
  }

  // Area of the wheel section from its parts: rim below the tread (by Gauss's rule on the curve),
  // disc, hub, fillets.
  double
  wheel_area(const WheelProfile &wheel, const WheelDimensions &d)
  {
    std::vector<Segment> segments = wheel.tread.segments();
    const Point2         first    = wheel.tread.at(0).position;
    const Point2         last     = wheel.tread.at(wheel.tread.parameter_end()).position;
    const double         low      = d.nominal_radius - d.rim_inner_radius;
    const auto           add      = [&segments](const Point2 &a, const Point2 &b) {
      Segment segment;
      segment.start = a;
      segment.end   = b;
      segments.push_back(segment);
    };
    add(last, {last.x, low});
    add({last.x, low}, {first.x, low});
    add({first.x, low}, first);
    const double f = d.fillet_radius;
    return test::section_properties(Curve(segments)).area +
           d.disc_thickness * (d.rim_inner_radius - d.hub_outer_radius) +
           d.hub_length * (d.hub_outer_radius - d.bore_radius) + 4 * (1 - M_PI / 4) * f * f;
  }

  /// First moment of a meshed section about the axle, from small quadrilaterals [m3].
  double
  meshed_moment(const Section &section)
  {
    constexpr int n   = 16;
    double        sum = 0;
    for (unsigned int block = 0; block < section.blocks.size(); ++block)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          {
            const auto at = [&](const int k, const int l) {
              return section.position(block, double(i + k) / n, double(j + l) / n);
            };
            const Point2 a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
            sum += cross(b - a, c - a) * (a.y + b.y + c.y) / 6 + cross(c - a, d - a) * (a.y + c.y + d.y) / 6;
          }
    return sum;
  }

  void
  check_pair(const std::string &rail_name, const double shift, const double block)
  {
    const RailProfile     rail  = rail_profile(rail_name);
    const WheelProfile    wheel = wheel_profile("S1002");
    const WheelDimensions dimensions;
    const ContactGeometry contact = find_contact(rail, wheel, TrackDimensions(), {shift, RollMode::none});
    const FrameProfile    wheel_top(wheel.tread, contact.wheel, contact.frame),
      rail_top(rail.head, contact.rail, contact.frame);
    const FineStrip strip = make_fine_strip(contact, wheel_top, rail_top, 1e-4, 0.004, block);

    std::ostringstream text;
    text << rail_name << " at " << shift * 1e3 << " mm, blocks of " << block * 1e3 << " mm";
    const std::string name = text.str();
    std::cout << "\n" << name << ", strip in mm:";
    for (const double s : strip.s)
      std::cout << ' ' << s * 1e3;
    const Range limits = strip_limits(wheel_top, rail_top);
    std::cout << ", possible from " << limits.s0 * 1e3 << " to " << limits.s1 * 1e3 << std::endl;
    for (const Range &range : interpenetration(wheel_top, rail_top, 1e-4))
      BOOST_TEST((strip.s.front() < range.s0 && strip.s.back() > range.s1),
                 "  the strip covers an interpenetration");

    const Section rail_section  = make_rail_section(rail, contact.rail, strip, block);
    const Section wheel_section = make_wheel_section(wheel, dimensions, contact.wheel, strip, block);
    check_conformity(rail_section, name + ", rail");
    check_conformity(wheel_section, name + ", wheel");

    const auto rail_to_track       = [](const Point2 &p) { return p; };
    const auto wheel_profile_point = [&](const Point2 &p) {
      return Point2{-p.x, dimensions.nominal_radius - p.y};
    };
    const auto wheel_to_track = [&](const Point2 &p) {
      return contact.wheel.to_track(wheel_profile_point(p));
    };
    const auto        rail_profile_point = [&](const Point2 &p) { return contact.rail.to_section(p); };
    const StripBlocks on_rail            = strip_blocks(rail_section, strip, rail_to_track);
    const StripBlocks on_wheel           = strip_blocks(wheel_section, strip, wheel_to_track);
    BOOST_TEST(test::near(
      std::max(on_rail.error, on_wheel.error), 0, 1e-9, name + ": vertices in the strip at equal s"));
    BOOST_TEST(test::near(distance_from(rail_section, Boundary::running, rail.outline, rail_profile_point),
                          0,
                          1e-9,
                          name + ", rail: running edges on the profile"));
    BOOST_TEST(test::near(distance_from(rail_section, Boundary::foot, rail.outline, rail_profile_point),
                          0,
                          1e-9,
                          name + ", rail: foot edges on the profile"));
    BOOST_TEST(test::near(distance_from(wheel_section, Boundary::running, wheel.tread, wheel_profile_point),
                          0,
                          1e-9,
                          name + ", wheel: running edges on the profile"));

    const double rail_area = test::section_properties(rail.outline).area,
                 wheel_sum = wheel_area(wheel, dimensions);
    BOOST_TEST(
      test::near(test::section_quality(rail_section, 16).area / rail_area, 1, 2e-3, name + ", rail: area"));
    BOOST_TEST(
      test::near(test::section_quality(wheel_section, 16).area / wheel_sum, 1, 2e-3, name + ", wheel: area"));
    const WheelSectionOutline outline = make_wheel_section_outline(wheel, dimensions);
    BOOST_TEST(test::near(moment_about_axle(outline, dimensions) / meshed_moment(wheel_section),
                          1,
                          1e-4,
                          name + ", wheel: weight of its outline over that of its mesh"));
    const double cell        = (strip.s.back() - strip.s.front()) / (16 * (strip.s.size() - 1));
    const double rail_width  = width_below(rail_section, on_rail, cell),
                 wheel_width = width_below(wheel_section, on_wheel, cell);
    std::ostringstream widths;
    widths << std::setprecision(3) << name << ": width of the strip's cells 6 mm deep, rail " << rail_width
           << ", wheel " << wheel_width << " of that on the surface";
    BOOST_TEST(std::min(rail_width, wheel_width) > 0.85, widths.str());
    check_shape(rail_section, on_rail, block, name + ", rail");
    check_shape(wheel_section, on_wheel, block, name + ", wheel");
  }

  // Bad input is refused with a sentence.
  void
  check_errors()
  {
    const RailProfile     rail    = rail_profile("54E1");
    const WheelProfile    wheel   = wheel_profile("S1002");
    const ContactGeometry contact = find_contact(rail, wheel, TrackDimensions(), {0, RollMode::none});
    const FineStrip       good{contact.frame, {-0.01, 0.006}}, wide{contact.frame, {-0.09, 0.006}};

    const auto check_refused = [](const std::function<void()> &action, const std::string &what) {
      const std::string error = test::error_of<InputError>(action);
      BOOST_TEST(!error.empty(), what + ": " + error);
    };
    WheelDimensions thin, hub;
    thin.rim_width       = 0.1;
    hub.hub_outer_radius = 0.38;
    check_refused([&] { make_rail_section(rail, contact.rail, wide, 0.016); }, "strip wider than the head");
    check_refused([&] { make_rail_section(rail, contact.rail, good, 0); }, "block size zero");
    check_refused([&] { make_wheel_section(wheel, thin, contact.wheel, good, 0.016); }, "rim too narrow");
    check_refused([&] { make_wheel_section(wheel, hub, contact.wheel, good, 0.016); }, "hub too large");
  }
} // namespace


BOOST_AUTO_TEST_CASE(mesh_sections)
{
  for (const std::string rail : {"54E1", "60E1"})
    for (const double shift : {0., 1e-3, 3.5e-3, -2e-3, -3.5e-3, -5.5e-3})
      for (const double block : {16e-3, 8e-3})
        try
          {
            check_pair(rail, shift, block);
          }
        catch (const std::exception &error)
          {
            BOOST_TEST(false, rail + " at " + std::to_string(shift * 1e3) + " mm: " + error.what());
          }
  check_errors();
}
