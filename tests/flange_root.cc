// label: long
// The contact in the root of the flange: under load a second patch opens beside the one that the profiles let
// expect, beyond the fine cells of the default margin.

#include <wheelrail/input/parameters.h>
#include <wheelrail/run/run_start.h>

#include "parallel.h"

using namespace wheelrail;
using namespace test;


BOOST_FIXTURE_TEST_CASE(flange_root, test::Parallel)
{
  Scene scene = read_scene(WHEELRAIL_SOURCE_DIR "/prm/quickstart.prm",
                           {"Wheelset/Lateral shift = -5.5 mm", "Mesh/Fine margin = 3 mm"})
                  .scene;
  const Scene         given    = scene;
  const SceneGeometry geometry = make_geometry(scene);
  Model               model    = make_model(scene, geometry, MPI_COMM_WORLD);
  const auto          narrow   = model.contact->lattice();
  Log                 log;
  const auto          start = start_on_wide_mesh(scene, geometry, model, nullptr, log, MPI_COMM_WORLD);
  BOOST_TEST(!start.at_border, "the patch keeps off the edge of the fine cells");
  BOOST_TEST(near(scene.fine_margin / given.fine_margin, 2, 1e-12, "the fine margin is doubled"));
  BOOST_TEST(model.contact->lattice().n_lateral > narrow.n_lateral + 4, "the lattice is wider");
  const ContactSums sums = model.contact->evaluate(0);
  BOOST_TEST(near(sums.force[1] / model.wheel_load, 1, 1e-3, "the contact carries the wheel load"));
}
