// A wheel at rest on irregular surfaces, by half-spaces: CONTACT's wheel with a rounded flat, smooth surfaces
// that are written into files, a hollow whose contact is known in closed form.
#include "reference_table.h"
#include "slices_files.h"

#include <wheelrail/geometry/irregular_shapes.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/scene_irregularities.h>
#include <wheelrail/profiles/height_grid.h>
#include <wheelrail/sections/slices_file.h>
#include <wheelrail/wheel/irregular_places.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;
using test::near_relative;

namespace
{
  Segment
  line_segment(const Point2 &start, const Point2 &end)
  {
    Segment segment;
    segment.name  = "line";
    segment.start = start;
    segment.end   = end;
    return segment;
  }

  /// A cylinder of `radius` on a rail with a crown of 300 mm, both centred.
  SceneGeometry
  cylinder_on_crown(const double radius)
  {
    const double crown = 0.3, x = 0.03, angle = std::asin(x / crown);
    Segment      arc;
    arc.name        = "crown";
    arc.kind        = Segment::Kind::arc;
    arc.centre      = {0, -crown};
    arc.radius      = crown;
    arc.angle_start = M_PI / 2 - angle;
    arc.angle_end   = M_PI / 2 + angle;
    arc.start       = {x, -crown + crown * std::cos(angle)};
    arc.end         = {-x, arc.start.y};
    SceneGeometry geometry;
    geometry.rail.head          = Curve({arc});
    geometry.wheel.tread        = Curve({line_segment({0.0302, 0}, {-0.0302, 0})});
    ContactGeometry &contact    = geometry.contact;
    contact.outline             = {geometry.wheel.tread, {0, 1}};
    contact.axle                = {0, radius};
    contact.axis                = {{0, radius}, {1, 0, 0}};
    contact.pose.nominal_radius = radius;
    contact.rolling_radius      = radius;
    contact.forward_radius      = radius;
    geometry.surfaces           = running_surfaces(geometry.rail.head, geometry.wheel.tread, contact);
    return geometry;
  }

  Scene
  scene_of_contact()
  {
    Scene scene;
    for (MaterialData *material : {&scene.rail_material, &scene.wheel_material})
      {
        material->poissons_ratio = 0.28;
        material->youngs_modulus = 2 * 82e9 * 1.28;
      }
    scene.wheel_load             = 10e3;
    scene.halfspace_element_size = 0.2e-3;
    return scene;
  }

  BOOST_AUTO_TEST_CASE(test_rounded_flat)
  {
    test::write_flat("flat.slcw");
    Scene scene                  = scene_of_contact();
    scene.irregularities[0].kind = IrregularKind::file;
    scene.irregularities[0].file = "flat.slcw";
    SceneGeometry geometry       = cylinder_on_crown(0.45);
    add_irregularities(scene, geometry);
    const auto      rows = test::read_table("contact_rounded_flat.csv");
    IrregularPlaces places{true, {}};
    for (const auto &row : rows)
      places.values.push_back(std::stod(row[0]) * M_PI / 180);
    const auto found = solve_places(scene, geometry, 10e3, places);
    for (std::size_t k = 0; k < rows.size(); ++k)
      {
        const std::string at    = "pitch " + rows[k][0] + " deg: ";
        const double      pitch = std::stod(rows[k][0]);
        BOOST_TEST(found[k].fault.empty(), at + "it is solved");
        // both count from the round wheel in first touch
        BOOST_TEST(near(
          1e6 * (found[k].drop + 22.71e-6), 1e3 * std::stod(rows[k][1]), 2, at + "drop of the wheel [um]"));
        // at -5 deg the peak stands beside the kink where the flat ends, on a spline that rings there
        if (pitch == -5 || pitch == -3)
          {
            BOOST_TEST(near_relative(found[k].peak_pressure,
                                     1e6 * std::stod(rows[k][3]),
                                     pitch == -3 ? 0.02 : 0.035,
                                     at + "peak pressure"));
            BOOST_TEST(near_relative(found[k].area, 1e-6 * std::stod(rows[k][4]), 0.02, at + "area"));
          }
      }
    BOOST_TEST((found[1].centre_along > 3e-3 && found[1].centre_along < 6e-3),
               "at -5 deg the contact lies ahead");
  }

  /// The points of a profile as rows y, z of a slice: y to the field side, z down [mm].
  void
  write_slice(const Curve &curve, const std::string &file, const bool backwards = false)
  {
    std::ofstream            out(file);
    char                     line[80];
    const double             length = curve.length(0, curve.parameter_end());
    const int                n      = static_cast<int>(length / 0.05e-3);
    double                   t      = 0;
    std::vector<std::string> lines;
    for (int k = 0; k <= n; ++k)
      {
        const Point2 p = curve.at(t).position;
        std::snprintf(line, sizeof line, "%.10f %.10f\n", 1e3 * p.x, -1e3 * p.y);
        lines.push_back(line);
        t = curve.advance(t, length / n);
      }
    if (backwards)
      std::reverse(lines.begin(), lines.end());
    for (const std::string &one : lines)
      out << one;
  }

  void
  write_smooth_slices(const std::string &name, const std::string &slice, const double step)
  {
    std::ofstream out(name);
    out << "0 1 offset, scale\n5 NSLC\n0 0 0\n1\n";
    for (int k = 0; k < 5; ++k)
      out << (k - 2) * step << " '" << slice << "'\n";
  }

  /// Smooth surfaces in files are the smooth surfaces.
  BOOST_AUTO_TEST_CASE(test_smooth_files)
  {
    const Scene         smooth;
    const SceneGeometry geometry = make_geometry(smooth);
    const double        load     = 100e3;
    const auto          expected = solve_places(smooth, geometry, load, {false, {0.}})[0];
    {
      std::ofstream grid("smooth.csv");
      grid << "along_mm,across_mm,height_um\n";
      for (int i = -5; i <= 5; ++i)
        for (int j = -5; j <= 5; ++j)
          grid << 20 * i << "," << 6 * j << ",0\n";
    }
    write_slice(geometry.rail.head, "rail_slice.txt");
    write_slice(geometry.wheel.tread, "wheel_slice.txt");
    write_slice(geometry.rail.head, "rail_backwards.txt", true);
    write_smooth_slices("rail.slcs", "rail_slice.txt", 50);
    write_smooth_slices("backwards.slcs", "rail_backwards.txt", 50);
    write_smooth_slices("wheel.slcw", "wheel_slice.txt", 0.1);
    for (const std::string file : {"smooth.csv", "rail.slcs", "backwards.slcs", "wheel.slcw"})
      {
        Scene scene                  = smooth;
        scene.irregularities[0].kind = IrregularKind::file;
        scene.irregularities[0].file = file;
        const auto found             = solve_places(scene, make_geometry(scene), load, {false, {0., 7e-3}});
        for (const PlaceContact &one : found)
          {
            // points each 0.05 mm tell jumps of the curvature of the rail head to some 1e-10 m
            const double tolerance = is_slices_file(file) && file.back() == 's' ? 2e-6 : 1e-6;
            BOOST_TEST(
              near_relative(one.peak_pressure, expected.peak_pressure, tolerance, file + ": peak pressure"));
            BOOST_TEST(
              near(1e6 * one.drop, 0, file == "smooth.csv" ? 1e-6 : 2e-3, file + ": drop of the wheel [um]"));
          }
      }
  }

  /// A long shallow hollow lowers the wheel by its depth, its slope pushes with load times slope, and a wave
  /// has the same contact at the next crest.
  BOOST_AUTO_TEST_CASE(test_waves)
  {
    Scene scene;
    scene.irregularities[0].kind       = IrregularKind::corrugation;
    scene.irregularities[0].length     = 0.9;
    scene.irregularities[0].wavelength = 0.3;
    scene.irregularities[0].depth      = 20e-6;
    const SceneGeometry geometry       = make_geometry(scene);
    const double        load           = 100e3;
    const auto          found = solve_places(scene, geometry, load, {false, {0.3, 0.375, 0.45, 0.6}});
    BOOST_TEST(near(1e6 * found[2].drop, 20, 0.05, "drop in the trough [um]"));
    const double slope = M_PI * 20e-6 / 0.3;
    BOOST_TEST(near(found[1].slope_force, slope * load, 0.01 * slope * load, "force of the slope [N]"));
    BOOST_TEST(
      near_relative(found[3].peak_pressure, found[0].peak_pressure, 1e-6, "crests are alike: peak pressure"));
    // in the trough curvatures differ by 2 pi^2 depth/wavelength^2
    BOOST_TEST(found[2].peak_pressure < found[0].peak_pressure, "in the trough the pressure is lower");
  }

  /// Irregularities that overlap add up, one beside the contact is not felt, and a wheelset with yaw lies as
  /// deep in a long trough as one without.
  BOOST_AUTO_TEST_CASE(test_together)
  {
    const double load   = 100e3;
    const auto   trough = [load](const std::vector<double> &depths, const double yaw, const double lateral) {
      Scene scene;
      scene.yaw = yaw;
      for (std::size_t k = 0; k < depths.size(); ++k)
        {
          IrregularityData &wave = scene.irregularities[k];
          wave.kind              = IrregularKind::corrugation;
          wave.length            = 0.9;
          wave.wavelength        = 0.3;
          wave.depth             = depths[k];
          wave.lateral           = lateral;
          wave.width             = std::isfinite(lateral) ? 10e-3 : 0;
        }
      return solve_places(scene, make_geometry(scene), load, {false, {0.45}})[0];
    };
    const double       here = IrregularityData::automatic;
    const PlaceContact one = trough({20e-6}, 0, here), two = trough({8e-6, 12e-6}, 0, here);
    BOOST_TEST(
      near(1e6 * two.drop, 1e6 * one.drop, 1e-6, "waves of 8 and 12 um are one of 20 um: drop [um]"));
    BOOST_TEST(near_relative(two.peak_pressure, one.peak_pressure, 1e-9, "and its peak pressure"));
    const Scene  smooth;
    const double even = solve_places(smooth, make_geometry(smooth), load, {false, {0.}})[0].peak_pressure;
    const PlaceContact beside = trough({20e-6}, 0, 25e-3);
    BOOST_TEST(near(1e6 * beside.drop, 0, 1e-6, "beside the contact: drop [um]"));
    BOOST_TEST(near_relative(beside.peak_pressure, even, 1e-9, "beside the contact: peak pressure"));
    BOOST_TEST(near(1e6 * trough({20e-6}, 10e-3, here).drop, 20, 0.1, "with yaw: drop in the trough [um]"));
  }

  /// The fine cells of a run hold the patch under three times the load at each place of an irregularity, even
  /// where a flat stands on its edge and the patch is wider than that of the round wheel.
  BOOST_AUTO_TEST_CASE(test_strip)
  {
    Scene scene                  = Scene();
    scene.cell_size              = 2e-3;
    scene.rolling_distance       = 100e-3;
    scene.halfspace_element_size = 0.8e-3;
    const FineStrip   smooth     = sweep_plan(scene, make_geometry(scene)).strip;
    IrregularityData &flat       = scene.irregularities[0];
    flat.kind                    = IrregularKind::flat;
    flat.place                   = 50e-3;
    flat.length                  = 60e-3;
    const SceneGeometry geometry = make_geometry(scene);
    const FineStrip     strip    = sweep_plan(scene, geometry).strip;
    double              room = HUGE_VAL, widest = 0;
    for (const PlaceContact &one :
         solve_places(scene, geometry, 3 * expected_load(scene), parse_irregular_places("0:100:5 mm", false)))
      {
        const PatchFields &patch = one.patch;
        double             low = HUGE_VAL, high = -HUGE_VAL;
        for (unsigned int i = 0; i < patch.n_along; ++i)
          for (unsigned int j = 0; j < patch.n_lateral; ++j)
            if (patch.pressure[i * patch.n_lateral + j] > 0)
              {
                low  = std::min(low, patch.lateral[j]);
                high = std::max(high, patch.lateral[j]);
              }
        room   = std::min({room, low - strip.s.front(), strip.s.back() - high});
        widest = std::max(widest, high - low);
      }
    BOOST_TEST(room > scene.cell_size,
               "a cell and more beside the widest patch, " + std::to_string(1e3 * widest) +
                 " mm: " + std::to_string(1e3 * room) + " mm");
    BOOST_TEST(strip.s.back() - strip.s.front() > smooth.s.back() - smooth.s.front(),
               "more than for a round wheel");
  }

  /// Rows in any order, columns in any unit.
  BOOST_AUTO_TEST_CASE(test_order)
  {
    std::ofstream("order.csv") << "height_mm;along_m\n0;0.003\n0.001;0.001\n0;0\n0.002;0.002\n";
    const HeightGrid line = read_height_file("order.csv");
    BOOST_TEST((line.across.empty() && line.along.size() == 4), "a line in any order");
    BOOST_TEST(near(line.height[2], 2e-6, 1e-15, "in other units [m]"));
  }
} // namespace
