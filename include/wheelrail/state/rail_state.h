#pragma once

#include <wheelrail/sampling/run_parts.h>
#include <wheelrail/state/checkpoint.h>

#include <string>

namespace wheelrail
{
  /// Writes what a run leaves, in bodies without loads on the mesh of a discretization, as rail.h5 into its
  /// folder, with all `parameters` in force. Collective; throws RunError on all ranks.
  void
  save_rail(const RunParts &run, const std::string &parameters);

  /// Reads the rail that Run/Rail of the scene names. `parameters` are the entries now in force. Throws
  /// InputError when no run has left a rail there, or one of another steel. To be called on all ranks.
  Checkpoint
  read_rail(const Scene &scene, const std::string &parameters, MPI_Comm communicator);

  /// Lays that rail into a model that make_model() has just built: dents, residual stresses and history, and,
  /// with a moving window, the cells that it needs beside those of the start, where the model's
  /// discretization then is. The wheel is new, or that of the earlier run turned back to its start (Run/Next
  /// wheel); plastic work counts from here on. Throws InputError when the rail, or the same wheel, has
  /// another mesh. Collective.
  void
  lay_rail(const Scene &scene, const Checkpoint &rail, Model &model, MPI_Comm communicator);
} // namespace wheelrail
