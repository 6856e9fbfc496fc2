#include <wheelrail/base/interrupt.h>
#include <wheelrail/bodies/body_table.h>
#include <wheelrail/bodies/line_loads.h>

#include <algorithm>
#include <array>
#include <cmath>

// (2) of doc/theory/bodies.md, D(k) = C(k) - H(k): finite elements less half-space, both as means over rows
// of 2 mm. C has the logarithm of the half-space near the load, which elements do not resolve; D is smooth.
// Rows side by side err by the elements: a cubic replaces them.
// Checked: a block, two lags and more apart, 2e-5 of the self influence; a layer on a rigid base, 5e-3 of
// Fourier's integral (doc/theory/bodies.md, Verification).

namespace wheelrail
{
  namespace
  {
    // below the first the remainder of a rail stays as it is there, above the last nothing is left of it
    // [1/m]
    constexpr double lowest_wavenumber = 0.25, highest_wavenumber = 1500;
    // a rail deflects as a beam on its foot below some 10/m, which more of them have to show
    constexpr unsigned int n_wavenumbers = 12, n_of_rail = 24, n_harmonics = 13;

    std::vector<double>
    between(const double low, const double high, const unsigned int n)
    {
      std::vector<double> places;
      for (unsigned int i = 0; i < n; ++i)
        // in equal steps of log k, as remainder_at() interpolates
        places.push_back(low * std::pow(high / low, double(i) / (n - 1)));
      return places;
    }


    /// Mean over two rows of a half-space's response at k, in fixed axes: two Gauss points on each.
    LineResponse
    mean_response(const BodyTable &table, const BodyTable::Row &i, const BodyTable::Row &j, const double k)
    {
      // rows have a width, so that elements and half-space are compared in the same means; two points on each
      // are exact for cubics, and rows two apart see no singularity
      const double gauss = 0.5 / std::sqrt(3.);
      LineResponse mean{};
      for (const double a : {-gauss, gauss})
        for (const double b : {-gauss, gauss})
          {
            const LineResponse one = halfspace_line(table.shear_modulus,
                                                    table.poissons_ratio,
                                                    !table.wheel,
                                                    k,
                                                    i.arc + a * i.width - j.arc - b * j.width);
            for (int c = 0; c < 9; ++c)
              mean[c] += 0.25 * one[c];
          }
      return in_fixed_axes(mean, i.angle, j.angle);
    }


    /// Weights of the cubic through four places at one place (Lagrange).
    std::array<double, 4>
    cubic_weights(const std::array<double, 4> &at, const double x)
    {
      std::array<double, 4> weights;
      for (int i = 0; i < 4; ++i)
        {
          weights[i] = 1;
          for (int j = 0; j < 4; ++j)
            if (j != i)
              // product over j of (x - x_j)/(x_i - x_j)
              weights[i] *= (x - at[j]) / (at[i] - at[j]);
        }
      return weights;
    }


    /// Puts cubics through rows two and three away in place of what the elements say of a row's own
    /// neighbours, as seen from the sources, then makes the matrix symmetric again.
    void
    mend(const BodyTable &table, std::vector<double> &D)
    {
      // D is smooth across the rows, so that a cubic through good rows is nearer than what elements say
      const int                 m = table.rows.size(), n = 3 * m;
      const std::vector<double> before = D;
      for (int j = 0; j < m; ++j)
        {
          // of the sources on row j, receivers j - 1, j, j + 1 are replaced; at the ends of the running
          // surface the cubic extrapolates
          std::array<int, 4> from{{j - 3, j - 2, j + 2, j + 3}};
          if (j < 3)
            from = {{j + 2, j + 3, j + 4, j + 5}};
          if (j + 3 >= m)
            from = {{j - 5, j - 4, j - 3, j - 2}};
          std::array<double, 4> at;
          for (int f = 0; f < 4; ++f)
            at[f] = table.rows[from[f]].arc;
          for (int i = std::max(0, j - 1); i <= std::min(m - 1, j + 1); ++i)
            {
              const auto weights = cubic_weights(at, table.rows[i].arc);
              for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b)
                  {
                    double sum = 0;
                    for (int f = 0; f < 4; ++f)
                      sum += weights[f] * before[std::size_t(n) * (3 * from[f] + a) + 3 * j + b];
                    D[std::size_t(n) * (3 * i + a) + 3 * j + b] = sum;
                  }
            }
        }
      // Maxwell and Betti: C(k) = C(k)', H likewise
      for (int r = 0; r < n; ++r)
        for (int c = 0; c < r; ++c)
          D[std::size_t(n) * r + c] = D[std::size_t(n) * c + r] =
            0.5 * (D[std::size_t(n) * r + c] + D[std::size_t(n) * c + r]);
    }


    /// Compliance less half-space at a wave. The elements of a wheel count displacements outwards.
    std::vector<double>
    remainder(WaveStiffness                 &stiffness,
              const std::vector<SurfaceRow> &rows,
              const BodyTable               &table,
              const double                   wave)
    {
      // (2) of doc/theory/bodies.md, D(k) = C(k) - H(k)
      std::vector<double> D = stiffness.compliance(wave, rows);
      const int           m = rows.size(), n = 3 * m;
      for (int i = 0; i < m; ++i)
        for (int j = 0; j < m; ++j)
          {
            if (table.wheel)
              for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b)
                  // outwards is down at the contact: y of the section changes its sign, once for a
                  // displacement, once for a force
                  if ((a == 1) != (b == 1))
                    D[std::size_t(n) * (3 * i + a) + 3 * j + b] *= -1;
            if (std::abs(i - j) < 2)
              continue;
            // k = n/r, with the geometric mean of both rows, so that H stays symmetric; a half-space is
            // singular at k = 0
            const double       r = std::sqrt(table.rows[i].radius * table.rows[j].radius);
            const double       k = table.wheel ? std::max(wave, BodyTable::least_wave) / r : wave;
            const LineResponse H = mean_response(table, table.rows[i], table.rows[j], k);
            for (int a = 0; a < 3; ++a)
              for (int b = 0; b < 3; ++b)
                D[std::size_t(n) * (3 * i + a) + 3 * j + b] -= H[3 * a + b];
          }
      mend(table, D);
      return D;
    }
  } // namespace


  Point2
  profile_place(const Point2 &node, const bool wheel, const double nominal_radius)
  {
    // x of a section points to the track centre, that of a profile to the field side
    return {-node.x, wheel ? nominal_radius - node.y : node.y};
  }


  std::vector<SurfaceRow>
  rows_on_profile(const SectionMesh &mesh,
                  const Curve       &profile,
                  const bool         wheel,
                  const double       nominal_radius,
                  const unsigned int cells)
  {
    constexpr double on_profile = 1e-5; // [m]
    // rows on the chamfers and fillets beside the running surface are left out: a contact does not lie there
    std::vector<SurfaceRow> rows;
    for (const SurfaceRow &row : surface_rows(mesh, cells, wheel))
      {
        const Point2 place = profile_place(row.place, wheel, nominal_radius);
        if (norm(profile.at(profile.closest(place)).position - place) <= on_profile)
          rows.push_back(row);
      }
    return rows;
  }


  BodyTable
  make_body_table(const SectionMesh &mesh,
                  const Curve       &profile,
                  const Elasticity  &elasticity,
                  const bool         wheel,
                  const double       nominal_radius,
                  const unsigned int cells)
  {
    // 1. Rows of the running surface, with their arcs on the profile; 2. growth; 3. wavenumbers; 4. D at each
    BodyTable table;
    table.wheel          = wheel;
    table.shear_modulus  = elasticity.shear_modulus();
    table.poissons_ratio = elasticity.poissons_ratio;
    WaveStiffness                 stiffness(mesh, elasticity, wheel);
    const std::vector<SurfaceRow> rows = rows_on_profile(mesh, profile, wheel, nominal_radius, cells);
    for (const SurfaceRow &row : rows)
      {
        const double t = profile.closest(profile_place(row.place, wheel, nominal_radius));
        table.rows.push_back(
          {profile.length(0, t), wheel ? -row.angle : row.angle, row.width, row.radius, {}});
      }
    if (wheel)
      {
        const std::vector<Point2> growth = stiffness.growth(1, elasticity.density, rows);
        for (std::size_t i = 0; i < rows.size(); ++i)
          // at 1 rad/s; y of a wheel's section is outwards, down at the contact
          table.rows[i].growth = {growth[i].x, -growth[i].y};
        for (unsigned int n = 0; n < n_harmonics; ++n)
          table.waves.push_back(n);
        table.harmonics = n_harmonics;
      }
    for (const double k : wheel
                            ? between(n_harmonics - 0.5, highest_wavenumber * nominal_radius, n_wavenumbers)
                            : between(lowest_wavenumber, highest_wavenumber, n_of_rail))
      table.waves.push_back(k);
    // D at each wavenumber (rail) or number of waves (wheel): one factor of K each
    for (const double wave : table.waves)
      {
        // a signal ends a run of tables between two factors
        leave_if_interrupted();
        table.remainder.push_back(remainder(stiffness, rows, table, wave));
      }
    return table;
  }
} // namespace wheelrail
