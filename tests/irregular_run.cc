// ranks: 1
// label: long
// Runs over irregular surfaces: the same hollow as an offset of the contact and in the mesh, on rail and
// wheel; energy, and what the history shows.
#include "parallel.h"
#include "stopped_runs.h"

#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/summary.h>

#include <algorithm>
#include <cmath>
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

  /// A free wheel at 30 m/s over a hollow 30 mm long, on cells of 2 mm.
  Result
  over_hollow(const double depth, const IrregularBody body)
  {
    Scene scene;
    scene.title = (body == IrregularBody::rail ? "rail " : "wheel ") + std::to_string(1e6 * depth) + " um";
    scene.cell_size           = 2e-3;
    scene.fine_depth          = 6e-3;
    scene.rail_length         = 0.5;
    scene.velocity            = 30;
    scene.rolling_distance    = 60e-3;
    scene.averaging_distance  = 5e-3;
    scene.ticks               = 1;
    scene.volume_fields       = false;
    scene.checkpoint_interval = 1e4;
    scene.folder              = "hollow";
    IrregularityData &hollow  = scene.irregularities[0];
    hollow.kind               = IrregularKind::dent;
    hollow.body               = body;
    hollow.place              = 30e-3;
    hollow.length             = 30e-3;
    hollow.depth              = depth;
    check(run(scene, false) == 0, scene.title + ": the run ends");
    Result result{read_summary("hollow/summary.json"), read_history("hollow/history.h5")};
    check(result.summary.energy_error < 0.01,
          scene.title + ": energy error below 1 %: " + std::to_string(100 * result.summary.energy_error));
    return result;
  }

  void
  test_both_ways(const IrregularBody body)
  {
    const std::string name    = body == IrregularBody::rail ? "rail: " : "wheel: ";
    const Result      shallow = over_hollow(49e-6, body), deep = over_hollow(51e-6, body);
    const double      load = get_figure(shallow.summary, "wheel_load_N");
    // as large as they are deep
    const double ratio = 51. / 49;
    for (const char *force : {"vertical_force", "longitudinal_force"})
      check_near(deep.swing(force) / (ratio * shallow.swing(force)),
                 1,
                 0.02,
                 name + force + " in the mesh over that of offsets");
    check(shallow.swing("vertical_force") > 0.05 * load, name + "the hollow is felt");
    check_near(get_figure(deep.summary, "least_vertical_force_at_m"),
               get_figure(shallow.summary, "least_vertical_force_at_m"),
               1.5e-3,
               name + "at the same place [m]");
  }

  /// The history shows what the wheel rolled over.
  void
  test_history()
  {
    const Result run = over_hollow(40e-6, IrregularBody::rail);
    check_near(run.column("rail_irregularity").back(), 0, 1e-12, "behind the hollow the rail is smooth [m]");
    double deepest = 0;
    for (const double h : run.column("rail_irregularity"))
      deepest = std::min(deepest, h);
    check_near(1e6 * deepest, -40, 0.1, "the history shows its depth [um]");
  }
} // namespace

int
main(int argc, char **argv)
{
  Parallel parallel(argc, argv);
  test_both_ways(IrregularBody::rail);
  test_both_ways(IrregularBody::wheel);
  test_history();
  return parallel.report();
}
