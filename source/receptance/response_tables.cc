#include <wheelrail/base/interrupt.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/receptance/response_tables.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace wheelrail
{
  namespace
  {
    /// Receptance, its phase, mobility and accelerance over frequency, under names that begin alike.
    void
    add_response(FigureTable                             &table,
                 const std::string                       &before,
                 const std::vector<double>               &frequency,
                 const std::vector<std::complex<double>> &receptance)
    {
      std::vector<double> size, phase, mobility, accelerance;
      for (std::size_t k = 0; k < frequency.size(); ++k)
        {
          const double w = 2 * M_PI * frequency[k];
          size.push_back(std::abs(receptance[k]));
          phase.push_back(std::arg(receptance[k]));
          mobility.push_back(w * size.back());
          accelerance.push_back(w * mobility.back());
        }
      table.add(before + "receptance_m_per_N", "m/N", size);
      table.add(before + "phase_rad", "rad", phase);
      table.add(before + "mobility_m_per_Ns", "m/(N s)", mobility);
      table.add(before + "accelerance_per_kg", "1/kg", accelerance);
    }
  } // namespace


  FigureTable
  make_response_table(const std::vector<double>                            &frequency,
                      const std::vector<std::vector<std::complex<double>>> &of_face,
                      const std::vector<double>                            &distance)
  {
    FigureTable table;
    table.add("frequency_Hz", "Hz", frequency);
    add_response(table, "", frequency, of_face[0]);
    add_response(table, "cross_", frequency, of_face[1]);
    if (distance.size() < 2)
      return table;
    std::vector<double> decay;
    for (std::size_t k = 0; k < frequency.size(); ++k)
      {
        std::vector<double> amplitude = {std::abs(of_face[0][k])};
        for (std::size_t f = 2; f < of_face.size(); ++f)
          amplitude.push_back(std::abs(of_face[f][k]));
        decay.push_back(decay_rate(distance, amplitude));
      }
    table.add("decay_rate_dB_per_m", "dB/m", decay);
    // farther along by some 0.6 m
    const auto   at = std::min_element(distance.begin(), distance.end(), [](const double a, const double b) {
      return std::abs(a - 0.6) < std::abs(b - 0.6);
    });
    const double away = *at;
    if (away > 0)
      add_response(table,
                   "at_" + std::to_string(std::lround(1e3 * away)) + "mm_",
                   frequency,
                   of_face[at - distance.begin() + 1]);
    return table;
  }


  FigureTable
  make_waves_table(const TrackWaves &waves, const Receptances &blow, const std::vector<double> &distance)
  {
    constexpr double                               growth = 1.047;
    std::vector<double>                            frequency;
    std::vector<std::vector<std::complex<double>>> of_face(blow.of_face.size());
    double                                         next = 0;
    for (const double f : blow.frequency)
      if (f >= next)
        {
          leave_if_interrupted();
          frequency.push_back(f);
          const auto all = waves.receptances(f, blow.fading);
          for (std::size_t face = 0; face < all.size(); ++face)
            of_face[face].push_back(all[face]);
          next = growth * f;
        }
    return make_response_table(frequency, of_face, distance);
  }


  FigureTable
  make_resonance_table(const std::vector<Resonance> &peaks)
  {
    FigureTable         table;
    std::vector<double> f, m, l;
    for (const Resonance &peak : peaks)
      f.push_back(peak.frequency), m.push_back(peak.mobility), l.push_back(peak.loss);
    table.add("frequency_Hz", "Hz", f);
    table.add("mobility_m_per_Ns", "m/(N s)", m);
    table.add("loss_factor", "1", l);
    return table;
  }


  std::string
  beside_text(const std::string &path, std::ostream &out)
  {
    using Q               = MotionQuantity;
    const MotionFile rows = read_receptance_file(path);
    for (const std::string &note : rows.notes)
      out << "note: " << note << '\n';
    const auto                       &f     = *rows.find(Q::frequency);
    const auto                       *phase = rows.find(Q::phase);
    std::vector<std::complex<double>> values;
    for (std::size_t k = 0; k < f.size(); ++k)
      {
        const double w    = 2 * M_PI * f[k];
        double       size = 0, turn = 0; // of velocity and acceleration the phase is ahead
        if (const auto *const r = rows.find(Q::receptance))
          size = (*r)[k];
        else if (const auto *const m = rows.find(Q::mobility))
          size = (*m)[k] / w, turn = -0.5 * M_PI;
        else
          size = (*rows.find(Q::accelerance))[k] / (w * w), turn = -M_PI;
        values.push_back(std::polar(size, (phase ? (*phase)[k] : 0) + turn));
      }
    FigureTable table;
    table.add("frequency_Hz", "Hz", f);
    add_response(table, "", f, values);
    if (!phase)
      table.columns[2].assign(f.size(), std::nan(""));
    return table.as_csv();
  }
} // namespace wheelrail
