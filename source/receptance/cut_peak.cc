#include <wheelrail/base/format_text.h>
#include <wheelrail/receptance/cut_peak.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  std::optional<CutPeak>
  most_cut(const std::vector<Resonance> &peaks, const TrackWaves &waves, const double fading)
  {
    constexpr double       narrow = 0.1, beside = 0.03, least = 1;
    constexpr int          steps = 12;
    std::optional<CutPeak> most;
    for (const Resonance &peak : peaks)
      {
        if (!(peak.loss < narrow))
          continue;
        CutPeak one{peak.frequency, 0, 0};
        for (int k = -steps; k <= steps; ++k)
          {
            const double f = peak.frequency * (1 + beside * k / steps);
            one.mobility   = std::max(one.mobility, 2 * M_PI * f * std::abs(waves.receptances(f, fading)[0]));
          }
        one.decibel = 20 * std::log10(one.mobility / peak.mobility);
        if (one.decibel > (most ? most->decibel : least))
          most = one;
      }
    return most;
  }


  std::string
  cut_note(const CutPeak &peak, const double duration, const double length)
  {
    return text(
             "note: the peak at %.0f Hz is cut by %.1f dB: its motion dies more slowly than %.0f ms on %g m "
             "let "
             "it; ",
             peak.frequency,
             peak.decibel,
             1e3 * duration,
             length) +
           text("by waves it has %.3e m/(N s); take a longer --duration and Track/Rail length",
                peak.mobility);
  }
} // namespace wheelrail
