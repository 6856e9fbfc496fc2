#include <wheelrail/base/format_text.h>
#include <wheelrail/receptance/spectra.h>

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelrail
{
  namespace
  {
    using Complex = std::complex<double>;

    /// Real data to their spectrum, again and again.
    class Transform
    {
    public:
      explicit Transform(const int length)
        : real_(length)
        , spectrum_(length / 2 + 1)
        , plan_(fftw_plan_dft_r2c_1d(length,
                                     real_.data(),
                                     reinterpret_cast<fftw_complex *>(spectrum_.data()),
                                     FFTW_ESTIMATE))
      {
      }
      ~Transform()
      {
        fftw_destroy_plan(plan_);
      }
      Transform(const Transform &) = delete;

      /// Of values times exp(-fading t); zeros behind them. What is faded also goes to zero smoothly, over
      /// the last fifth: a step at the end would be in all frequencies.
      const std::vector<Complex> &
      operator()(const std::vector<double> &values, const double fading, const double step)
      {
        std::fill(real_.begin(), real_.end(), 0.);
        const std::size_t size = std::min(values.size(), real_.size()), last = size / 5;
        for (std::size_t n = 0; n < size; ++n)
          real_[n] = values[n] * std::exp(-fading * n * step);
        for (std::size_t n = 0; n < last && fading > 0; ++n)
          real_[size - 1 - n] *= 0.5 - 0.5 * std::cos(M_PI * n / last);
        fftw_execute(plan_);
        return spectrum_;
      }

    private:
      std::vector<double>  real_;
      std::vector<Complex> spectrum_;
      fftw_plan            plan_;
    };

    double
    largest(const std::vector<double> &values, const std::size_t from)
    {
      double most = 0;
      for (std::size_t n = from; n < values.size(); ++n)
        most = std::max(most, std::abs(values[n]));
      return most;
    }
  } // namespace


  Receptances
  receptances(const BlowRecord &record, const double resolution, const double lowest, const double highest)
  {
    constexpr double enough = 0.01;
    Receptances      all;
    const auto      &first    = record.moved.front();
    const double     most     = largest(first, 0);
    const double     duration = record.step * first.size();
    all.left                  = most > 0 ? largest(first, first.size() - first.size() / 10) / most : 0;
    if (all.left > enough)
      all.fading = std::log(all.left / enough) / (0.95 * duration);
    const int    length = static_cast<int>(std::lround(1 / (resolution * record.step)));
    Transform    transform(std::max<int>(length, first.size()));
    const double exact = 1 / (std::max<int>(length, first.size()) * record.step); // step of the lines [Hz]
    const auto   from  = static_cast<std::size_t>(std::max(1., std::ceil(lowest / exact)));
    const auto   to    = static_cast<std::size_t>(std::floor(highest / exact));
    const auto   force = transform(record.force, all.fading, record.step);
    for (std::size_t line = from; line <= to; ++line)
      all.frequency.push_back(line * exact);
    for (const auto &moved : record.moved)
      {
        const auto &spectrum = transform(moved, all.fading, record.step);
        auto       &of_face  = all.of_face.emplace_back();
        for (std::size_t line = from; line <= to; ++line)
          of_face.push_back(spectrum[line] / force[line]);
      }
    return all;
  }


  std::vector<Resonance>
  resonances(const std::vector<double> &frequency, const std::vector<double> &mobility)
  {
    const double           stands_out = std::pow(10., 1. / 20), half = std::sqrt(0.5);
    std::vector<Resonance> found;
    const std::size_t      n = mobility.size();
    for (std::size_t p = 1; p + 1 < n; ++p)
      {
        if (!(mobility[p] > mobility[p - 1] && mobility[p] >= mobility[p + 1]))
          continue;
        // lows on both sides, before anything higher
        double lows[2] = {mobility[p], mobility[p]};
        for (std::size_t k = p; k-- > 0 && mobility[k] <= mobility[p];)
          lows[0] = std::min(lows[0], mobility[k]);
        for (std::size_t k = p + 1; k < n && mobility[k] <= mobility[p]; ++k)
          lows[1] = std::min(lows[1], mobility[k]);
        if (mobility[p] < stands_out * std::max(lows[0], lows[1]))
          continue;
        Resonance peak{frequency[p], mobility[p], std::numeric_limits<double>::quiet_NaN()};
        if (std::max(lows[0], lows[1]) < half * mobility[p])
          {
            const auto crossing = [&](std::size_t k, const int step) {
              while (mobility[k + step] > half * mobility[p])
                k += step;
              const double part = (mobility[k] - half * mobility[p]) / (mobility[k] - mobility[k + step]);
              return frequency[k] + part * (frequency[k + step] - frequency[k]);
            };
            peak.loss = (crossing(p, 1) - crossing(p, -1)) / frequency[p];
          }
        found.push_back(peak);
      }
    return found;
  }


  double
  decay_rate(const std::vector<double> &distance, const std::vector<double> &amplitude)
  {
    double sum = 0;
    for (std::size_t n = 0; n < distance.size(); ++n)
      {
        const double from = n == 0 ? distance[0] : 0.5 * (distance[n - 1] + distance[n]);
        const double to   = n + 1 == distance.size() ? distance[n] : 0.5 * (distance[n] + distance[n + 1]);
        sum += std::pow(amplitude[n] / amplitude[0], 2) * (to - from);
      }
    return 10 * std::log10(std::exp(1.)) / sum;
  }


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
