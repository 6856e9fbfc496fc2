#pragma once

#include <wheelrail/receptance/spectra.h>
#include <wheelrail/receptance/track_waves.h>

#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// A resonance that record and rail are too short for: its motion dies more slowly.
  struct CutPeak
  {
    double frequency = 0; ///< [Hz]
    double mobility =
      0;                ///< that the waves of an endless track have there, their largest within 3 % [m/(N s)]
    double decibel = 0; ///< by which the peak is lower [dB]
  };

  /// The narrow peak (loss factor below 0.1) that is cut most, if it is by more than 1 dB.
  std::optional<CutPeak>
  most_cut(const std::vector<Resonance> &peaks, const TrackWaves &waves, double fading);

  /// The note on it, after a record of `duration` [s] on a rail of `length` [m].
  std::string
  cut_note(const CutPeak &peak, double duration, double length);
} // namespace wheelrail
