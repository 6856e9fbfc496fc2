// Grinding and turning between steps of wear, and cracks net of wear.

#include "near.h"
#include "worn_profiles.h"

#include <wheelrail/damage/machining.h>
#include <wheelrail/wear/wear_evolution.h>
#include <wheelrail/wear/wear_files.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;
using test::worn;

namespace
{
  /// A hollow of 0.5 mm at the top of the rail goes when the whole head goes down by as much.
  BOOST_AUTO_TEST_CASE(test_hollow)
  {
    const WornShape     fresh = rail_shape(read_profiles(Scene()).rail);
    WornShape           worn  = fresh;
    std::vector<double> taken(fresh.points.size());
    const auto          cells = cell_lengths(arc_of(fresh.points));
    for (std::size_t k = 0; k < taken.size(); ++k)
      taken[k] = 0.5e-3 * std::exp(-std::pow(fresh.points[k].x / 5e-3, 2)) * cells[k];
    take_off(taken, worn);
    const WornShape before = worn;
    const Machining work   = machining(worn, fresh.points, M_PI / 3);
    BOOST_TEST(near(1e3 * work.shift, 0.5, 1e-3, "the target goes down by the hollow's depth [mm]"));
    take_off(work.sections, worn);
    BOOST_TEST(
      near(section_between(before.points, worn.points) / work.section, 1, 2e-3, "what the profile lost"));
    double apart = 0;
    for (const Point2 &p : worn.points)
      {
        if (std::abs(p.x) > 25e-3)
          continue;
        double next = 1;
        for (const Point2 &q : fresh.points)
          next = std::min(next, norm(q - Point2{0, work.shift} - p));
        apart = std::max(apart, next);
      }
    BOOST_TEST(apart < 0.13e-3,
               "the ground head lies on the target's points, 0.25 mm apart: " + std::to_string(1e3 * apart));
    BOOST_TEST(
      near(machining(fresh, fresh.points, M_PI / 3).section, 0, 1e-12, "a new rail loses nothing [m2]"));
  }

  /// A flange that is 1 mm thinner asks for 1 mm times the slope of its face, and then has its old
  /// dimensions.
  BOOST_AUTO_TEST_CASE(test_flange)
  {
    const SceneProfiles profiles = read_profiles(Scene());
    const WornShape     rail = rail_shape(profiles.rail), fresh = wheel_shape(profiles.wheel);
    WornShape           worn = fresh;
    std::vector<double> taken(fresh.points.size(), 0.);
    const auto          cells = cell_lengths(arc_of(fresh.points));
    for (std::size_t k = 0; k < taken.size(); ++k)
      taken[k] = 1e-3 * std::exp(-std::pow((fresh.points[k].x + 40e-3) / 3e-3, 2)) * cells[k];
    take_off(taken, worn);
    const Machining work = machining(worn, fresh.points, 80 * M_PI / 180);
    BOOST_TEST((work.shift > 1.5e-3 && work.shift < 5e-3),
               "turned by " + std::to_string(1e3 * work.shift) +
                 " mm for a flange that lost 1 mm along its normal");
    take_off(work.sections, worn);
    const WornDimensions turned = worn_dimensions(rail, rail, worn), was = worn_dimensions(rail, rail, fresh);
    BOOST_TEST(near(1e3 * turned.flange_height, 1e3 * was.flange_height, 0.1, "Sh as new [mm]"));
    BOOST_TEST(near(1e3 * turned.flange_thickness, 1e3 * was.flange_thickness, 0.1, "Sd as new [mm]"));
    BOOST_TEST(near(1e3 * turned.flange_gradient, 1e3 * was.flange_gradient, 0.1, "qR as new [mm]"));
  }

  Scene
  pulling()
  {
    return test::wearing_scene(0.25, 300e6);
  }

  /// Every 100 000 t of 300 000: twice, not at the end.
  BOOST_AUTO_TEST_CASE(test_events)
  {
    Scene scene                 = pulling();
    scene.wear_plan.grind_to    = "54E1";
    scene.wear_plan.grind_every = 100e6;
    std::vector<MachiningEvent> events;
    const WearState state = worn(scene, [&](const MachiningEvent &done) { events.push_back(done); });
    BOOST_TEST((events.size() == 2 && state.grindings == 2),
               "ground twice: " + std::to_string(events.size()));
    double told = 0;
    for (const MachiningEvent &event : events)
      told += event.section;
    BOOST_TEST(
      near(told / state.steps.back().rail_ground, 1, 1e-12, "what was told over what is in the table"));
    double     lost  = 0;
    const auto cells = cell_lengths(arc_of(state.new_rail.points));
    for (std::size_t k = 0; k < cells.size(); ++k)
      lost += state.rail.depth[k] * cells[k];
    BOOST_TEST(near(state.steps.back().rail_section / lost,
                    1,
                    2e-3,
                    "section between new and last profile over all depths"));
    std::vector<double> at;
    for (std::size_t k = 1; k < state.steps.size(); ++k)
      if (state.steps[k].passages == state.steps[k - 1].passages)
        {
          at.push_back(state.steps[k].gross_load);
          BOOST_TEST(state.steps[k].rail_ground > state.steps[k - 1].rail_ground,
                     "a state before and one behind");
          BOOST_TEST(state.steps[k].rail_damage <= state.steps[k - 1].rail_damage,
                     "grinding starts no cracks");
        }
    BOOST_TEST(at.size() == 2, "two events in the table");
    if (at.size() == 2)
      {
        BOOST_TEST(near(at[0] / 100e6, 1, 1e-9, "at 100 000 t"));
        BOOST_TEST(near(at[1] / 200e6, 1, 1e-9, "at 200 000 t"));
      }
    scene.wear_plan.worn       = WornBody::wheel;
    scene.wear_plan.distance   = 1e6;
    scene.wear_plan.turn_to    = "S1002";
    scene.wear_plan.turn_every = 0.6e6;
    events.clear();
    const WearState wheel = worn(scene, [&](const MachiningEvent &done) { events.push_back(done); });
    BOOST_TEST((events.size() == 1 && !events[0].of_rail && wheel.turnings == 1 && wheel.grindings == 0),
               "a wheel that wears alone is turned, its rail is not ground");
    BOOST_TEST(near(wheel.steps.back().distance / 1e6, 1, 1e-9, "and rolls as far as planned"));
    BOOST_TEST((wheel.steps.back().rail_damage == 0 && wheel.steps.back().wheel_damage > 0),
               "the rails it meets are ever new ones");
  }

  /// Crack growth is Burstow's function up to its peak, and goes on there; the net of growth and wear is
  /// nothing where wear is faster, and their difference where it is not.
  BOOST_AUTO_TEST_CASE(test_net_cracks)
  {
    const WearData data;
    BOOST_TEST(near(crack_growth(40, data), burstow_damage(40, data), 0, "as Burstow's up to the peak"));
    BOOST_TEST(
      near(crack_growth(120, data), data.damage_most, 0, "no falling branch: wear is counted by itself"));
    Scene                       scene = pulling();
    std::vector<MachiningEvent> events;
    scene.wear.crack_depth = 1; // no wear takes such cracks away
    const WearState deep   = worn(scene, [&](const MachiningEvent &done) { events.push_back(done); });
    BOOST_TEST(near(
      deep.steps.back().rail_cracks / deep.steps.back().rail_damage, 1, 0.02, "without wear: growth alone"));
    BOOST_TEST((deep.steps.back().wheel_damage == 0 && deep.steps.back().wheel_cracks == 0),
               "the wheels that a rail meets are ever new ones");
    scene.wear.crack_depth  = 1e-5;
    const WearState shallow = worn(scene, [&](const MachiningEvent &done) { events.push_back(done); });
    BOOST_TEST(
      near(shallow.steps.back().rail_damage, deep.steps.back().rail_damage, 1e-12, "Burstow's own stays"));
    // depth 5e-4 of some 3 nm a passage against 1e-5 m x 0.6e-5 a passage: wear wins but at the patch's rim
    BOOST_TEST(shallow.steps.back().rail_cracks < 0.3 * shallow.steps.back().rail_damage,
               "shallow cracks are worn off: " + std::to_string(shallow.steps.back().rail_cracks) + " of " +
                 std::to_string(shallow.steps.back().rail_damage));
  }
} // namespace
