#include <wheelrail/base/left_out.h>
#include <wheelrail/model/scene_parts.h>
#include <wheelrail/receptance/receptance_command.h>
#include <wheelrail/run/run_resonances.h>

namespace wheelrail
{
  void
  add_track(const Scene &, double, MPI_Comm, SceneParts &)
  {
  }


  void
  add_resonances(const Scene &, const SceneGeometry &, const Model &, Summary &)
  {
  }


  int
  act_receptance(const po::variables_map &, const RunFunction &, std::ostream &)
  {
    refuse_left_out("receptance", Subject::track);
  }
} // namespace wheelrail
