#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/bodies/answering_bodies.h>
#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/contactfiles/case_bodies.h>
#include <wheelrail/contactfiles/case_problem.h>
#include <wheelrail/contactfiles/contact_input.h>
#include <wheelrail/contactfiles/patch_problem.h>
#include <wheelrail/profiles/measured_profiles.h>
#include <wheelrail/sections/slices_file.h>
#include <wheelrail/tables/text_rows.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// The running circle lies 70 mm from the flange back (EN 13715).
    constexpr double circle_to_back = 70e-3;

    /// Of CONTACT's y, seen on the right-hand side.
    double
    side_of(const ContactCase &one)
    {
      return one.digits.side == 0 ? -1 : 1;
    }

    bool
    all_zero(const double *const begin, const double *const end)
    {
      return std::all_of(begin, end, [](const double value) { return value == 0; });
    }

    /// Throws InputError for what true bodies do not have.
    void
    check_bodies(const ContactCase &one)
    {
      const ControlDigits                &d = one.digits;
      const ContactWheelset              &w = one.wheelset;
      const std::array<double, 6>        &v = w.velocity, &rail = one.track.deviation;
      const std::vector<double>          &c        = one.material.constants;
      const std::pair<bool, const char *> checks[] = {
        {d.side >= 4, "rollers; taken are rails"},
        {is_slices_file(one.track.profile.file) || is_slices_file(w.profile.file),
         "slices; taken are profiles of one section"},
        {d.forces == 3, "rails on springs; taken are F = 0 and 1"},
        {d.motion != 3, "a motion other than steady rolling; taken is T = 3"},
        {d.bound != 0, "normal springs; taken is B = 0"},
        {d.variation == 1, "friction by inclination; taken are V = 0 and 2"},
        {d.heat != 0, "heat; taken is H = 0"},
        {d.material == 4 && c[2] > 0 && c[2] < 1e10, "a layer that yields; taken is TAU_C0 = 0"},
        {!all_zero(w.flexible.begin(), w.flexible.end()), "flexible wheelsets; taken are E = 1, 2 and 3"},
        {!all_zero(v.data() + 2, v.data() + 5) || !all_zero(rail.data() + 3, rail.data() + 6),
         "motions of the wheelset or rail beside rolling; taken are VS, VY and the pitch rate"},
        {v[0] <= 0 || (d.forces == 0 && v[5] >= 0), "backward rolling; taken are VS > 0 and VPITCH < 0"}};
      for (const auto &[found, what] : checks)
        if (found)
          throw InputError(std::string("true bodies do not take ") + what);
    }

    /// The points of a profile as they stand, x to the field side, y up, moved along x.
    MeasuredProfile
    profile_of(const ContactProfile &given, const bool wheel, const double move)
    {
      std::string text;
      for (const Point2 &p : section_points(given, wheel))
        text += contact_line({(p.x + move) / millimetre, -p.y / millimetre});
      ProfileFileOptions options{wheel ? ProfileKind::wheel : ProfileKind::rail,
                                 ProfileMirror::no,
                                 ProfileMirror::no,
                                 ProfileUnit::millimetre,
                                 0};
      options.placed = wheel;
      return read_profile_text(text, given.file.empty() ? "the profile" : given.file, options);
    }

    /// Wheel, track, pose and motion, seen on the right-hand side; X points against CONTACT's y.
    void
    set_pose(const ContactCase &one, const ProfileLine &rail, Scene &scene)
    {
      const double                 side  = side_of(one);
      const ContactWheelset       &w     = one.wheelset;
      const std::array<double, 6> &p     = w.position;
      ContactCase                  other = one; // whose rail touches the middle of the track
      other.track.cant -= side * other.track.deviation[2];
      other.track.deviation    = {};
      other.track.gauge        = 0;
      other.track.gauge_height = one.track.gauge_height > 0 ? one.track.gauge_height : 14;
      scene.track.gauge =
        2 * (wheel_rail_pose(one, rail).rail.move[1] - wheel_rail_pose(other, rail).rail.move[1]);
      scene.track.gauge_height         = millimetre * other.track.gauge_height;
      scene.track.inclination          = std::tan(other.track.cant);
      scene.track.flange_back_distance = millimetre * w.flange_distance;
      scene.lateral_shift              = -side * millimetre * p[1];
      scene.roll                       = RollMode::given;
      scene.roll_angle                 = side * p[3];
      scene.yaw                        = -side * p[4];
      scene.velocity                   = millimetre * w.velocity[0];
      scene.lateral_creepage           = -side * w.velocity[1] / w.velocity[0];
    }

    void
    set_surfaces(const ContactCase &one, Scene &scene)
    {
      const ContactMaterial &m = one.material;
      for (const auto &[steel, k] : {std::pair{&scene.rail_material, 0}, std::pair{&scene.wheel_material, 1}})
        {
          steel->poissons_ratio = m.poisson[std::size_t(k)];
          steel->youngs_modulus = 2 * megapascal * m.shear[std::size_t(k)] * (1 + steel->poissons_ratio);
        }
      scene.friction                = friction_of(one, patch_friction(one, 0));
      scene.halfspace_memory_length = millimetre * one.friction.memory_length;
      if (one.friction.memory_speed > 0)
        scene.halfspace_memory_speed = millimetre * one.friction.memory_speed;
      if (one.digits.material == 4)
        {
          scene.halfspace_layer_shear     = megapascal * m.constants[0];
          scene.halfspace_layer_thickness = millimetre * m.constants[1];
        }
      scene.halfspace_element_size = millimetre * std::min(one.elements.dx, one.elements.ds);
    }

    std::vector<double>
    row_of(const std::size_t        k,
           const ContactCase       &one,
           const WheelRailCase     &halfspaces,
           const WheelRailSolution &bodies)
    {
      const ContactReference  &r      = *bodies.reference;
      const HalfspaceSolution &s      = bodies.solution;
      const double             side   = side_of(one); // s points against y on the right
      const double             circle = 0.5 * millimetre * one.wheelset.flange_distance + circle_to_back;
      double                   peak   = 0;
      for (const WheelRailPatch &patch : halfspaces.patches)
        peak = std::max(peak, patch.solution.peak_pressure);
      return {double(k + 1),
              side * (circle - r.place.x),
              -side * r.angle,
              s.fn,
              s.fx,
              -side * s.fy,
              -side * r.spin_moment,
              s.approach,
              s.peak_pressure,
              r.creepage,
              side * r.lateral_creepage,
              -side * r.spin,
              s.area,
              s.adhesion_area / s.area,
              s.peak_pressure / peak - 1};
    }
  } // namespace


  WheelRailSolution
  solve_case_bodies(const ContactCase &one, const WheelRailCase &solved)
  {
    check_bodies(one);
    const ProfileLine rail  = section_line(one.track.profile, false),
                      wheel = section_line(one.wheelset.profile, true);
    Scene scene;
    set_surfaces(one, scene);
    set_pose(one, rail, scene);
    // where the radius is nominal
    const double circle = millimetre * one.wheelset.flange_place + circle_to_back;
    const double radius =
      millimetre * one.wheelset.radius + wheel.at(wheel.parameter(arc_at_y(wheel, circle))).z;
    scene.wheel.rim_inner_radius += radius - scene.track.nominal_radius;
    scene.track.nominal_radius = radius;
    SceneProfiles profiles;
    profiles.rail  = measured_rail(profile_of(one.track.profile, false, 0), scene.rail_body, profiles.notes);
    profiles.wheel = measured_wheel(profile_of(one.wheelset.profile, true, -circle),
                                    scene.wheel.rim_width,
                                    profiles.notes,
                                    WheelOrigin::running_circle);
    const SceneGeometry geometry = make_geometry(scene, std::move(profiles));
    WheelRailLoad       load;
    load.force     = solved.force_track[2];
    load.vertical  = true;
    load.rate_held = one.digits.forces == 0;
    if (load.rate_held)
      load.creepage = -solved.pitch_rate / scene.velocity * geometry.contact.forward_radius - 1;
    else
      load.longitudinal = -one.wheelset.velocity[5];
    scene.halfspace_bodies  = ContactBodies::real;
    WheelRailSolution found = solve_wheel_rail(scene, geometry, load, {});
    if (!found.solution.converged())
      throw RunError(found.solution.not_reached);
    return found;
  }


  FigureTable
  bodies_table(const std::vector<ContactCase> &cases,
               const std::vector<CaseResult>  &results,
               std::vector<std::string>       &without)
  {
    FigureTable table;
    table.add_columns(
      "case 1, y_track_m m, contact_angle_rad rad, normal_force_N N, longitudinal_force_N N, "
      "tangential_lateral_force_N N, spin_moment_Nm Nm, approach_m m, max_pressure_Pa Pa, creepage 1, "
      "lateral_creepage 1, spin_per_m 1/m, area_of_whole_elements_m2 m2, stick_fraction 1, "
      "relative_difference_max_pressure 1");
    for (std::size_t k = 0; k < cases.size(); ++k)
      {
        const CaseResult &result = results[k];
        std::string       fault;
        if (result.solved)
          fault = "true bodies have an answer for wheel on rail, module 1, alone";
        else if (result.wheel_rail && !result.wheel_rail->patches.empty())
          fault = fault_of([&]() {
            table.add_row(
              row_of(k, cases[k], *result.wheel_rail, solve_case_bodies(cases[k], *result.wheel_rail)));
          });
        if (!fault.empty())
          without.push_back(place(cases[k].file, cases[k].line) + fault);
      }
    return table;
  }


  void
  print_bodies(const FigureTable &table, std::ostream &out)
  {
    out << "\nTrue bodies under the forces that press; peak pressure against that of the half-spaces\n\n"
           "  case     Y(TR)       angle          FN          FX          FS  approach       peak     area   "
           "  peak\n"
           "              mm        mrad           N           N           N        mm        MPa      mm2   "
           "     %\n";
    for (std::size_t k = 0; k < table.rows(); ++k)
      {
        const auto value = [&](const char *key) { return (*table.find(key))[k]; };
        out << text("%6.0f %9.3f %11.3f %11.5g %11.5g %11.5g %9.5f %10.5g %8.2f %+8.1f\n",
                    value("case"),
                    1e3 * value("y_track_m"),
                    1e3 * value("contact_angle_rad"),
                    value("normal_force_N"),
                    value("longitudinal_force_N"),
                    value("tangential_lateral_force_N"),
                    1e3 * value("approach_m"),
                    1e-6 * value("max_pressure_Pa"),
                    1e6 * value("area_of_whole_elements_m2"),
                    100 * value("relative_difference_max_pressure"));
      }
  }
} // namespace wheelrail
