#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/profiles/measured_profiles.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Depth below the top at which sides of heads are compared; the gauge is measured there.
    constexpr double side_depth = 14e-3;

    /// Places of a head that runs from the field side to the gauge side.
    struct HeadMarks
    {
      double                top       = 0; ///< y of the highest point [m]
      std::size_t           top_joint = 0; ///< the joint of segments next to it
      std::optional<double> field, gauge;  ///< x of the sides at `side_depth` [m]
    };

    HeadMarks
    marks_of(const Curve &head)
    {
      HeadMarks marks;
      marks.top = head.at(0).position.y;
      for (std::size_t i = 0; i < head.segments().size(); ++i)
        for (int k = 1; k <= 16; ++k)
          if (const double y = position_on(head.segments()[i], k / 16.).y; y > marks.top)
            {
              marks.top       = y;
              marks.top_joint = k < 8 ? i : i + 1;
            }
      const auto level = [&](const Point2 &p) { return p.y - (marks.top - side_depth); };
      for (const double t : head.roots(level, 0, head.parameter_end()))
        {
          const double x = head.at(t).position.x;
          if (t < static_cast<double>(marks.top_joint))
            marks.field = x;
          else if (!marks.gauge)
            marks.gauge = x;
        }
      return marks;
    }

    double
    half_width(const RailProfile &body)
    {
      return *marks_of(body.head).field;
    }

    bool
    lies_on(const HeadMarks &marks, const double half)
    {
      if (marks.top > 1e-3 || marks.top < -15e-3)
        return false;
      return marks.field ? std::abs(*marks.field - half) < 1.5e-3
                         : *marks.gauge + half > -1.5e-3 && *marks.gauge + half < 8e-3;
    }

    /// The gauge side decides where the rail lies: it must not be made up.
    void
    check_gauge_side(const HeadMarks &marks, const MeasuredProfile &profile)
    {
      const std::string depth = in_mm(side_depth) + " below the top, where the gauge is measured; a profile ";
      if (!marks.field && !marks.gauge)
        throw InputError(profile.file + ": neither side of the head reaches " + depth +
                         "that goes deeper is needed, or Profiles/Rail origin (for half-spaces)");
      if (!marks.gauge)
        throw InputError(profile.file + ": only the field side of the head reaches " + depth +
                         "that goes deeper on the gauge side is needed (when the sides are exchanged, set "
                         "Profiles/Rail mirror)");
    }

    /// From the frame of the file to that of the body; nothing where the head lies there already.
    Point2
    move_onto(const HeadMarks &marks, const RailProfile &body)
    {
      const double half = half_width(body);
      if (lies_on(marks, half))
        return {0, 0};
      return {marks.field ? half - *marks.field : -half - *marks.gauge, -marks.top};
    }

    Point2
    find_move(const HeadMarks &marks, const RailProfile &body, std::vector<std::string> &notes)
    {
      const Point2 move = move_onto(marks, body);
      if (lies_on(marks, half_width(body)))
        notes.push_back("origin of the file kept: top at y = " + in_mm(marks.top) + " of " + body.name);
      else
        notes.push_back("moved by " + in_mm(move.x) + " and " + in_mm(move.y) + ": top to y = 0, " +
                        (marks.field ? "field" : "gauge") + " side of the head to that of " + body.name);
      return move;
    }

    /// Mean distance of the line of measured points from the outline of a body on which the head is put [m].
    double
    mean_distance(const MeasuredProfile &profile, const HeadMarks &marks, const RailProfile &body)
    {
      const Point2 move = move_onto(marks, body);
      double       sum = 0, length = 0;
      for (std::size_t i = 1; i < profile.points.size(); ++i)
        {
          const Point2 a = profile.points[i - 1].position, b = profile.points[i].position,
                       q = 0.5 * (a + b) + move;
          sum += norm(b - a) * norm(body.outline.at(body.outline.closest(q)).position - q);
          length += norm(b - a);
        }
      return sum / length;
    }

    /// The standard rail whose head is as wide; where both sides were measured by the width, which wear of
    /// the gauge side makes smaller, and without a field side the one whose outline lies nearest.
    RailProfile
    choose_body(const MeasuredProfile    &profile,
                const HeadMarks          &marks,
                const std::string        &name,
                std::vector<std::string> &notes)
    {
      if (name != "auto")
        return rail_profile(name);
      std::string best;
      double      least = 1;
      for (const std::string &candidate : standard_rails())
        {
          const RailProfile body       = rail_profile(candidate);
          const double      half       = half_width(body);
          double            difference = marks.field ? std::abs(*marks.field - *marks.gauge - 2 * half)
                                                     : mean_distance(profile, marks, body);
          if (lies_on(marks, half) && marks.field)
            difference = std::abs(*marks.field - half);
          if (best.empty() || difference < least)
            {
              best  = candidate;
              least = difference;
            }
        }
      notes.push_back("body of the rail: " + best +
                      (marks.field ? ", whose head is as wide"
                                   : ", whose outline lies " + in_mm(least, 100) +
                                       " off the points on average, the nearest one") +
                      "; Profiles/Rail body changes it");
      return rail_profile(best);
    }

    /// How far from the side of the body a head may end [m].
    constexpr double most_apart = 20e-3;

    /// The side of the body's head, down to its lower corner.
    Curve
    side_of(const RailProfile &body)
    {
      const auto &all = body.outline.segments();
      return Curve({all.begin(), all.begin() + (body.head.segments().size() / 2 - 1)});
    }

    /// From the end p of a measured head (mirrored to x > 0) to the end of the body's lower corner: a
    /// line to the side of the standard head and what follows there.
    std::vector<Segment>
    lower_part(const RailProfile        &body,
               const Point2             &p,
               const std::string        &file,
               const std::string        &side,
               std::vector<std::string> &notes)
    {
      const Curve       along  = side_of(body);
      const std::size_t corner = along.segments().size();
      // a side is joined to the side, not to the crown above it
      const auto   level = along.roots([&](const Point2 &q) { return q.y - p.y; }, 0, along.parameter_end());
      const double near  = p.y < -5e-3 && !level.empty() ? level.front() : along.closest(p);
      const double apart = norm(along.at(near).position - p);
      if (apart > most_apart)
        throw InputError(file + ": the " + side + "-side end of the head, " + in_mm(-p.y, 10) +
                         " below the top of " + body.name + ", lies " + in_mm(apart, 10) +
                         " off the side of that rail, to which it is joined (up to " + in_mm(most_apart) +
                         "); check the orientation of the file, or set Profiles/Rail body to another one");
      // short where the end lies on the body: a chord of 5 mm would flatten its crown
      const double target = along.advance(near, std::max(std::min(5e-3, 1e-3 + 40 * apart), 4 * apart));
      if (apart > 1e-3)
        notes.push_back("the " + side + " side ends " + in_mm(apart, 10) + " off the side of " + body.name +
                        ": joined to it by a straight line of " +
                        in_mm(norm(along.at(target).position - p), 10) + ", which was not measured");
      std::vector<Segment> part{line_segment("joined side", p, along.at(target).position)};
      for (auto i = static_cast<std::size_t>(target); i < corner; ++i)
        part.push_back(part_of(along.segments()[i], std::clamp(target - static_cast<double>(i), 0., 1.), 1));
      part.push_back(body.outline.segments()[corner]);
      return part;
    }

    /// The measured pieces above the lower corners of the body. There are some: find_move() leaves the top
    /// at most 15 mm below that of the body, and the corners lie deeper. Ends that lie off the side end so
    /// much higher that the line to the corner is no flatter than 45 degrees; the gauge height stays.
    std::vector<Segment>
    running_part(const Curve &curve, const Point2 &move, const RailProfile &body)
    {
      const Point2         corner = body.outline.segments()[body.head.segments().size() / 2 - 1].start;
      std::vector<Segment> pieces;
      for (const Segment &g : curve.segments())
        pieces.push_back(moved(g, move));
      const auto too_low = [&](const Point2 &p) {
        const double off = std::abs(std::abs(p.x) - corner.x);
        return p.y < corner.y + std::max(2e-3, off > 1e-3 && p.y < -20e-3 ? off : 0);
      };
      while (!pieces.empty() && too_low(pieces.front().start))
        pieces.erase(pieces.begin());
      while (!pieces.empty() && too_low(pieces.back().end))
        pieces.pop_back();
      return pieces;
    }

    std::vector<Segment>
    walked_back(const std::vector<Segment> &segments)
    {
      std::vector<Segment> result;
      for (auto g = segments.rbegin(); g != segments.rend(); ++g)
        result.push_back(reversed(*g));
      return result;
    }

    std::vector<Segment>
    on_gauge_side(const std::vector<Segment> &segments)
    {
      std::vector<Segment> result;
      for (const Segment &g : segments)
        result.push_back(mirrored(g));
      return result;
    }

    void
    append(std::vector<Segment> &to, const std::vector<Segment> &from)
    {
      to.insert(to.end(), from.begin(), from.end());
    }

    /// The head, moved, on the lower part of a body.
    RailProfile
    on_body(const MeasuredProfile    &profile,
            const Point2             &move,
            const RailProfile        &body,
            std::vector<std::string> &notes)
    {
      const auto   head      = running_part(profile.curve, move, body);
      const Point2 field_end = head.front().start, gauge_end = head.back().end;
      const auto   field = lower_part(body, field_end, profile.file, "field", notes);
      const auto   gauge =
        on_gauge_side(lower_part(body, {-gauge_end.x, gauge_end.y}, profile.file, "gauge", notes));
      notes.push_back("joined to the sides of " + body.name + " " + in_mm(-field_end.y, 10) +
                      " (field side) and " + in_mm(-gauge_end.y, 10) +
                      " (gauge side) below its top; below that it is the body");

      const std::size_t    top     = marks_of(Curve(head)).top_joint;
      const auto          &all     = body.outline.segments();
      const std::size_t    half    = body.head.segments().size() / 2;
      std::vector<Segment> outline = walked_back({head.begin(), head.begin() + top});
      append(outline, field);
      append(outline, {all.begin() + half, all.end() - half});
      append(outline, walked_back(gauge));
      append(outline, walked_back({head.begin() + top, head.end()}));

      std::vector<Segment> running = walked_back(field);
      append(running, head);
      append(running, gauge);

      RailProfile rail;
      rail.name    = profile.file;
      rail.outline = Curve(outline);
      rail.head    = Curve(running);
      rail.height  = body.height;
      rail.placed  = profile.placed;
      return rail;
    }

    /// A standard rail whose halves stand `width` farther apart [m].
    RailProfile
    widened(const RailProfile &body, const double width)
    {
      const Point2         apart{0.5 * width, 0};
      const std::size_t    half = body.head.segments().size() / 2;
      std::vector<Segment> outline{line_segment("middle of the head", {0, 0}, apart)};
      for (const Segment &g : body.outline.segments())
        {
          const bool field = g.start.x + g.end.x > 0;
          if (!field && outline.back().end.x > 0)
            outline.push_back(line_segment("middle of the foot", outline.back().end, g.start - apart));
          outline.push_back(moved(g, field ? apart : -1. * apart));
        }
      outline.push_back(line_segment("middle of the head", -1. * apart, {0, 0}));
      RailProfile          wide = body;
      std::vector<Segment> head =
        walked_back({outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(half) + 1});
      append(head, walked_back({outline.end() - static_cast<std::ptrdiff_t>(half) - 1, outline.end()}));
      wide.outline = Curve(outline);
      wide.head    = Curve(head);
      return wide;
    }
  } // namespace


  RailProfile
  measured_rail(const MeasuredProfile &profile, const std::string &body_name, std::vector<std::string> &notes)
  {
    const HeadMarks marks = marks_of(profile.curve);
    if (profile.crown)
      {
        notes.push_back(
          "a crown without sides, which half-spaces alone take: its x = 0 lies on the running "
          "circle, its top at y = 0");
        std::vector<Segment> head;
        for (const Segment &g : profile.curve.segments())
          head.push_back(moved(g, {0, -marks.top}));
        return {profile.file, {}, 0, true, Curve(head)};
      }
    check_gauge_side(marks, profile);
    const RailProfile body = choose_body(profile, marks, body_name, notes);
    const Point2      move = profile.placed ? Point2{0, -marks.top} : find_move(marks, body, notes);
    if (profile.placed)
      notes.push_back("moved by " + in_mm(move.y) + ": top to y = 0; x = 0 lies on the running circle");
    return on_body(profile, move, body, notes);
  }


  RailProfile
  wide_rail(const MeasuredProfile &profile, const std::string &body, std::vector<std::string> &notes)
  {
    const HeadMarks marks = marks_of(profile.curve);
    check_gauge_side(marks, profile);
    const RailProfile standard = rail_profile(body);
    // as wide as the ends of its sides
    const Point2 field  = profile.curve.at(0).position,
                 gauge  = profile.curve.at(profile.curve.parameter_end()).position;
    const double middle = 0.5 * (field.x + gauge.x), width = field.x - gauge.x - 2 * half_width(standard);
    // the lower side is deeper than that of a usual head, so that wide blocks find room in it
    constexpr double room   = 14e-3;
    const double     deeper = room + std::abs(field.y - gauge.y);
    RailProfile      rail =
      on_body(profile, {-middle, deeper - marks.top}, width > 0 ? widened(standard, width) : standard, notes);
    rail.height += deeper;
    if (width > 0)
      notes.push_back("the body is " + body + " widened in its middle by " + in_mm(width, 10));
    for (Curve *curve : {&rail.outline, &rail.head})
      {
        std::vector<Segment> segments;
        for (const Segment &g : curve->segments())
          segments.push_back(moved(g, {middle, -deeper}));
        *curve = Curve(segments);
      }
    return rail;
  }
} // namespace wheelrail
