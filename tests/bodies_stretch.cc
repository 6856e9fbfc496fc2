// label: long
// The tread of a loaded, turning wheel is stretched along the track more than the head of the rail: by the
// true bodies and by the static start of a run.

#include <wheelrail/reference/body_contact.h>

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
  /// `limit`: of the difference, relative.
  void
  stretched(const std::string &what, const std::vector<std::string> &sets, const double limit)
  {
    const Scene         scene    = scene_from_text("", "x.prm", sets).scene;
    const SceneGeometry geometry = make_geometry(scene);
    const BodyTables    tables   = make_body_tables(scene, geometry, "tables");
    const double bodies = solve_bodies(scene, geometry, scene_load(scene, geometry), tables).tread_stretch;
    Model        model  = make_model(scene, geometry, MPI_COMM_SELF);
    const StaticResult start = silent_start(scene, model);
    std::cout << "        " << what << ": " << 1e4 * bodies << "e-4 by true bodies, "
              << 1e4 * start.tread_stretch << "e-4 by the static start" << std::endl;
    check_relative(start.tread_stretch, bodies, limit, what + ": stretch of the tread beyond the head");
  }
} // namespace

int
main(int argc, char **argv)
{
  Parallel          parallel(argc, argv);
  const std::string element = "Half-space/Element size = 0.5 mm", free = "Wheelset/Traction coefficient = 0";
  stretched("free rolling at 140 km/h, 1 mm cells", {element, free}, 0.03);
  stretched("at 5 km/h, without growth", {element, free, "Wheelset/Velocity = 5 km/h"}, 0.03);
  stretched("S1002 on 60E1, driving", {element, "Profiles/Rail = 60E1"}, 0.03);
  return parallel.report();
}
