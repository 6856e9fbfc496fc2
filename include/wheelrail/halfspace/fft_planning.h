#pragma once

#include <mutex>

namespace wheelrail
{
  /// FFTW makes and destroys plans on one thread at a time; executing them is free. To be held by all that
  /// does so where several rows are solved at once.
  inline std::mutex &
  fft_planning()
  {
    static std::mutex planning;
    return planning;
  }
} // namespace wheelrail
