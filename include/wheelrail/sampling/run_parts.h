#pragma once

#include <wheelrail/sampling/recorder.h>

namespace wheelrail
{
  /// The parts of a running computation.
  struct RunParts
  {
    const Scene    &scene;
    const Model    &model;
    const Axle     &axle;
    const Rolling  &rolling;
    const Recorder &recorder;
    MPI_Comm        communicator;
  };
} // namespace wheelrail
