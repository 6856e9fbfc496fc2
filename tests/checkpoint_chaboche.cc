// label: long
// A rail of cyclic hardening that is stopped while it yields and goes on: the same bits, history of back
// stresses and energies included.

#include <wheelrail/output/summary.h>

#include "parallel.h"
#include "read_output.h"
#include "small_scene.h"
#include "stopped_runs.h"

#include <filesystem>
#include <string>

using namespace wheelrail;
using namespace test;
namespace fs = std::filesystem;

namespace
{
  Scene
  scene(const std::string &name, const ElementForm form)
  {
    Scene scene                = small_scene(4e-3);
    scene.title                = "stopped while it yields";
    scene.element              = form;
    scene.ticks                = 3;
    scene.volume_fields        = false;
    scene.checkpoint_interval  = 1e4;
    MaterialData &rail         = scene.rail_material;
    rail.law                   = SteelLaw::chaboche;
    rail.yield_stress          = 300e6;
    rail.cyclic.isotropic      = 100e6;
    rail.cyclic.isotropic_rate = 50;
    rail.cyclic.moduli         = {40e9, 10e9, 2e9};
    rail.cyclic.rates          = {500, 100, 0};
    rail.cyclic.recovery       = 0.3;
    scene.folder               = "checkpoint_chaboche_" + name;
    return scene;
  }

  void
  stopped(const ElementForm form, const std::string &name)
  {
    const Scene base = scene(name, form), one_go = scene(name + "_one_go", form);
    BOOST_TEST(run(base, false, 20) == 3, "interrupted soon after the static start, " + name);
    fs::remove_all(one_go.folder);
    fs::copy(base.folder, one_go.folder);
    BOOST_TEST(run(one_go, true) == 0, "gone on to the end in one go, " + name);
    BOOST_TEST((run(base, true, 150) == 3 && run(base, true, 290) == 3), "interrupted twice, " + name);
    BOOST_TEST(run(base, true) == 0, "gone on to the end, " + name);

    const History a = read_history(one_go.folder + "/history.h5"),
                  b = read_history(base.folder + "/history.h5");
    BOOST_TEST((a.columns[0].size() > 50 && a.columns == b.columns), "the same history, " + name);
    for (std::size_t c = 0; c < a.names.size(); ++c)
      if (a.names[c] == "plastic_work" || a.names[c] == "hardening_energy")
        BOOST_TEST((a.columns[c].back() > a.columns[c][a.columns[c].size() / 3] && a.columns[c].back() > 0),
                   a.names[c] + " grows while it rolls, " + name);
    const Summary s = read_summary(one_go.folder + "/summary.json"),
                  t = read_summary(base.folder + "/summary.json");
    for (const char *key : {"max_pressure_Pa", "max_plastic_strain", "plastic_work_rail_J"})
      BOOST_TEST((get_figure(s, key) == get_figure(t, key)), "the same " + std::string(key) + ", " + name);
    // like static starts, two unloadings in one process agree within their tolerance only
    BOOST_TEST(near(
      s.max_residual_von_mises / t.max_residual_von_mises, 1, 1e-6, "the same residual stress, " + name));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(checkpoint_chaboche, test::Parallel)
{
  stopped(ElementForm::reduced, "reduced");
  stopped(ElementForm::full, "full");
}
