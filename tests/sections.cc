// A wheel on rails whose section changes along the track: a plain rail written as slices, a gap between two
// rails, parts that begin, and what a mesh makes of them. Against CONTACT: sections_contact.
#include "sliced_surface.h"

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/planes/wheel_on_rail.h>
#include <wheelrail/profiles/measured_profiles.h>
#include <wheelrail/sections/touching_places.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace wheelrail;
using test::head_points;
using test::near;
using test::near_relative;
using test::surface_of;
using test::write_points;
using test::write_slices;

namespace
{
  BOOST_AUTO_TEST_CASE(plain_rail)
  {
    test::write_points("head.txt", head_points());
    write_slices("plain.slcs", "head.txt", -200, 300);
    ProfileFileOptions options;
    options.noise  = 0;
    options.placed = true;
    options.turn   = ProfileMirror::yes;
    std::vector<std::string> notes;
    const TrackDimensions    track;
    const RailProfile        rail  = measured_rail(read_profile_file("head.txt", options), "54E1", notes);
    const WheelProfile       wheel = wheel_profile("S1002");
    const std::vector<SectionsSurface> rails{surface_of("plain.slcs", track.inclination, 0.1e-3)};
    for (const auto &[shift, yaw] :
         std::vector<std::pair<double, double>>{{-3e-3, 0}, {0, 0}, {3e-3, 0}, {0, 0.01}})
      {
        WheelsetPose pose;
        pose.lateral_shift          = shift;
        pose.yaw                    = yaw;
        const ContactGeometry plain = find_contact(rail, wheel, track, pose);
        const PosedWheel      posed(wheel, track, pose);
        const TouchingPlace   place = touching_places(rails, posed, 13e-3).front();
        const std::string     at    = "plain rail as slices, shift " + std::to_string(1e3 * shift) + ": ";
        BOOST_TEST(near(place.height, plain.wheel.origin.y - plain.rail.origin.y, 1e-9, at + "height [m]"));
        BOOST_TEST(near_relative(place.wheel.radius, plain.rolling_radius, 1e-6, at + "rolling radius"));
        BOOST_TEST(near(
          -1e3 * plain.rail
                   .to_section({place.place[0] + plain.rail.origin.x, place.place[1] + plain.rail.origin.y})
                   .x,
          -1e3 * plain.rail_x,
          1e-3,
          at + "place on the rail [mm]"));
        BOOST_TEST(near(place.angle, plain.angle, 1e-5, at + "contact angle"));
        BOOST_TEST(near(1e3 * place.ahead, 1e3 * plain.ahead, 1e-3, at + "ahead [mm]"));
        BOOST_TEST(near(place.slope, 0, 1e-9, at + "slope along"));
      }
  }

  /// The head, lowered by a dip of 1 mm between -100 and 100 mm.
  void
  write_dip()
  {
    std::ofstream out("dip.slcs");
    out << "0 1 U_OFFSET U_SCALE\n81 NSLC\n0 0 0 NFEAT NKINK NACCEL\n1 U_INTPOL\n";
    for (int k = 0; k <= 80; ++k)
      {
        const double        u      = -400 + 10 * k;
        std::vector<Point2> points = head_points();
        for (Point2 &p : points)
          p.y += std::abs(u) < 100 ? std::pow(std::cos(M_PI * u / 200), 4) : 0;
        const std::string file = "dip_" + std::to_string(k) + ".txt";
        write_points(file, points);
        out << u << " '" << file << "'\n";
      }
  }

  /// The mesh takes the section at the start and moves its surface: nowhere for a plain rail, and where the
  /// whole section sinks it is the sunk section.
  BOOST_AUTO_TEST_CASE(surface_of_mesh)
  {
    Scene scene;
    scene.rail_file.noise  = 0;
    scene.rail_profile     = "plain.slcs";
    scene.rolling_distance = 0.05;
    BOOST_TEST(make_geometry(scene).surfaces.rail.irregularities().empty(),
               "one section all along moves nothing");
    write_dip();
    scene.rail_profile            = "dip.slcs";
    scene.rail_place              = -0.2;
    scene.rolling_distance        = 0.4;
    const SceneGeometry   dip     = make_geometry(scene);
    const RunningSurface &surface = dip.surfaces.rail;
    BOOST_TEST(near(1e9 * surface.at(0, 0.03).n, 0, 1, "before the dip [nm]"));
    BOOST_TEST(near(1e6 * surface.at(0, 0.65).n, 0, 0.01, "behind it [um]"));
    for (const double z : {0.12, 0.15, 0.2, 0.26})
      {
        const double slices = std::pow(std::cos(M_PI * (z - 0.2) / 0.2), 4) * 1e-3;
        Placement    lower  = dip.contact.rail;
        lower.origin        = lower.to_track({0, -slices});
        const FrameProfile sunk(dip.rail.head, lower, dip.contact.frame);
        for (const double s : {-9e-3, -3e-3, 0., 4e-3, 9e-3})
          {
            const SurfaceHeight at = surface.at(s, z);
            const std::string   what =
              "sunk rail at " + std::to_string(1e3 * z) + ", " + std::to_string(1e3 * s);
            BOOST_TEST(near(1e6 * at.n, 1e6 * sunk.at(s).n, 0.5, what + " [um]"));
            BOOST_TEST(near(at.slope, sunk.at(s).slope, 1e-4, what + ", slope"));
          }
      }
    BOOST_TEST(near(surface.at(0, 0.15).slope_along,
                    (surface.at(0, 0.1501).n - surface.at(0, 0.1499).n) / 2e-4,
                    1e-6,
                    "slope along"));
    scene.rail_place              = -0.06; // in the dip
    const RunningSurface on_slope = make_geometry(scene).surfaces.rail;
    const auto           depth = [](const double z) { return std::pow(std::cos(M_PI * z / 0.2), 4) * 1e-3; };
    BOOST_TEST(near(1e6 * (on_slope.at(0, 0.009).n - on_slope.at(0, 0).n),
                    1e6 * (depth(-0.06) - depth(-0.051)),
                    0.5,
                    "the run starts on the slope of the slices [um]"));
  }

  /// The head `low` below the running circle, behind a gap of 6 mm [mm].
  void
  write_behind(const std::string &name, const double low)
  {
    std::vector<Point2> points = head_points();
    for (Point2 &p : points)
      p.y += low;
    write_points(name + ".txt", points);
    write_slices(name + ".slcs", name + ".txt", 6, 200);
  }

  /// Over the gap to a second rail that is level, 0.5 mm lower or 0.5 mm higher the wheel rolls on the ends
  /// of both: its height is the larger one of circles about them.
  BOOST_AUTO_TEST_CASE(gap_of_two_rails)
  {
    write_slices("before.slcs", "head.txt", -200, 0);
    const TrackDimensions track;
    const PosedWheel      wheel(wheel_profile("S1002"), track, {});
    for (const double low : {0., 0.5e-3, -0.5e-3})
      {
        write_behind("behind", 1e3 * low);
        std::vector<SectionsSurface> rails;
        rails.push_back(surface_of("before.slcs", 0, 0.5e-3, true));
        rails.push_back(surface_of("behind.slcs", 0, 0.5e-3, true));
        const TouchingPlace on_rail = touching_places(rails, wheel, -50e-3).front();
        const double        r       = on_rail.wheel.radius;
        const auto          sagitta = [r](const double u) { return r - std::sqrt(r * r - u * u); };
        for (const double z : {-12e-3, -1e-3, 3e-3, 5e-3, 12e-3, 40e-3})
          {
            const double first = sagitta(std::max(0., z)), second = low + sagitta(std::max(0., 6e-3 - z));
            BOOST_TEST(near(1e6 * (on_rail.height - touching_places(rails, wheel, z).front().height),
                            1e6 * std::min(first, second),
                            0.05,
                            "second rail " + std::to_string(1e3 * low) + " mm lower, at " +
                              std::to_string(1e3 * z) + " mm: drop of the wheel [um]"));
          }
        const auto in_gap = touching_places(rails, wheel, 3e-3);
        if (low == 0)
          BOOST_TEST((in_gap.size() == 2 && in_gap.front().at_end && in_gap.back().at_end && !on_rail.at_end),
                     "it touches both edges of the gap");
      }
  }

  /// What a mesh makes of them where the second is lower: nothing carries in the gap.
  BOOST_AUTO_TEST_CASE(gap_of_mesh)
  {
    write_behind("lower", 0.5);
    Scene scene;
    scene.rail_file.noise         = 0;
    scene.rail_profile            = "before.slcs";
    scene.second_rail             = "lower.slcs";
    scene.rail_place              = -0.05;
    scene.rolling_distance        = 0.1;
    const SceneGeometry   joint   = make_geometry(scene);
    const RunningSurface &surface = joint.surfaces.rail;
    BOOST_TEST(near(1e3 * surface.gap().s0, 50, 1e-9, "the gap begins [mm]"));
    BOOST_TEST(near(1e3 * surface.gap().s1, 56, 1e-9, "the gap ends [mm]"));
    BOOST_TEST(near(1e6 * surface.at(0, 49.9e-3).n, 0, 1, "the end of the first rail [um]"));
    Placement sunk = joint.contact.rail;
    sunk.origin    = sunk.to_track({0, -0.5e-3});
    BOOST_TEST(near(1e6 * surface.at(0, 56.1e-3).n,
                    1e6 * FrameProfile(joint.rail.head, sunk, joint.contact.frame).at(0).n,
                    1,
                    "the begin of the second [um]"));
    BOOST_TEST(surface.at(0, 53e-3).n < -0.5e-3, "the gap is too deep for the wheel");
    write_slices("far.slcs", "head.txt", 60, 200);
    scene.second_rail = "far.slcs";
    const Range along = overlap_along(make_geometry(scene), 0.1e-3, 0);
    BOOST_TEST((along.s0 < -30e-3 && along.s1 > 30e-3),
               "fine cells reach both ends of a gap of 60 mm: from " + std::to_string(1e3 * along.s0) +
                 " to " + std::to_string(1e3 * along.s1) + " mm");
  }

  /// A part of a rail exists from the first slice on that has it; what exists is the same rail.
  BOOST_AUTO_TEST_CASE(part_that_begins)
  {
    std::ofstream out("parts.slcs");
    out << "0 1 U_OFFSET U_SCALE\n8 NSLC\n3 1 1 NFEAT NKINK NACCEL\n1 U_INTPOL\n";
    for (int k = 0; k < 8; ++k)
      out << 10 * k << " 'head.txt'\n";
    out << "1\n-1\n";
    for (int k = 0; k < 8; ++k)
      out << 10 * k << " 0 40 " << (k < 4 ? -1 : 999) << '\n';
    out.close();
    const SectionsSurface parts = surface_of("parts.slcs"), whole = surface_of("plain.slcs");
    const SectionColumn   before = parts.column(39.9e-3), behind = parts.column(40e-3),
                        plain = whole.column(40e-3);
    BOOST_TEST(near(1e3 * before.length(), 40, 0.01, "arc length of the part that all slices have [mm]"));
    BOOST_TEST(near(1e3 * behind.length(), 1e3 * plain.length(), 0.01, "arc length of both parts [mm]"));
    const Point2 a = before.at(30e-3).position, b = behind.at(30e-3).position;
    BOOST_TEST(near(1e6 * norm(a - b), 0, 0.1, "the first part where the second begins [um]"));
  }

  /// How far slices are off as a whole is found over a dip of 1 mm, which is none of it.
  BOOST_AUTO_TEST_CASE(noise_of_whole_slices)
  {
    for (const double noise : {0., 5e-6})
      {
        std::mt19937_64                  random(4);
        std::normal_distribution<double> normal(0, 1);
        Slices                           slices;
        for (int k = -20; k <= 20; ++k)
          {
            const double        u   = 5e-3 * k;
            const double        off = noise * normal(random) - 1e-3 * std::pow(std::cos(M_PI * u / 0.2), 4);
            std::vector<Point2> points;
            for (const Point2 &p : head_points())
              points.push_back({1e-3 * p.x, off - 1e-3 * p.y});
            slices.slices.push_back({u, points, {}, ""});
          }
        BOOST_TEST(near(1e6 * SectionsSurface(slices, {}, -1, "noise.slcs").noise(),
                        1e6 * noise,
                        noise > 0 ? 1.5 : 0.3,
                        "slices that are off as a whole [um]"));
      }
  }
} // namespace
