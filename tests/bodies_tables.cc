// label: long
// Coarse tables of the true bodies against fine ones, and against elements of half the size.

#include "near.h"

#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/input/parameters.h>

#include <string>

using namespace wheelrail;
using test::near_relative;


BOOST_AUTO_TEST_CASE(bodies_tables)
{
  for (const std::string shift : {"0 mm", "-5.5 mm"})
    {
      const Scene scene = scene_from_text("",
                                          "x.prm",
                                          {"Wheelset/Lateral shift = " + shift,
                                           "Wheelset/Traction coefficient = 0.25",
                                           "Half-space/Element size = 0.5 mm"})
                            .scene;
      const SceneGeometry geometry = make_geometry(scene);
      const WheelRailLoad load     = scene_load(scene, geometry);
      BodyTableSizes      fine;
      fine.levels = 4;
      fine.cells  = 2;
      const WheelRailSolution coarse =
                                solve_bodies(scene, geometry, load, make_body_tables(scene, geometry, "")),
                              exact = solve_bodies(
                                scene, geometry, load, make_body_tables(scene, geometry, "", fine));
      BOOST_TEST(near_relative(coarse.measures.peak_pressure_fitted,
                               exact.measures.peak_pressure_fitted,
                               2e-3,
                               "peak pressure, rows of one cell of 2 mm over two of 1 mm, shift " + shift));
      BOOST_TEST(near_relative(coarse.solution.xi, exact.solution.xi, 1e-2, "creepage, shift " + shift));
      BOOST_TEST(near_relative(coarse.measures.area, exact.measures.area, 1e-2, "area, shift " + shift));
    }
}
