#pragma once

#include <wheelrail/sampling/recorder.h>
#include <wheelrail/solid/histories.h>

#include <mpi.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Format of saved states: counts up whenever a field is added or changes its meaning. No other is read.
  constexpr int checkpoint_format = 11;

  /// What a run needs to go on after a step, beyond the model, which the scene gives anew. Either the part
  /// of one rank, or the whole of all ranks, of which rank 0 alone may have the rows of nodes and cells.
  /// These go by their keys, see LocalMesh.
  struct Checkpoint
  {
    std::string  parameters;            ///< all entries in force, see print_parameters()
    double       wall_time         = 0; ///< of the run so far [s]
    unsigned int ticks             = 0; ///< number of ticks written so far
    double       time_step         = 0; ///< [s]
    double       prepared_distance = 0; ///< for which the mesh was made [m]
    double       longest_distance  = 0; ///< to which the run may be gone on with [m]
    double       fine_margin       = 0; ///< with which the mesh was made [m]

    FineWindow window;          ///< where the fine cells lie, when they move
    int        start_block = 0; ///< see SweepPlan

    std::vector<std::uint64_t>            node, cell; ///< keys of those that follow, of a whole one ascending
    std::map<std::string, NumberedValues> node_values; ///< position, displacement [m], velocity [m/s]
    std::map<std::string, NumberedValues> cell_values; ///< see visit_histories()
    std::map<std::string, std::vector<double>> works;  ///< energy terms that are sums: one part a rank [J]
    int                                        ranks = 1;

    Contact::State  contact;
    TimeLoop::State rolling; ///< with what the parts keep, of the whole that of the nodes of all ranks
    Recorder::State recorder;

    /// How far the wheel has rolled [m].
    double
    travelled() const
    {
      return rolling.parts.at("axle").numbers.at("travelled");
    }
  };

  /// Copies the rank's part of the state after a step. `parameters`, `wall_time` and `ticks` are left to the
  /// caller. Nothing is sent.
  Checkpoint
  take_checkpoint(const Model &model, const Rolling &rolling, const Recorder &recorder);

  /// Whether all numbers of nodes, elements, contact and parts are finite on all ranks. Collective.
  bool
  is_finite(const Checkpoint &part, MPI_Comm communicator);

  /// The parts of all ranks together, on rank 0; an empty one on the others. Collective.
  Checkpoint
  gather_checkpoint(Checkpoint part, MPI_Comm communicator);

  /// A whole checkpoint that rank 0 has, on all ranks but for the rows of nodes and cells, which rank 0 keeps
  /// for restore_bodies(). Collective.
  Checkpoint
  share_checkpoint(Checkpoint whole, MPI_Comm communicator);

  /// Puts a whole checkpoint into a model built from the same scene, on any number of ranks; the next step
  /// then gives what it would have given in the first run: on as many ranks bit for bit, otherwise up to
  /// round-off. `rolling` must have been made with the time step of the checkpoint. Collective; throws
  /// InputError on all ranks when the mesh is another one.
  void
  restore_checkpoint(const Checkpoint &whole,
                     Model            &model,
                     Rolling          &rolling,
                     Recorder         &recorder,
                     MPI_Comm          communicator);

  /// Puts displacements, velocities and histories of a whole checkpoint into both bodies, or into the one
  /// that is asked for, such as the rail: the wheel may then have any mesh. Whether their mesh is that of the
  /// checkpoint, else nothing is changed. The rail may lie `farther` along the track [m] than it did. A rank
  /// fetches the rows of its own nodes and cells alone. Collective.
  bool
  restore_bodies(const Checkpoint   &saved,
                 Solid              &solid,
                 double              farther,
                 MPI_Comm            communicator,
                 std::optional<Body> body = {});

  /// A whole checkpoint as the bytes of an HDF5 file.
  std::vector<char>
  checkpoint_bytes(const Checkpoint &whole);

  /// Throws RunError when the bytes are no such file, or one of another format.
  Checkpoint
  checkpoint_from_bytes(const std::string &bytes);
} // namespace wheelrail
