#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/receptance/hammer_places.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    const Vector3 up = {0, 1, 0}, to_centre = {1, 0, 0};

    /// Points of the running surface of a section.
    std::vector<Point2>
    surface_points(const Section &section)
    {
      constexpr int       parts = 20; // of an edge
      std::vector<Point2> points;
      for (std::size_t block = 0; block < section.blocks.size(); ++block)
        for (unsigned int edge = 0; edge < 4; ++edge)
          {
            const auto mark = section.boundary.find(Section::edge_key(section.blocks[block].corner, edge));
            if (mark == section.boundary.end() || mark->second != Boundary::running)
              continue;
            for (int p = 0; p <= parts; ++p)
              {
                const double t = double(p) / parts;
                points.push_back(section.position(block, edge < 2 ? edge : t, edge < 2 ? t : edge - 2.));
              }
          }
      return points;
    }

    Point2
    top_of(const std::vector<Point2> &points)
    {
      return *std::max_element(
        points.begin(), points.end(), [](const Point2 &a, const Point2 &b) { return a.y < b.y; });
    }

    /// The side of the head towards the track centre, 14 mm below the top.
    Point2
    side_of(const std::vector<Point2> &points)
    {
      constexpr double below = 14e-3;
      const double     y = top_of(points).y - below, middle = top_of(points).x;
      Point2           best{middle, 1e9};
      for (const Point2 &p : points)
        if (p.x > middle && std::abs(p.y - y) < std::abs(best.y - y))
          best = p;
      return best;
    }

    /// The stretch of the rail without damping [m].
    std::array<double, 2>
    undamped(const Scene &scene)
    {
      const double middle = 0.5 * scene.mesh_distance(),
                   half   = 0.5 * scene.rail_length - scene.support.damped_ends;
      return {middle - half, middle + half};
    }

    double
    place_of(const Scene &scene, const std::string &at)
    {
      const auto   ends    = undamped(scene);
      const double middle  = 0.5 * (ends[0] + ends[1]);
      const bool   between = at == "between", over = at == "sleeper";
      const bool   sleepers = scene.support.kind == RailSupport::sleepers;
      if ((between || over) && !sleepers)
        throw InputError("--at " + at +
                         ": the scene has no sleepers; set Track/Support = sleepers, or give a place "
                         "along the track, such as --at \"250 mm\"");
      double place = middle;
      if (between || over || (at.empty() && sleepers))
        {
          const double first = scene.support.first_sleeper + (between ? 0.5 * scene.support.spacing : 0);
          place = first + std::round((middle - first) / scene.support.spacing) * scene.support.spacing;
        }
      else if (!at.empty())
        try
          {
            place = parse_quantity(at, Dimension::length);
          }
        catch (const InputError &error)
          {
            throw InputError("--at " + at + ": neither sleeper nor between nor a place along the track; " +
                             error.what());
          }
      constexpr double margin = 0.1;
      if (place < ends[0] + margin || place > ends[1] - margin)
        throw InputError("--at " + (at.empty() ? "sleeper" : at) + ": at " + rounded_mm(place) +
                         " the hammer hits the rail beside the stretch from " + rounded_mm(ends[0]) + " to " +
                         rounded_mm(ends[1]) +
                         ", where it is not damped; take another place, a longer Track/Rail length or "
                         "shorter Track/Damped ends");
      return place;
    }
  } // namespace


  RailPlaces
  rail_places(const Scene &scene, const Section &rail, const std::string &at, const bool lateral)
  {
    constexpr double farthest = 4, margin = 0.05;
    RailPlaces       places;
    places.along            = place_of(scene, at);
    const auto       points = surface_points(rail);
    const Point2     struck = lateral ? side_of(points) : top_of(points);
    const HammerFace face   = {
        Body::rail, {struck.x, struck.y, places.along}, HammerFace().radius, lateral ? to_centre : up};
    HammerFace other  = face;
    other.direction   = lateral ? up : to_centre;
    places.faces      = {face, other};
    places.distance   = {0};
    const auto   ends = undamped(scene);
    const double room = std::min(farthest, std::max(ends[1] - places.along, places.along - ends[0]) - margin);
    // towards the longer side; waves are symmetric
    const double sense = ends[1] - places.along >= places.along - ends[0] ? 1 : -1;
    for (double away = 0.1; away <= room; away += away < 1.15 ? 0.1 : 0.2)
      {
        HammerFace farther = face;
        farther.middle[2] += sense * away;
        places.faces.push_back(farther);
        places.distance.push_back(away);
      }
    return places;
  }


  std::vector<HammerFace>
  wheel_faces(const SceneGeometry &geometry, const bool lateral)
  {
    const Point2     at = geometry.contact.frame.origin;
    const HammerFace face{Body::wheel, {at.x, at.y, 0}, HammerFace().radius, lateral ? to_centre : up};
    HammerFace       other = face;
    other.direction        = lateral ? up : to_centre;
    return {face, other};
  }
} // namespace wheelrail
