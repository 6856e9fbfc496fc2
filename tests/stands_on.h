#pragma once

#include <wheelrail/model/model.h>
#include <wheelrail/track/track_support.h>

#include <memory>

namespace test
{
  /// The rail of a model stands on this in place of the clamped foot.
  inline wheelrail::TrackSupport &
  put_on(wheelrail::Model &model, const wheelrail::TrackData &data)
  {
    model.parts[0] = std::make_unique<wheelrail::TrackSupport>(data, MPI_COMM_WORLD);
    return dynamic_cast<wheelrail::TrackSupport &>(*model.parts[0]);
  }
} // namespace test
