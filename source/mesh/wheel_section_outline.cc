#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/mesh/section.h>
#include <wheelrail/mesh/wheel_section_outline.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    Segment
    arc(const char   *name,
        const Point2 &centre,
        const double  radius,
        const double  angle_start,
        const double  angle_end)
    {
      Segment segment;
      segment.kind        = Segment::Kind::arc;
      segment.name        = name;
      segment.centre      = centre;
      segment.radius      = radius;
      segment.angle_start = angle_start;
      segment.angle_end   = angle_end;
      segment.start       = centre + radius * Point2{std::cos(angle_start), std::sin(angle_start)};
      segment.end         = centre + radius * Point2{std::cos(angle_end), std::sin(angle_end)};
      return segment;
    }

    void
    require(const bool good, const std::string &what)
    {
      if (!good)
        throw InputError("The wheel section cannot be built: " + what);
    }

    void
    check_dimensions(const WheelDimensions &d, const double tread_width)
    {
      const double f = d.fillet_radius, half = 0.5 * d.disc_thickness + f;
      require(f > 0, "the fillet radius must be positive.");
      require(d.disc_thickness > 0, "the disc thickness must be positive.");
      require(d.bore_radius > 0 && d.bore_radius < d.hub_outer_radius,
              "the bore radius must be positive and less than the outer radius of the hub.");
      require(
        d.hub_outer_radius + 2 * f < d.rim_inner_radius,
        "hub and rim leave no room for the disc and its fillets; the outer radius of the hub plus two fillet "
        "radii must be less than the inner radius of the rim.");
      require(d.rim_inner_radius < d.nominal_radius - 0.02,
              "the rim must be at least 20 mm thick at the running circle.");
      require(d.disc_position - half > 0 && d.disc_position + half < d.rim_width,
              "the disc with its fillets must lie within the width of the rim.");
      require(std::abs(d.hub_position - d.disc_position) + half < 0.5 * d.hub_length,
              "the disc with its fillets must lie within the length of the hub.");
      // a profile as wide as the rim, but for what its file rounds off, is accepted
      require(tread_width < d.rim_width + 1e-4,
              "the profile is " + in_mm(tread_width) + " wide, which is more than the rim width of " +
                in_mm(d.rim_width) + ". Shorten the profile or widen the rim.");
    }

    // Rim outline in the frame of the profile: up the field side, a 45 degree chamfer if the profile
    // ends short of it, the profile, and down the flange back.
    void
    make_rim_outline(WheelSectionOutline &wheel, const WheelProfile &profile, const WheelDimensions &d)
    {
      const Point2 start = profile.tread.at(0).position;
      const Point2 end   = profile.tread.at(profile.tread.parameter_end()).position;
      const double face  = end.x + d.rim_width;
      const double low   = d.nominal_radius - d.rim_inner_radius;

      const bool           chamfer = face - start.x > 1e-4;
      const Point2         top     = chamfer ? Point2{face, start.y + face - start.x} : start;
      std::vector<Segment> segments{line_segment("rim face", {top.x, low}, top)};
      if (chamfer)
        segments.push_back(line_segment("chamfer", top, start));
      segments.insert(segments.end(), profile.tread.segments().begin(), profile.tread.segments().end());
      segments.push_back(line_segment("flange back", end, {end.x, low}));

      wheel.rim         = {std::make_shared<const Curve>(segments), -1, d.nominal_radius};
      wheel.tread_start = 1;
      wheel.back        = wheel.rim.curve->parameter_end() - 1;
      wheel.disc        = -end.x - d.disc_position;
    }

    // Underside of the rim, disc and hub on one side (+1 field, -1 gauge), in a frame with the radius
    // as y and x positive to the field side.
    MirroredCurve
    make_disc_outline(const WheelSectionOutline &wheel, const WheelDimensions &d, const double side)
    {
      const double f      = d.fillet_radius;
      const double middle = -wheel.disc, surface = middle + side * 0.5 * d.disc_thickness;
      const double rim  = -wheel.rim.position(side > 0 ? 0 : wheel.back + 1).x;
      const double hub  = middle + d.disc_position - d.hub_position + side * 0.5 * d.hub_length;
      const double high = d.rim_inner_radius, low = d.hub_outer_radius;
      const auto   turned = [side](const double angle) { return (side > 0 ? angle : 180 - angle) * degree; };

      const double centre = surface + side * f;
      return {std::make_shared<const Curve>(
                std::vector<Segment>{line_segment("rim underside", {rim, high}, {centre, high}),
                                     arc("rim fillet", {centre, high - f}, f, turned(90), turned(180)),
                                     line_segment("disc", {surface, high - f}, {surface, low + f}),
                                     arc("hub fillet", {centre, low + f}, f, turned(180), turned(270)),
                                     line_segment("hub", {centre, low}, {hub, low})}),
              1,
              0};
    }

    /// Of the area between a stretch of a curve and the axle, with the sign of the path along the axle [m3].
    double
    moment_below(const MirroredCurve &curve, const double start, const double end)
    {
      constexpr int pieces = 32; // of a segment; an arc of 90 degrees is met to 2e-4 of its own segment
      const int     n      = pieces * static_cast<int>(std::ceil(std::abs(end - start)));
      double        moment = 0;
      for (int i = 0; i < n; ++i)
        {
          const Point2 a = curve.position(start + (end - start) * i / n),
                       b = curve.position(start + (end - start) * (i + 1) / n);
          moment += (b.x - a.x) * (a.y * a.y + a.y * b.y + b.y * b.y) / 6;
        }
      return moment;
    }
  } // namespace


  WheelSectionOutline
  make_wheel_section_outline(const WheelProfile &profile, const WheelDimensions &dimensions)
  {
    if (profile.crown)
      throw InputError("Wheel '" + profile.name +
                       "' is a crown without flange, which half-spaces alone take (Half-space/Bodies = "
                       "half-spaces): give a tread with its flange.");
    check_dimensions(dimensions,
                     profile.tread.at(0).position.x -
                       profile.tread.at(profile.tread.parameter_end()).position.x);
    WheelSectionOutline wheel;
    make_rim_outline(wheel, profile, dimensions);
    wheel.field = make_disc_outline(wheel, dimensions, 1);
    wheel.gauge = make_disc_outline(wheel, dimensions, -1);
    return wheel;
  }


  double
  moment_about_axle(const WheelSectionOutline &outline, const WheelDimensions &dimensions)
  {
    const auto   end  = [](const MirroredCurve &curve) { return curve.curve->parameter_end(); };
    const double bore = dimensions.bore_radius, hub = outline.gauge.position(end(outline.gauge)).x -
                                                      outline.field.position(end(outline.field)).x;
    // upper side of the rim less its underside, and hub less bore; upright faces add nothing
    return moment_below(outline.rim, 0, end(outline.rim)) +
           moment_below(outline.gauge, 0, end(outline.gauge)) -
           moment_below(outline.field, 0, end(outline.field)) - 0.5 * hub * bore * bore;
  }
} // namespace wheelrail
