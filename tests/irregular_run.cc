// ranks: 1
// label: long
// Runs over irregular surfaces: the same hollow as an offset of the contact and in the mesh, on rail and
// wheel; energy, what the history shows; smooth surfaces in files; small waves.
#include "between_rows.h"
#include "parallel.h"
#include "read_output.h"
#include "stopped_runs.h"

#include <wheelrail/output/summary.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  struct Result
  {
    Summary summary;
    History history;

    const std::vector<double> &
    column(const std::string &name) const
    {
      for (std::size_t c = 0; c < history.names.size(); ++c)
        if (history.names[c] == name)
          return history.columns[c];
      throw std::runtime_error("no column " + name);
    }
    /// The vertical force after this distance, between the rows [N].
    double
    force_at(const double distance) const
    {
      return between_rows(column("rolled_distance"), column("vertical_force"), distance);
    }

    /// Largest deviation of a column from its first value.
    double
    swing(const std::string &name) const
    {
      double largest = 0;
      for (const double value : column(name))
        largest = std::max(largest, std::abs(value - column(name).front()));
      return largest;
    }
  };

  /// A free wheel at 30 m/s on cells of 2 mm, over 8 mm.
  Scene
  short_scene(const std::string &title)
  {
    Scene scene;
    scene.title               = title;
    scene.cell_size           = 2e-3;
    scene.fine_depth          = 6e-3;
    scene.rail_length         = 0.5;
    scene.velocity            = 30;
    scene.rolling_distance    = 8e-3;
    scene.averaging_distance  = 4e-3;
    scene.ticks               = 1;
    scene.volume_fields       = false;
    scene.checkpoint_interval = 1e4;
    scene.folder              = "short";
    return scene;
  }

  /// The same over a hollow of rail or wheel.
  Scene
  hollow_scene(const double depth, const IrregularBody body)
  {
    Scene scene =
      short_scene((body == IrregularBody::rail ? "rail " : "wheel ") + std::to_string(1e6 * depth) + " um");
    scene.rolling_distance   = 60e-3;
    scene.averaging_distance = 5e-3;
    scene.folder             = "hollow";
    IrregularityData &hollow = scene.irregularities[0];
    hollow.kind              = IrregularKind::dent;
    hollow.body              = body;
    hollow.place             = 30e-3;
    hollow.length            = 30e-3;
    hollow.depth             = depth;
    return scene;
  }

  /// Over a hollow 30 mm long that is carried one way.
  Result
  over_hollow(const double depth, const Body body, const CarriedBy carried)
  {
    Scene scene = hollow_scene(depth, body == Body::rail ? IrregularBody::rail : IrregularBody::wheel);
    scene.title += carried == CarriedBy::mesh ? " in the mesh" : " of offsets";
    SceneGeometry   geometry = make_geometry(scene);
    RunningSurface &surface  = body == Body::rail ? geometry.surfaces.rail : geometry.surfaces.wheel;
    Irregularities  hollow   = surface.irregularities();
    hollow.front().carried   = carried;
    surface.set_irregularities(std::make_shared<const Irregularities>(hollow));
    RunOptions options;
    options.overwrite       = true;
    options.prm_text        = "# a test\n";
    options.parameters_text = print_parameters(scene);
    BOOST_TEST(run_scene(scene, geometry, options) == 0, scene.title + ": the run ends");
    Result result{read_summary("hollow/summary.json"), read_history("hollow/history.h5")};
    BOOST_TEST(result.summary.energy_error < 0.01,
               scene.title +
                 ": energy error below 1 %: " + std::to_string(100 * result.summary.energy_error));
    return result;
  }

  /// The share of one column's change in that of another one over the same way, by least squares.
  double
  share(const Result &of, const Result &in, const std::string &name)
  {
    const auto &x = in.column("rolled_distance"), &y = in.column(name), &u = of.column("rolled_distance"),
               &v    = of.column(name);
    double      both = 0, own = 0;
    std::size_t k = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        while (k + 2 < u.size() && u[k + 1] < x[i])
          ++k;
        const double part = (x[i] - u[k]) / (u[k + 1] - u[k]), there = v[k] + part * (v[k + 1] - v[k]);
        both += (there - v.front()) * (y[i] - y.front());
        own += std::pow(y[i] - y.front(), 2);
      }
    return both / own;
  }

  /// A hollow of the rail at the border between both ways: the same forces.
  BOOST_FIXTURE_TEST_CASE(test_both_ways, test::Parallel)
  {
    const Result offsets = over_hollow(50e-6, Body::rail, CarriedBy::offset),
                 mesh    = over_hollow(50e-6, Body::rail, CarriedBy::mesh);
    for (const char *force : {"vertical_force", "longitudinal_force", "lateral_force"})
      BOOST_TEST(
        near(share(mesh, offsets, force), 1, 0.02, force + std::string(" in the mesh over that of offsets")));
    BOOST_TEST(offsets.swing("vertical_force") > 0.05 * get_figure(offsets.summary, "wheel_load_N"),
               "the hollow is felt");
    BOOST_TEST(near(get_figure(mesh.summary, "least_vertical_force_at_m"),
                    get_figure(offsets.summary, "least_vertical_force_at_m"),
                    1.5e-3,
                    "at the same place [m]"));
  }

  /// On a wheel the mesh carries even shallow ones, since the radius is what slides: see deepest_offset.
  BOOST_FIXTURE_TEST_CASE(test_shallow_on_wheel, test::Parallel)
  {
    const SceneGeometry geometry = make_geometry(hollow_scene(5e-6, IrregularBody::wheel));
    BOOST_TEST((geometry.surfaces.wheel.irregularities().front().carried == CarriedBy::mesh),
               "a hollow of 5 um of the wheel is in the mesh");
    over_hollow(40e-6, Body::wheel, CarriedBy::mesh);
  }

  /// Heights of nothing, in a file, are no irregularity.
  BOOST_FIXTURE_TEST_CASE(test_smooth_file, test::Parallel)
  {
    std::ofstream grid("smooth.csv");
    grid << "along_mm,across_mm,height_um\n";
    for (int i = -5; i <= 5; ++i)
      for (int j = -5; j <= 5; ++j)
        grid << 20 * i << "," << 6 * j << ",0\n";
    grid.close();
    run(short_scene("smooth"), false);
    const Summary smooth = read_summary("short/summary.json");
    for (const IrregularBody body : {IrregularBody::rail, IrregularBody::wheel})
      {
        Scene scene                  = short_scene("smooth, in a file");
        scene.irregularities[0].kind = IrregularKind::file;
        scene.irregularities[0].body = body;
        scene.irregularities[0].file = "smooth.csv";
        run(scene, false);
        const Summary     found = read_summary("short/summary.json");
        const std::string name  = body == IrregularBody::rail ? "rail" : "wheel";
        BOOST_TEST(near_relative(
          found.vertical_force, smooth.vertical_force, 1e-6, name + " in a file: vertical force"));
        BOOST_TEST(
          near_relative(found.max_pressure, smooth.max_pressure, 1e-6, name + " in a file: peak pressure"));
        BOOST_TEST(near_relative(found.contact_area, smooth.contact_area, 1e-6, name + " in a file: area"));
      }
  }

  /// Vertical force over the path on waves of 40 mm.
  Result
  over_waves(const double depth)
  {
    Scene scene            = short_scene("waves of " + std::to_string(1e6 * depth) + " um");
    scene.rolling_distance = 70e-3;
    IrregularityData &wave = scene.irregularities[0];
    wave.kind              = IrregularKind::corrugation;
    wave.place             = 22e-3;
    wave.wavelength        = 40e-3;
    wave.length            = 80e-3;
    wave.depth             = depth;
    BOOST_TEST(run(scene, false) == 0, scene.title + ": the run ends");
    return {read_summary("short/summary.json"), read_history("short/history.h5")};
  }

  /// Small waves: twice the depth, twice the change of the force against waves of next to no depth.
  BOOST_FIXTURE_TEST_CASE(test_linear, test::Parallel)
  {
    const Result     still = over_waves(0.01e-6), one = over_waves(5e-6), two = over_waves(10e-6);
    double           of_one = 0, of_two = 0;
    constexpr double length = 70e-3; // steps differ in length, with what the waves do to the cells
    constexpr int    places = 700;
    for (int k = 1; k <= places; ++k)
      {
        const double at = length * k / places, force = still.force_at(at);
        of_one += std::pow(one.force_at(at) - force, 2);
        of_two += std::pow(two.force_at(at) - force, 2);
      }
    BOOST_TEST(std::sqrt(of_one / places) > 500,
               "waves of 5 um are felt: " + std::to_string(std::sqrt(of_one / places)) + " N");
    BOOST_TEST(
      near(std::sqrt(of_two / of_one), 2, 0.04, "change of force by waves of 10 um over that by 5 um"));
  }

  /// The history shows what the wheel rolled over.
  BOOST_FIXTURE_TEST_CASE(test_history, test::Parallel)
  {
    const Result run = over_hollow(40e-6, Body::rail, CarriedBy::offset);
    BOOST_TEST(
      near(run.column("rail_irregularity").back(), 0, 1e-12, "behind the hollow the rail is smooth [m]"));
    double deepest = 0;
    for (const double h : run.column("rail_irregularity"))
      deepest = std::min(deepest, h);
    BOOST_TEST(near(1e6 * deepest, -40, 0.1, "the history shows its depth [um]"));
  }
} // namespace
