#include <wheelrail/base/log.h>
#include <wheelrail/output/root.h>
#include <wheelrail/run/run_output.h>
#include <wheelrail/sampling/slices.h>

#include <cstdio>

namespace wheelrail
{
  RunOutput::RunOutput(const RunParts &parts, const bool resume, const unsigned int ticks)
    : parts_(parts)
  {
    on_root(parts_.communicator, [&]() {
      const std::string &folder = parts_.scene.folder;
      patch_file_               = std::make_unique<TickFile>(folder + "/patch.h5", resume, ticks);
      slice_file_               = std::make_unique<TickFile>(folder + "/slices.h5", resume, ticks);
      surface_series_           = std::make_unique<PvdSeries>(folder + "/surface.pvd");
      window_series_            = std::make_unique<PvdSeries>(folder + "/window.pvd");
      volume_series_            = std::make_unique<PvdSeries>(folder + "/volume.pvd");
      for (const auto &series : {surface_series_.get(), window_series_.get()})
        if (resume)
          series->load(ticks);
      if (resume)
        volume_series_->load(1); // the start; the end is written anew
    });
  }


  void
  RunOutput::tick(const unsigned int tick)
  {
    const double time = parts_.rolling.time(), travelled = parts_.axle.travelled();
    const auto   slices = make_slices(parts_.model, travelled, parts_.communicator);
    on_root(parts_.communicator, [&]() {
      append_patch(*patch_file_, patch_fields(*parts_.model.contact, parts_.model.axle, time, travelled));
      append_slices(*slice_file_, time, travelled, slices);
      write_history(parts_.recorder.state().history, parts_.scene.folder + "/history.h5");
      write_history(parts_.recorder.state().patches, parts_.scene.folder + "/patch_history.h5");
    });
    write_series("surface", Selection::surface, tick, surface_series_.get());
    write_series("window", Selection::window, tick, window_series_.get());
  }


  void
  RunOutput::volume(const std::string &name)
  {
    write_vtu(field_mesh(parts_.model.solid,
                         parts_.axle,
                         *parts_.model.contact,
                         Selection::all,
                         unloaded_distance(parts_.model),
                         parts_.communicator),
              parts_.scene.folder,
              name,
              parts_.communicator);
    on_root(parts_.communicator, [&]() { volume_series_->add(parts_.rolling.time(), name + ".vtu"); });
  }


  void
  RunOutput::write_series(const char        *kind,
                          const Selection    selection,
                          const unsigned int tick,
                          PvdSeries         *series)
  {
    char name[64];
    std::snprintf(name, sizeof name, "%s_%04u", kind, tick);
    write_vtu(field_mesh(parts_.model.solid,
                         parts_.axle,
                         *parts_.model.contact,
                         selection,
                         unloaded_distance(parts_.model),
                         parts_.communicator),
              parts_.scene.folder,
              name,
              parts_.communicator);
    on_root(parts_.communicator, [&]() { series->add(parts_.rolling.time(), std::string(name) + ".vtu"); });
  }
} // namespace wheelrail
