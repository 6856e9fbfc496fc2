#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/profiles/measured_profiles.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

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

    /// What a profile shows of its flange.
    struct Flange
    {
      Point2 tip;          ///< lowest point; where the flange was cut short, its end
      double low  = 0;     ///< least x [m]
      bool   back = false; ///< its back was measured
      bool   cut  = false; ///< it ends before its tip
    };

    Flange
    flange_of(const Curve &tread)
    {
      Flange flange;
      flange.tip  = flange_tip(tread);
      flange.back = reaches_back(tread, flange.tip);
      flange.low  = flange.tip.x;
      for (const Segment &g : tread.segments())
        flange.low = std::min(flange.low, g.end.x);
      const CurvePoint end = tread.at(tread.parameter_end());
      flange.cut           = norm(end.position - flange.tip) < 1e-4 && end.tangent.y < -0.2;
      return flange;
    }

    /// The lateral move that puts the running circle at x = 0 where Profiles/Wheel origin leaves it to the
    /// program: by the flange back, or by the place of the tip, which is 47 mm to 63 mm off the running
    /// circle and 14 mm to 22 mm off the back with flanges 24 mm to 34 mm thick. A flange cut short ends up
    /// to 10 mm before its tip.
    double
    lateral_move(const Flange &flange, const std::string &file, std::vector<std::string> &notes)
    {
      const double short_by = flange.cut ? 10e-3 : 0;
      const auto   tip_in   = [&](const double low, const double high) {
        return flange.tip.x > low && flange.tip.x < high + short_by;
      };
      if (flange.back && std::abs(flange.low + circle_distance) > 1e-3 && std::abs(flange.low) > 1e-3)
        {
          const double move = -circle_distance - flange.low;
          notes.push_back("moved laterally by " + in_mm(move) + ": flange back 70 mm off the running circle");
          return move;
        }
      if (std::abs(flange.low + circle_distance) <= 1e-3 || (!flange.back && tip_in(-63e-3, -47e-3)))
        {
          notes.push_back("lateral origin of the file kept: running circle at x = 0");
          return 0;
        }
      if (flange.back || tip_in(14e-3, 22e-3))
        {
          notes.push_back(
            "moved laterally by -70 mm: the origin of the file lies on the flange back, since " +
            (flange.back ? "the back is at x = " + in_mm(flange.low, 100)
                         : "the tip is at x = " + in_mm(flange.tip.x, 10)) +
            "; Profiles/Wheel origin changes it");
          return -circle_distance;
        }
      throw InputError(file + ": the running circle cannot be found: the flange " +
                       (flange.cut ? "ends" : "tip lies") + " at x = " + in_mm(flange.tip.x, 10) +
                       ", where -63 mm to -47 mm is expected with the origin on the running circle, 14 mm to "
                       "22 mm with the origin on "
                       "the flange back, and the flange back was not measured; shift the lateral coordinates "
                       "so that the running "
                       "circle has 0, or set Profiles/Wheel origin");
    }

    Point2
    find_move(const MeasuredProfile &profile, const WheelOrigin origin, std::vector<std::string> &notes)
    {
      const Curve &tread  = profile.curve;
      const Flange flange = flange_of(tread);
      double       x      = 0;
      if (profile.crown)
        notes.push_back(
          "a crown without flange, which half-spaces alone take: its x = 0 is the running circle");
      else if (origin == WheelOrigin::automatic)
        x = lateral_move(flange, profile.file, notes);
      else
        {
          const bool back = origin == WheelOrigin::flange_back;
          x               = back ? -circle_distance : 0;
          notes.push_back(back ? "moved laterally by -70 mm: Profiles/Wheel origin = flange back"
                               : "lateral origin of the file kept: Profiles/Wheel origin = running circle");
          // a flange thicker than 44 mm, or its field side left of its back
          if (flange.tip.x + x < -circle_distance || flange.tip.x + x > -35e-3)
            throw InputError(
              profile.file + ": with Profiles/Wheel origin = " + (back ? "flange back" : "running circle") +
              " the flange tip lies at x = " + in_mm(flange.tip.x + x, 10) +
              ", the running circle being 0; -70 mm to -35 mm is possible: write another origin, or auto");
        }
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
      // what lies higher than the chamfer of a new wheel is the face of the rim
      const std::size_t all = pieces.size();
      while (pieces.size() > 1 && pieces.front().start.x > 0 && pieces.front().start.y > 8e-3)
        pieces.erase(pieces.begin());
      if (pieces.size() < all)
        notes.push_back("face of the rim left out, more than 8 mm above the running circle");
      const double wide = pieces.front().start.x;
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
      if (room < 2e-4 || t.y > 0.999) // the back itself, also one that a given origin puts elsewhere
        return;
      // an arc with this tangent at the end that turns into the vertical at the flange back
      const double bend   = 1 - t.y; // radius times this is the path to the left
      const bool   cut    = t.y < -0.2;
      const double lowest = cut ? end.y - room / bend * (1 + t.x) : tip.y;
      if (end.x > tip.x + 1e-9 || t.x >= 0 || bend < 1e-6 || (cut && (lowest > -20e-3 || lowest < -40e-3)))
        throw InputError(
          file + ": the profile ends at x = " + in_mm(end.x, 10) + ", y = " + in_mm(end.y, 10) +
          " before the top of the flange, and an arc from there to the flange back makes no flange 20 mm to "
          "40 mm high; more of the flange front is needed");
      Segment arc;
      arc.kind        = Segment::Kind::arc;
      arc.name        = "continued flange";
      arc.radius      = room / bend;
      arc.centre      = end + arc.radius * Point2{t.y, -t.x};
      arc.angle_start = std::atan2(-(arc.centre.y - end.y), -(arc.centre.x - end.x));
      if (arc.angle_start < 0)
        arc.angle_start += 2 * M_PI;
      arc.angle_end = M_PI;
      arc.start     = end;
      arc.end       = arc.centre + Point2{-arc.radius, 0};
      pieces.push_back(arc);
      notes.push_back("flange continued by an arc of " + in_mm(arc.radius, 10) + " into the flange back");
      if (cut)
        notes.push_back(
          "the flange was cut off at x = " + in_mm(end.x, 10) + ", y = " + in_mm(end.y, 10) +
          ", before its tip: its height (" + in_mm(-lowest, 10) +
          " now), its tip and its back are made up, and contact beyond the cut cannot be trusted");
    }
  } // namespace


  WheelProfile
  measured_wheel(const MeasuredProfile    &profile,
                 const double              rim_width,
                 std::vector<std::string> &notes,
                 const WheelOrigin         origin)
  {
    const Point2         move = find_move(profile, origin, notes);
    std::vector<Segment> pieces;
    for (const Segment &g : profile.curve.segments())
      pieces.push_back(moved(g, move));
    if (profile.crown)
      return {profile.file, Curve(pieces), true};
    const Point2 tip = flange_tip(profile.curve) + move;
    finish_field_side(pieces, rim_width - circle_distance, notes);
    finish_back(pieces, tip, profile.file, notes);

    WheelProfile wheel;
    wheel.name  = profile.file;
    wheel.tread = Curve(pieces);
    return wheel;
  }
} // namespace wheelrail
