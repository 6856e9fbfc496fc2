#include <wheelrail/base/format_text.h>
#include <wheelrail/base/log.h>
#include <wheelrail/output/root.h>
#include <wheelrail/run/run_output.h>
#include <wheelrail/sampling/slices.h>
#include <wheelrail/sampling/slip_edge.h>

#include <cstdio>

namespace wheelrail
{
  RunOutput::RunOutput(const RunParts    &parts,
                       const bool         resume,
                       const unsigned int ticks,
                       const unsigned int volumes)
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
        volume_series_->load(volumes);
    });
  }


  void
  RunOutput::tick(const unsigned int tick)
  {
    const double time = parts_.rolling.time(), travelled = parts_.axle.travelled();
    parts_.model.contact->gather_nodes();
    const auto slices = make_slices(parts_.model, stress(), travelled, parts_.communicator);
    stress_below_     = largest_stress_below(slices, parts_.scene.cell_size);
    stress_below_at_  = time;
    on_root(parts_.communicator, [&]() {
      const PatchFields patch = patch_fields(*parts_.model.contact, parts_.axle, time);
      append_patch(*patch_file_, patch, slip_edge(patch));
      append_slices(*slice_file_, time, travelled, slices);
      write_history(parts_.recorder.state().history, parts_.scene.folder + "/history.h5");
      write_history(parts_.recorder.state().patches, parts_.scene.folder + "/patch_history.h5");
    });
    const std::string number = text("_%04u", tick);
    write_mesh("surface" + number, Selection::surface, stress(), surface_series_.get());
    write_mesh("window" + number, Selection::window, stress(), window_series_.get());
  }


  const NodalStress &
  RunOutput::stress()
  {
    if (const double time = parts_.rolling.time(); time != stress_at_)
      {
        stress_    = nodal_stress(parts_.model.solid);
        stress_at_ = time;
      }
    return stress_;
  }


  StressBelow
  RunOutput::stress_below()
  {
    if (parts_.rolling.time() == stress_below_at_)
      return stress_below_;
    parts_.model.contact->gather_nodes();
    return largest_stress_below(
      make_slices(parts_.model, stress(), parts_.axle.travelled(), parts_.communicator),
      parts_.scene.cell_size);
  }


  void
  RunOutput::volume(const std::string &name, const NodalStress *residual)
  {
    write_mesh(name, Selection::all, stress(), volume_series_.get(), residual);
  }


  void
  RunOutput::residual(const Residual &residual)
  {
    on_root(parts_.communicator, [&]() {
      TickFile file(parts_.scene.folder + "/residual.h5", false, 0);
      append_slices(file, parts_.rolling.time(), parts_.axle.travelled(), residual.slices);
    });
    write_mesh("residual_surface", Selection::surface, residual.stress, nullptr, &residual.stress);
  }


  void
  RunOutput::write_mesh(const std::string &name,
                        const Selection    selection,
                        const NodalStress &stress,
                        PvdSeries         *series,
                        const NodalStress *residual)
  {
    parts_.model.contact->gather_nodes();
    const auto mesh = field_mesh(parts_.model.solid,
                                 parts_.axle,
                                 *parts_.model.contact,
                                 selection,
                                 stress,
                                 unloaded_distance(parts_.model),
                                 residual);
    write_vtu(mesh, parts_.scene.folder, name, parts_.communicator);
    on_root(parts_.communicator, [&]() {
      if (series)
        series->add(parts_.rolling.time(), name + ".vtu");
    });
  }
} // namespace wheelrail
