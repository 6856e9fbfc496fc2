#include <wheelrail/run/moving_mesh.h>

namespace wheelrail
{
  namespace
  {
    void
    change_mesh(RunState &run)
    {
      run.rolling.change_mesh([&]() { prepare_mesh(run.model, run.communicator); }, run.axle.contact_along());
    }
  } // namespace


  bool
  follow_wheel(RunState &run)
  {
    const Model           &model    = run.model;
    const RunningSurfaces &surfaces = model.contact->surfaces();
    if (!model.discretization->plan().moving ||
        !move_window(run.scene,
                     run.model,
                     {run.axle.contact_along(), run.axle.contact_on_wheel(surfaces.rolling_radius)},
                     run.communicator))
      return false;
    change_mesh(run);
    return true;
  }


  void
  lengthen_path(RunState &run)
  {
    if (run.model.discretization->plan().moving && lengthen_path(run.model, run.scene.path()))
      change_mesh(run);
  }
} // namespace wheelrail
