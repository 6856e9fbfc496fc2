#include <wheelrail/run/run_start.h>
#include <wheelrail/run/run_state.h>
#include <wheelrail/sampling/fields.h>

#include <utility>

namespace wheelrail
{
  RunState::RunState(const Scene &scene_of_run,
                     Model      &&built,
                     const double hub_displacement,
                     const double rate,
                     MPI_Comm     of_all)
    : scene(scene_of_run)
    , model(std::move(built))
    , communicator(of_all)
    , axle(model.axle, hub_displacement, rate, communicator)
    , rolling(model.solid, *model.contact, model.parts, axle, time_scheme(scene, model), communicator)
    , recorder(model)
  {
  }


  void
  RunState::record()
  {
    recorder.add(rolling, axle, communicator);
    model.contact->gather_nodes();
    const PatchFields patch = patch_fields(*model.contact, axle, rolling.time());
    recorder.add_patch(patch, wear_profile(patch, axle.velocity(), scene.wear, true));
  }


  std::unique_ptr<RunState>
  start_run(Scene                            scene,
            const SceneGeometry             &geometry,
            Model                            model,
            const std::optional<Checkpoint> &rail,
            Log                             &log,
            MPI_Comm                         communicator)
  {
    const RunStart start =
      start_on_wide_mesh(scene, geometry, model, rail ? &*rail : nullptr, log, communicator);
    return std::make_unique<RunState>(
      scene, std::move(model), start.hub_displacement, start.rate, communicator);
  }


  std::unique_ptr<RunState>
  resume_run(const Scene &scene, Model model, const Checkpoint &saved, MPI_Comm communicator)
  {
    model.time_step = saved.time_step; // another Run/Rolling distance would round it otherwise
    if (model.discretization->plan().moving)
      {
        model.window = saved.window;
        prepare_mesh(model, communicator);
      }
    auto run = std::make_unique<RunState>(scene, std::move(model), 0, 0, communicator);
    restore_checkpoint(saved, run->model, run->rolling, run->recorder, communicator);
    if (const History &rows = run->recorder.state().history; !rows.columns.empty())
      run->axle.set_start_torque(column(rows, "drive_torque").front()); // of the first step
    lengthen_path(*run);
    run->ticks          = saved.ticks;
    run->first_step     = run->rolling.steps();
    run->first_distance = run->axle.travelled();
    run->wall_before    = saved.wall_time;
    return run;
  }


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
