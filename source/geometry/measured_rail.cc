#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/geometry/measured_profiles.h>

#include <algorithm>
#include <cmath>
#include <optional>

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
                         "that goes deeper is needed");
      if (!marks.gauge)
        throw InputError(profile.file + ": only the field side of the head reaches " + depth +
                         "that goes deeper on the gauge side is needed (when the sides are exchanged, set "
                         "Profiles/Rail mirror)");
    }

    /// The standard rail whose head is as wide; where both sides were measured by the width, which wear of
    /// the gauge side makes smaller.
    RailProfile
    choose_body(const HeadMarks &marks, const std::string &name, std::vector<std::string> &notes)
    {
      if (name != "auto")
        return rail_profile(name);
      std::string best;
      double      least = 1;
      for (const std::string &candidate : standard_rails())
        {
          const double half       = half_width(rail_profile(candidate));
          double       difference = least;
          if (lies_on(marks, half) && marks.field)
            difference = std::abs(*marks.field - half);
          else if (marks.field && marks.gauge)
            difference = std::abs(*marks.field - *marks.gauge - 2 * half);
          if (best.empty() || difference < least)
            {
              best  = candidate;
              least = difference;
            }
        }
      notes.push_back("body of the rail: " + best +
                      (marks.field ? ", whose head is as wide" : ", the first of the standard ones") +
                      "; Profiles/Rail body changes it");
      return rail_profile(best);
    }

    Point2
    find_move(const HeadMarks &marks, const RailProfile &body, std::vector<std::string> &notes)
    {
      const double half = half_width(body);
      if (lies_on(marks, half))
        {
          notes.push_back("origin of the file kept: top at y = " + in_mm(marks.top) + " of " + body.name);
          return {0, 0};
        }
      const Point2 move{marks.field ? half - *marks.field : -half - *marks.gauge, -marks.top};
      notes.push_back("moved by " + in_mm(move.x) + " and " + in_mm(move.y) + ": top to y = 0, " +
                      (marks.field ? "field" : "gauge") + " side of the head to that of " + body.name);
      return move;
    }

    /// From the end p of a measured head (mirrored to x > 0) to the end of the body's lower corner: a
    /// line to the side of the standard head and what follows there.
    std::vector<Segment>
    lower_part(const RailProfile &body, const Point2 &p, const std::string &file, const char *side)
    {
      const std::size_t corner = body.head.segments().size() / 2 - 1;
      const double      near   = body.outline.closest(p);
      const double      apart  = norm(body.outline.at(near).position - p);
      if (apart > 12e-3 || near > static_cast<double>(corner))
        throw InputError(file + ": the " + side + "-side end of the head, " + in_mm(-p.y, 10) +
                         " below the top of " + body.name + ", lies " + in_mm(apart, 10) +
                         " off the side of that rail, to which it is joined (up to 12 mm, and above its "
                         "lower corner); check the orientation "
                         "of the file, or set Profiles/Rail body to another one");
      const double target =
        std::min(body.outline.advance(near, std::max(5e-3, 4 * apart)), static_cast<double>(corner));
      const std::size_t    first = static_cast<std::size_t>(target);
      std::vector<Segment> part{line_segment("joined side", p, body.outline.at(target).position)};
      part.push_back(part_of(body.outline.segments()[first], target - static_cast<double>(first), 1));
      for (std::size_t i = first + 1; i <= corner; ++i)
        part.push_back(body.outline.segments()[i]);
      return part;
    }

    /// The measured pieces above the lower corners of the body. There are some: find_move() leaves the top
    /// at most 15 mm below that of the body, and the corners lie deeper.
    std::vector<Segment>
    running_part(const Curve &curve, const Point2 &move, const RailProfile &body)
    {
      const std::size_t    corner = body.head.segments().size() / 2 - 1;
      const double         lowest = body.outline.segments()[corner].start.y + 2e-3;
      std::vector<Segment> pieces;
      for (const Segment &g : curve.segments())
        pieces.push_back(moved(g, move));
      while (!pieces.empty() && pieces.front().start.y < lowest)
        pieces.erase(pieces.begin());
      while (!pieces.empty() && pieces.back().end.y < lowest)
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
  } // namespace


  RailProfile
  measured_rail(const MeasuredProfile &profile, const std::string &body_name, std::vector<std::string> &notes)
  {
    const HeadMarks marks = marks_of(profile.curve);
    check_gauge_side(marks, profile);
    const RailProfile body      = choose_body(marks, body_name, notes);
    const Point2      move      = find_move(marks, body, notes);
    const auto        head      = running_part(profile.curve, move, body);
    const Point2      field_end = head.front().start, gauge_end = head.back().end;
    const auto        field = lower_part(body, field_end, profile.file, "field");
    const auto gauge = on_gauge_side(lower_part(body, {-gauge_end.x, gauge_end.y}, profile.file, "gauge"));
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
    return rail;
  }
} // namespace wheelrail
