// label: long
// The tread of a loaded, turning wheel is stretched along the track more than the head of the rail: by the
// true bodies and by the static start of a run.

#include <wheelrail/bodies/body_contact.h>

#include "messages.h"
#include "parallel.h"
#include "silent_start.h"

#include <iostream>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  double
  of_start(const std::vector<std::string> &sets)
  {
    const Scene scene = scene_from_text("", "x.prm", sets).scene;
    Model       model = make_model(scene, make_geometry(scene), MPI_COMM_SELF);
    return silent_start(scene, model).tread_stretch;
  }

  /// Pressure stretches both surfaces by 3e-3, and the difference of both is some 0.8e-4, so that a mesh
  /// which is off by 0.1 % in the first is off by 4 % in the second. Blocks of 16 mm have too little of it,
  /// those of 8 mm too much, on fine cells of any size.
  void
  stretched(const std::string &what, std::vector<std::string> sets)
  {
    const Scene         scene    = scene_from_text("", "x.prm", sets).scene;
    const SceneGeometry geometry = make_geometry(scene);
    const BodyTables    tables   = make_body_tables(scene, geometry, "tables");
    const double        bodies =
      BodyContact(scene, geometry, tables).stretch_under_pressure(scene_load(scene, geometry));
    const double coarse = of_start(sets);
    sets.push_back("Mesh/Coarse cell size = 8 mm");
    const double fine = of_start(sets);
    std::cout << "        " << what << ": " << 1e4 * bodies << "e-4 by true bodies, " << 1e4 * coarse
              << " and " << 1e4 * fine << "e-4 by static starts on blocks of 16 and 8 mm" << std::endl;
    BOOST_TEST((coarse < bodies && bodies < fine), what + ": the stretch of true bodies lies between");
    BOOST_TEST(near_relative(0.5 * (coarse + fine), bodies, 0.03, what + ": in the middle"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(bodies_stretch, test::Parallel)
{
  const std::string element = "Half-space/Element size = 0.5 mm", free = "Wheelset/Traction coefficient = 0";
  stretched("free rolling at 140 km/h, 1 mm cells", {element, free});
  stretched("at 5 km/h, without growth", {element, free, "Wheelset/Velocity = 5 km/h"});
  stretched("S1002 on 60E1, driving", {element, "Profiles/Rail = 60E1"});
}
