#pragma once

#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/vtu.h>
#include <wheelrail/sampling/fields.h>
#include <wheelrail/sampling/residual.h>
#include <wheelrail/sampling/run_parts.h>
#include <wheelrail/sampling/stress_below.h>

#include <memory>
#include <string>

namespace wheelrail
{
  /// The files that a run writes tick by tick into its folder: patch.h5, slices.h5, history.h5 and the
  /// series of VTU files.
  class RunOutput
  {
  public:
    /// With `resume` the first `ticks` ticks that the files hold are kept, and the first `volumes` files of
    /// the whole mesh. Throws RunError on all ranks when they cannot be read. Collective.
    RunOutput(const RunParts &parts, bool resume, unsigned int ticks, unsigned int volumes);

    /// Writes the state of the moment as tick number `tick`. Collective; throws RunError on all ranks.
    void
    tick(unsigned int tick);

    /// Writes the whole mesh into `name`.vtu and adds it to volume.pvd, with the stresses of the moment, and
    /// residual ones where they are given. Collective; throws RunError on all ranks.
    void
    volume(const std::string &name, const NodalStress *residual = nullptr);

    /// Writes what a passage has left: slices into residual.h5, the running surfaces into
    /// residual_surface.vtu. Collective; throws RunError on all ranks.
    void
    residual(const Residual &residual);

    /// Stresses of the moment, see nodal_stress(); recovered once however often they are asked for.
    /// Collective.
    const NodalStress &
    stress();

    /// Largest stresses of the cuts at the moment, below the depth of one cell: those of the tick where one
    /// was written now. Collective.
    StressBelow
    stress_below();

  private:
    /// Writes a part of the mesh into `name`.vtu and adds it to a series, if there is one.
    void
    write_mesh(const std::string &name,
               Selection          selection,
               const NodalStress &stress,
               PvdSeries         *series,
               const NodalStress *residual = nullptr);

    RunParts                   parts_;
    NodalStress                stress_;                  ///< of the last time that they were asked for
    double                     stress_at_ = -1;          ///< the time then [s]; none: -1
    StressBelow                stress_below_;            ///< of the last tick
    double                     stress_below_at_ = -1;    ///< the time then [s]; none: -1
    std::unique_ptr<TickFile>  patch_file_, slice_file_; ///< on rank 0 only, as the series
    std::unique_ptr<PvdSeries> surface_series_, window_series_, volume_series_; ///< for ParaView
  };
} // namespace wheelrail
