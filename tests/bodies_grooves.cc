// label: long
// A wheel whose tread is an arc of 10 mm in grooves of 10.25 and 10.05 mm, conformal contact, against the
// program CONTACT (tests/reference/contact_groove.csv): with the influence of a half-space along the curved
// surface, and with influences that are corrected for the turn of the normal. True bodies are those of a
// groove and a ridge.

#include "near.h"
#include "reference_table.h"

#include <wheelrail/base/format_text.h>
#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/mesh/section_builder.h>
#include <wheelrail/model/scene_material.h>

#include <cmath>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near_relative;

namespace
{
  constexpr double tip = 10e-3, rolling = 0.42;                         // [m]
  constexpr double groove_angle = 60 * degree, tip_angle = 45 * degree; // half arcs
  constexpr int    across = 20, layers = 6;                             // blocks
  const auto interpolated = [](const Point2 &a, const Point2 &b, const double f) { return a + f * (b - a); };

  /// An arc about the y axis through the origin, from the field side to the track centre.
  Curve
  arc(const double radius, const double half)
  {
    Segment s;
    s.kind        = Segment::Kind::arc;
    s.name        = "arc";
    s.centre      = {0, radius};
    s.radius      = radius;
    s.angle_start = -0.5 * M_PI + half;
    s.angle_end   = -0.5 * M_PI - half;
    s.start       = s.centre + radius * Point2{std::cos(s.angle_start), std::sin(s.angle_start)};
    s.end         = s.centre + radius * Point2{std::cos(s.angle_end), std::sin(s.angle_end)};
    return Curve({s});
  }

  /// Layers of blocks between the running surface, layer 0, and the held one; `point` of layer and place
  /// from 0 to 1, left to right.
  template <class Point>
  SectionMesh
  layered(const Point &point, const Boundary held)
  {
    SectionBuilder    builder;
    std::vector<Side> layer(layers + 1);
    for (int k = 0; k <= layers; ++k)
      {
        for (int i = 0; i <= across; ++i)
          layer[k].push_back(builder.corner(point(double(k) / layers, double(i) / across)));
        for (int i = 0; i < across; ++i)
          builder.curve(layer[k][i], layer[k][i + 1], [=](const double t) {
            return point(double(k) / layers, (i + t) / across);
          });
      }
    for (int k = 0; k < layers; ++k)
      for (int i = 0; i < across; ++i)
        builder.patch("block",
                      part(layer[k + 1], i, i + 1),
                      part(layer[k], i, i + 1),
                      {layer[k + 1][i], layer[k][i]},
                      {layer[k + 1][i + 1], layer[k][i + 1]});
    builder.mark(layer.front(), Boundary::running);
    builder.mark(layer.back(), held);
    return mesh_section(builder.section(), held, 1);
  }

  /// A groove in a ring of 120 mm.
  SectionMesh
  groove_section(const double groove)
  {
    return layered(
      [=](const double depth, const double place) {
        const double radius = groove * std::pow(0.12 / groove, depth),
                     angle  = -0.5 * M_PI + groove_angle * (2 * place - 1);
        return Point2{0, groove} + radius * Point2{std::cos(angle), std::sin(angle)};
      },
      Boundary::foot);
  }

  /// A ridge that becomes wider at 45 degrees, 60 mm high.
  SectionMesh
  ridge_section()
  {
    return layered(
      [](const double depth, const double place) {
        const double angle = 0.5 * M_PI - tip_angle * (2 * place - 1);
        return interpolated(Point2{0, rolling - tip} + tip * Point2{std::cos(angle), std::sin(angle)},
                            {0.055 * (2 * place - 1), rolling - 0.06},
                            depth * (0.3 + 0.7 * depth));
      },
      Boundary::bore);
  }

  SceneGeometry
  geometry_of(const Scene &scene, const double groove)
  {
    SceneGeometry    geometry;
    ContactGeometry &contact = geometry.contact;
    TrackDimensions  track   = scene.track;
    track.nominal_radius     = rolling;
    geometry.rail.head       = arc(groove, groove_angle);
    geometry.wheel.tread     = arc(tip, tip_angle);
    contact.outline          = wheel_outline(geometry.wheel, track, 0, 0);
    contact.axis             = axle_line(contact.wheel, track, 0);
    contact.axle             = {0, rolling};
    contact.rolling_radius   = rolling;
    contact.forward_radius   = rolling;
    contact.pose             = {contact.wheel, rolling, {}};
    contact.rail_curvature   = -1 / groove;
    contact.wheel_curvature  = 1 / tip;
    geometry.surfaces        = running_surfaces(geometry.rail.head, geometry.wheel.tread, contact);
    return geometry;
  }
} // namespace


BOOST_AUTO_TEST_CASE(bodies_grooves)
{
  const Scene scene =
    scene_from_text(
      "",
      "x.prm",
      split_list(
        "Half-space/Element size = 0.4 mm, Rail material/Young's modulus = 204.8 GPa, Wheel material/Young's "
        "modulus = 204.8 GPa, Rail material/Poisson's ratio = 0.28, Wheel material/Poisson's ratio = 0.28, "
        "Contact/Friction coefficient = 0.3, Wheelset/Velocity = 5 km/h, Wheelset/Traction coefficient = 0"))
      .scene;
  const Elasticity steel = elasticity(scene.rail_material);
  WheelRailLoad    load;
  load.force       = 1e4;
  load.vertical    = true;
  const auto table = test::read_table("contact_groove.csv");
  for (const double radius : {10.25, 10.05}) // [mm]
    {
      const double        groove   = 1e-3 * radius;
      const std::string   of       = ", groove of " + std::to_string(radius) + " mm";
      const SceneGeometry geometry = geometry_of(scene, groove);
      const BodyTables    tables{
        make_body_table(groove_section(groove), geometry.rail.head, steel, false, 0, 1),
        make_body_table(ridge_section(), geometry.wheel.tread, steel, true, rolling, 1)};
      const WheelRailSolution found = solve_bodies(scene, geometry, load, tables);
      BOOST_TEST(found.solution.converged(), "it converges" + of + found.solution.not_reached);
      double off_conformal = 1, off_halfspace = 0;
      for (const auto &row : table)
        if (std::stod(row[1]) == radius)
          {
            const bool conformal = row[0] == "conformal";
            (conformal ? off_conformal : off_halfspace) =
              1e-6 * found.solution.peak_pressure / std::stod(row[2]) - 1;
            if (conformal)
              BOOST_TEST(near_relative(1e6 * found.measures.area, std::stod(row[3]), 0.015, "area" + of));
          }
      BOOST_TEST(std::abs(off_conformal) < 0.015,
                 "peak pressure over that of corrected influences" + of + ": 1 + " +
                   std::to_string(off_conformal));
      BOOST_TEST(std::abs(off_conformal) < 0.5 * std::abs(off_halfspace),
                 "they are nearer than a half-space's" + of + ": 1 + " + std::to_string(off_halfspace));
    }
}
