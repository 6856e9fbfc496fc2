#include <wheelrail/run/moving_mesh.h>

namespace wheelrail
{
  namespace
  {
    void
    change_mesh(RunState &run, void (*remake)(Model &, MPI_Comm))
    {
      run.rolling.change_mesh([&]() { remake(run.model, run.communicator); }, run.axle.contact_along());
    }
  } // namespace


  void
  use_window(RunState &run)
  {
    if (!run.model.swept)
      return;
    run.model.forest.reset();
    change_mesh(run, prepare_window);
  }


  bool
  follow_wheel(RunState &run)
  {
    const Model           &model    = run.model;
    const RunningSurfaces &surfaces = model.contact->surfaces();
    if (!model.swept ||
        !move_window(run.scene,
                     run.model,
                     {run.axle.contact_along(), run.axle.contact_on_wheel(surfaces.rolling_radius)},
                     run.communicator))
      return false;
    change_mesh(run, prepare_window);
    return true;
  }


  void
  lengthen_way(RunState &run)
  {
    if (run.model.swept && lengthen_path(run.model, run.scene.path()))
      change_mesh(run, prepare_window);
  }


  void
  use_forest(RunState &run)
  {
    if (run.model.swept)
      change_mesh(run, prepare_window_forest);
  }
} // namespace wheelrail
