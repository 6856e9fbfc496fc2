#pragma once

#include <wheelrail/application/recorder.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// What one rank needs to go on with a run after a step, beyond the model, which the scene gives anew.
  struct Checkpoint
  {
    std::string  parameters;    ///< all entries in force, see print_parameters()
    double       wall_time = 0; ///< of the run so far [s]
    unsigned int ticks     = 0; ///< number of ticks written so far

    std::vector<double> global_node;            ///< n_nodes: the nodes of the rank
    std::vector<double> displacement, velocity; ///< 4 x n_nodes [m], [m/s], as in Solid
    std::vector<double> dilatation[2];          ///< of the packed elements of rail and wheel
    std::vector<double> plastic[2];             ///< their plastic_state(), empty in elastic bodies

    Contact::State  contact;
    Axle::State     axle;
    Rolling::State  rolling;
    Recorder::State recorder;
  };

  /// Copies the state after a step. `parameters`, `wall_time` and `ticks` are left to the caller.
  Checkpoint
  take_checkpoint(const Model &model, const Axle &axle, const Rolling &rolling, const Recorder &recorder);

  /// Puts the state of a checkpoint into a model built from the same scene on as many ranks; the next
  /// step then gives what it would have given in the first run, bit for bit. Collective; throws InputError on
  /// all ranks when the nodes are not those of the checkpoint.
  void
  restore_checkpoint(const Checkpoint &checkpoint,
                     Model            &model,
                     Axle             &axle,
                     Rolling          &rolling,
                     Recorder         &recorder,
                     MPI_Comm          communicator);

  /// A checkpoint as the bytes of an HDF5 file.
  std::vector<char>
  checkpoint_bytes(const Checkpoint &checkpoint);

  /// Throws RunError when the bytes are no such file.
  Checkpoint
  checkpoint_from_bytes(const std::string &bytes);
} // namespace wheelrail
