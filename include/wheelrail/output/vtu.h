#pragma once

#include <wheelrail/output/fields.h>

#include <mpi.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// Writes the parts of all ranks into the one file `folder`/`name`.vtu (VTK XML,
  /// zlib at its fastest level). Hexahedra when `points_per_cell` is 8, quadrilaterals
  /// in space when it is 4. Fields with one component become scalars, with three vectors, with six symmetric
  /// tensors; their unit is written as the attribute `units` of the data array. Cells of a rank share their
  /// points; where ranks meet, points are there twice.
  ///
  /// Collective over `comm`; all ranks must pass the same fields in the same order, also a rank
  /// without cells. Throws RunError on every rank when the arrays of any rank do not fit together
  /// or the file cannot be written.
  void
  write_vtu(const FieldMesh &mesh, const std::string &folder, const std::string &name, MPI_Comm comm);

  /// A time series for ParaView: the list of the files of a .pvd file and their times [s].
  /// To be used on one rank.
  class PvdSeries
  {
  public:
    /// `path` is the .pvd file; nothing is written before the first add().
    explicit PvdSeries(std::string path);

    /// Appends `file` (a name relative to the folder of the .pvd file) at `time` [s] and rewrites
    /// the .pvd file whole. Entries at or after `time` are dropped first, so that a resumed run
    /// does not list a stretch twice. Throws RunError when it cannot be written.
    void
    add(double time, const std::string &file);

    /// Takes over the first `keep` entries of the .pvd file that is already there (a resumed run);
    /// without the file the series stays empty.
    void
    load(std::size_t keep = std::numeric_limits<std::size_t>::max());

    const std::vector<std::pair<double, std::string>> &
    entries() const
    {
      return entries_;
    }

  private:
    std::string                                 path_;
    std::vector<std::pair<double, std::string>> entries_;
  };
} // namespace wheelrail
