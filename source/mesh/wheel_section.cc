#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/mesh/running_layer.h>
#include <wheelrail/mesh/wheel_section.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wheelrail
{
  namespace
  {
    // Everything the parts of the section share. In the frame of the builder, left is the field side.
    struct Wheel : WheelSectionOutline
    {
      SectionBuilder  builder;
      WheelDimensions dimensions;
      double          block_size   = 0; ///< [m]
      double          depth        = 0; ///< of the running layer [m]
      unsigned int    disc_columns = 2;
    };

    // Parameters of `field` and `gauge` in the middle of the fillets, which are their segments 1 and 3.
    constexpr double rim_fillet = 1.5, hub_fillet = 3.5;

    // Layer below the tread from the field side to the flange root, with its corners inside.
    struct Tread
    {
      RunningLayer layer;
      Side         inner;
    };

    Tread
    make_tread(Wheel &wheel, const Placement &placement, const FineStrip &strip, const double flange_top)
    {
      SectionBuilder &builder = wheel.builder;
      const double    circle  = wheel.rim.curve->closest({0, 0});

      // field side: the chamfer is the end of the layer; without one the end lies on the face
      const double edge =
        std::abs(wheel.rim.tangent(wheel.tread_start).y) > 0.5
          ? wheel.rim.find_tangent(30 * degree, wheel.tread_start, circle, "edge of the chamfer")
          : wheel.tread_start;
      const double side_length = wheel.rim.curve->length(wheel.tread_start, edge);
      const double corner      = side_length > 0.3 * wheel.depth
                                   ? wheel.tread_start
                                   : wheel.rim.curve->advance(wheel.tread_start, -(wheel.depth - side_length));

      const double root = wheel.rim.find_tangent(42 * degree, circle, flange_top, "flange root");

      RunningLayerInput input;
      input.curve         = wheel.rim;
      input.placement     = placement;
      input.strip         = strip;
      input.start         = {edge, false, [p = wheel.rim.position(corner)](double) { return p; }};
      input.end           = {root, true, [rim = wheel.rim, depth = 0.85 * wheel.depth](const double end) {
                     return rim.position(end) - depth * rim.normal(end);
                   }};
      input.block_size    = wheel.block_size;
      input.depth         = wheel.depth;
      input.minimum_count = wheel.disc_columns;

      Tread tread;
      tread.layer = make_running_layer(builder, input);
      for (const Point2 &p : tread.layer.inner)
        tread.inner.push_back(builder.corner(p));

      const Side end =
        builder.along(tread.inner[0], tread.layer.outer[0], CurveStretch(wheel.rim, corner, edge), 1);
      builder.patch(
        "running layer", tread.inner, tread.layer.outer, end, {tread.inner.back(), tread.layer.outer.back()});
      return tread;
    }

    // Flange: a layer around a core. Returns the line of corners below it, from the root to the back.
    Side
    make_flange(Wheel &wheel, const Tread &tread, const double tip)
    {
      SectionBuilder &builder = wheel.builder;
      const double    depth   = std::min(0.008, 0.6 * wheel.block_size);
      const double    front =
        wheel.rim.find_tangent(40 * degree, tip, wheel.rim.curve->closest({0, 0}), "front of the flange tip");
      if (!(tread.layer.end < front))
        throw InputError(
          "The wheel section cannot be built: the fine cells reach so far up the flange that "
          "no block of " +
          in_mm(wheel.block_size) + " fits between them and its tip.");
      const double rear = wheel.rim.find_tangent(-45 * degree, tip, wheel.back, "rear of the flange tip");
      const unsigned int root = tread.layer.outer.back(), root_inner = tread.inner.back();

      // the line below the flange: level with the inner corner at the root, on the straight back
      const double back_x   = wheel.rim.position(wheel.back).x;
      const double level    = std::min(builder.point(root_inner).y, wheel.rim.position(wheel.back).y);
      const double low_back = wheel.rim.curve->advance(wheel.back, wheel.rim.position(wheel.back).y - level);

      const unsigned int outer_front = builder.corner(wheel.rim.position(front));
      const unsigned int outer_rear  = builder.corner(wheel.rim.position(rear));
      const unsigned int inner_front =
        builder.corner(wheel.rim.position(front) - depth * wheel.rim.normal(front));
      const unsigned int inner_rear =
        builder.corner(wheel.rim.position(rear) - depth * wheel.rim.normal(rear));
      const unsigned int outer_back = builder.corner(wheel.rim.position(low_back));
      const unsigned int inner_back = builder.corner({back_x - 1.2 * depth, level});

      const CurveStretch face(wheel.rim, tread.layer.end, front), top(wheel.rim, front, rear);
      const unsigned int rows    = block_count(face.length(), wheel.block_size);
      const unsigned int columns = block_count(top.length(), wheel.block_size);

      const Side face_outer = builder.along(root, outer_front, face, rows);
      const Side top_outer  = builder.along(outer_front, outer_rear, top, columns);
      const Side back_outer =
        builder.along(outer_back, outer_rear, CurveStretch(wheel.rim, low_back, rear), rows);
      const Side face_inner = builder.straight(root_inner, inner_front, rows);
      const Side top_inner  = builder.straight(inner_front, inner_rear, columns);
      const Side back_inner = builder.straight(inner_back, inner_rear, rows);
      const Side low        = builder.straight(root_inner, inner_back, columns);
      builder.mark(face_outer, Boundary::running);
      builder.mark(top_outer, Boundary::running);

      builder.patch("flange face", {root, root_inner}, {outer_front, inner_front}, face_outer, face_inner);
      builder.patch("flange tip", top_inner, top_outer, {inner_front, outer_front}, {inner_rear, outer_rear});
      builder.patch(
        "flange back", {inner_back, outer_back}, {inner_rear, outer_rear}, back_inner, back_outer);
      builder.patch("flange core", low, top_inner, face_inner, back_inner);
      return joined(low, {inner_back, outer_back});
    }

    // The rim below the running layer and the flange. Returns the line across the top of the disc.
    Side
    make_rim(Wheel &wheel, const Side &top)
    {
      SectionBuilder    &builder    = wheel.builder;
      const unsigned int field_low  = builder.corner(wheel.field.position(0));
      const unsigned int gauge_low  = builder.corner(wheel.gauge.position(0));
      const unsigned int field_disc = builder.corner(wheel.field.position(rim_fillet));
      const unsigned int gauge_disc = builder.corner(wheel.gauge.position(rim_fillet));

      std::vector<Point2> points;
      for (const unsigned int corner : top)
        points.push_back(builder.point(corner));
      const unsigned int middle = wheel.disc_columns;
      const unsigned int left   = columns_left(points,
                                             {{builder.point(field_low),
                                                 builder.point(field_disc),
                                                 builder.point(gauge_disc),
                                                 builder.point(gauge_low)}},
                                             middle);
      const unsigned int right  = top.size() - 1 - left - middle;
      const double height = 0.5 * (points.front().y + points.back().y) - wheel.dimensions.rim_inner_radius;
      const unsigned int rows = block_count(height, wheel.block_size);

      Side       disc = builder.straight(field_disc, gauge_disc, middle);
      const Side low_field =
        builder.along(field_low, field_disc, CurveStretch(wheel.field, 0, rim_fillet), left);
      const Side low_gauge =
        builder.along(gauge_disc, gauge_low, CurveStretch(wheel.gauge, rim_fillet, 0), right);
      builder.patch("rim",
                    joined(joined(low_field, disc), low_gauge),
                    top,
                    builder.straight(field_low, top.front(), rows),
                    builder.straight(gauge_low, top.back(), rows));
      return disc;
    }

    // From the rim down: half of a fillet, the straight disc, half of a fillet. Returns the line of corners
    // across its lower end. Edges of blocks are straight: in a hollow fillet they lie outside the profile,
    // and with one row in it the disc bends a tenth too little.
    Side
    make_disc(Wheel &wheel, const Side &top)
    {
      constexpr double fillet_rows = 0.008; // [m]
      SectionBuilder  &builder     = wheel.builder;
      const double     ends[]      = {rim_fillet, 2, 3, hub_fillet};
      Side             low         = top;
      for (const int part : {0, 1, 2})
        {
          const CurveStretch field(wheel.field, ends[part + 1], ends[part]),
            gauge(wheel.gauge, ends[part + 1], ends[part]);
          const double height = part == 1 ? 2.5 * wheel.block_size : std::min(wheel.block_size, fillet_rows);
          const unsigned int rows = block_count(field.length(), height);
          const Side         high = low;
          low = builder.straight(builder.corner(field(0)), builder.corner(gauge(0)), wheel.disc_columns);
          builder.patch("disc",
                        low,
                        high,
                        builder.along(low.front(), high.front(), field, rows),
                        builder.along(low.back(), high.back(), gauge, rows));
        }
      return low;
    }

    void
    make_hub(Wheel &wheel, const Side &disc_low)
    {
      // the hub never needs fine cells
      SectionBuilder        &builder = wheel.builder;
      const WheelDimensions &d       = wheel.dimensions;
      const double           coarse  = 1.75 * wheel.block_size;
      const CurveStretch     field_hub(wheel.field, 5, hub_fillet), gauge_hub(wheel.gauge, hub_fillet, 5);
      const unsigned int     hub_rows = block_count(d.hub_outer_radius - d.bore_radius, coarse);
      const unsigned int     left     = block_count(field_hub.length(), coarse),
                         right        = block_count(gauge_hub.length(), coarse);

      const double       half       = 0.5 * d.disc_thickness + 0.4 * d.fillet_radius;
      const unsigned int field_high = builder.corner(field_hub(0)), gauge_high = builder.corner(gauge_hub(1));
      const unsigned int field_low  = builder.corner({builder.point(field_high).x, d.bore_radius});
      const unsigned int gauge_low  = builder.corner({builder.point(gauge_high).x, d.bore_radius});
      const unsigned int field_bore = builder.corner({wheel.disc - half, d.bore_radius});
      const unsigned int gauge_bore = builder.corner({wheel.disc + half, d.bore_radius});

      const Side bore_field  = builder.straight(field_low, field_bore, left);
      const Side bore_middle = builder.straight(field_bore, gauge_bore, wheel.disc_columns);
      const Side bore_gauge  = builder.straight(gauge_bore, gauge_low, right);
      builder.mark(joined(joined(bore_field, bore_middle), bore_gauge), Boundary::bore);

      const Side field_inside = builder.straight(field_bore, disc_low.front(), hub_rows);
      const Side gauge_inside = builder.straight(gauge_bore, disc_low.back(), hub_rows);
      builder.patch("hub below the disc", bore_middle, disc_low, field_inside, gauge_inside);
      builder.patch("hub, field side",
                    bore_field,
                    builder.along(field_high, disc_low.front(), field_hub, left),
                    builder.straight(field_low, field_high, hub_rows),
                    field_inside);
      builder.patch("hub, gauge side",
                    bore_gauge,
                    builder.along(disc_low.back(), gauge_high, gauge_hub, right),
                    gauge_inside,
                    builder.straight(gauge_low, gauge_high, hub_rows));
    }

    // Parameter of the highest point of the flange.
    double
    flange_tip(const Wheel &wheel)
    {
      const unsigned int n   = 64 * (wheel.back - wheel.tread_start);
      double             tip = wheel.tread_start, highest = 0;
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double t = wheel.tread_start + (wheel.back - wheel.tread_start) * i / n;
          const double y = wheel.rim.position(t).y;
          if (y > highest)
            {
              highest = y;
              tip     = t;
            }
        }
      return tip;
    }
  } // namespace


  Section
  make_wheel_section(const WheelProfile    &profile,
                     const WheelDimensions &dimensions,
                     const Placement       &wheel_in_track,
                     const FineStrip       &strip,
                     const double           block_size)
  {
    if (!(block_size > 0))
      throw InputError("The wheel section cannot be built: a positive block size is needed, 16 mm is usual.");

    Wheel wheel;
    static_cast<WheelSectionOutline &>(wheel) = make_wheel_section_outline(profile, dimensions);
    wheel.dimensions                          = dimensions;
    wheel.block_size                          = block_size;
    wheel.depth                               = running_layer_depth * block_size;
    wheel.disc_columns = std::max(2u, block_count(dimensions.disc_thickness, block_size));

    const double       tip         = flange_tip(wheel);
    const Tread        tread       = make_tread(wheel, wheel_in_track, strip, tip);
    const Side         below       = make_flange(wheel, tread, tip);
    const Side         disc        = make_rim(wheel, joined(tread.inner, below));
    const unsigned int last_of_rim = wheel.builder.section().corners.size() - 1;
    make_hub(wheel, make_disc(wheel, disc));

    Side fixed = disc;
    for (unsigned int i = tread.layer.strip_begin; i <= tread.layer.strip_end; ++i)
      fixed.push_back(tread.inner[i]);
    wheel.builder.smooth(0, last_of_rim, fixed, block_size);
    wheel.builder.check();
    return wheel.builder.section();
  }
} // namespace wheelrail
