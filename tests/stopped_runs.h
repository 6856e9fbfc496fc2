#pragma once

// Runs that are stopped after a number of steps and go on, for the tests of saved states.

#include <wheelrail/input/listing.h>
#include <wheelrail/run/run_scene.h>

#include <mpi.h>

namespace test
{
  /// Begins the run of a scene anew, or goes on with it; stops after `stop_after_steps` when that is not
  /// zero. Returns the exit code once rank 0 has written. Collective; throws what run_scene() throws.
  inline int
  run(const wheelrail::Scene &scene, const bool resume, const unsigned long stop_after_steps = 0)
  {
    wheelrail::RunOptions options;
    options.overwrite        = !resume;
    options.resume           = resume;
    options.stop_after_steps = stop_after_steps;
    options.prm_text         = "# a test\n";
    options.parameters_text  = wheelrail::print_parameters(scene);
    const int code           = wheelrail::run_scene(scene, wheelrail::make_geometry(scene), options);
    MPI_Barrier(MPI_COMM_WORLD);
    return code;
  }
} // namespace test
