#include <wheelrail/application/geometry_command.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/base/value_list.h>
#include <wheelrail/geometry/conicity.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

namespace wheelrail
{
  namespace
  {
    const double degree = M_PI / 180;

    /// Gap that closes under a wheel load of some 100 kN [m].
    constexpr double loaded_gap = 1e-4;

    struct Pair
    {
      RailProfile        rail;
      WheelProfile       wheel;
      TrackDimensions    track;
      WheelsetPose       pose;  ///< but for the shift
      const WheelOnRail *other; ///< of the left-hand side, where it differs
    };

    /// "none", "from contact" or the angle; and the yaw, if any.
    std::string
    pose_text(const WheelsetPose &pose)
    {
      const std::string roll = pose.roll == RollMode::none ? "none"
                               : pose.roll == RollMode::from_contact
                                 ? "from contact"
                                 : format_quantity(pose.roll_angle, "mrad");
      return roll + (pose.yaw == 0 ? "" : ", yaw " + format_quantity(pose.yaw, "mrad"));
    }

    /// The contact at a shift, or nothing; `reason` then tells why.
    std::optional<ContactGeometry>
    contact_at(const Pair &pair, const double shift, std::string &reason)
    {
      leave_if_interrupted();
      try
        {
          WheelsetPose pose  = pair.pose;
          pose.lateral_shift = shift;
          return find_contact(pair.rail, pair.wheel, pair.track, pose, pair.other);
        }
      catch (const InputError &error)
        {
          reason = error.what();
          return {};
        }
    }

    std::string
    fixed(const double value, const int digits)
    {
      std::ostringstream text;
      text << std::fixed << std::setprecision(digits) << value;
      // A rounded zero must not show a sign.
      const std::string result = text.str();
      return result.find_first_not_of("-0.") == std::string::npos && result[0] == '-' ? result.substr(1)
                                                                                      : result;
    }

    /// Radius of curvature in mm, or "flat".
    std::string
    radius_text(const double curvature)
    {
      return std::abs(curvature) < 1e-4 ? "flat" : fixed(1e3 / curvature, 1);
    }

    void
    print_row(std::ostream &out, const std::vector<std::string> &cells)
    {
      const int widths[] = {9, 9, 10, 10, 9, 11, 11, 9, 11, 9};
      for (std::size_t i = 0; i < cells.size(); ++i)
        if (i < 10)
          out << std::right << std::setw(widths[i]) << cells[i];
        else
          out << "  " << cells[i];
      out << '\n';
    }

    /// The shift between `a` and `b` at which the contact point jumps, by bisection; nothing when
    /// it moves continuously. The two contacts close to the jump replace `a` and `b`.
    bool
    narrow_jump(const Pair &pair, ContactGeometry &a, ContactGeometry &b)
    {
      const double least_jump = 0.5e-3;
      std::string  ignored;
      for (int i = 0; i < 14; ++i)
        {
          if (std::abs(b.wheel_x - a.wheel_x) < least_jump)
            return false;
          const auto middle = contact_at(pair, 0.5 * (a.lateral_shift + b.lateral_shift), ignored);
          if (!middle)
            return false;
          if (std::abs(middle->wheel_x - a.wheel_x) > std::abs(b.wheel_x - middle->wheel_x))
            b = *middle;
          else
            a = *middle;
        }
      return std::abs(b.wheel_x - a.wheel_x) >= least_jump;
    }

    /// " + 0.031 mm at -25.2": the further points whose gap closes under load, with the rail's x.
    std::string
    further_text(const ContactGeometry &c)
    {
      std::string text;
      for (const FurtherPoint &p : c.further)
        if (p.gap < loaded_gap)
          text += " + " + fixed(1e3 * p.gap, 3) + " mm at " + fixed(1e3 * p.rail_x, 1);
      return text;
    }

    std::vector<std::string>
    row_of(const ContactGeometry &c)
    {
      return {fixed(1e3 * c.lateral_shift, 2),
              fixed(1e3 * c.roll, 4),
              fixed(1e3 * c.wheel_x, 3),
              fixed(1e3 * c.rail_x, 3),
              fixed(c.angle / degree, 3),
              fixed(1e3 * c.rolling_radius, 4),
              fixed(1e3 * (c.rolling_radius - c.other_radius), 4),
              radius_text(c.rail_curvature),
              radius_text(c.wheel_curvature),
              c.second_gap < 0 ? "none" : fixed(1e3 * c.second_gap, 4),
              c.wheel_segment + " on " + c.rail_segment + further_text(c)};
    }

    /// One line for each further point that touches under load.
    void
    print_further(const std::vector<ContactGeometry> &contacts, std::ostream &out)
    {
      bool none = true;
      for (const ContactGeometry &c : contacts)
        for (const FurtherPoint &p : c.further)
          if (p.gap < loaded_gap)
            {
              if (none)
                {
                  out << "\nFurther points that 0.1 mm of approach would close\n\n";
                  print_row(out,
                            {"shift", "gap", "wheel x", "rail x", "angle", "ahead", "", "rail R", "wheel R"});
                  print_row(out, {"mm", "mm", "mm", "mm", "deg", "mm", "", "mm", "mm"});
                }
              none = false;
              print_row(out,
                        {fixed(1e3 * c.lateral_shift, 2),
                         fixed(1e3 * p.gap, 4),
                         fixed(1e3 * p.wheel_x, 3),
                         fixed(1e3 * p.rail_x, 3),
                         fixed(p.angle / degree, 3),
                         fixed(1e3 * p.ahead, 3),
                         "",
                         radius_text(p.rail_curvature),
                         radius_text(p.wheel_curvature)});
            }
    }

    void
    print_table(const Pair &pair, const std::vector<double> &shifts, std::ostream &out)
    {
      out
        << "\nRoll " << pose_text(pair.pose)
        << " (a star marks a jump of the contact point since the line above; + the gap in mm and the rail's "
           "x\nof further points that 0.1 mm of approach would close)\n\n";
      print_row(out,
                {"shift",
                 "roll",
                 "wheel x",
                 "rail x",
                 "angle",
                 "radius",
                 "difference",
                 "rail R",
                 "wheel R",
                 "2nd gap",
                 "zones"});
      print_row(out, {"mm", "mrad", "mm", "mm", "deg", "mm", "mm", "mm", "mm", "mm", ""});

      std::vector<ContactGeometry>   contacts;
      std::vector<std::string>       jumps;
      std::optional<ContactGeometry> before;
      for (const double shift : shifts)
        {
          std::string reason;
          const auto  here = contact_at(pair, shift, reason);
          if (!here)
            {
              out << std::setw(9) << fixed(1e3 * shift, 2) << "  no contact: " << reason << '\n';
              before.reset();
              continue;
            }
          auto row = row_of(*here);
          if (before && std::abs(here->wheel_x - before->wheel_x) > 0.5e-3)
            {
              ContactGeometry a = *before, b = *here;
              if (narrow_jump(pair, a, b))
                {
                  row.back() += " *";
                  jumps.push_back("  at " + fixed(500 * (a.lateral_shift + b.lateral_shift), 3) +
                                  " mm: wheel x from " + fixed(1e3 * a.wheel_x, 2) + " to " +
                                  fixed(1e3 * b.wheel_x, 2) + " mm, rail x from " + fixed(1e3 * a.rail_x, 2) +
                                  " to " + fixed(1e3 * b.rail_x, 2) + " mm");
                }
            }
          print_row(out, row);
          contacts.push_back(*here);
          before = here;
        }
      if (!jumps.empty())
        out
          << "\nThe contact point jumps (in the order of the table; a step with several shows the largest)\n";
      for (const std::string &jump : jumps)
        out << jump << '\n';
      print_further(contacts, out);
    }

    void
    print_conicity(const Pair &pair, std::ostream &out)
    {
      const double           e = 2 * running_circle_distance(pair.track), r0 = pair.track.nominal_radius;
      const RadiusDifference difference =
        radius_difference(pair.rail, pair.wheel, pair.track, pair.pose.roll, 8e-3, 1e-4, pair.other);
      out << "\nEquivalent conicity (EN 15302, UIC 519: cone with the same wavelength of Klingel's "
             "movement), roll "
          << pose_text(pair.pose) << "\n\n";
      if (!difference.odd)
        out << (std::isfinite(difference.rolling_line())
                  ? "  around a shift of " + fixed(-1e3 * difference.rolling_line(), 3) +
                      " mm, where both wheels roll alike\n"
                  : "  none: both wheels roll alike nowhere within 8 mm\n");
      for (int amplitude = 1; amplitude <= 8; ++amplitude)
        {
          const double conicity = equivalent_conicity(difference, 1e-3 * amplitude, e, r0);
          if (difference.odd ? amplitude * 1e-3 > difference.displacement.back() * (1 + 1e-12)
                             : std::isnan(conicity))
            break;
          out << "  amplitude " << amplitude << " mm   "
              << (std::isnan(conicity) ? "none: the difference of the rolling radii pushes outwards"
                                       : fixed(conicity, 4) + "   wavelength " +
                                           fixed(M_PI * std::sqrt(2 * e * r0 / conicity), 2) + " m")
              << '\n';
        }
    }

    void
    print_details(const Pair &pair, const ContactGeometry &c, std::ostream &out)
    {
      const auto line = [&out](const std::string &name, const std::string &value) {
        out << "  " << std::left << std::setw(37) << name << std::right << value << '\n';
      };
      out << "\nThe scene's own shift: " << fixed(1e3 * c.lateral_shift, 3) << " mm, roll "
          << pose_text(pair.pose) << "\n\n";
      line("roll", fixed(1e3 * c.roll, 5) + " mrad");
      line("point on the wheel (x, y)",
           fixed(1e3 * c.wheel_x, 4) + ", " + fixed(1e3 * c.wheel_y, 4) + " mm, zone " + c.wheel_segment);
      line("point on the rail (x, y)",
           fixed(1e3 * c.rail_x, 4) + ", " + fixed(1e3 * c.rail_y, 4) + " mm, " + c.rail_segment);
      line("point in the track plane (X, Y)",
           fixed(1e3 * c.frame.origin.x, 4) + ", " + fixed(1e3 * c.frame.origin.y, 4) + " mm");
      if (c.yaw != 0)
        {
          line("yaw", fixed(1e3 * c.yaw, 5) + " mrad");
          line("point ahead of the axle", fixed(1e3 * c.ahead, 4) + " mm");
          line("point ahead of the wheelset's middle", fixed(1e3 * c.along, 4) + " mm");
        }
      line("contact angle", fixed(c.angle / degree, 4) + " deg");
      line("rolling radius", fixed(1e3 * c.rolling_radius, 4) + " mm");
      line("lateral curvature of the rail",
           fixed(c.rail_curvature, 4) + " 1/m (radius " + radius_text(c.rail_curvature) + " mm)");
      line("lateral curvature of the wheel",
           fixed(c.wheel_curvature, 4) + " 1/m (radius " + radius_text(c.wheel_curvature) + " mm)");
      for (const FurtherPoint &p : c.further)
        line("further minimum of the gap",
             fixed(1e3 * p.gap, 4) + " mm at rail x " + fixed(1e3 * p.rail_x, 3) + ", wheel x " +
               fixed(1e3 * p.wheel_x, 3) + " mm, angle " + fixed(p.angle / degree, 2) + " deg, radii " +
               radius_text(p.rail_curvature) + " on " + radius_text(p.wheel_curvature) +
               (c.yaw == 0 ? "" : ", " + fixed(1e3 * p.ahead, 2) + " mm ahead of the axle") +
               (p.gap < loaded_gap ? ": touches under load" : ""));

      const FrameProfile wheel(pair.wheel.tread, c.wheel, c.frame), rail(pair.rail.head, c.rail, c.frame);
      const double low = std::max(wheel.s_min(), rail.s_min()), high = std::min(wheel.s_max(), rail.s_max());
      for (const double s : {-10e-3, -5e-3, -2e-3, 2e-3, 5e-3, 10e-3})
        line("undeformed distance at s = " + fixed(1e3 * s, 0) + " mm",
             s < low || s > high ? "outside the profiles"
                                 : fixed(1e6 * undeformed_distance(wheel, rail, s), 3) + " um");
      double width = 0;
      for (const Range &range : interpenetration(wheel, rail, 1e-4))
        {
          width += range.s1 - range.s0;
          line("interpenetration at 0.1 mm approach",
               "s from " + fixed(1e3 * range.s0, 3) + " to " + fixed(1e3 * range.s1, 3) + " mm");
        }
      line("its width", fixed(1e3 * width, 3) + " mm");
    }
  } // namespace


  std::vector<double>
  default_geometry_shifts()
  {
    std::vector<double> shifts;
    for (int i = -12; i <= 12; ++i)
      shifts.push_back(0.5e-3 * i);
    return shifts;
  }


  int
  run_geometry_command(const Scene               &scene,
                       const SceneProfiles       &profiles,
                       const std::vector<double> &shifts,
                       std::ostream              &out,
                       const SceneProfiles       *left)
  {
    const std::optional<WheelOnRail> other =
      left ? std::optional<WheelOnRail>(WheelOnRail{left->rail, left->wheel}) : std::nullopt;
    Pair pair{profiles.rail, profiles.wheel, scene.track, wheelset_pose(scene), other ? &*other : nullptr};
    out << "Wheel " << pair.wheel.name << " on rail " << pair.rail.name
        << (left ? ", left wheel " + left->wheel.name + " on rail " + left->rail.name : "") << ", gauge "
        << fixed(1e3 * scene.track.gauge, 2) << " mm (" << fixed(1e3 * scene.track.gauge_height, 1)
        << " mm below the top), inclination ";
    if (scene.track.inclination > 0)
      out << "1:" << fixed(1. / scene.track.inclination, 2);
    else
      out << fixed(scene.track.inclination, 4);
    out << ", flange-back distance " << fixed(1e3 * scene.track.flange_back_distance, 2)
        << " mm, nominal radius " << fixed(1e3 * scene.track.nominal_radius, 2) << " mm\n"
        << "\nModelled is the wheel on the " << (scene.left_wheel ? "left" : "right")
        << "-hand rail. Shift: of the wheelset towards the track centre, "
           "negative\n"
           "brings the flange root to the gauge corner. x: positive to the field side, from the running "
           "circle and\n"
           "from the rail's axis. Angle: positive when the tangent falls to the gauge side. Difference: "
           "rolling\n"
           "radius less that of the other wheel. R: lateral radii, negative when concave.\n";

    using Modes = std::vector<RollMode>;
    for (const RollMode mode : scene.roll == RollMode::given ? Modes{RollMode::given}
                                                             : Modes{RollMode::none, RollMode::from_contact})
      {
        pair.pose.roll = mode;
        print_table(pair, shifts.empty() ? default_geometry_shifts() : shifts, out);
        // a wheelset that swings has no lasting yaw or roll
        if (scene.yaw == 0 && mode != RollMode::given)
          print_conicity(pair, out);
      }

    pair.pose = wheelset_pose(scene);
    std::string reason;
    const auto  own = contact_at(pair, pair.pose.lateral_shift, reason);
    if (own)
      print_details(pair, *own, out);
    else
      out << "\nThe scene's own shift: " << reason << '\n';
    out.flush();
    return own ? 0 : 1;
  }


  std::vector<double>
  parse_shifts(const std::string &text)
  {
    const auto fail = [&](const std::string &why) {
      throw InputError("--shifts " + text + ": " + why +
                       "; write first:last:step or values with commas, in mm, such as -6:6:0.5");
    };
    ValueList list = parse_value_list(text, 100000);
    if (!list.fault.empty())
      fail(list.fault);
    for (double &shift : list.values)
      shift /= 1e3;
    return list.values;
  }
} // namespace wheelrail
