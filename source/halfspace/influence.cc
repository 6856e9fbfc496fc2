#include <wheelrail/halfspace/corner_sweep.h>
#include <wheelrail/halfspace/influence.h>

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <mutex>

// A_ab of doc/theory/halfspace.md, Equations: displacement difference u_a of two half-spaces under a constant
// traction t_b on a rectangle, in closed form from the primitives of x^2/r^3, y^2/r^3, x y/r^3, x/r^2, y/r^2
// (Boussinesq 1885, Cerruti 1882; Kalker 1990), and products with A by FFT.
// Checked: CONTACT's peak pressure and approach of Hertz's ellipses, to its last printed digit
// (doc/theory/halfspace.md, Verification).

namespace wheelrail
{
  namespace
  {

    /// The next size from n on with prime factors 2, 3 and 5 only, even.
    int
    fft_size(const int n)
    {
      for (int size = n + n % 2;; size += 2)
        {
          int rest = size;
          // sizes with small prime factors, for which FFTW is fast
          for (const int factor : {2, 3, 5})
            while (rest % factor == 0)
              rest /= factor;
          if (rest == 1)
            return size;
        }
    }

    /// b asinh(a / |b|), 0 at b = 0.
    double
    log_term(const double a, const double b)
    {
      // the integral of x^2/r^3 (a = x, b = y) or y^2/r^3 (a = y, b = x); asinh and not ln(a + r), which
      // loses all its digits for a < 0, far from the load
      return b == 0 ? 0 : b * std::asinh(a / std::abs(b));
    }

    /// The indefinite integrals over x and y of x^2/r^3, y^2/r^3, x y/r^3, x/r^2, y/r^2.
    std::array<double, 5>
    primitives(const double x, const double y)
    {
      // Each line F has d2F/(dx dy) equal to its integrand, so that a rectangle is F at its four corners with
      // alternating signs. The first two add up to the primitive of 1/r. At r = 0 all tend to 0.
      const double r = std::hypot(x, y), log_r = r > 0 ? std::log(r) : 0;
      return {log_term(x, y),
              log_term(y, x),
              -r,
              y * log_r + (x == 0 ? 0 : x * std::atan(y / x)),
              x * log_r + (y == 0 ? 0 : y * std::atan(x / y))};
    }

    /// The coefficients from the integrals at the four corners of the element; `itself`: under its own load.
    InfluenceCoefficients
    between(const HalfspaceConstants    &constants,
            const std::array<double, 5> &far_far,
            const std::array<double, 5> &far_near,
            const std::array<double, 5> &near_far,
            const std::array<double, 5> &near_near,
            const bool                   itself)
    {
      // u_a = A_ab t_b: Boussinesq (1885) and Cerruti (1882) over a rectangle (doc/theory/halfspace.md,
      // Equations)
      std::array<double, 5> i;
      for (int k = 0; k < 5; ++k)
        // 1. the five integrals over the loaded rectangle, x from xa to xb and y from ya to yb
        i[k] = far_far[k] - far_near[k] - near_far[k] + near_near[k];
      // 2. the coefficients, with n = (1 - nu)/(pi G), nu = nu/(pi G), k = K/(pi G) and 1/r = x^2/r^3 +
      // y^2/r^3:
      //    u_x = n t_x/r + nu (x^2 t_x + x y t_y)/r^3 - k x p/r^2,   u_y likewise,
      //    u_n = n p/r + k (x t_x + y t_y)/r^2.
      // Pressure and tangential problem are coupled with opposite signs: p acts on body 1 along +n and u is
      // body 1 less body 2, so that A is skew in the pairs (x, n), (y, n).
      const double          inverse_distance = i[0] + i[1];
      const double          n = constants.normal, nu = constants.poisson, k = constants.coupling;
      InfluenceCoefficients c;
      c[0] = {n * inverse_distance + nu * i[0], nu * i[2], -k * i[3]};
      c[1] = {nu * i[2], n * inverse_distance + nu * i[1], -k * i[4]};
      c[2] = {k * i[3], k * i[4], n * inverse_distance};
      if (itself)
        {
          // 3. a layer of thickness h and shear modulus G between the bodies (Winkler's foundation in shear,
          // no coupling between places): u = h/G t
          c[0][0] += constants.layer;
          c[1][1] += constants.layer;
        }
      return c;
    }
  } // namespace

  HalfspaceConstants
  halfspace_constants(const HalfspaceBody &body1, const HalfspaceBody &body2)
  {
    // A quotient over G is the mean of both bodies; the sum of both over 2 pi is that mean over pi. A rigid
    // body is one with g to infinity.
    const double       g1 = body1.shear_modulus, g2 = body2.shear_modulus;
    const double       nu1 = body1.poisson_ratio, nu2 = body2.poisson_ratio;
    HalfspaceConstants c;
    // (1 - nu)/G and nu/G, means of both bodies, and K/G, which like bodies do not have (Kalker 1990;
    // doc/theory/halfspace.md, Equations)
    c.normal  = ((1 - nu1) / g1 + (1 - nu2) / g2) / (2 * M_PI);
    c.poisson = (nu1 / g1 + nu2 / g2) / (2 * M_PI);
    // of opposite sign in both bodies, since p presses them apart but u is a difference; it vanishes for like
    // bodies and for nu = 0.5
    c.coupling = ((1 - 2 * nu1) / g1 - (1 - 2 * nu2) / g2) / (4 * M_PI);
    return c;
  }

  InfluenceCoefficients
  influence_coefficients(const HalfspaceConstants &constants, double dx, double dy, double x, double y)
  {
    // the load covers dx x dy about the origin: seen from the point, its corners lie at x -+ dx/2, y -+ dy/2
    const double xa = x - dx / 2, xb = x + dx / 2, ya = y - dy / 2, yb = y + dy / 2;
    return between(constants,
                   primitives(xb, yb),
                   primitives(xb, ya),
                   primitives(xa, yb),
                   primitives(xa, ya),
                   std::abs(x) < dx / 2 && std::abs(y) < dy / 2);
  }


  std::vector<std::vector<double>>
  influence_by_distance(const HalfspaceConstants         &constants,
                        const HalfspaceGrid              &grid,
                        const InfluenceProducts          &products,
                        const double                      ahead,
                        const std::vector<InfluencePair> &pairs)
  {
    const int nx = products.columns(), ny = products.rows();
    // distances from -nx/2 to nx/2 - 1 in elements: all that a doubled grid asks for
    const int middle_x = nx / 2, middle_y = ny / 2;
    // tables by distance I - J: what depends on it alone is a convolution, and one table serves all pairs
    std::vector<std::vector<double>> tables(pairs.size(), std::vector<double>(std::size_t(nx) * ny));
    sweep_corners(
      grid,
      {-middle_x, nx - middle_x, -middle_y, ny - middle_y},
      ahead,
      primitives,
      [&](const int i, const int j, const auto &ff, const auto &fn, const auto &nf, const auto &nn) {
        // the layer yields under its own element alone, also when the point lies `ahead` within it
        const bool itself = j == 0 && std::abs(i * grid.dx + ahead) < grid.dx / 2;
        const auto c      = between(constants, ff, fn, nf, nn, itself);
        for (std::size_t k = 0; k < pairs.size(); ++k)
          tables[k][i + middle_x + std::size_t(nx) * (j + middle_y)] = c[pairs[k].a][pairs[k].b];
      });
    return tables;
  }

  namespace
  {
    /// As FFTW takes them; std::complex has its two numbers one after the other.
    fftw_complex *
    values_of(InfluenceProducts::Spectrum &spectrum)
    {
      return reinterpret_cast<fftw_complex *>(spectrum.data());
    }
  } // namespace

  struct InfluenceProducts::Plans
  {
    double   *real  = nullptr;
    fftw_plan whole = nullptr; ///< of a kernel, which fills the doubled grid
    // of fields, row by row of the grid and then along the columns: of the doubled grid the other half of the
    // rows is zero before, and not asked for behind
    fftw_plan rows = nullptr, columns = nullptr, back_columns = nullptr, back_rows = nullptr;
  };

  InfluenceProducts::InfluenceProducts(const HalfspaceGrid &grid)
    : grid_(grid)
    // A product A t is a convolution, A_ab(I - J). The FFT makes it a cyclic one; on a grid of twice the
    // length the copies do not reach the elements (zero padding; Hockney 1970).
    , nx_(fft_size(2 * grid.mx))
    , ny_(fft_size(2 * grid.my))
    , plans_(std::make_unique<Plans>())
  {
    // FFTW's planner may be called by one thread at a time
    const std::lock_guard<std::mutex> guard(fft_planning());
    plans_->real = fftw_alloc_real(std::size_t(nx_) * ny_);
    Spectrum            any(spectrum_size());
    double *const       real    = plans_->real;
    fftw_complex *const complex = values_of(any);
    const int           nc = nx_ / 2 + 1, my = grid.my;
    const unsigned int  how = FFTW_ESTIMATE;
    plans_->whole           = fftw_plan_dft_r2c_2d(ny_, nx_, real, complex, how);
    plans_->rows = fftw_plan_many_dft_r2c(1, &nx_, my, real, nullptr, 1, nx_, complex, nullptr, 1, nc, how);
    plans_->back_rows =
      fftw_plan_many_dft_c2r(1, &nx_, my, complex, nullptr, 1, nc, real, nullptr, 1, nx_, how);
    const auto columns = [&](const int direction) {
      return fftw_plan_many_dft(
        1, &ny_, nc, complex, nullptr, nc, 1, complex, nullptr, nc, 1, direction, how);
    };
    // columns in place, after the rows there and before the rows back
    plans_->columns      = columns(FFTW_FORWARD);
    plans_->back_columns = columns(FFTW_BACKWARD);
  }

  InfluenceProducts::~InfluenceProducts()
  {
    const std::lock_guard<std::mutex> guard(fft_planning());
    for (fftw_plan plan :
         {plans_->whole, plans_->rows, plans_->columns, plans_->back_columns, plans_->back_rows})
      fftw_destroy_plan(plan);
    fftw_free(plans_->real);
  }

  std::size_t
  InfluenceProducts::spectrum_size() const
  {
    return std::size_t(ny_) * (nx_ / 2 + 1);
  }

  InfluenceProducts::Spectrum
  InfluenceProducts::kernel(const std::vector<double> &by_distance)
  {
    // distances that wrap around: the upper half of the doubled grid stands for negative ones
    for (int j = 0; j < ny_; ++j)
      {
        const double *from = by_distance.data() + std::size_t(nx_) * ((j + ny_ / 2) % ny_);
        double       *to   = plans_->real + std::size_t(nx_) * j;
        std::rotate_copy(from, from + nx_ / 2, from + nx_, to);
      }
    Spectrum spectrum(spectrum_size());
    fftw_execute_dft_r2c(plans_->whole, plans_->real, values_of(spectrum));
    // FFTW's transforms there and back multiply by the number of values: divided out once, in the kernel
    const double scale = 1. / (double(nx_) * ny_);
    for (Complex &value : spectrum)
      value *= scale;
    return spectrum;
  }

  void
  InfluenceProducts::forward(const std::vector<double> &field, Spectrum &spectrum)
  {
    // zero padding: the copies of the field do not reach the elements
    std::fill_n(plans_->real, std::size_t(nx_) * grid_.my, 0.);
    for (int j = 0; j < grid_.my; ++j)
      std::copy_n(field.data() + std::size_t(grid_.mx) * j, grid_.mx, plans_->real + std::size_t(nx_) * j);
    spectrum.resize(spectrum_size());
    fftw_complex *const values = values_of(spectrum);
    // only the my rows of the grid differ from zero before the transform along y
    fftw_execute_dft_r2c(plans_->rows, plans_->real, values);
    const std::size_t filled = std::size_t(nx_ / 2 + 1) * grid_.my;
    std::fill(spectrum.begin() + filled, spectrum.end(), 0.);
    fftw_execute_dft(plans_->columns, values, values);
  }

  void
  InfluenceProducts::backward(Spectrum &spectrum, std::vector<double> &field)
  {
    fftw_complex *const values = values_of(spectrum);
    fftw_execute_dft(plans_->back_columns, values, values);
    fftw_execute_dft_c2r(plans_->back_rows, values, plans_->real);
    field.resize(grid_.size());
    for (int j = 0; j < grid_.my; ++j)
      std::copy_n(plans_->real + std::size_t(nx_) * j, grid_.mx, field.data() + std::size_t(grid_.mx) * j);
  }
} // namespace wheelrail
