#include <wheelrail/geometry/standard_rails.h>

#include <cmath>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    // All dimensions in this file are in millimetres, as on the drawings; they become metres when
    // the segments are made.

    /// A line or circle on which a segment of the outline lies. The outline runs clockwise, with
    /// the steel on its right.
    struct Carrier
    {
      const char *name;
      bool        is_line;
      Point2      point;      ///< a point of the line, or the centre
      Point2      direction;  ///< of the line, unit vector in running direction
      double      radius = 0; ///< of the circle
      bool        convex = true;
    };

    Carrier
    line(const char *name, const Point2 &through, const Point2 &direction)
    {
      return {name, true, through, (1. / norm(direction)) * direction, 0, true};
    }

    Carrier
    circle(const char *name, const Point2 &centre, const double radius, const bool convex)
    {
      return {name, false, centre, {}, radius, convex};
    }

    /// Where two carriers that touch pass into each other.
    Point2
    joint(const Carrier &a, const Carrier &b)
    {
      if (a.is_line)
        return a.point + dot(b.point - a.point, a.direction) * a.direction;
      if (b.is_line)
        return joint(b, a);
      // Internal tangency: the point lies on the line of centres, on the side of the smaller one.
      const Carrier &large  = a.radius > b.radius ? a : b;
      const Carrier &small  = a.radius > b.radius ? b : a;
      const Point2   centre = small.point - large.point;
      return large.point + (large.radius / norm(centre)) * centre;
    }

    /// The line moved to its right (negative: left) by `distance`.
    Carrier
    shifted(const Carrier &l, const double distance)
    {
      return line(l.name, l.point + distance * Point2{l.direction.y, -l.direction.x}, l.direction);
    }

    /// Circle of given radius that rounds the corner from line a to line b.
    Carrier
    fillet(const char *name, const Carrier &a, const Carrier &b, const double radius, const bool convex)
    {
      const double  side = convex ? radius : -radius;
      const Carrier sa = shifted(a, side), sb = shifted(b, side);
      const double  along = cross(sb.point - sa.point, sb.direction) / cross(sa.direction, sb.direction);
      return circle(name, sa.point + along * sa.direction, radius, convex);
    }

    /// Concave circle of given radius between a line and the inside of a larger concave circle;
    /// of the two solutions the one further along the line (sign = 1) or further back (-1).
    Carrier
    fillet_to_circle(const char    *name,
                     const Carrier &l,
                     const Carrier &large,
                     const double   radius,
                     const double   sign)
    {
      const Carrier s        = shifted(l, -radius);
      const Point2  d        = large.point - s.point;
      const double  foot     = dot(d, s.direction);
      const double  distance = cross(d, s.direction);
      const double  reach    = large.radius - radius;
      return circle(name,
                    s.point + (foot + sign * std::sqrt(reach * reach - distance * distance)) * s.direction,
                    radius,
                    false);
    }

    /// Concave circle inside a larger concave one, touching it, with its centre at height y on the
    /// side towards the web.
    Carrier
    inner_circle(const char *name, const Carrier &large, const double y, const double radius)
    {
      const double reach = large.radius - radius, dy = y - large.point.y;
      return circle(name, {large.point.x - std::sqrt(reach * reach - dy * dy), y}, radius, false);
    }

    /// Circle that continues a convex circle from its point at abscissa x with a common tangent.
    Carrier
    continued(const char *name, const Carrier &before, const double x, const double radius)
    {
      const double dx   = x - before.point.x;
      const Point2 from = {x, before.point.y + std::sqrt(before.radius * before.radius - dx * dx)};
      return circle(name, from + (radius / before.radius) * (before.point - from), radius, true);
    }

    Segment
    segment_on(const Carrier &c, const Point2 &from, const Point2 &to)
    {
      Segment g;
      g.name  = c.name;
      g.start = 1e-3 * from;
      g.end   = 1e-3 * to;
      if (c.is_line)
        return g;
      g.kind           = Segment::Kind::arc;
      g.centre         = 1e-3 * c.point;
      g.radius         = 1e-3 * c.radius;
      const auto polar = [&c](const Point2 &p) { return std::atan2(p.y - c.point.y, p.x - c.point.x); };
      g.angle_start    = polar(from);
      // No arc turns by more than half a circle, convex ones clockwise, concave ones counter-clockwise.
      const double sweep = std::remainder(polar(to) - g.angle_start, 2. * M_PI);
      g.angle_end        = g.angle_start + sweep;
      return g;
    }

    /// Outline and head from the carriers of the field-side half, which start at the crown and end
    /// with the base; `head_size` of them belong to the head.
    RailProfile
    assemble(const std::string          &name,
             const double                height,
             const std::vector<Carrier> &half,
             const unsigned int          head_size)
    {
      std::vector<Segment> right;
      Point2               from = {0, 0};
      for (std::size_t i = 0; i < half.size(); ++i)
        {
          const Point2 to = i + 1 < half.size() ? joint(half[i], half[i + 1]) : Point2{0, -height};
          right.push_back(segment_on(half[i], from, to));
          from = to;
        }

      std::vector<Segment> outline = right, head;
      for (auto g = right.rbegin(); g != right.rend(); ++g)
        outline.push_back(reversed(mirrored(*g)));
      for (unsigned int i = head_size; i > 0; --i)
        head.push_back(reversed(right[i - 1]));
      for (unsigned int i = 0; i < head_size; ++i)
        head.push_back(mirrored(right[i]));

      RailProfile rail;
      rail.name    = name;
      rail.outline = Curve(outline);
      rail.head    = Curve(head);
      rail.height  = 1e-3 * height;
      return rail;
    }

    /// Crown, head radius and corner as all rails of the family have them: R300, R80, R13.
    struct Head
    {
      Carrier crown, shoulder, corner, side;
    };

    Head
    head_of(const double crown_half_width, const double shoulder_half_width)
    {
      Head h;
      h.crown    = circle("crown R300", {0, -300}, 300, true);
      h.shoulder = continued("head R80", h.crown, crown_half_width, 80);
      h.corner   = continued("corner R13", h.shoulder, shoulder_half_width, 13);
      // The side 1:20 starts where the corner has its slope.
      const Point2 down = (1. / std::sqrt(401.)) * Point2{1, -20};
      h.side            = line("head side 1:20", h.corner.point + 13. * Point2{-down.y, down.x}, down);
      return h;
    }
  } // namespace


  RailProfile
  rail_54E1()
  {
    const Head    h          = head_of(10.012, 24.8635);
    const Carrier underside  = line("head underside 1:2.75", {0, -49.4}, {-2.75, -1});
    const Carrier web        = circle("web R508", {516, -82.8}, 508, false);
    const Carrier upper_web  = inner_circle("upper web R22", web, -57.4, 22);
    const Carrier foot_steep = line("foot top 1:2.75", {0, -128.8}, {2.75, -1});
    const Carrier foot_flat  = line("foot top 1:10", {70, -148}, {10, -1});
    const Carrier toe        = line("toe", {70, 0}, {0, -1});
    const Carrier base       = line("base", {0, -159}, {-1, 0});

    return assemble("54E1",
                    159,
                    {h.crown,
                     h.shoulder,
                     h.corner,
                     h.side,
                     fillet("head lower corner R3", h.side, underside, 3, true),
                     underside,
                     fillet_to_circle("upper web R8", underside, upper_web, 8, 1),
                     upper_web,
                     web,
                     fillet_to_circle("lower web R16", foot_steep, web, 16, -1),
                     foot_steep,
                     fillet("foot R20", foot_steep, foot_flat, 20, false),
                     foot_flat,
                     fillet("toe top R3", foot_flat, toe, 3, true),
                     toe,
                     fillet("toe bottom R2", toe, base, 2, true),
                     base},
                    5);
  }


  RailProfile
  rail_60E1()
  {
    const Head    h          = head_of(10.228, 26.0265);
    const Carrier underside  = line("head underside 1:2.75", {0, -51}, {-2.75, -1});
    const Carrier upper_120  = circle("upper web R120", {128.25, -79.75}, 120, false);
    const Carrier upper_35   = inner_circle("upper web R35", upper_120, -60.25, 35);
    const Carrier web        = line("web", {8.25, 0}, {0, -1});
    const Carrier lower_120  = circle("lower web R120", {128.25, -111.75}, 120, false);
    const Carrier lower_35   = inner_circle("lower web R35", lower_120, -131.25, 35);
    const Carrier foot_steep = line("foot top 1:2.75", {0, -140.5}, {2.75, -1});
    const Carrier foot_flat  = line("foot top 1:14", {75, -160.5}, {14, -1});
    const Carrier toe        = line("toe", {75, 0}, {0, -1});
    const Carrier base       = line("base", {0, -172}, {-1, 0});

    return assemble("60E1",
                    172,
                    {h.crown,
                     h.shoulder,
                     h.corner,
                     h.side,
                     fillet("head lower corner R3", h.side, underside, 3, true),
                     underside,
                     fillet_to_circle("upper web R7", underside, upper_35, 7, 1),
                     upper_35,
                     upper_120,
                     web,
                     lower_120,
                     lower_35,
                     fillet_to_circle("lower web R7", foot_steep, lower_35, 7, -1),
                     foot_steep,
                     fillet("foot R40", foot_steep, foot_flat, 40, false),
                     foot_flat,
                     fillet("toe top R4", foot_flat, toe, 4, true),
                     toe,
                     fillet("toe bottom R2", toe, base, 2, true),
                     base},
                    5);
  }
} // namespace wheelrail
