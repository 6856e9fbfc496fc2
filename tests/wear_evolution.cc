// Profiles that wear: volumes, the size of steps, the pressure that evens out, going on after a stop.

#include "messages.h"
#include "worn_profiles.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/wear/wear_files.h>
#include <wheelrail/wheel/halfspace_parts.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;
using test::worn;

namespace
{
  Scene
  pulling()
  {
    return test::wearing_scene(0.25, 300e6);
  }

  double
  sum(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.);
  }

  BOOST_AUTO_TEST_CASE(test_shapes)
  {
    // a half circle of 10 mm, as a rail would run: over the top, x descending
    Segment arc;
    arc.kind                  = Segment::Kind::arc;
    arc.name                  = "arc";
    arc.radius                = 10e-3;
    arc.angle_start           = 0;
    arc.angle_end             = M_PI;
    arc.start                 = {10e-3, 0};
    arc.end                   = {-10e-3, 0};
    WornShape           shape = worn_shape(Curve({arc}), -1, 0.1e-3, true);
    const auto          way   = arc_of(shape.points);
    const auto          cells = cell_lengths(way);
    std::vector<double> sections(way.size(), 0);
    BOOST_TEST(near(way.back() / (M_PI * 10e-3), 1, 1e-4, "length of the points over that of the arc"));
    BOOST_TEST(
      near(arc_next_to(shape.points, way, {0, 12e-3}) / (0.5 * M_PI * 10e-3), 1, 1e-4, "way to the top"));
    spread_section(cells, 14e-3, 17e-3, 2e-9, sections);
    spread_section(cells, -5e-3, -1e-3, 1e-9, sections); // before the first point
    BOOST_TEST(near(sum(sections) / 3e-9, 1, 1e-12, "sections that are spread over their sum"));
    BOOST_TEST(near(sections.front() / 1e-9, 1, 1e-12, "what lies before the first point"));
    sections.front()  = 0;
    const auto smooth = smoothed_sections(way, sections, 5e-3);
    BOOST_TEST(near(sum(smooth) / 2e-9, 1, 1e-12, "smoothing loses nothing"));
    const std::vector<Point2> before = shape.points;
    take_off(smooth, shape);
    BOOST_TEST(near(section_between(before, shape.points) / 2e-9, 1, 1e-4, "what the profile lost"));
    BOOST_TEST(norm(shape.points[way.size() / 2]) < 10e-3, "it goes into the steel");
    // half of a wave of the cut-off length stays
    std::vector<double> wave(way.size());
    for (std::size_t k = 0; k < wave.size(); ++k)
      wave[k] = cells[k] * (1 + std::cos(2 * M_PI * way[k] / 5e-3));
    const auto  half   = smoothed_sections(way, wave, 5e-3);
    std::size_t middle = wave.size() / 2;
    double      high = 0, low = 10;
    for (std::size_t k = middle - 25; k < middle + 25; ++k)
      {
        high = std::max(high, half[k] / cells[k]);
        low  = std::min(low, half[k] / cells[k]);
      }
    BOOST_TEST(near(0.5 * (high - low), 0.5, 0.01, "amplitude of a wave of the cut-off length"));
  }

  /// What the patch says is what the profile loses: k p s / H.
  BOOST_AUTO_TEST_CASE(test_volume)
  {
    const Scene             scene    = pulling();
    const SceneProfiles     profiles = read_profiles(scene);
    const WornShape         rail = rail_shape(profiles.rail), wheel = wheel_shape(profiles.wheel);
    const SceneGeometry     geometry = make_geometry(scene, profiles_of(rail, wheel, scene));
    const WheelRailSolution one      = *solve_alone({scene, geometry, scene.wheel_load}, std::nullopt);
    const WearProfile       across   = halfspace_wear(one.problem, one.solution, scene.velocity, scene.wear);
    double                  weights  = 1;
    const MixWear           mix =
      wear_of_mix(mix_rows(scene, scene.wheel_load, weights), profiles_of(rail, wheel, scene), rail, wheel);
    const double section = over_width(across, across.depth);
    BOOST_TEST(near(sum(mix.rail_section) / section, 1, 1e-3, "section of the rail over that of the patch"));
    BOOST_TEST(
      near(sum(mix.wheel_section) / section, 1, 1e-3, "section of the wheel over that of the patch"));
    BOOST_TEST(near(mix.axle_load / 200e3, 1, 1e-12, "axle load"));

    const WearState after = worn(scene);
    double          taken = 0;
    for (const WearStep &step : after.steps)
      taken = std::max(taken, step.rail_section);
    const auto cells = cell_lengths(arc_of(after.new_rail.points));
    double     depth = 0;
    for (std::size_t k = 0; k < cells.size(); ++k)
      depth += after.rail.depth[k] * cells[k];
    BOOST_TEST(
      near(taken / depth, 1, 1e-3, "section between new and worn rail over the depths that were taken"));
    BOOST_TEST((after.steps.back().wheel_section < 1e-15 && after.steps.back().wheel_depth == 0),
               "the wheel stays");
    BOOST_TEST(near(after.steps.back().gross_load / 300e6, 1, 1e-9, "all that was planned has passed"));
    BOOST_TEST(
      near(after.rail.depth[after.rail.depth.size() / 4], 0, 1e-9, "no wear far from the contact [m]"));
  }

  BOOST_AUTO_TEST_CASE(test_steps)
  {
    Scene           scene      = pulling();
    const WearState once       = worn(scene);
    scene.wear_plan.step_depth = 0.5 * once.steps.front().step_depth;
    const WearState twice      = worn(scene);
    BOOST_TEST(twice.steps.size() > 1.5 * once.steps.size(),
               "half the depth a step takes more steps: " + std::to_string(twice.steps.size()) + " and " +
                 std::to_string(once.steps.size()));
    double most = 0, apart = 0;
    for (std::size_t k = 0; k < once.rail.depth.size(); ++k)
      {
        most  = std::max(most, once.rail.depth[k]);
        apart = std::max(apart, std::abs(once.rail.depth[k] - twice.rail.depth[k]));
      }
    BOOST_TEST(near(apart / most, 0, 0.02, "profile with half the steps, over the depth"));
    scene.wear_plan.step_depth = 1e-3;
    const WearState large      = worn(scene);
    BOOST_TEST((large.steps.size() == once.steps.size() &&
                large.note.find("Steps are smaller than Wear/Step depth") != std::string::npos),
               "too large a step is cut, and said: " + large.note);
  }

  /// A wheel that slides on one place takes off most where the load is largest: the load evens out across the
  /// middle half of the patch, and stays even.
  BOOST_AUTO_TEST_CASE(test_conforming)
  {
    Scene scene                = pulling();
    scene.drive                = Drive::rate; // it slides as a whole, everywhere as fast
    scene.creepage             = 0.05;
    scene.wear_plan.gross_load = 30e6;
    scene.wear_plan.smoothing  = 5e-3;
    const auto spread          = [&](const WearState &state) {
      const SceneGeometry     geometry = make_geometry(scene, profiles_of(state.rail, state.wheel, scene));
      const WheelRailSolution one      = *solve_alone({scene, geometry, scene.wheel_load}, std::nullopt);
      const auto             &grid     = one.solution.grid;
      std::vector<double>     rows;
      for (int j = 0; j < grid.my; ++j)
        {
          double load = 0;
          for (int i = 0; i < grid.mx; ++i)
            load += one.solution.pressure[i + grid.mx * j];
          if (load > 0)
            rows.push_back(load);
        }
      const auto begin = rows.begin() + rows.size() / 4, end = rows.end() - rows.size() / 4;
      const auto range = std::minmax_element(begin, end);
      return (*range.second - *range.first) / (std::accumulate(begin, end, 0.) / (end - begin));
    };
    const double before = spread(begin_wear(read_profiles(scene))), after = spread(worn(scene));
    BOOST_TEST(after < 0.5 * before,
               "load across the middle half of the patch: from a spread of " + std::to_string(before) +
                 " to " + std::to_string(after));
    scene.wear_plan.gross_load *= 2;
    const double later = spread(worn(scene));
    BOOST_TEST(later < after + 0.1, "which stays when it wears on: " + std::to_string(later));
  }

  /// A left wheel is a right one in the mirror.
  BOOST_AUTO_TEST_CASE(test_mirror)
  {
    Scene           scene = pulling();
    const WearState right = worn(scene);
    scene.left_wheel      = true;
    const WearState left  = worn(scene);
    double          apart = 0;
    for (std::size_t k = 0; k < right.rail.points.size(); ++k)
      apart = std::max(apart, norm(right.rail.points[k] - left.rail.points[k]));
    BOOST_TEST(near(apart / right.steps.back().rail_depth, 0, 1e-9, "left and right rail, over the depth"));
  }

  BOOST_AUTO_TEST_CASE(test_resume)
  {
    Scene scene                = pulling();
    scene.wear_plan.worn       = WornBody::both;
    scene.wear_plan.wheels     = 20;
    scene.wear_plan.gross_load = 10e6;
    const WearState whole      = worn(scene);
    BOOST_TEST((whole.steps.back().wheel_depth > 0 && whole.steps.back().rail_depth > 0), "both wear");
    BOOST_TEST(near(
      whole.steps.back().distance / (whole.steps.back().passages * 1000. / 20), 1, 1e-9, "way of a wheel"));
    WearState  state   = begin_wear(read_profiles(scene));
    double     weights = 1;
    const auto rows    = mix_rows(scene, scene.wheel_load, weights);
    struct Stop
    {
    };
    try
      {
        wear_on(
          scene,
          rows,
          [](const WearState &now) {
            std::ofstream("wear_state.json") << wear_state_as_text(now, "one");
            if (now.steps.size() == 3)
              throw Stop();
          },
          state);
      }
    catch (const Stop &)
      {
      }
    BOOST_TEST(!read_wear_state("nothing.json"), "a file that is not there holds no state");
    BOOST_TEST((read_wear_state("wear_state.json")->digest == "one"), "whose state it is");
    state = read_wear_state("wear_state.json")->state;
    state.steps.pop_back();
    wear_on(
      scene, rows, [](const WearState &) {}, state);
    bool same = state.steps.size() == whole.steps.size();
    for (std::size_t k = 0; k < whole.rail.points.size(); ++k)
      same =
        same && state.rail.points[k].y == whole.rail.points[k].y && state.wheel.depth == whole.wheel.depth;
    BOOST_TEST(same, "stopped and gone on to the same bits");
    std::string text;
    std::getline(std::ifstream("wear_state.json"), text);
    text[text.find("\"depth\":[") + 12] ^= 1;
    for (const std::string &damaged : {std::string("{"), text})
      {
        std::ofstream("wear_state.json") << damaged;
        BOOST_TEST(
          test::same_text(test::message_of([]() { read_wear_state("wear_state.json"); }),
                          "\"wear_state.json\": damaged, so that it cannot be resumed. Choose another "
                          "Output/Folder, or give --overwrite to start anew.",
                          "half a file, another digit"));
      }
  }

  /// S1002 new: flange 28 mm high, 32.5 mm thick, qR 10.8 mm (EN 13715).
  BOOST_AUTO_TEST_CASE(test_dimensions)
  {
    const SceneProfiles  profiles = read_profiles(Scene());
    const WornShape      rail = rail_shape(profiles.rail), wheel = wheel_shape(profiles.wheel);
    const WornDimensions fresh = worn_dimensions(rail, rail, wheel);
    BOOST_TEST(near(1e3 * fresh.flange_height, 28, 0.01, "flange height Sh [mm]"));
    BOOST_TEST(near(1e3 * fresh.flange_thickness, 32.5, 0.05, "flange thickness Sd [mm]"));
    BOOST_TEST(near(1e3 * fresh.flange_gradient, 10.8, 0.1, "flange gradient qR [mm]"));
    BOOST_TEST((fresh.rail_height == 0 && fresh.rail_side == 0), "a new rail has lost nothing");
    WornShape lower = rail;
    for (Point2 &p : lower.points)
      {
        p.y -= 1e-3;
        p.x += 0.5e-3;
      }
    BOOST_TEST(near(1e3 * worn_dimensions(rail, lower, wheel).rail_height, 1, 0.01, "height [mm]"));
    // with 0.1 mm of the arc of the side between 13 and 14 mm
    BOOST_TEST(near(1e3 * worn_dimensions(rail, lower, wheel).rail_side, 0.597, 0.01, "gauge side [mm]"));
  }

  std::string
  said(const Arguments &arguments)
  {
    std::ostringstream out;
    return test::message_of([&]() { execute(arguments, {}, out); });
  }

  BOOST_AUTO_TEST_CASE(test_faults)
  {
    Scene scene                = pulling();
    scene.friction.at_rest     = 0;
    scene.traction_coefficient = 0;
    const WearState none       = worn(scene);
    BOOST_TEST((none.steps.back().rail_depth == 0 && none.note.find("Nothing wears") != std::string::npos),
               "without friction nothing wears: " + none.note);
    BOOST_TEST(test::same_text(
      wear_verdict(none).doubts(),
      "Up to 100 % of the passages are with care, such as the scene: Too few elements: they leave the peak "
      "pressure uncertain by 5.1 %; take Half-space/Element size = 0.98 mm. The peak pressure is 6 % above "
      "that of the true bodies, whose head and rim turn and move under these forces, which half-spaces do "
      "not include; take Half-space/Bodies = real.",
      "contacts on the head are held against true bodies"));
    scene.lateral_shift      = -4.5e-3;
    const WearState   corner = worn(scene);
    const std::string doubts = wear_verdict(corner).doubts();
    BOOST_TEST(
      (wear_verdict(corner).grade() == Grade::not_trusted &&
       doubts.rfind(
         "Up to 100 % of the passages are not trusted, such as the scene: Too few elements: they leave ",
         0) == 0 &&
       doubts.find("The peak pressure is 35 % above that of the true bodies") != std::string::npos),
      "the corner of the head is not: " + doubts);
    BOOST_TEST(near(corner.steps.back().not_trusted, 1, 0, "all of its passages"));
    std::ofstream("mix.csv") << "lateral shift [mm],yaw [mrad],weight\n0,0,1\n-11.9,50,1\n";
    const std::string prm  = WHEELRAIL_SOURCE_DIR "/prm/wear.prm";
    const auto        with = [&](const std::vector<std::string> &sets) {
      Arguments words = {"wear", prm, "--no-pictures", "--set", "Wear/Mix = mix.csv"};
      for (const std::string &set : sets)
        {
          words.emplace_back("--set");
          words.push_back(set);
        }
      return said(words);
    };
    const std::string far = with({});
    BOOST_TEST(far.rfind("Wear/Mix = mix.csv, row 2: Wheel 'S1002' and rail '54E1'", 0) == 0,
               "a row that does not touch: " + far);
    std::ofstream("mix.csv") << "lateral shift [mm],weight\n0,0\n1,0\n";
    BOOST_TEST(test::same_text(
      with({}),
      "mix.csv: no row has both a weight and a load above 0; write how often each row passes, "
      "and with which load",
      "no weight"));
    std::ofstream("mix.csv") << "lateral shift [mm],weight\n0,-1\n";
    BOOST_TEST(test::same_text(
      with({}),
      "mix.csv:2: weight = -1 is out of range; 0 to 1e12 is accepted, in the unit of the first line",
      "a negative weight"));
    BOOST_TEST(test::same_text(
      with({"Profiles/Rail left = 60E1"}),
      "Profiles/Rail left = 60E1: both sides wear alike, as on a line with as many curves to the left "
      "as to the right; write as right",
      "two rails"));
    BOOST_TEST(test::same_text(
      with({"Half-space/Undeformed distance = hertz"}),
      "wear takes the distance of wheel and rail: set Half-space/Undeformed distance = profiles",
      "a distance that is given"));
  }
} // namespace
