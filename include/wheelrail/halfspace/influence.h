#pragma once

#include <wheelrail/halfspace/problem.h>

#include <boost/align/aligned_allocator.hpp>

#include <array>
#include <complex>
#include <memory>
#include <mutex>
#include <vector>

namespace wheelrail
{
  /// The constants of the displacement difference of two half-spaces, all over pi:
  /// normal = (1 - nu) / G, poisson = nu / G, coupling = K / G with 1 / G = (1 / G1 + 1 / G2) / 2,
  /// nu / G = (nu1 / G1 + nu2 / G2) / 2, K / G = ((1 - 2 nu1) / G1 - (1 - 2 nu2) / G2) / 4 (Kalker 1990).
  struct HalfspaceConstants
  {
    double normal = 0, poisson = 0, coupling = 0; ///< [1/Pa]
    double layer = 0; ///< shear compliance of an interface layer between the bodies [m/Pa]
  };
  HalfspaceConstants
  halfspace_constants(const HalfspaceBody &body1, const HalfspaceBody &body2);

  /// Displacement difference at (x, y) under unit traction in direction b on the element dx x dy around the
  /// origin: coefficient[a][b] [m/Pa], directions 0, 1, 2 = x, y, n (Boussinesq 1885, Cerruti 1882,
  /// integrated over the rectangle in closed form); a layer adds its compliance to the shear displacements in
  /// the element itself.
  using InfluenceCoefficients = std::array<std::array<double, 3>, 3>;
  InfluenceCoefficients
  influence_coefficients(const HalfspaceConstants &constants, double dx, double dy, double x, double y);

  /// The coefficient of displacement a under traction b: which of InfluenceCoefficients.
  struct InfluencePair
  {
    int a = 0, b = 0;
  };

  /// a b, without the care for infinities that std::complex takes in each product.
  inline std::complex<double>
  times(const std::complex<double> &a, const std::complex<double> &b)
  {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
  }

  inline std::complex<double>
  times(const double a, const std::complex<double> &b)
  {
    return {a * b.real(), a * b.imag()};
  }

  /// Products of influence matrices with fields on one grid, by FFT on the doubled grid: n log n per product.
  class InfluenceProducts
  {
  public:
    using Complex = std::complex<double>;
    /// Aligned as FFTW's own memory, so that transforms run in place.
    using Spectrum = std::vector<Complex, boost::alignment::aligned_allocator<Complex, 64>>;

    explicit InfluenceProducts(const HalfspaceGrid &grid);
    ~InfluenceProducts();
    InfluenceProducts(const InfluenceProducts &) = delete;
    InfluenceProducts &
    operator=(const InfluenceProducts &) = delete;

    /// The spectrum of a kernel given by the distance in elements, from -columns() / 2 to columns() / 2 - 1
    /// along x, fastest, and so along y over the rows.
    Spectrum
    kernel(const std::vector<double> &by_distance);

    /// Sizes of the doubled grid, even.
    int
    columns() const
    {
      return nx_;
    }
    int
    rows() const
    {
      return ny_;
    }

    /// Spectrum of a field, zero outside the grid.
    void
    forward(const std::vector<double> &field, Spectrum &spectrum);

    /// The field of a spectrum, cut to the grid. The spectrum is used up.
    void
    backward(Spectrum &spectrum, std::vector<double> &field);

    std::size_t
    spectrum_size() const;

    /// Number of values of the doubled grid.
    std::size_t
    padded_size() const
    {
      return std::size_t(nx_) * ny_;
    }

  private:
    struct Plans;
    HalfspaceGrid          grid_;
    int                    nx_, ny_; ///< sizes of the doubled grid
    std::unique_ptr<Plans> plans_;
  };

  /// The coefficients of some pairs by the distance from loaded to observed element, as
  /// InfluenceProducts::kernel() takes them, each [m/Pa]; the observed one lies `ahead` further along x [m].
  /// Neighbours share their corners: what belongs to one is computed once.
  std::vector<std::vector<double>>
  influence_by_distance(const HalfspaceConstants         &constants,
                        const HalfspaceGrid              &grid,
                        const InfluenceProducts          &products,
                        double                            ahead,
                        const std::vector<InfluencePair> &pairs);

  /// FFTW makes and destroys plans on one thread at a time; executing them is free. To be held by all that
  /// does so where several rows are solved at once.
  inline std::mutex &
  fft_planning()
  {
    static std::mutex planning;
    return planning;
  }
} // namespace wheelrail
