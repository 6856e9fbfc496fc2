#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/geometry/measured_profiles.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Running circle from the flange back [m], EN 13715.
    constexpr double circle_distance = 70e-3;

    Point2
    flange_tip(const Curve &tread)
    {
      Point2 tip = tread.at(0).position;
      for (const Segment &g : tread.segments())
        for (int k = 0; k <= 8; ++k)
          if (const Point2 p = position_on(g, k / 8.); p.y < tip.y)
            tip = p;
      return tip;
    }

    /// Whether the profile goes up the back of its flange: 3 mm or more above the tip, and steeply.
    bool
    reaches_back(const Curve &tread, const Point2 &tip)
    {
      const double     end  = tread.parameter_end();
      const CurvePoint last = tread.at(end), before = tread.at(tread.advance(end, -2e-3));
      const Point2     d = last.position - before.position;
      return last.position.y > tip.y + 3e-3 && d.y > 3 * std::abs(d.x);
    }

    Point2
    find_move(const MeasuredProfile &profile, std::vector<std::string> &notes)
    {
      const Curve &tread = profile.curve;
      const Point2 tip   = flange_tip(tread);
      const bool   back  = reaches_back(tread, tip);
      double       x     = 0;
      double       low   = tip.x;
      for (const Segment &g : tread.segments())
        low = std::min(low, g.end.x);
      // a flange of 24 mm to 34 mm in thickness has its tip 47 mm to 63 mm off the running circle
      if (back && std::abs(low + circle_distance) > 1e-3)
        {
          x = -circle_distance - low;
          notes.push_back("moved laterally by " + in_mm(x) + ": flange back 70 mm off the running circle");
        }
      else if (back || (tip.x > -63e-3 && tip.x < -47e-3))
        notes.push_back("lateral origin of the file kept: running circle at x = 0");
      else
        throw InputError(
          profile.file +
          ": the running circle cannot be found: the flange tip lies at x = " + in_mm(tip.x, 10) +
          ", where -63 mm to -47 mm is expected with the origin on the running circle, and the flange back "
          "was not measured; shift the lateral coordinates so that the running circle has 0");
      const auto roots = tread.roots([&](const Point2 &p) { return p.x + x; }, 0, tread.parameter_end());
      if (roots.empty())
        throw InputError(profile.file +
                         ": the profile does not reach the running circle, 70 mm from the flange back; "
                         "a tread on both sides of it is needed");
      const double y = -tread.at(roots.front()).position.y;
      if (std::abs(y) > 1e-6)
        notes.push_back("moved vertically by " + in_mm(y) +
                        ": the running circle has the nominal rolling radius");
      return {x, y};
    }

    void
    finish_field_side(std::vector<Segment> &pieces, const double face, std::vector<std::string> &notes)
    {
      constexpr double chamfer = 5e-3;
      const double     wide    = pieces.front().start.x;
      while (pieces.size() > 1 && pieces.front().start.x > face)
        pieces.erase(pieces.begin());
      if (wide > face)
        notes.push_back("cut at the rim face, " + in_mm(face - pieces.front().start.x, 100) + " before it");
      const Point2 end = pieces.front().start;
      if (end.x > face - chamfer - 1e-6)
        return;
      // the direction over the last 10 mm, which noise turns less than the tangent
      const Curve  curve(pieces);
      const Point2 inside = curve.at(curve.advance(0, 10e-3)).position;
      const double slope  = std::abs(end.x - inside.x) > 5e-3 ? (end.y - inside.y) / (end.x - inside.x) : 0;
      const double x      = face - chamfer;
      pieces.insert(pieces.begin(), line_segment("continued tread", {x, end.y + slope * (x - end.x)}, end));
      notes.push_back("tread continued straight by " + in_mm(x - end.x, 100) + " on the field side");
    }

    void
    finish_back(std::vector<Segment>     &pieces,
                const Point2             &tip,
                const std::string        &file,
                std::vector<std::string> &notes)
    {
      // the back above the running circle belongs to the rim
      while (pieces.size() > 1 && pieces.back().end.x < tip.x && pieces.back().end.y > 5e-3)
        pieces.pop_back();
      const CurvePoint last = point_on(pieces.back(), 1);
      const Point2     t = last.tangent, end = last.position;
      const double     room = end.x + circle_distance;
      if (room < 2e-4)
        return;
      // an arc with this tangent at the end that turns into the vertical at the flange back
      const double bend = 1 - t.y; // radius times this is the way to the left
      if (end.x > tip.x + 1e-9 || t.x >= 0 || t.y < -0.2 || bend < 1e-6)
        throw InputError(file + ": the profile ends at x = " + in_mm(end.x, 10) +
                         ", y = " + in_mm(end.y, 10) +
                         " before the top of the flange; the whole flange front and its tip are needed");
      Segment arc;
      arc.kind        = Segment::Kind::arc;
      arc.name        = "continued flange";
      arc.radius      = room / bend;
      arc.centre      = end + arc.radius * Point2{t.y, -t.x};
      arc.angle_start = std::atan2(-(arc.centre.y - end.y), -(arc.centre.x - end.x));
      if (arc.angle_start < 0)
        arc.angle_start += 2 * std::acos(-1.);
      arc.angle_end = std::acos(-1.);
      arc.start     = end;
      arc.end       = arc.centre + Point2{-arc.radius, 0};
      pieces.push_back(arc);
      notes.push_back("flange continued by an arc of " + in_mm(arc.radius, 10) + " into the flange back");
    }
  } // namespace


  WheelProfile
  measured_wheel(const MeasuredProfile &profile, const double rim_width, std::vector<std::string> &notes)
  {
    const Point2         move = find_move(profile, notes);
    std::vector<Segment> pieces;
    for (const Segment &g : profile.curve.segments())
      pieces.push_back(moved(g, move));
    const Point2 tip = flange_tip(profile.curve) + move;
    finish_field_side(pieces, rim_width - circle_distance, notes);
    finish_back(pieces, tip, profile.file, notes);

    WheelProfile wheel;
    wheel.name  = profile.file;
    wheel.tread = Curve(pieces);
    return wheel;
  }
} // namespace wheelrail
