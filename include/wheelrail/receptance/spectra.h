#pragma once

#include <wheelrail/receptance/blow.h>
#include <wheelrail/receptance/track_waves.h>

#include <complex>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Displacements over the force that makes them, time factor exp(i w t).
  struct Receptances
  {
    std::vector<double> frequency; ///< ascending, equal steps [Hz]
    /// Of each face, at each frequency [m/N].
    std::vector<std::vector<std::complex<double>>> of_face;
    /// Rate f of the factor exp(-f t) that the displacements were given, since they had not died at the end
    /// of the record [1/s]: the receptance is that at the angular frequency w - i f, as if of a body that
    /// loses energy faster; peaks are broader by f/pi [Hz]. 0: none.
    double fading = 0;
    double left   = 0; ///< largest displacement in the last tenth of the record over the largest of all [1]
  };

  /// By Fourier transforms (FFTW) of a record filled up with zeros. Frequencies are multiples of `resolution`
  /// [Hz], from `lowest` to `highest`. What has not died to 1 % in the last tenth of the record is faded to
  /// it.
  Receptances
  receptances(const BlowRecord &record, double resolution, double lowest, double highest);

  /// A peak of a mobility.
  struct Resonance
  {
    double frequency = 0; ///< [Hz]
    double mobility  = 0; ///< [m/(N s)]
    double loss =
      0; ///< width at 3 dB below over the frequency; NaN where the peak is not as high on both sides
  };

  /// The peaks that stand out by 1 dB at least from the lows on both sides, ascending.
  std::vector<Resonance>
  resonances(const std::vector<double> &frequency, const std::vector<double> &mobility);

  /// How fast waves die along the track, of amplitudes at distances from the hammer, the first of which is 0
  /// [dB/m]: 4.343 over the sum of squares of the amplitudes over that of the first, times the stretch that
  /// each represents (EN 15461). Rails that end before the waves have died show too much: 4.343 over the
  /// largest distance is the least.
  double
  decay_rate(const std::vector<double> &distance, const std::vector<double> &amplitude);

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
