// What is expected of a scene before it is computed: patch and number of cells, against figures that
// were computed.

#include "check.h"

#include <wheelrail/input/parameters.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/model.h>

#include <deal.II/base/mpi.h>

using namespace wheelrail;
using test::check;
using test::check_near;

namespace
{
  ExpectedPatch
  patch_of(const Scene &scene)
  {
    return expected_patch(scene,
                          find_contact(rail_profile(scene.rail_profile),
                                       wheel_profile(scene.wheel_profile),
                                       scene.track,
                                       scene.lateral_shift,
                                       scene.roll));
  }

  void
  test_patch()
  {
    // CONTACT (revision 2707) for this pair: 20.3 mm x 12.8 mm
    const ExpectedPatch patch = patch_of(Scene());
    check_near(patch.width, 20.3e-3, 2e-3, "width of the patch at shift 0 [m]");
    check_near(patch.length, 12.8e-3, 2e-3, "length of the patch at shift 0 [m]");

    // Hertz (1882): the approach goes with the load to the power 2/3, with E to -2/3
    Scene heavy       = Scene();
    heavy.sprung_mass = 8 * (heavy.sprung_mass + heavy.axle_mass + 320) - heavy.axle_mass - 320;
    check_near(
      patch_of(heavy).approach / patch.approach, 4, 1e-9, "eight times the load, four times the approach");
    Scene soft = Scene();
    soft.rail_material.youngs_modulus /= 8;
    soft.wheel_material.youngs_modulus /= 8;
    check_near(patch_of(soft).approach / patch.approach, 4, 1e-9, "an eighth of the stiffness, the same");
  }

  void
  test_elements()
  {
    for (const char *cell : {"4 mm", "2 mm"})
      {
        const Scene scene = scene_from_text("",
                                            "none",
                                            {std::string("Mesh/Solution cell size = ") + cell,
                                             "Mesh/Fine margin = 4 mm",
                                             "Run/Rolling distance = 30 mm",
                                             "Output/Ticks = 5",
                                             "Track/Rail length = 600 mm"});
        const Model model = make_model(scene, MPI_COMM_SELF);
        check_near(expected_elements(scene, patch_of(scene)) / double(model.solid.quality.elements),
                   1,
                   0.35,
                   std::string("expected over actual number of cells, ") + cell);
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_patch();
  test_elements();
  return test::report();
}
