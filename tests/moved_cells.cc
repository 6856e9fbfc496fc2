// ranks: 1 2
// The step that cells allow on a path over a dip, found by columns, against a mesh with finest cells all
// along it; and with mass scaling.
#include "messages.h"
#include "parallel.h"

#include <wheelrail/model/coarser_cells.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/run/run_texts.h>

#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  /// Cells of 4 mm over a dip of 5 mm in 48 mm, which stands its nodes nearer together.
  Scene
  dip()
  {
    Scene scene;
    scene.cell_size        = 4e-3;
    scene.fine_margin      = 4e-3;
    scene.fine_depth       = 8e-3;
    scene.rail_length      = 0.6;
    scene.rolling_distance = 0.12;
    scene.window           = MeshWindow::fixed;
    IrregularityData &one  = scene.irregularities[0];
    one.kind               = IrregularKind::dent;
    one.place              = 60e-3;
    one.length             = 48e-3;
    one.depth              = 5e-3;
    return scene;
  }

  Solid
  whole_mesh(const Scene &scene, const SceneGeometry &geometry)
  {
    Discretization discretization(MPI_COMM_WORLD, sweep_plan(scene, geometry));
    discretization.lay({{discretization.plan().fine}, {discretization.plan().fine}});
    Solid solid;
    solid.choice = {{material_law(scene.rail_material), material_law(scene.wheel_material)},
                    {scene.element, scene.element},
                    scene.bulk_viscosity,
                    highest_frequency(scene)};
    prepare(solid, discretization.local_mesh(), MPI_COMM_WORLD);
    return solid;
  }

  double
  mass(const Solid &solid, const Body body)
  {
    return mass_properties(solid, body, {}, MPI_COMM_WORLD).mass;
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(moved_cells, test::Parallel)
{
  Scene               scene    = dip();
  const SceneGeometry geometry = make_geometry(scene);
  Scene               smooth   = scene;
  smooth.irregularities[0]     = {};
  const Solid      plain       = whole_mesh(scene, geometry);
  const StableStep step = limit_of_step(scene, geometry), even = limit_of_step(smooth, make_geometry(smooth));
  // hanging vertices lie on their surface there, here in the middle of their parents
  BOOST_TEST(near_relative(step.step, plain.stable.step, 0.02, "step over the dip"));
  BOOST_TEST((step.body == plain.stable.body), "the body of the stiffest cell");
  BOOST_TEST(near(1e3 * norm(step.place - plain.stable.place), 0, 0.2, "its place [mm]"));
  BOOST_TEST(step.step < 0.95 * even.step, "the dip shortens the step");

  scene.mass_scaling      = true;
  const Solid      scaled = whole_mesh(scene, geometry);
  const StableStep cube   = limit_of_step(scene, geometry);
  BOOST_TEST(near_relative(cube.step,
                           stable_step(highest_frequency(scene), scene.bulk_viscosity),
                           1e-12,
                           "step of a cube by mass scaling"));
  BOOST_TEST(near_relative(scaled.stable.step, cube.step, 1e-12, "step of the whole mesh with it"));
  BOOST_TEST((cube.step > plain.stable.step && cube.scaled && !step.scaled), "it is longer, and told");
  const std::string told =
    ", raised to that of a cube by mass scaling; what that adds to the bodies is checked "
    "when a run starts";
  BOOST_TEST((time_step_text(1e-3, cube.step, cube).find(told) != std::string::npos), told);
  for (const Body body : both_bodies)
    BOOST_TEST(near(1e6 * (mass(scaled, body) / mass(plain, body) - 1),
                    1e6 * scaled.quality.scaled_share[body],
                    1e-3,
                    std::string("mass added to the ") + body_name(body) + ", told [1e-6]"));
  BOOST_TEST(scaled.quality.scaled_share.rail > 0, "the rail becomes heavier");
  BOOST_TEST(same_text(
    message_of([&]() { make_model(scene, geometry, MPI_COMM_WORLD); }),
    "Mesh/Mass scaling = true: it would add 0.78 % to the mass of the rail, and 0.1 % is accepted; leave it "
    "out, or take a smaller Mesh/Solution cell size",
    "mass scaling of large cells"));
  BOOST_TEST(!scene_on_coarser_cells(scene).mass_scaling, "a second run on larger cells has none");
}
