#pragma once

#include <wheelrail/output/figure_table.h>
#include <wheelrail/receptance/spectra.h>
#include <wheelrail/receptance/track_waves.h>

#include <complex>
#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Receptance, its phase, mobility and accelerance over frequency [Hz], where the body is struck, across
  /// it, and farther along by some 0.6 m, with the decay rate along the track where there are faces for it.
  /// `of_face`: receptances [m/N] of each face at all frequencies; `distance`: of the first face and those
  /// from the third on, from the blow [m].
  FigureTable
  make_response_table(const std::vector<double>                            &frequency,
                      const std::vector<std::vector<std::complex<double>>> &of_face,
                      const std::vector<double>                            &distance);

  /// The same by the waves of the section, at frequencies of the blow: some 120 of them, even steps of their
  /// logarithm.
  FigureTable
  make_waves_table(const TrackWaves &waves, const Receptances &blow, const std::vector<double> &distance);

  /// Frequency, mobility and loss factor of each resonance.
  FigureTable
  make_resonance_table(const std::vector<Resonance> &peaks);

  /// Another result, a file of this command or of others by the names of its columns
  /// (read_receptance_file()), as our tables have it. Prints what was noticed in it.
  std::string
  beside_text(const std::string &path, std::ostream &out);
} // namespace wheelrail
