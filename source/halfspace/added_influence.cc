#include <wheelrail/halfspace/added_influence.h>
#include <wheelrail/halfspace/influence.h>

#include <fftw3.h>

#include <algorithm>
#include <cmath>

// u = (half-spaces + R) t, (4) of doc/theory/bodies.md: here R t. Forces of the elements are gathered on rows
// of 2 mm that run along x, F_r(x) = sum over j of weight_jr T_j t_j dx dy, T_j from (x, y, n) of the row of
// elements to fixed axes. Along x the influence of row r' on row r is a convolution over the lag, (3): a
// product for each mode of an FFT. Displacements go back by the same weights, so that R stays symmetric to
// round-off.

namespace wheelrail
{
  namespace
  {
    using Complex = std::complex<double>;

    /// The next length from n on that FFTW is fast at, even.
    int
    fast_length(int n)
    {
      // even, with factors 2, 3 and 5
      for (n += n % 2;; n += 2)
        {
          int rest = n;
          for (const int p : {2, 3, 5})
            while (rest % p == 0)
              rest /= p;
          if (rest == 1)
            return n;
        }
    }
  } // namespace


  struct RowsInfluence::Body
  {
    int rows  = 0;
    int modes = 0; ///< the first ones, behind which nothing is left
    // w_jr, row of elements j, row of the table r: u_j = sum over r of w_jr u_r
    std::vector<double>  weights;
    std::vector<Complex> here, slip; ///< spectra of the influences: mode, row, column
  };


  /// FFT of one row along x.
  struct RowsInfluence::Plans
  {
    explicit Plans(const int length)
      : real(length)
      , spectrum(length / 2 + 1)
    {
      const std::lock_guard<std::mutex> guard(fft_planning());
      auto *const                       modes = reinterpret_cast<fftw_complex *>(spectrum.data());
      // planned once for each length, by one thread at a time
      forward  = fftw_plan_dft_r2c_1d(length, real.data(), modes, FFTW_ESTIMATE);
      backward = fftw_plan_dft_c2r_1d(length, modes, real.data(), FFTW_ESTIMATE);
    }
    ~Plans()
    {
      const std::lock_guard<std::mutex> guard(fft_planning());
      fftw_destroy_plan(forward);
      fftw_destroy_plan(backward);
    }

    std::vector<double>  real;
    std::vector<Complex> spectrum;
    fftw_plan            forward = nullptr, backward = nullptr;
  };


  std::vector<double>
  RowsInfluence::lags(const HalfspaceGrid &grid, const double ahead)
  {
    std::vector<double> lags;
    for (int i = -grid.mx; i <= grid.mx; ++i)
      // place of the displacement less place of the force [m]; `ahead`: seen one step further along x
      lags.push_back(i * grid.dx + ahead);
    return lags;
  }


  RowsInfluence::RowsInfluence(const HalfspaceGrid &grid, std::vector<Basis> bases)
    : grid_(grid)
    , bases_(std::move(bases))
    // lags from -mx to mx, and at least mx free ones over which the influence is closed smoothly: cyclic
    // products on mx elements do not wrap
    , length_(fast_length(3 * grid.mx + 2))
    , modes_(length_ / 2 + 1)
    , plans_(std::make_unique<Plans>(length_))
  {
  }


  RowsInfluence::~RowsInfluence() = default;


  /// Lags that no two elements have are free: a cubic from one end of the others to the next, in value and
  /// slope, leaves a smooth influence no short modes.
  void
  RowsInfluence::close_gap()
  {
    std::vector<double> &f    = plans_->real;
    const int            last = grid_.mx, first = length_ - grid_.mx, gap = first - last;
    const double         from = f[last], to = f[first], slope_from = (f[last] - f[last - 1]) * gap,
                 slope_to = (f[first + 1] - f[first]) * gap;
    for (int i = last + 1; i < first; ++i)
      {
        // Hermite's cubic; slopes count per gap
        const double t = double(i - last) / gap, r = 1 - t;
        f[i] = r * r * ((1 + 2 * t) * from + t * slope_from) + t * t * ((1 + 2 * r) * to - r * slope_to);
      }
  }


  void
  RowsInfluence::set_bases(const std::vector<Basis> &bases)
  {
    // spectra of rows stay: they live in the fixed axes
    bases_ = bases;
  }


  void
  RowsInfluence::add_body(const RowInfluence &here, const RowInfluence &ahead, const double step)
  {
    constexpr double nothing = 1e-6; // of the largest mode of the displacements
    const int        n       = 3 * here.rows;
    // by entry: displacement along one axis of one row under a force along one axis of another, over all lags
    // [m/N]
    Body body{here.rows, modes_, here.weights, {}, {}};
    body.here.resize(std::size_t(modes_) * n * n);
    body.slip.resize(body.here.size());
    std::vector<double> largest(modes_, 0.);
    for (int entry = 0; entry < n * n; ++entry)
      for (const bool slip : {false, true})
        {
          for (int i = -grid_.mx; i <= grid_.mx; ++i)
            {
              const std::size_t at    = std::size_t(i + grid_.mx) * n * n + entry;
              const double      value = here.by_lag[at];
              // negative lags stand at the end of the cyclic row
              plans_->real[(i + length_) % length_] =
                // displacement u, or slip (u - u')/dq with u' one step ahead (doc/theory/halfspace.md, Frame
                // and signs); FFTW multiplies by the length there and back
                (slip ? (value - ahead.by_lag[at]) / step : value) / length_;
            }
          close_gap();
          fftw_execute(plans_->forward);
          for (int m = 0; m < modes_; ++m)
            {
              (slip ? body.slip : body.here)[std::size_t(m) * n * n + entry] = plans_->spectrum[m];
              if (!slip)
                largest[m] = std::max(largest[m], std::abs(plans_->spectrum[m]));
            }
        }
    // what the slips have beyond is the rounding of the influences over the step
    const double least = nothing * *std::max_element(largest.begin(), largest.end());
    // modes exp(2 pi i m x/length) that hold less than 1e-6 of the largest one are left out, some twenty stay
    // the influence less that of half-spaces has no short waves
    while (body.modes > 1 && largest[body.modes - 1] < least)
      --body.modes;
    for (std::vector<Complex> *kernel : {&body.here, &body.slip})
      {
        kernel->resize(std::size_t(body.modes) * n * n);
        kernel->shrink_to_fit();
      }
    bodies_.push_back(std::move(body));
  }


  std::vector<Complex>
  RowsInfluence::row_forces(const Body &body, const Given &traction) const
  {
    // tractions [Pa] on body 1 to forces on rows [N]; body 2 has the tractions -t, so that the difference of
    // displacements is (R_1 + R_2) t
    const int n = 3 * body.rows, mx = grid_.mx;
    // 1. and 2. gather, 3. transform
    std::vector<Complex> spectra(std::size_t(body.modes) * n);
    std::vector<double>  forces(std::size_t(n) * mx, 0.), fixed(3 * mx);
    for (int j = 0; j < grid_.my; ++j)
      {
        std::fill(fixed.begin(), fixed.end(), 0.);
        bool any = false;
        for (int c = 0; c < 3; ++c)
          if (traction[c])
            for (int i = 0; i < mx; ++i)
              if (const double t = (*traction[c])[i + mx * j]; t != 0)
                {
                  any = true;
                  for (int axis = 0; axis < 3; ++axis)
                    // 1. tractions (x, y, n) of a row of elements in the fixed axes
                    fixed[axis * mx + i] += bases_[j][3 * axis + c] * t;
                }
        if (!any)
          continue;
        for (int r = 0; r < body.rows; ++r)
          // 2. forces on the rows of the table, by the weights with which displacements are interpolated: so
          // the influence is symmetric (Maxwell and Betti)
          if (const double weight = body.weights[std::size_t(j) * body.rows + r] * grid_.element_area();
              weight != 0)
            for (int axis = 0; axis < 3; ++axis)
              for (int i = 0; i < mx; ++i)
                forces[std::size_t(3 * r + axis) * mx + i] += weight * fixed[axis * mx + i];
      }
    for (int row = 0; row < n; ++row)
      {
        // 3. along x to modes
        std::fill(plans_->real.begin(), plans_->real.end(), 0.);
        std::copy_n(forces.begin() + std::size_t(row) * mx, mx, plans_->real.begin());
        fftw_execute(plans_->forward);
        for (int m = 0; m < body.modes; ++m)
          spectra[std::size_t(m) * n + row] = plans_->spectrum[m];
      }
    return spectra;
  }


  std::vector<double>
  RowsInfluence::row_displacements(const Body                 &body,
                                   const std::vector<Complex> &kernel,
                                   const std::vector<Complex> &forces) const
  {
    const int n = 3 * body.rows;
    // kernel: `here` for displacements [m/N], `slip` for (u - u')/dq [1/N]
    std::vector<Complex> image(std::size_t(body.modes) * n);
    for (int m = 0; m < body.modes; ++m)
      {
        // 4. each mode: a matrix (3 rows)^2 times forces. A convolution over lags is a product of modes.
        const Complex *k = &kernel[std::size_t(m) * n * n], *f = &forces[std::size_t(m) * n];
        for (int i = 0; i < n; ++i, k += n)
          {
            double re = 0, im = 0;
            for (int j = 0; j < n; ++j)
              {
                // complex matrix times vector, (3 rows)^2 for each mode, without the care for infinities of
                // std::complex
                re += k[j].real() * f[j].real() - k[j].imag() * f[j].imag();
                im += k[j].real() * f[j].imag() + k[j].imag() * f[j].real();
              }
            image[std::size_t(m) * n + i] = {re, im};
          }
      }
    // [m]; of slips [-]
    std::vector<double> displacement(std::size_t(n) * grid_.mx);
    for (int row = 0; row < n; ++row)
      {
        for (int m = 0; m < body.modes; ++m)
          // 5. back, of the elements alone
          plans_->spectrum[m] = image[std::size_t(m) * n + row];
        std::fill(plans_->spectrum.begin() + body.modes, plans_->spectrum.end(), 0.);
        fftw_execute(plans_->backward);
        std::copy_n(plans_->real.begin(), grid_.mx, displacement.begin() + std::size_t(row) * grid_.mx);
      }
    return displacement;
  }


  std::array<std::vector<double>, 3>
  RowsInfluence::fixed_displacement(const unsigned int body_number, const Given &traction) const
  {
    const Body &body = bodies_[body_number];
    const int   mx   = grid_.mx;
    // displacement of one body alone, for how its surface turns and moves ((5) and (6) of
    // doc/theory/bodies.md) [m]
    const std::vector<double>          u = row_displacements(body, body.here, row_forces(body, traction));
    std::array<std::vector<double>, 3> fixed;
    for (int axis = 0; axis < 3; ++axis)
      {
        fixed[axis].assign(grid_.size(), 0.);
        for (int j = 0; j < grid_.my; ++j)
          for (int r = 0; r < body.rows; ++r)
            if (const double weight = body.weights[std::size_t(j) * body.rows + r]; weight != 0)
              for (int i = 0; i < mx; ++i)
                // u_j = sum over r of w_jr u_r, left in the fixed axes
                fixed[axis][i + mx * j] += weight * u[std::size_t(3 * r + axis) * mx + i];
      }
    return fixed;
  }


  void
  RowsInfluence::add(const bool slip, const Given &traction, const Fields &result) const
  {
    // (half-spaces + R) t of (4): the solver adds this to the influence of half-spaces
    const int mx = grid_.mx;
    for (const Body &body : bodies_)
      {
        // both bodies add: each displaces its own surface under its own tractions
        const std::vector<double> u =
          row_displacements(body, slip ? body.slip : body.here, row_forces(body, traction));
        for (int j = 0; j < grid_.my; ++j)
          for (int r = 0; r < body.rows; ++r)
            {
              const double weight = body.weights[std::size_t(j) * body.rows + r];
              // rows near the row of elements alone have weights
              if (weight == 0)
                continue;
              for (int c = 0; c < 3; ++c)
                if (result[c])
                  for (int axis = 0; axis < 3; ++axis)
                    // 6. displacement along a direction of the contact: the product of the axes with it
                    if (const double share = weight * bases_[j][3 * axis + c]; share != 0)
                      for (int i = 0; i < mx; ++i)
                        (*result[c])[i + mx * j] += share * u[std::size_t(3 * r + axis) * mx + i];
            }
      }
  }


  void
  RowsInfluence::add_displacement(const Given &traction, const Fields &displacement) const
  {
    add(false, traction, displacement);
  }


  void
  RowsInfluence::add_slip(const Given &traction, const Fields &slip) const
  {
    add(true, traction, slip);
  }
} // namespace wheelrail
