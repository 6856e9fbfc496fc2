#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/contactfiles/contact_input.h>
#include <wheelrail/contactfiles/wheel_rail_input.h>
#include <wheelrail/wheel/given_distance.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wheelrail
{
  namespace
  {
    std::string
    row(const std::vector<double> &numbers, const std::string &names)
    {
      return contact_line(numbers, names, 10);
    }

    void
    check_scene(const Scene &scene)
    {
      const auto refuse = [](const std::string &text) {
        throw InputError("--contact-wheel-rail-input writes " + text);
      };
      if (scene.friction.kind != FrictionKind::constant)
        refuse("constant friction only: set Contact/Friction law = constant");
      if (scene.roll != RollMode::none)
        refuse("wheelsets without roll only: set Wheelset/Roll = none");
      if (scene.yaw != 0 || scene.lateral_creepage != 0 || std::isfinite(scene.halfspace_given_spin))
        refuse(
          "wheelsets that roll straight on only: set Wheelset/Yaw = 0 mrad, Wheelset/Lateral creepage = 0 "
          "and "
          "Half-space/Given spin = auto");
      if (std::isfinite(scene.track_radius))
        refuse("straight tracks only: set Track/Radius = straight");
      if (distance_is_given(scene))
        refuse("profiles only: set Half-space/Undeformed distance = profiles");
    }

    /// Points along a curve that runs from the field side to the track centre: y to the field side, z down.
    std::vector<Point2>
    outline(const Curve &curve)
    {
      constexpr double    step   = 0.25e-3;
      const double        length = curve.length(0, curve.parameter_end());
      const int           n      = int(std::ceil(length / step));
      std::vector<Point2> points;
      double              t = 0;
      for (int k = 0; k <= n; ++k)
        {
          const Point2 p = curve.at(t).position;
          points.push_back({p.x, -p.y});
          t = k + 1 == n ? curve.parameter_end() : curve.advance(t, length / n);
        }
      return points;
    }

    std::string
    table(const std::vector<Point2> &points)
    {
      std::string text;
      for (const Point2 &p : points)
        text += wheelrail::text("%.7f %.7f\n", 1e3 * p.x, 1e3 * p.y);
      return text;
    }
  } // namespace


  WheelRailInput
  wheel_rail_input(const Scene         &scene,
                   const SceneGeometry &geometry,
                   const double         vertical_load,
                   const std::string   &rail_file,
                   const std::string   &wheel_file)
  {
    check_scene(scene);
    const bool   rate_held     = scene.drive == Drive::rate;
    const double radius        = geometry.contact.rolling_radius;
    const auto   shear_modulus = [](const MaterialData &m) {
      return 1e-6 * m.youngs_modulus / (2 * (1 + m.poissons_ratio));
    };
    const double h = 1e3 * scene.halfspace_element_size;

    WheelRailInput files;
    std::string   &text = files.input;
    text = contact_head(scene.title, "wheel-rail module, right wheel; mm, N, rad, s") + " 1 MODULE\n";
    text += std::string(" 12031") + (rate_held ? "0" : "1") + "0   C-P-B-T-N-F-S\n";
    text += " 0022033   V-L-D-C-M-Z-E\n 0001221   H-G-I-A-O-W-R\n";
    text += row({999, 200, 50, 1, 1e-5}, "MAXGS, MAXIN, MAXNR, MAXOUT, EPS");
    text += row({scene.friction.at(0), scene.friction.at(0)}, "FSTAT, FKIN");
    text += row({scene.rail_material.poissons_ratio,
                 scene.wheel_material.poissons_ratio,
                 shear_modulus(scene.rail_material),
                 shear_modulus(scene.wheel_material)},
                "POISS 1,2, GG 1,2");
    text += row({h, h, 1}, "90d 8.0 4.0   DX, DS, DQREL, A_SEP, D_SEP, D_COMB");
    text += row({1e3 * scene.track.gauge_height,
                 0,
                 1e3 * scene.track.gauge,
                 std::atan(scene.track.inclination) + scene.halfspace_inclination},
                "GAUGHT, GAUGSQ, GAUGWD, CANT");
    text += " '" + rail_file + "' 0 1.0 0.0   RFNAME, MIRRORY, SCALE, SMOOTH\n";
    text += " 0 0 0 0 0 0   DY, DZ, ROLL, VY, VZ, VROLL\n";
    text += row({1e3 * scene.track.flange_back_distance, -70, 1e3 * scene.track.nominal_radius},
                "FBDIST, FBPOS, NOMRAD");
    text += " '" + wheel_file + "' 0 1.0 0.0   WFNAME, MIRRORY, SCALE, SMOOTH\n";
    text +=
      row({0, 0. - 1e3 * (geometry.contact.lateral_shift + scene.halfspace_lateral), vertical_load, 0, 0, 0},
          "S, Y, FZ, ROLL, YAW, PITCH");
    // the wheel turns about an axis that points to the left; the force is that on the rail
    text += row({1e3 * scene.velocity,
                 0,
                 0,
                 0,
                 0,
                 rate_held ? -scene.velocity / radius * (1 + scene.creepage)
                           : -scene.traction_coefficient * vertical_load},
                std::string("VS, VY, VZ, VROLL, VYAW, ") + (rate_held ? "VPITCH" : "FX_WS"));
    text += " 0 MODULE\n";

    std::vector<Point2> points = outline(geometry.rail.head);
    std::reverse(points.begin(), points.end());
    files.rail  = table(points);
    files.wheel = table(outline(geometry.wheel.tread));
    return files;
  }
} // namespace wheelrail
