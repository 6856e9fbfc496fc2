#pragma once

#include <string>

namespace wheelrail
{
  /// What a run writes, as in subsection Output.
  struct OutputSettings
  {
    std::string  folder              = "output/scene";
    unsigned int ticks               = 20; ///< evenly spaced outputs of patch and surface fields over the run
    bool         volume_fields       = true; ///< VTU of the whole mesh at start and end
    double       checkpoint_interval = 0;    ///< between two saved states [s], 0: see SavedStates
  };
} // namespace wheelrail
