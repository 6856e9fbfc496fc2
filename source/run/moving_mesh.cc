#include <wheelrail/base/errors.h>
#include <wheelrail/run/moving_mesh.h>
#include <wheelrail/run/run_texts.h>

#include <chrono>

namespace wheelrail
{
  namespace
  {
    void
    change_mesh(const MovingParts &run, void (*remake)(Model &, MPI_Comm))
    {
      run.rolling.change_mesh([&]() { remake(run.model, run.communicator); }, run.axle.contact_along());
    }
  } // namespace


  void
  use_window(const MovingParts &run)
  {
    if (!run.model.swept)
      return;
    run.model.forest.reset();
    change_mesh(run, prepare_window);
  }


  bool
  follow_wheel(const MovingParts &run)
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
  lengthen_way(const MovingParts &run)
  {
    if (run.model.swept && lengthen_path(run.model, run.scene.rolling_distance))
      change_mesh(run, prepare_window);
  }


  std::optional<Residual>
  take_loads_off(const MovingParts &run, Log &log, const std::function<void()> &meanwhile)
  {
    Model &model = run.model;
    if (!model.solid.blocks.rail.plastic() && !model.solid.blocks.wheel.plastic())
      return {};
    const auto begin = std::chrono::steady_clock::now();
    try
      {
        if (model.swept)
          change_mesh(run, prepare_window_forest);
        Residual residual = find_residual(model, run.axle, meanwhile, run.communicator);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        log.value("unloading",
                  text("%u Newton steps, %u CG steps, %s",
                       residual.way.steps,
                       residual.way.cg_steps,
                       format_duration(taken.count()).c_str()));
        return residual;
      }
    catch (const RunError &error)
      {
        log.warning(error.what());
        return {};
      }
  }
} // namespace wheelrail
