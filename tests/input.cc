// label: fast
// needs: track

// The entries of parameter files: every one, defaults, round trips.

#include "near.h"
#include "other_values.h"

#include <wheelrail/input/entries.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/scene/one_wheel.h>

#include <algorithm>
#include <sstream>
#include <vector>

using namespace wheelrail;
using test::near;
using test::other_values;
using test::same_text;

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

  BOOST_AUTO_TEST_CASE(test_entries)
  {
    const Scene defaults = scene_from_text("", "none", {}).scene;
    const Scene other    = other_scene();
    for (const Entry &entry : entries())
      {
        const std::string path = entry.path();
        BOOST_TEST(
          same_text(entry.get(defaults), entry.default_text, path + ": the text of the default reads back"));
        const auto value = other_values().find(path);
        BOOST_REQUIRE_MESSAGE(value != other_values().end(), path + ": is set by this test");
        BOOST_TEST(same_text(entry.get(other), value->second, path + ": set and read back"));
        BOOST_TEST((!entry.meaning.empty() && entry.meaning.back() == '.'), path + ": has a meaning");
      }
    BOOST_TEST(near(static_cast<double>(other_values().size()),
                    static_cast<double>(entries().size()),
                    0,
                    "all entries are tested"));
  }

  /// One entry changes one value: the others keep theirs.
  BOOST_AUTO_TEST_CASE(test_independence)
  {
    for (const auto &value : other_values())
      {
        Scene        scene = scene_from_text("", "none", {}).scene;
        const auto   slash = value.first.find('/');
        const Entry *entry = slash == std::string::npos
                               ? find_entry("", value.first)
                               : find_entry(value.first.substr(0, slash), value.first.substr(slash + 1));
        BOOST_REQUIRE_MESSAGE(entry != nullptr, value.first + ": is an entry");
        entry->set(scene, value.second);
        std::string changed;
        for (const Entry &any : entries())
          if (any.get(scene) != any.default_text)
            changed += any.path() + ";";
        BOOST_TEST(same_text(changed, value.first + ";", value.first + ": changes only itself"));
      }
  }

  BOOST_AUTO_TEST_CASE(test_fields)
  {
    const Scene s = other_scene();
    BOOST_TEST(same_text(s.title, "other scene, 50 % slower", "field title"));
    BOOST_TEST(same_text(
      s.wheel_profile, std::string(WHEELRAIL_TEST_DIR) + "/profiles/worn_S1002.prw", "field wheel_profile"));
    BOOST_TEST((s.wheel_file.mirror == ProfileMirror::no && s.rail_file.mirror == ProfileMirror::yes),
               "fields mirror");
    BOOST_TEST((s.wheel_file.turn == ProfileMirror::yes && s.rail_file.turn == ProfileMirror::yes),
               "fields turn");
    BOOST_TEST((s.wheel_origin == WheelOrigin::running_circle), "field wheel_origin");
    BOOST_TEST((s.wheel_file.unit == ProfileUnit::millimetre && s.rail_file.unit == ProfileUnit::inch),
               "fields unit");
    BOOST_TEST(same_text(s.rail_body, "60E1", "field rail_body"));
    BOOST_TEST(near(s.rail_file.noise, 1e-5, 0, "field rail_file.noise"));
    BOOST_TEST(near(s.wheel_file.noise, 1e-5, 0, "field wheel_file.noise"));
    BOOST_TEST(same_text(s.rail_profile, "60E1", "field rail_profile"));
    BOOST_TEST(same_text(s.left_rail_profile, "54E1", "field left_rail_profile"));
    BOOST_TEST(same_text(s.left_wheel_profile, "S1002", "field left_wheel_profile"));
    BOOST_TEST(near(s.track.gauge, 1.437, 0, "field gauge"));
    BOOST_TEST(near(s.track.gauge_height, 0.015, 0, "field gauge_height"));
    BOOST_TEST(near(s.track.inclination, 0.05, 0, "field inclination"));
    BOOST_TEST(near(s.rail_length, 1.2, 0, "field rail_length"));
    const SupportData &t = s.support;
    BOOST_TEST((t.kind == RailSupport::sleepers && t.pad_damping == PadLoss::constant),
               "fields of the support");
    BOOST_TEST(near(t.spacing, 0.65, 0, "field spacing"));
    BOOST_TEST(near(t.first_sleeper, -0.2, 0, "field first_sleeper"));
    BOOST_TEST(near(t.pad_length, 0.16, 0, "field pad_length"));
    BOOST_TEST(near(t.pad_stiffness, 250e6, 0, "field pad_stiffness"));
    BOOST_TEST(near(t.pad_lateral, 30e6, 0, "field pad_lateral"));
    BOOST_TEST(near(t.pad_longitudinal, 35e6, 0, "field pad_longitudinal"));
    BOOST_TEST(near(t.pad_loss, 0.2, 0, "field pad_loss"));
    BOOST_TEST(near(t.pad_frequency, 400, 0, "field pad_frequency"));
    BOOST_TEST(near(t.sleeper_mass, 150, 0, "field sleeper_mass"));
    BOOST_TEST(near(t.ballast_stiffness, 60e6, 0, "field ballast_stiffness"));
    BOOST_TEST(near(t.ballast_lateral, 20e6, 0, "field ballast_lateral"));
    BOOST_TEST(near(t.ballast_longitudinal, 15e6, 0, "field ballast_longitudinal"));
    BOOST_TEST(near(t.ballast_loss, 0.8, 0, "field ballast_loss"));
    BOOST_TEST(near(t.ballast_frequency, 90, 0, "field ballast_frequency"));
    BOOST_TEST(near(t.damped_ends, 0.3, 0, "field damped_ends"));
    BOOST_TEST(near(s.track.nominal_radius, 0.42, 0, "field track.nominal_radius"));
    BOOST_TEST(near(s.wheel.nominal_radius, 0.42, 0, "field wheel.nominal_radius"));
    BOOST_TEST(near(s.track.flange_back_distance, 1.361, 0, "field flange_back_distance"));
    BOOST_TEST(near(s.lateral_shift, -0.0035, 0, "field lateral_shift"));
    BOOST_TEST((s.roll == RollMode::from_contact), "field roll");
    BOOST_TEST(near(s.track_radius, -300, 0, "field track_radius"));
    BOOST_TEST((!s.rigid_axle && s.both_wheels && s.pose_balances), "fields of the axle");
    BOOST_TEST(near(s.cant, -0.08, 0, "field cant"));
    BOOST_TEST(near(s.prudhomme_factor, 0.85, 0, "field prudhomme_factor"));
    BOOST_TEST(near(s.lateral_stiffness, 3e6, 0, "field lateral_stiffness"));
    BOOST_TEST(near(s.yaw_stiffness, 5e6, 0, "field yaw_stiffness"));
    BOOST_TEST(near(s.centre_height, 1.6, 0, "field centre_height"));
    BOOST_TEST(near(s.left_friction, 0.25, 0, "field left_friction"));
    BOOST_TEST(same_text(s.wear_plan.mix, "mix.csv", "field wear_plan.mix"));
    BOOST_TEST((s.wear_plan.worn == WornBody::both), "field wear_plan.worn");
    BOOST_TEST(near(s.wear_plan.gross_load, 5e9, 0, "field wear_plan.gross_load"));
    BOOST_TEST(near(s.wear_plan.distance, 2e6, 0, "field wear_plan.distance"));
    BOOST_TEST(near(s.wear_plan.smoothing, 8e-3, 0, "field wear_plan.smoothing"));
    BOOST_TEST(near(s.wear_plan.step_depth, 2e-6, 0, "field wear_plan.step_depth"));
    BOOST_TEST(near(s.wear_plan.line_length, 3e3, 0, "field wear_plan.line_length"));
    BOOST_TEST(s.wear_plan.wheels == 40, "field wear_plan.wheels");
    BOOST_TEST(near(s.wear.crack_depth, 2e-3, 1e-15, "field wear.crack_depth"));
    BOOST_TEST(same_text(s.wear_plan.grind_to, "60E1", "field wear_plan.grind_to"));
    BOOST_TEST(near(s.wear_plan.grind_every, 3e9, 0, "field wear_plan.grind_every"));
    BOOST_TEST(same_text(s.wear_plan.turn_to, "S1002", "field wear_plan.turn_to"));
    BOOST_TEST(near(s.wear_plan.turn_every, 5e5, 0, "field wear_plan.turn_every"));
    BOOST_TEST(same_text(s.motion, "motion.csv", "field motion"));
    BOOST_TEST(near(s.motion_start, 12.5, 0, "field motion_start"));
    BOOST_TEST(near(s.wheel.rim_width, 0.136, 0, "field rim_width"));
    BOOST_TEST(near(s.wheel.rim_inner_radius, 0.365, 0, "field rim_inner_radius"));
    BOOST_TEST(near(s.wheel.disc_thickness, 0.025, 0, "field disc_thickness"));
    BOOST_TEST(near(s.wheel.disc_position, 0.07, 0, "field disc_position"));
    BOOST_TEST(near(s.wheel.hub_length, 0.18, 0, "field hub_length"));
    BOOST_TEST(near(s.wheel.hub_position, 0.071, 0, "field hub_position"));
    BOOST_TEST(near(s.wheel.hub_outer_radius, 0.125, 0, "field hub_outer_radius"));
    BOOST_TEST(near(s.wheel.bore_radius, 0.09, 0, "field bore_radius"));
    BOOST_TEST(near(s.wheel.fillet_radius, 0.018, 0, "field fillet_radius"));
    BOOST_TEST(near(s.sprung_mass, 9500, 0, "field sprung_mass"));
    BOOST_TEST(near(s.wheel_load, 98e3, 1e-9, "field wheel_load"));
    BOOST_TEST(near(s.axle_mass, 170, 0, "field axle_mass"));
    BOOST_TEST(near(s.axle_pitch_inertia, 1.4, 0, "field axle_pitch_inertia"));
    BOOST_TEST(near(s.suspension_stiffness, 1.2e6, 0, "field suspension_stiffness"));
    BOOST_TEST(near(s.suspension_damping, 2600, 0, "field suspension_damping"));
    BOOST_TEST(near(s.velocity, 70 / 3.6, 0, "field velocity"));
    BOOST_TEST((s.drive == Drive::rate), "field drive");
    BOOST_TEST(near(s.traction_coefficient, -0.2, 0, "field traction_coefficient"));
    BOOST_TEST(near(s.creepage, 0.001, 0, "field creepage"));
    BOOST_TEST(near(s.friction.at_rest, 0.3, 0, "field friction_coefficient"));
    BOOST_TEST((s.friction.kind == FrictionKind::rational), "field friction_law");
    BOOST_TEST(near(s.friction.at_speed, 0.25, 0, "field dynamic_friction_coefficient"));
    BOOST_TEST(near(s.friction.decay, 0.1, 0, "field friction_decay"));
    BOOST_TEST(near(s.friction.half_velocity, 3, 0, "field friction_half_velocity"));
    BOOST_TEST(near(s.penalty_scale, 3, 0, "field penalty_scale"));
    BOOST_TEST(near(s.contact_damping, 0.2, 0, "field contact_damping"));
    BOOST_TEST(near(s.rail_material.youngs_modulus, 206e9, 0, "field rail youngs_modulus"));
    BOOST_TEST(near(s.rail_material.poissons_ratio, 0.28, 0, "field rail poissons_ratio"));
    BOOST_TEST(near(s.rail_material.density, 7850, 0, "field rail density"));
    BOOST_TEST(near(s.rail_material.tangent_modulus, 20e9, 0, "field rail tangent_modulus"));
    BOOST_TEST(near(s.rail_material.kinematic_hardening, 0.5, 0, "field rail kinematic_hardening"));
    BOOST_TEST(near(s.wheel_material.youngs_modulus, 207e9, 0, "field wheel youngs_modulus"));
    BOOST_TEST(near(s.wheel_material.poissons_ratio, 0.29, 0, "field wheel poissons_ratio"));
    BOOST_TEST(near(s.wheel_material.density, 7800, 0, "field wheel density"));
    BOOST_TEST(near(s.wheel_material.tangent_modulus, 19e9, 0, "field wheel tangent_modulus"));
    BOOST_TEST(near(s.wheel_material.kinematic_hardening, 1, 0, "field wheel kinematic_hardening"));
    BOOST_TEST(near(s.cell_size, 0.002, 0, "field cell_size"));
    BOOST_TEST((s.halfspace_bodies == ContactBodies::real), "field halfspace_bodies");
    BOOST_TEST(near(s.halfspace_memory_length, 3e-6, 0, "field halfspace_memory_length"));
    BOOST_TEST(near(s.halfspace_memory_speed, 2e-3, 0, "field halfspace_memory_speed"));
    BOOST_TEST(near(s.halfspace_layer_thickness, 1.25e-3, 0, "field halfspace_layer_thickness"));
    BOOST_TEST(near(s.halfspace_layer_shear, 8e9, 0, "field halfspace_layer_shear"));
    BOOST_TEST(near(s.coarse_cell_size, 0.032, 0, "field coarse_cell_size"));
    BOOST_TEST(near(s.fine_depth, 0.007, 0, "field fine_depth"));
    BOOST_TEST(near(s.fine_margin, 0.006, 0, "field fine_margin"));
    BOOST_TEST(s.mass_scaling, "field mass_scaling");
    BOOST_TEST(near(s.rolling_distance, 0.26, 0, "field rolling_distance"));
    BOOST_TEST(near(s.longest_distance, 0.3, 0, "field longest_distance"));
    BOOST_TEST(near(s.standard_error, 0.002, 0, "field standard_error"));
    BOOST_TEST(near(s.wanted_accuracy, 0.03, 0, "field wanted_accuracy"));
    BOOST_TEST(near(s.averaging_distance, 0.05, 0, "field averaging_distance"));
    BOOST_TEST(near(s.time_step_factor, 0.8, 0, "field time_step_factor"));
    BOOST_TEST(near(s.bulk_viscosity, 0.03, 0, "field bulk_viscosity"));
    BOOST_TEST(near(s.energy_limit, 0.02, 0, "field energy_limit"));
    BOOST_TEST((s.element == ElementForm::full), "field element");
    BOOST_TEST((s.rail_element == ElementForm::reduced && s.wheel_element == ElementForm::full),
               "fields rail_element and wheel_element");
    BOOST_TEST(same_text(s.folder, "output/other", "field folder"));
    BOOST_TEST(near(s.ticks, 13, 0, "field ticks"));
    BOOST_TEST(!s.volume_fields, "field volume_fields");
    BOOST_TEST(
      near(scene_from_text("", "none", {"Mesh/Solution cell size = 2 mm"}).scene.depth_of_fine_cells(),
           0.010,
           1e-18,
           "fine depth auto is five cells"));
  }

  BOOST_AUTO_TEST_CASE(test_round_trip)
  {
    const std::string defaults = print_parameters(Scene());
    BOOST_TEST(same_text(print_parameters(scene_from_text(defaults, "listing", {}).scene),
                         defaults,
                         "listing of the defaults reads back"));
    const std::string other = print_parameters(other_scene());
    BOOST_TEST(same_text(print_parameters(scene_from_text(other, "listing", {}).scene),
                         other,
                         "listing of another scene reads back"));
    BOOST_TEST((other != defaults), "the listings differ");
    const Scene odd  = scene_from_text("", "none", {"Wheelset/Velocity = 38.123456789012345 m/s"}).scene;
    const Scene back = scene_from_text(print_parameters(odd), "listing", {}).scene;
    BOOST_TEST(near(back.velocity, odd.velocity, 1e-14, "a velocity of 17 digits reads back"));
    std::size_t        longest = 0;
    std::istringstream lines(defaults);
    for (std::string line; std::getline(lines, line);)
      longest = std::max(longest, line.size());
    BOOST_TEST(longest <= 100, "no line of the listing is longer than 100 characters");
  }
} // namespace
