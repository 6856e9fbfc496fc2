#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/geometry/irregular_lobes.h>
#include <wheelrail/geometry/roughness.h>

#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <utility>

// Heights from levels of one-third-octave bands (EN 15610; doc/manual/irregularities.md): lines of a spectrum
// k/length with equal shares of a band's mean square and random phases; periodic over `length`, faded at its
// ends.

namespace wheelrail
{
  namespace
  {
    constexpr double octave_part = 10;   // bands for each factor of ten
    constexpr double reference   = 1e-6; // of levels [m]

    /// Number of the band that a wavelength lies in, 10 lg(wavelength/1 m) rounded.
    int
    band_number(const double wavelength)
    {
      return static_cast<int>(std::lround(octave_part * std::log10(wavelength)));
    }

    double
    middle_of(const int band)
    {
      return std::pow(10., band / octave_part);
    }

    /// Mean square of the heights of each band [m2].
    std::map<int, double>
    powers(const std::vector<RoughnessBand> &bands)
    {
      constexpr double      nominal = 0.1; // parts of a band: 12.5 mm in place of 12.59 mm and the like
      std::map<int, double> power;
      for (const RoughnessBand &band : bands)
        {
          const int n = band_number(band.wavelength);
          if (std::abs(octave_part * std::log10(band.wavelength) - n) > nominal)
            throw InputError(in_mm(band.wavelength) +
                             " is the middle of no one-third-octave band; the nearest is " +
                             in_mm(std::round(1e5 * middle_of(n)) / 1e5));
          // level L = 10 lg(mean square/(1 um)^2): mean square = r0^2 10^(L/10) of one-third-octave bands (EN
          // 15610)
          if (!power.insert({n, reference * reference * std::pow(10., band.level / 10)}).second)
            throw InputError("the band of " + in_mm(band.wavelength) + " is given twice");
        }
      if (power.empty())
        throw InputError("no band");
      return power;
    }

    /// Amplitudes of the lines k/length, k = 0, 1, ... [m].
    std::vector<double>
    amplitudes(const std::map<int, double> &power, const double length)
    {
      // lines of the spectrum k/length up to the lower edge of the shortest band
      const double        shortest = middle_of(power.begin()->first) * std::pow(10., -0.5 / octave_part);
      std::vector<double> amplitude(static_cast<std::size_t>(length / shortest) + 2, 0.);
      std::map<int, std::vector<std::size_t>> lines;
      for (std::size_t k = 1; k < amplitude.size(); ++k)
        if (const int n = band_number(length / double(k)); power.count(n) > 0)
          lines[n].push_back(k);
      for (const auto &[n, mean_square] : power)
        {
          if (lines[n].empty())
            throw InputError(
              "the band of " + in_mm(std::round(1e5 * middle_of(n)) / 1e5) +
              " has no line of the spectrum, since these lie 1/length apart: take a Length of " +
              in_mm(std::ceil(1e3 * 5 * middle_of(n)) / 1e3) + " or leave the band out");
          for (const std::size_t k : lines[n])
            // a cosine of amplitude A has the mean square A^2/2; all lines of a band get the same share
            amplitude[k] = std::sqrt(2 * mean_square / double(lines[n].size()));
        }
      return amplitude;
    }

    /// Heights at 16 or more even places for each of the shortest waves over one length [m].
    std::vector<double>
    heights(const std::vector<double> &amplitude, const unsigned int seed)
    {
      std::size_t n = 1;
      while (n < 16 * amplitude.size())
        n *= 2;
      std::mt19937_64     random(seed);
      std::vector<double> values(n, 0.); // real part of line k at k, imaginary part at n - k
      for (std::size_t k = 1; k < amplitude.size(); ++k)
        {
          // the library's distributions differ from system to system
          // random phases, even in [0, 2 pi): sum over k of A_k cos(2 pi k u/length + phase)
          const double phase = 2 * M_PI * double(random() >> 11) * std::pow(2., -53);
          values[k]          = 0.5 * amplitude[k] * std::cos(phase);
          values[n - k]      = 0.5 * amplitude[k] * std::sin(phase);
        }
      gsl_fft_halfcomplex_radix2_backward(values.data(), 1, n);
      return values;
    }

    /// The periodic spline through heights over `length`; at() takes a place from the begin on.
    class PeriodicHeights
    {
    public:
      PeriodicHeights(std::vector<double> values, const double length)
        : length_(length)
      {
        std::vector<double> places(values.size() + 1);
        for (std::size_t k = 0; k < places.size(); ++k)
          places[k] = length * double(k) / double(values.size());
        values.push_back(values.front());
        spline_ = {gsl_spline_alloc(gsl_interp_cspline_periodic, values.size()), gsl_spline_free};
        gsl_spline_init(spline_.get(), places.data(), values.data(), values.size());
      }

      /// Height and slope.
      std::pair<double, double>
      at(const double u) const
      {
        const double within = std::clamp(u - length_ * std::floor(u / length_), 0., length_);
        return {gsl_spline_eval(spline_.get(), within, nullptr),
                gsl_spline_eval_deriv(spline_.get(), within, nullptr)};
      }

    private:
      double                      length_;
      std::shared_ptr<gsl_spline> spline_;
    };
  } // namespace


  Irregularity
  roughness(const IrregularSize &size, const std::vector<RoughnessBand> &bands, const unsigned int seed)
  {
    const std::map<int, double> power = powers(bands);
    const PeriodicHeights       waves(heights(amplitudes(power, size.length), seed), size.length);
    const double                fade = std::min(0.5 * middle_of(power.rbegin()->first), 0.25 * size.length);
    IrregularSize               unit = size;
    unit.depth                       = -1; // heights count upwards
    Irregularity shape               = product(
      unit,
      size.place - 0.5 * size.length - fade,
      size.place + 0.5 * size.length + fade,
      [waves, fade, half = 0.5 * size.length](const double u) {
        const auto [height, slope] = waves.at(u + half);
        const Lobe faded           = lobe(std::max(0., std::abs(u) - half), 2 * fade);
        return Lobe{height * faded.value, slope * faded.value + height * (u < 0 ? -1 : 1) * faded.slope};
      },
      across_plateau(size));
    shape.shortest = middle_of(power.begin()->first);
    return shape;
  }
} // namespace wheelrail
