#include <wheelrail/output/root.h>
#include <wheelrail/state/checkpoint_files.h>
#include <wheelrail/state/saved_states.h>

#include <algorithm>
#include <chrono>

namespace wheelrail
{
  namespace
  {
    double
    seconds()
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    }
  } // namespace


  SavedStates::SavedStates(const Scene &scene,
                           std::string  parameters,
                           const double interval,
                           MPI_Comm     communicator)
    : folder_(scene.folder)
    , parameters_(std::move(parameters))
    , interval_(interval)
    , communicator_(communicator)
    , last_end_(seconds())
  {
  }


  void
  SavedStates::keep(const RunParts &run, const unsigned int ticks, const double wall_time)
  {
    const SweepPlan &plan = run.model.discretization->plan();
    Checkpoint       part = take_checkpoint(run.model, run.rolling, run.recorder);
    if (!is_finite(part, communicator_))
      return;
    kept_                   = std::move(part);
    kept_.parameters        = parameters_;
    kept_.prepared_distance = run.scene.mesh_distance();
    kept_.longest_distance =
      plan.moving && !run.scene.rail_by_slices() ? plan.longest_path : kept_.prepared_distance;
    kept_.fine_margin = run.scene.fine_margin;
    kept_.ticks       = ticks;
    kept_.wall_time   = wall_time;
    any_              = true;
    on_disk_          = false;
  }


  bool
  SavedStates::due() const
  {
    // the clocks of the ranks differ: that of rank 0 counts
    const double interval = interval_ > 0 ? interval_ : std::max(60., 100 * last_seconds_);
    int          is_due   = seconds() - last_end_ >= interval ? 1 : 0;
    MPI_Bcast(&is_due, 1, MPI_INT, 0, communicator_);
    return is_due == 1;
  }


  double
  SavedStates::save()
  {
    if (!any_ || on_disk_)
      return bytes_;
    const double begin = seconds();
    bytes_             = write_checkpoint(kept_, folder_, communicator_);
    on_disk_           = true;
    last_end_          = seconds();
    last_seconds_      = last_end_ - begin;
    saving_ += last_seconds_;
    return bytes_;
  }


  double
  SavedStates::save(const Stop &stop)
  {
    save();
    if (any_)
      on_root(communicator_, [&]() { write_stop(stop, folder_); });
    return bytes_;
  }
} // namespace wheelrail
