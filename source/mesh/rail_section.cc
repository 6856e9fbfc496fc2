#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/mesh/rail_section.h>
#include <wheelrail/mesh/running_layer.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace wheelrail
{
  namespace
  {
    // Places on one half of the outline, as parameters of it. The angles of the tangent that mark
    // them are chosen in the middle of each rounding, so that blocks meet the profile there with
    // similar angles on both sides. Each lies beyond the one before it, and between it and the web no other
    // rounding passes through its angle.
    struct Half
    {
      double head_corner = 0; ///< lower corner of the head (R3)
      double neck        = 0; ///< fillet below the head
      double web         = 0; ///< where it is narrowest
      double foot_fillet = 0; ///< fillet above the foot
      double toe_top     = 0;
      double toe_bottom  = 0;
    };

    // Parameter where a half of the outline is narrowest, between head and foot.
    double
    narrowest(const MirroredCurve &outline, const double start, const double end, const double height)
    {
      constexpr unsigned int samples = 16; // of a segment; any place on the web will do
      const unsigned int     n       = static_cast<unsigned int>(samples * std::abs(end - start));
      double                 place = end, least = height;
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double t = start + (end - start) * i / n;
          const Point2 p = outline.position(t);
          if (p.y < -0.35 * height && p.y > -0.75 * height && std::abs(p.x) < least)
            {
              least = std::abs(p.x);
              place = t;
            }
        }
      return place;
    }

    // `side` is +1 on the field side (left in the frame of the builder, the outline runs down) and
    // -1 on the gauge side, which is walked backwards. From the web up and down: sides of worn and joined
    // heads pass through any angle.
    Half
    find_half(const MirroredCurve &outline, const double side, const double height)
    {
      const double start = side > 0 ? 0 : outline.curve->parameter_end();
      const double end   = outline.curve->closest({0, -height});
      const double web   = narrowest(outline, start, end, height);
      const auto   find  = [&](const double angle, const double from, const double to, const char *what) {
        return outline.find_tangent(side * angle * degree, from, to, what);
      };

      Half half;
      half.web           = web;
      half.neck          = find(-60, web, start, "fillet between head and web");
      const double under = find(-40, half.neck, start, "underside of the rail head");
      half.head_corner   = find(-55, under, start, "lower corner of the rail head");
      half.foot_fillet   = find(-125, web, end, "fillet between web and foot");
      half.toe_top       = find(-120, half.foot_fillet, end, "upper edge of the rail foot");
      half.toe_bottom    = find(-45, half.toe_top, end, "lower edge of the rail foot");
      return half;
    }

    constexpr double usual_web = 0.016; // 54E1 and 60E1: 16 to 16.5 mm

    // Everything the parts of the section share.
    struct Rail
    {
      SectionBuilder builder;
      MirroredCurve  head, outline;
      Half           field, gauge;
      double         block_size    = 0;
      unsigned int   web_columns   = 2;
      double         web_thickness = usual_web;
      Side           layer_inner; ///< corners below those of the running layer
    };

    // A ring corner in the middle of a rounded head corner; the corner below it is smoothed later.
    LayerEnd
    ring_corner(const Rail &rail, const double parameter, const double depth)
    {
      const auto inner = [head = rail.head, depth](const double end) {
        return head.position(end) - depth * head.normal(end);
      };
      return {parameter, true, inner};
    }

    RunningLayer
    make_top_layer(Rail &rail, const Placement &placement, const FineStrip &strip)
    {
      const double top   = rail.head.curve->closest({0, 0});
      const double depth = running_layer_depth * rail.block_size;
      // the middle of the rounded corner, which turns from the slope of the crown to the side of the head
      const double field =
        rail.head.find_tangent(50 * degree, top, 0, "rounded upper corner on the field side");
      const double gauge = rail.head.find_tangent(
        -50 * degree, top, rail.head.curve->parameter_end(), "rounded upper corner on the gauge side");

      RunningLayerInput input;
      input.curve         = rail.head;
      input.placement     = placement;
      input.strip         = strip;
      input.start         = ring_corner(rail, field, depth);
      input.end           = ring_corner(rail, gauge, depth);
      input.block_size    = rail.block_size;
      input.depth         = depth;
      input.minimum_count = rail.web_columns + 2;
      return make_running_layer(rail.builder, input);
    }

    // A corner inside the material, at `distance` from a place on the outline in a direction turned
    // from the running direction by `angle` (towards the material on both sides).
    unsigned int
    inside(Rail &rail, const double parameter, const double side, const double angle, const double distance)
    {
      const Point2 t = rail.outline.tangent(parameter), n = rail.outline.normal(parameter);
      return rail.builder.corner(rail.outline.position(parameter) +
                                 distance * (side * std::cos(angle) * t + std::sin(angle) * n));
    }

    /// Corners of the head: on the outline where it is widest and at the neck, and inside.
    struct HeadCorners
    {
      unsigned int field, gauge, field_neck, gauge_neck, low_field, low_gauge, over_field, over_gauge;
    };

    HeadCorners
    head_corners(Rail &rail)
    {
      SectionBuilder &builder = rail.builder;
      // of the blocks at sides and underside: a proportion that keeps their angles (tests/mesh_sections.cc),
      // at most 13 mm, so that large blocks leave a core between them
      const double depth = std::min(0.85 * rail.block_size, 0.013);
      HeadCorners  corner;
      corner.field      = builder.corner(rail.outline.position(rail.field.head_corner));
      corner.gauge      = builder.corner(rail.outline.position(rail.gauge.head_corner));
      corner.field_neck = builder.corner(rail.outline.position(rail.field.neck));
      corner.gauge_neck = builder.corner(rail.outline.position(rail.gauge.neck));
      corner.low_field  = inside(rail, rail.field.head_corner, 1, 90 * degree, depth);
      corner.low_gauge  = inside(rail, rail.gauge.head_corner, -1, 90 * degree, depth);
      corner.over_field = inside(rail, rail.field.neck, 1, 130 * degree, depth);
      corner.over_gauge = inside(rail, rail.gauge.neck, -1, 130 * degree, depth);
      return corner;
    }

    /// The sides, a chain on the outline and one inside, from the lower corner up, and the core between them
    /// above the line `low`.
    void
    make_head_sides(Rail &rail, const RunningLayer &layer, const HeadCorners &corner, const Side &low)
    {
      SectionBuilder    &builder = rail.builder;
      const Side        &inner   = rail.layer_inner;
      const unsigned int n       = layer.outer.size() - 1;
      const double       length  = 0.5 * (norm(builder.point(inner[0]) - builder.point(corner.low_field)) +
                                   norm(builder.point(layer.outer[0]) - builder.point(corner.field)));
      const unsigned int rows    = block_count(length, 0.85 * rail.block_size);
      const auto         side    = [&](const Half &half, const double head_parameter) {
        const double top = rail.outline.curve->closest(rail.head.curve->at(head_parameter).position);
        return CurveStretch(rail.outline, half.head_corner, top);
      };
      const Side field_side =
        builder.along(corner.field, layer.outer[0], side(rail.field, layer.start), rows);
      const Side gauge_side = builder.along(corner.gauge, layer.outer[n], side(rail.gauge, layer.end), rows);
      builder.mark(field_side, Boundary::running);
      builder.mark(gauge_side, Boundary::running);
      const Side field_inner = builder.straight(corner.low_field, inner[0], rows);
      const Side gauge_inner = builder.straight(corner.low_gauge, inner[n], rows);

      builder.patch("field side of the head",
                    {corner.field, corner.low_field},
                    {layer.outer[0], inner[0]},
                    field_side,
                    field_inner);
      builder.patch("gauge side of the head",
                    {corner.low_gauge, corner.gauge},
                    {inner[n], layer.outer[n]},
                    gauge_inner,
                    gauge_side);
      builder.patch("core of the head", low, inner, field_inner, gauge_inner);
    }

    // The head. Returns the line of corners across the neck, from field to gauge side.
    Side
    make_head(Rail &rail, const RunningLayer &layer)
    {
      SectionBuilder    &builder = rail.builder;
      const unsigned int n       = layer.outer.size() - 1;
      Side              &inner   = rail.layer_inner;
      for (const Point2 &p : layer.inner)
        inner.push_back(builder.corner(p));
      builder.patch(
        "running layer", inner, layer.outer, {inner[0], layer.outer[0]}, {inner[n], layer.outer[n]});

      const HeadCorners  corner = head_corners(rail);
      const unsigned int web    = rail.web_columns;
      const unsigned int left   = columns_left(layer.inner,
                                             {{builder.point(corner.low_field),
                                                 builder.point(corner.over_field),
                                                 builder.point(corner.over_gauge),
                                                 builder.point(corner.low_gauge)}},
                                             web);
      const unsigned int right  = n - left - web;

      const Side low_left  = builder.straight(corner.low_field, corner.over_field, left);
      const Side low_web   = builder.straight(corner.over_field, corner.over_gauge, web);
      const Side low_right = builder.straight(corner.over_gauge, corner.low_gauge, right);
      make_head_sides(rail, layer, corner, joined(joined(low_left, low_web), low_right));

      // the underside, and the neck between its two halves
      const CurveStretch field_under(rail.outline, rail.field.head_corner, rail.field.neck);
      const CurveStretch gauge_under(rail.outline, rail.gauge.neck, rail.gauge.head_corner);
      Side               neck = builder.straight(corner.field_neck, corner.gauge_neck, web);
      builder.patch("underside of the head, field side",
                    builder.along(corner.field, corner.field_neck, field_under, left),
                    low_left,
                    {corner.field, corner.low_field},
                    {corner.field_neck, corner.over_field});
      builder.patch("underside of the head, gauge side",
                    builder.along(corner.gauge_neck, corner.gauge, gauge_under, right),
                    low_right,
                    {corner.gauge_neck, corner.over_gauge},
                    {corner.gauge, corner.low_gauge});
      builder.patch("neck",
                    neck,
                    low_web,
                    {corner.field_neck, corner.over_field},
                    {corner.gauge_neck, corner.over_gauge});
      return neck;
    }

    // The web. Returns the line of corners across its lower end.
    Side
    make_web(Rail &rail, const Side &neck)
    {
      SectionBuilder    &builder = rail.builder;
      const CurveStretch field(rail.outline, rail.field.foot_fillet, rail.field.neck);
      const CurveStretch gauge(rail.outline, rail.gauge.foot_fillet, rail.gauge.neck);
      // as tall as wide: the chords of taller blocks bridge the hollow fillets and make the web stiffer
      // (doc/theory/mesh.md)
      const unsigned int rows = block_count(field.length(), rail.web_thickness / rail.web_columns);
      Side bottom = builder.straight(builder.corner(field(0)), builder.corner(gauge(0)), rail.web_columns);
      builder.patch("web",
                    bottom,
                    neck,
                    builder.along(bottom.front(), neck.front(), field, rows),
                    builder.along(bottom.back(), neck.back(), gauge, rows));
      return bottom;
    }

    // Parameter of the place on the base below the web, a little further out than the fillet.
    double
    base_below(const Rail &rail, const Half &half, const double height)
    {
      const double x = -1.2 * rail.outline.position(half.foot_fillet).x;
      return rail.outline.curve->closest({x, -height});
    }

    void
    make_foot(Rail &rail, const Side &web, const double height)
    {
      SectionBuilder    &builder    = rail.builder;
      const double       field_base = base_below(rail, rail.field, height);
      const double       gauge_base = base_below(rail, rail.gauge, height);
      const CurveStretch middle(rail.outline, field_base, gauge_base);
      const unsigned int field_low = builder.corner(middle(0)), gauge_low = builder.corner(middle(1));

      const CurveStretch field_top(rail.outline, rail.field.toe_top, rail.field.foot_fillet);
      const CurveStretch gauge_top(rail.outline, rail.gauge.foot_fillet, rail.gauge.toe_top);
      const CurveStretch field_bottom(rail.outline, rail.field.toe_bottom, field_base);
      const CurveStretch gauge_bottom(rail.outline, gauge_base, rail.gauge.toe_bottom);
      const CurveStretch field_toe(rail.outline, rail.field.toe_bottom, rail.field.toe_top);
      const CurveStretch gauge_toe(rail.outline, rail.gauge.toe_bottom, rail.gauge.toe_top);

      // the foot never needs fine cells: two blocks for each arm at 16 mm
      const unsigned int columns = block_count(field_top.length(), 1.75 * rail.block_size);
      const unsigned int rows    = block_count(field_toe.length(), 1.75 * rail.block_size);
      const Side         field   = builder.straight(field_low, web.front(), rows);
      const Side         gauge   = builder.straight(gauge_low, web.back(), rows);

      const unsigned int field_toe_low  = builder.corner(field_toe(0)),
                         field_toe_high = builder.corner(field_toe(1));
      const unsigned int gauge_toe_low  = builder.corner(gauge_toe(0)),
                         gauge_toe_high = builder.corner(gauge_toe(1));

      const Side field_base_side = builder.along(field_toe_low, field_low, field_bottom, columns);
      const Side middle_base     = builder.along(field_low, gauge_low, middle, rail.web_columns);
      const Side gauge_base_side = builder.along(gauge_low, gauge_toe_low, gauge_bottom, columns);
      builder.mark(joined(joined(field_base_side, middle_base), gauge_base_side), Boundary::foot);

      builder.patch("foot below the web", middle_base, web, field, gauge);
      builder.patch("foot, field side",
                    field_base_side,
                    builder.along(field_toe_high, web.front(), field_top, columns),
                    builder.along(field_toe_low, field_toe_high, field_toe, rows),
                    field);
      builder.patch("foot, gauge side",
                    gauge_base_side,
                    builder.along(web.back(), gauge_toe_high, gauge_top, columns),
                    gauge,
                    builder.along(gauge_toe_low, gauge_toe_high, gauge_toe, rows));
    }

    // The builder's frame is the profile's with x mirrored: placing it in the track is a rotation.
    Section
    placed(const Section &section, const Placement &placement)
    {
      const auto place  = [placement](const Point2 &p) { return placement.to_track({-p.x, p.y}); };
      Section    result = section;
      for (Point2 &p : result.corners)
        p = place(p);
      for (auto &edge : result.curved)
        edge.second = [place, curve = edge.second](const double t) { return place(curve(t)); };
      return result;
    }
  } // namespace


  Section
  make_rail_section(const RailProfile &profile,
                    const Placement   &placement,
                    const FineStrip   &strip,
                    const double       block_size)
  {
    if (!(block_size > 0))
      throw InputError("The rail section cannot be divided into blocks of " + in_mm(block_size) +
                       ": a positive block size is needed, 16 mm is usual.");

    if (profile.outline.segments().empty())
      throw InputError("Rail '" + profile.name +
                       "' is a crown without sides, which half-spaces alone take (Half-space/Bodies = "
                       "half-spaces): give a head with its sides.");
    Rail rail;
    rail.head       = {std::make_shared<const Curve>(profile.head), 1, 0};
    rail.outline    = {std::make_shared<const Curve>(profile.outline), 1, 0};
    rail.field      = find_half(rail.outline, 1, profile.height);
    rail.gauge      = find_half(rail.outline, -1, profile.height);
    rail.block_size = block_size;
    const double thickness =
      std::abs(rail.outline.position(rail.field.web).x - rail.outline.position(rail.gauge.web).x);
    if (thickness > 1.5 * usual_web) // of a rail that was widened
      rail.web_thickness = thickness;
    rail.web_columns = std::max(2u, block_count(rail.web_thickness, block_size));

    const RunningLayer layer = make_top_layer(rail, placement, strip);
    const Side         neck  = make_head(rail, layer);
    const Side         web   = make_web(rail, neck);
    make_foot(rail, web, profile.height);

    Side fixed = neck;
    for (unsigned int i = layer.strip_begin; i <= layer.strip_end; ++i)
      fixed.push_back(rail.layer_inner[i]);
    rail.builder.smooth(0, web.front() - 1, fixed, block_size);
    rail.builder.round_edges(part(layer.outer, layer.strip_begin, layer.strip_end));
    rail.builder.check();
    return placed(rail.builder.section(), placement);
  }
} // namespace wheelrail
