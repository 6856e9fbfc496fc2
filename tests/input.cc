// label: fast
// needs: track

// The entries of parameter files: every one, defaults, round trips.

#include "check.h"
#include "other_values.h"

#include <wheelrail/input/entries.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/scene/one_wheel.h>

#include <algorithm>
#include <sstream>
#include <vector>

using namespace wheelrail;
using test::check;
using test::check_near;
using test::check_text;
using test::other_values;

namespace
{
  Scene
  other_scene()
  {
    std::vector<std::string> sets;
    for (const auto &value : other_values())
      sets.push_back(value.first + " = " + value.second);
    SceneInput input                = scene_from_text("", "none", sets);
    SceneInput straight             = input; // not all of it can be run
    straight.scene.yaw              = 0;
    straight.scene.lateral_creepage = 0;
    straight.scene.motion           = "none"; // its file is not there
    straight.scene.left_wheel       = false;  // the mesh at the other shift needs other sizes
    straight.scene.second_rail      = "none"; // beside a rail of one section
    straight.scene.planned_strip.clear();     // nor that strip
    straight.scene.irregularities   = {};     // longer than its path
    straight.scene.halfspace_bodies = ContactBodies::half_spaces; // which take a pose by hand
    leave_wheelset(straight.scene);
    straight.scene.start_offset     = 0; // the window is fixed
    straight.scene.staggered_starts = 1;
    straight.scene.error_estimate   = ErrorEstimate::model; // of a rail that was rolled over
    require_computable(straight);
    return input.scene;
  }

  void
  test_entries()
  {
    const Scene defaults = scene_from_text("", "none", {}).scene;
    const Scene other    = other_scene();
    for (const Entry &entry : entries())
      {
        const std::string path = entry.path();
        check_text(entry.get(defaults), entry.default_text, path + ": the text of the default reads back");
        const auto value = other_values().find(path);
        if (check(value != other_values().end(), path + ": is set by this test"))
          check_text(entry.get(other), value->second, path + ": set and read back");
        check(!entry.meaning.empty() && entry.meaning.back() == '.', path + ": has a meaning");
      }
    check_near(static_cast<double>(other_values().size()),
               static_cast<double>(entries().size()),
               0,
               "all entries are tested");
  }

  /// One entry changes one value: the others keep theirs.
  void
  test_independence()
  {
    for (const auto &value : other_values())
      {
        Scene        scene = scene_from_text("", "none", {}).scene;
        const auto   slash = value.first.find('/');
        const Entry *entry = slash == std::string::npos
                               ? find_entry("", value.first)
                               : find_entry(value.first.substr(0, slash), value.first.substr(slash + 1));
        if (!check(entry != nullptr, value.first + ": is an entry"))
          continue;
        entry->set(scene, value.second);
        std::string changed;
        for (const Entry &any : entries())
          if (any.get(scene) != any.default_text)
            changed += any.path() + ";";
        check_text(changed, value.first + ";", value.first + ": changes only itself");
      }
  }

  void
  test_fields()
  {
    const Scene s = other_scene();
    check_text(s.title, "other scene, 50 % slower", "field title");
    check_text(
      s.wheel_profile, std::string(WHEELRAIL_TEST_DIR) + "/profiles/worn_S1002.prw", "field wheel_profile");
    check(s.wheel_file.mirror == ProfileMirror::no && s.rail_file.mirror == ProfileMirror::yes,
          "fields mirror");
    check(s.wheel_file.turn == ProfileMirror::yes && s.rail_file.turn == ProfileMirror::yes, "fields turn");
    check(s.wheel_origin == WheelOrigin::running_circle, "field wheel_origin");
    check(s.wheel_file.unit == ProfileUnit::millimetre && s.rail_file.unit == ProfileUnit::inch,
          "fields unit");
    check_text(s.rail_body, "60E1", "field rail_body");
    check_near(s.rail_file.noise, 1e-5, 0, "field rail_file.noise");
    check_near(s.wheel_file.noise, 1e-5, 0, "field wheel_file.noise");
    check_text(s.rail_profile, "60E1", "field rail_profile");
    check_text(s.left_rail_profile, "54E1", "field left_rail_profile");
    check_text(s.left_wheel_profile, "S1002", "field left_wheel_profile");
    check_near(s.track.gauge, 1.437, 0, "field gauge");
    check_near(s.track.gauge_height, 0.015, 0, "field gauge_height");
    check_near(s.track.inclination, 0.05, 0, "field inclination");
    check_near(s.rail_length, 1.2, 0, "field rail_length");
    const SupportData &t = s.support;
    check(t.kind == RailSupport::sleepers && t.pad_damping == PadLoss::constant, "fields of the support");
    check_near(t.spacing, 0.65, 0, "field spacing");
    check_near(t.first_sleeper, -0.2, 0, "field first_sleeper");
    check_near(t.pad_length, 0.16, 0, "field pad_length");
    check_near(t.pad_stiffness, 250e6, 0, "field pad_stiffness");
    check_near(t.pad_lateral, 30e6, 0, "field pad_lateral");
    check_near(t.pad_longitudinal, 35e6, 0, "field pad_longitudinal");
    check_near(t.pad_loss, 0.2, 0, "field pad_loss");
    check_near(t.pad_frequency, 400, 0, "field pad_frequency");
    check_near(t.sleeper_mass, 150, 0, "field sleeper_mass");
    check_near(t.ballast_stiffness, 60e6, 0, "field ballast_stiffness");
    check_near(t.ballast_lateral, 20e6, 0, "field ballast_lateral");
    check_near(t.ballast_longitudinal, 15e6, 0, "field ballast_longitudinal");
    check_near(t.ballast_loss, 0.8, 0, "field ballast_loss");
    check_near(t.ballast_frequency, 90, 0, "field ballast_frequency");
    check_near(t.damped_ends, 0.3, 0, "field damped_ends");
    check_near(s.track.nominal_radius, 0.42, 0, "field track.nominal_radius");
    check_near(s.wheel.nominal_radius, 0.42, 0, "field wheel.nominal_radius");
    check_near(s.track.flange_back_distance, 1.361, 0, "field flange_back_distance");
    check_near(s.lateral_shift, -0.0035, 0, "field lateral_shift");
    check(s.roll == RollMode::from_contact, "field roll");
    check_near(s.track_radius, -300, 0, "field track_radius");
    check(!s.rigid_axle && s.both_wheels && s.pose_balances, "fields of the axle");
    check_near(s.cant, -0.08, 0, "field cant");
    check_near(s.prudhomme_factor, 0.85, 0, "field prudhomme_factor");
    check_near(s.lateral_stiffness, 3e6, 0, "field lateral_stiffness");
    check_near(s.yaw_stiffness, 5e6, 0, "field yaw_stiffness");
    check_near(s.centre_height, 1.6, 0, "field centre_height");
    check_near(s.left_friction, 0.25, 0, "field left_friction");
    check_text(s.wear_plan.mix, "mix.csv", "field wear_plan.mix");
    check(s.wear_plan.worn == WornBody::both, "field wear_plan.worn");
    check_near(s.wear_plan.gross_load, 5e9, 0, "field wear_plan.gross_load");
    check_near(s.wear_plan.distance, 2e6, 0, "field wear_plan.distance");
    check_near(s.wear_plan.smoothing, 8e-3, 0, "field wear_plan.smoothing");
    check_near(s.wear_plan.step_depth, 2e-6, 0, "field wear_plan.step_depth");
    check_near(s.wear_plan.line_length, 3e3, 0, "field wear_plan.line_length");
    check(s.wear_plan.wheels == 40, "field wear_plan.wheels");
    check_near(s.wear.crack_depth, 2e-3, 1e-15, "field wear.crack_depth");
    check_text(s.wear_plan.grind_to, "60E1", "field wear_plan.grind_to");
    check_near(s.wear_plan.grind_every, 3e9, 0, "field wear_plan.grind_every");
    check_text(s.wear_plan.turn_to, "S1002", "field wear_plan.turn_to");
    check_near(s.wear_plan.turn_every, 5e5, 0, "field wear_plan.turn_every");
    check_text(s.motion, "motion.csv", "field motion");
    check_near(s.motion_start, 12.5, 0, "field motion_start");
    check_near(s.wheel.rim_width, 0.136, 0, "field rim_width");
    check_near(s.wheel.rim_inner_radius, 0.365, 0, "field rim_inner_radius");
    check_near(s.wheel.disc_thickness, 0.025, 0, "field disc_thickness");
    check_near(s.wheel.disc_position, 0.07, 0, "field disc_position");
    check_near(s.wheel.hub_length, 0.18, 0, "field hub_length");
    check_near(s.wheel.hub_position, 0.071, 0, "field hub_position");
    check_near(s.wheel.hub_outer_radius, 0.125, 0, "field hub_outer_radius");
    check_near(s.wheel.bore_radius, 0.09, 0, "field bore_radius");
    check_near(s.wheel.fillet_radius, 0.018, 0, "field fillet_radius");
    check_near(s.sprung_mass, 9500, 0, "field sprung_mass");
    check_near(s.wheel_load, 98e3, 1e-9, "field wheel_load");
    check_near(s.axle_mass, 170, 0, "field axle_mass");
    check_near(s.axle_pitch_inertia, 1.4, 0, "field axle_pitch_inertia");
    check_near(s.suspension_stiffness, 1.2e6, 0, "field suspension_stiffness");
    check_near(s.suspension_damping, 2600, 0, "field suspension_damping");
    check_near(s.velocity, 70 / 3.6, 0, "field velocity");
    check(s.drive == Drive::rate, "field drive");
    check_near(s.traction_coefficient, -0.2, 0, "field traction_coefficient");
    check_near(s.creepage, 0.001, 0, "field creepage");
    check_near(s.friction.at_rest, 0.3, 0, "field friction_coefficient");
    check(s.friction.kind == FrictionKind::rational, "field friction_law");
    check_near(s.friction.at_speed, 0.25, 0, "field dynamic_friction_coefficient");
    check_near(s.friction.decay, 0.1, 0, "field friction_decay");
    check_near(s.friction.half_velocity, 3, 0, "field friction_half_velocity");
    check_near(s.penalty_scale, 3, 0, "field penalty_scale");
    check_near(s.contact_damping, 0.2, 0, "field contact_damping");
    check_near(s.rail_material.youngs_modulus, 206e9, 0, "field rail youngs_modulus");
    check_near(s.rail_material.poissons_ratio, 0.28, 0, "field rail poissons_ratio");
    check_near(s.rail_material.density, 7850, 0, "field rail density");
    check_near(s.rail_material.tangent_modulus, 20e9, 0, "field rail tangent_modulus");
    check_near(s.rail_material.kinematic_hardening, 0.5, 0, "field rail kinematic_hardening");
    check_near(s.wheel_material.youngs_modulus, 207e9, 0, "field wheel youngs_modulus");
    check_near(s.wheel_material.poissons_ratio, 0.29, 0, "field wheel poissons_ratio");
    check_near(s.wheel_material.density, 7800, 0, "field wheel density");
    check_near(s.wheel_material.tangent_modulus, 19e9, 0, "field wheel tangent_modulus");
    check_near(s.wheel_material.kinematic_hardening, 1, 0, "field wheel kinematic_hardening");
    check_near(s.cell_size, 0.002, 0, "field cell_size");
    check(s.halfspace_bodies == ContactBodies::real, "field halfspace_bodies");
    check_near(s.halfspace_memory_length, 3e-6, 0, "field halfspace_memory_length");
    check_near(s.halfspace_memory_speed, 2e-3, 0, "field halfspace_memory_speed");
    check_near(s.halfspace_layer_thickness, 1.25e-3, 0, "field halfspace_layer_thickness");
    check_near(s.halfspace_layer_shear, 8e9, 0, "field halfspace_layer_shear");
    check_near(s.coarse_cell_size, 0.032, 0, "field coarse_cell_size");
    check_near(s.fine_depth, 0.007, 0, "field fine_depth");
    check_near(s.fine_margin, 0.006, 0, "field fine_margin");
    check(s.mass_scaling, "field mass_scaling");
    check_near(s.rolling_distance, 0.26, 0, "field rolling_distance");
    check_near(s.longest_distance, 0.3, 0, "field longest_distance");
    check_near(s.standard_error, 0.002, 0, "field standard_error");
    check_near(s.wanted_accuracy, 0.03, 0, "field wanted_accuracy");
    check_near(s.averaging_distance, 0.05, 0, "field averaging_distance");
    check_near(s.time_step_factor, 0.8, 0, "field time_step_factor");
    check_near(s.bulk_viscosity, 0.03, 0, "field bulk_viscosity");
    check_near(s.energy_limit, 0.02, 0, "field energy_limit");
    check(s.element == ElementForm::full, "field element");
    check(s.rail_element == ElementForm::reduced && s.wheel_element == ElementForm::full,
          "fields rail_element and wheel_element");
    check_text(s.folder, "output/other", "field folder");
    check_near(s.ticks, 13, 0, "field ticks");
    check(!s.volume_fields, "field volume_fields");
    check_near(scene_from_text("", "none", {"Mesh/Solution cell size = 2 mm"}).scene.depth_of_fine_cells(),
               0.010,
               1e-18,
               "fine depth auto is five cells");
  }

  void
  test_round_trip()
  {
    const std::string defaults = print_parameters(Scene());
    check_text(print_parameters(scene_from_text(defaults, "listing", {}).scene),
               defaults,
               "listing of the defaults reads back");
    const std::string other = print_parameters(other_scene());
    check_text(print_parameters(scene_from_text(other, "listing", {}).scene),
               other,
               "listing of another scene reads back");
    check(other != defaults, "the listings differ");
    const Scene odd  = scene_from_text("", "none", {"Wheelset/Velocity = 38.123456789012345 m/s"}).scene;
    const Scene back = scene_from_text(print_parameters(odd), "listing", {}).scene;
    check_near(back.velocity, odd.velocity, 1e-14, "a velocity of 17 digits reads back");
    std::size_t        longest = 0;
    std::istringstream lines(defaults);
    for (std::string line; std::getline(lines, line);)
      longest = std::max(longest, line.size());
    check(longest <= 100, "no line of the listing is longer than 100 characters");
  }
} // namespace

int
main()
{
  test_entries();
  test_independence();
  test_fields();
  test_round_trip();
  return test::report();
}
