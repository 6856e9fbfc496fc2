#include <wheelrail/base/errors.h>
#include <wheelrail/bodies/body_influence.h>
#include <wheelrail/bodies/line_loads.h>
#include <wheelrail/bodies/wave_panels.h>

#include <gsl/gsl_interp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

// (3) of doc/theory/bodies.md, R(z) = 1/pi int D(k) cos(k z) dk of a rail, and for a wheel of radius r 1/(pi
// r) sum' D_n cos(n z/r) over harmonics, then the integral beyond. Steps: 1. D at a wave, from the table; 2.
// turned to the axes of the track; 3. plus what the half-space along the body's own arc differs from that
// along the contact; 4. summed over waves at all lags; 5. of a wheel less the integral over H for which its
// harmonics stand.

namespace wheelrail
{
  namespace
  {
    /// The remainder of a table at a wave, between rows: cubic in log k. Below the first wavenumber of a rail
    /// it stays: on its foot the rail deflects there as under a load without end.
    std::vector<double>
    remainder_at(const BodyTable &table, const ContactRows &rows, const double wave)
    {
      const unsigned int first = table.wheel ? table.harmonics : 0, last = table.waves.size() - 1;
      // four wavenumbers around `wave`, two on either side but at the ends
      std::array<double, 4> weights{};
      unsigned int          from = first;
      if (wave <= table.waves[first])
        weights[0] = 1;
      else
        {
          while (from + 4 <= last && table.waves[from + 2] < wave)
            ++from;
          for (int i = 0; i < 4; ++i)
            {
              weights[i] = 1;
              for (int j = 0; j < 4; ++j)
                if (j != i)
                  // Lagrange's cubic through four wavenumbers in log k
                  weights[i] *= std::log(wave / table.waves[from + j]) /
                                std::log(table.waves[from + i] / table.waves[from + j]);
            }
        }
      // the part of the table between the rows of the contact, weighted
      const std::size_t   n = 3 * rows.count, all = 3 * table.rows.size();
      std::vector<double> D(n * n, 0.);
      for (int w = 0; w < 4; ++w)
        if (weights[w] != 0)
          for (std::size_t i = 0; i < n; ++i)
            {
              const double *row = &table.remainder[from + w][all * (3 * rows.first + i) + 3 * rows.first];
              for (std::size_t j = 0; j < n; ++j)
                D[n * i + j] += weights[w] * row[j];
            }
      return D;
    }


    /// The part of the table between rows at one of its own waves.
    std::vector<double>
    harmonic(const BodyTable &table, const ContactRows &rows, const unsigned int number)
    {
      const std::size_t   n = 3 * rows.count, all = 3 * table.rows.size();
      std::vector<double> D(n * n);
      for (std::size_t i = 0; i < n; ++i)
        std::copy_n(&table.remainder[number][all * (3 * rows.first + i) + 3 * rows.first], n, &D[n * i]);
      return D;
    }


    /// Turns (x, y) of rows and columns by an angle.
    void
    turn(std::vector<double> &D, const double angle)
    {
      const std::size_t n = std::size_t(std::lround(std::sqrt(double(D.size()))));
      const double      c = std::cos(angle), s = std::sin(angle);
      for (std::size_t i = 0; i < n; i += 3)
        for (std::size_t j = 0; j < n; ++j)
          {
            // R D R', R the rotation by the angle: of displacements here, of forces below
            double      &x = D[n * i + j], &y = D[n * (i + 1) + j];
            const double turned = c * x - s * y;
            y                   = s * x + c * y;
            x                   = turned;
          }
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; j += 3)
          {
            double      &x = D[n * i + j], &y = D[n * i + j + 1];
            const double turned = c * x - s * y;
            y                   = s * x + c * y;
            x                   = turned;
          }
    }


    /// A half-space between two places of a surface with these angles against X, in fixed axes; at distance 0
    /// the mean of both sides at `least`.
    LineResponse
    surface_response(const BodyTable &table,
                     const double     k,
                     const double     s,
                     const double     receiver,
                     const double     source,
                     const double     least)
    {
      // H of one body alone, displacements under tractions on it; at distance 0, where the tangential-normal
      // terms jump, the mean of both sides
      LineResponse local{};
      // n is left of t, that is up: out of a rail, into a wheel, hence `outwards` of halfspace_line()
      const bool close = std::abs(s) < least;
      for (const double side : {1., -1.})
        {
          const LineResponse one = halfspace_line(
            table.shear_modulus, table.poissons_ratio, !table.wheel, k, close ? side * least : s);
          for (int c = 0; c < 9; ++c)
            local[c] += 0.5 * one[c];
        }
      return in_fixed_axes(local, receiver, source);
    }


    /// Where the rows of the table lie in the contact.
    struct RowPlace
    {
      double arc = 0, angle = 0;       ///< on the body, against X of the track
      double lateral = 0, contact = 0; ///< coordinate of the contact and angle of its lateral direction
      double stretch = 1;              ///< d arc / d lateral
    };
    std::vector<RowPlace>
    row_places(const BodyTable &table, const BodyPlacement &placement, const ContactRows &rows)
    {
      // Of each row of the table: where it lies on its body, and where on the unfolded rail, in which the
      // half-spaces of the solver count distances
      std::vector<RowPlace>      places;
      const std::vector<double> &arcs = placement.arcs;
      for (int r = rows.first; r < rows.first + rows.count; ++r)
        {
          const BodyTable::Row &row = table.rows[r];
          // between the rows of elements; beyond them it goes on as at the end
          const auto above = std::upper_bound(arcs.begin(), arcs.end(), row.arc) - arcs.begin();
          const int  i     = std::clamp<int>(above - 1, 0, int(arcs.size()) - 2);
          // arcs ascend on the wheel as on the rail: both run towards the track centre
          const double step   = arcs[i + 1] - arcs[i];
          const double f      = std::clamp((row.arc - arcs[i]) / step, 0., 1.),
                       beyond = row.arc - arcs[i] - f * step;
          RowPlace place;
          place.arc   = row.arc;
          place.angle = row.angle + placement.turn;
          // of the body's own arc against that of the contact, which is the rail's: the wheel's arcs are a
          // little longer or shorter
          place.stretch = step / (placement.lateral[i + 1] - placement.lateral[i]);
          place.lateral =
            placement.lateral[i] + f * (placement.lateral[i + 1] - placement.lateral[i]) + beyond;
          place.contact = placement.angles[i] + f * (placement.angles[i + 1] - placement.angles[i]);
          if (beyond != 0)
            place.contact = place.angle;
          places.push_back(place);
        }
      return places;
    }


    /// Adds to D what a half-space along the body's own profile has more than one along the contact.
    void
    add_unfolding(const BodyTable             &table,
                  const std::vector<RowPlace> &places,
                  const double                 k,
                  std::vector<double>         &D)
    {
      const std::size_t n = 3 * places.size();
      // The solvers have H of a half-space with the arc of the rail as distance; the body has its own arc and
      // own angles: D + H(own) - H(contact).
      const double f = 1 / (M_PI * table.shear_modulus), nu = table.poissons_ratio;
      for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < places.size(); ++j)
          {
            // a receives, b is loaded
            const RowPlace &a = places[i], &b = places[j];
            if (i == j)
              {
                // the limit: log of the stretch, alike in all directions but for Poisson's ratio
                // K0(x) goes as -ln x for x to 0: own less flat is -ln(d arc/d lateral) times the factor of
                // K0, (1 - nu)/(pi G) for t and n, 1/(pi G) for w
                const double log_stretch = std::log(a.stretch);
                for (int c = 0; c < 3; ++c)
                  D[n * (3 * i + c) + 3 * j + c] -= f * (c == 2 ? 1 : 1 - nu) * log_stretch;
                continue;
              }
            const LineResponse own = in_fixed_axes(
                                 halfspace_line(table.shear_modulus, nu, !table.wheel, k, a.arc - b.arc),
                                 a.angle,
                                 b.angle),
                               flat = in_fixed_axes(
                                 halfspace_line(
                                   table.shear_modulus, nu, !table.wheel, k, a.lateral - b.lateral),
                                 a.contact,
                                 b.contact);
            for (int c = 0; c < 9; ++c)
              D[n * (3 * i + c / 3) + 3 * j + c % 3] += own[c] - flat[c];
          }
    }


    /// Adds a wave to the influences: cos where displacement and force both lie along or across the track,
    /// sin where one does and the other does not.
    void
    add_wave(const Wave                &wave,
             const std::vector<double> &D,
             const std::vector<double> &lags,
             std::vector<double>       &by_lag)
    {
      const std::size_t   n    = std::size_t(std::lround(std::sqrt(double(D.size()))));
      std::vector<double> even = D, odd = D;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          {
            const bool rows = i % 3 == 2, columns = j % 3 == 2;
            // (3) of doc/theory/bodies.md: of Re[(u_x, u_y, i w) exp(i k z)] and forces (f_x, f_y, i f_z)
            // exp(i k z), u_x under f_x goes with cos(k z), and so does w under f_z; u_x under f_z with +sin,
            // w under f_x with -sin
            (rows == columns ? odd : even)[n * i + j] = 0;
            odd[n * i + j] *= rows ? -wave.weight : wave.weight;
            even[n * i + j] *= wave.weight;
          }
      for (std::size_t l = 0; l < lags.size(); ++l)
        {
          const double c = std::cos(wave.k * lags[l]), s = std::sin(wave.k * lags[l]);
          double      *sum = &by_lag[l * n * n];
          for (std::size_t e = 0; e < n * n; ++e)
            sum[e] += c * even[e] + s * odd[e];
        }
    }


    /// What a sum over the harmonics of half-spaces differs from the integral that it stands for.
    void
    add_half_space_waves(const BodyTable             &table,
                         const std::vector<RowPlace> &places,
                         const double                 radius,
                         const double                 longest,
                         const std::vector<double>   &lags,
                         std::vector<double>         &by_lag)
    {
      // 1. Harmonics n of the half-space along the contact, 1/(pi r) each, of n = 0 half and with k = 0.3/r,
      // where H is finite
      std::vector<Wave> waves;
      for (unsigned int n = 0; n < table.harmonics; ++n)
        waves.push_back(
          {std::max<double>(n, BodyTable::least_wave) / radius, (n > 0 ? 1. : 0.5) / (M_PI * radius)});
      // minus the integral over 0 ... (N - 1/2)/r for which the sum over n = 0 ... N - 1 stands: what is left
      // is the difference of a periodic and an endless half-space
      for (Wave wave : wave_panels(0, (table.harmonics - 0.5) / radius, 0.02 / radius, longest))
        {
          wave.weight *= -1;
          waves.push_back(wave);
        }
      const std::size_t n = 3 * places.size();
      for (std::size_t w = 0; w < waves.size(); ++w)
        {
          // along the contact, as H of the solvers
          std::vector<double> H(n * n);
          for (std::size_t i = 0; i < places.size(); ++i)
            for (std::size_t j = 0; j < places.size(); ++j)
              {
                const LineResponse one = surface_response(table,
                                                          waves[w].k,
                                                          places[i].lateral - places[j].lateral,
                                                          places[i].contact,
                                                          places[j].contact,
                                                          0.5e-3);
                for (int c = 0; c < 9; ++c)
                  H[n * (3 * i + c / 3) + 3 * j + c % 3] = one[c];
              }
          // the harmonic 0 goes alike all around
          const Wave wave{w == 0 ? 0 : waves[w].k, waves[w].weight};
          add_wave(wave, H, lags, by_lag);
        }
    }
  } // namespace


  ContactRows
  contact_rows(const BodyTable &table, const BodyPlacement &placement)
  {
    constexpr int beside = 3;
    const auto    before = [&](const double arc) {
      int r = 0;
      while (r + 1 < int(table.rows.size()) && table.rows[r + 1].arc < arc)
        ++r;
      return r;
    };
    ContactRows rows;
    // rows under the contact and three beside it on either side, for the cubic spline
    rows.first     = std::max(0, before(placement.arcs.front()) - beside);
    const int last = std::min<int>(table.rows.size() - 1, before(placement.arcs.back()) + 1 + beside);
    rows.count     = last - rows.first + 1;
    if (rows.count < 4)
      throw RunError("The contact lies beside the running surface of the " +
                     std::string(table.wheel ? "wheel" : "rail") + " that has a table of its elasticity.");
    // rows of the table between which the spline goes
    std::vector<double> arcs;
    for (int r = rows.first; r <= last; ++r)
      arcs.push_back(table.rows[r].arc);
    gsl_interp       *spline = gsl_interp_alloc(gsl_interp_cspline, rows.count);
    gsl_interp_accel *place  = gsl_interp_accel_alloc();
    rows.weights.resize(placement.arcs.size() * rows.count);
    for (int r = 0; r < rows.count; ++r)
      {
        std::vector<double> unit(rows.count, 0.);
        // weights of the natural cubic spline: its value at the arc for a 1 on row r and 0 on the others
        unit[r] = 1;
        // a spline is linear in its values: weights serve displacements and, transposed, forces
        gsl_interp_init(spline, arcs.data(), unit.data(), rows.count);
        for (std::size_t j = 0; j < placement.arcs.size(); ++j)
          rows.weights[j * rows.count + r] =
            gsl_interp_eval(spline,
                            arcs.data(),
                            unit.data(),
                            std::clamp(placement.arcs[j], arcs.front(), arcs.back()),
                            place);
      }
    gsl_interp_accel_free(place);
    gsl_interp_free(spline);
    return rows;
  }


  RowInfluence
  body_influence(const BodyTable           &table,
                 const BodyPlacement       &placement,
                 const ContactRows         &rows,
                 const std::vector<double> &lags)
  {
    const std::size_t n = 3 * rows.count;
    RowInfluence      influence{rows.count, rows.weights, std::vector<double>(lags.size() * n * n, 0.)};
    double            longest = 0;
    for (const double lag : lags)
      longest = std::max(longest, std::abs(lag));
    // (3) of doc/theory/bodies.md: the sum over the harmonics of a wheel, and the integral over k
    const std::vector<RowPlace> places = row_places(table, placement, rows);
    const double                radius = placement.radius;
    // n / radius for a wheel
    const double per_wave = table.wheel ? 1 / radius : 1;
    const double first    = table.wheel ? (table.harmonics - 0.5) * per_wave : 0,
                 last     = table.waves.back() * per_wave;
    // 1. harmonics of a wheel, n = 0, 1, 2, ...
    for (unsigned int h = 0; h < table.harmonics; ++h)
      {
        std::vector<double> D = harmonic(table, rows, h);
        turn(D, placement.turn);
        add_unfolding(table, places, std::max<double>(h, BodyTable::least_wave) / radius, D);
        // sum over n of cos(n z/r)/(pi r), of n = 0 half: a load around the wheel in Fourier's series
        add_wave({h / radius, (h > 0 ? 1. : 0.5) / (M_PI * radius)}, D, lags, influence.by_lag);
      }
    // 2. the integral over k: of a rail from 0, of a wheel beyond its harmonics
    for (const Wave &wave : wave_panels(first, last, table.wheel ? 3 / radius : 0.05, longest))
      {
        std::vector<double> D = remainder_at(table, rows, wave.k / per_wave);
        turn(D, placement.turn);
        add_unfolding(table, places, wave.k, D);
        add_wave(wave, D, lags, influence.by_lag);
      }
    if (table.wheel)
      add_half_space_waves(table, places, radius, longest, lags, influence.by_lag);
    return influence;
  }


  std::vector<Point2>
  growth(const BodyTable &table, const BodyPlacement &placement, const ContactRows &rows, const double rate)
  {
    // into the axes of the track; along it nothing grows
    const double        c = std::cos(placement.turn), s = std::sin(placement.turn);
    std::vector<Point2> growth;
    for (std::size_t j = 0; j < placement.arcs.size(); ++j)
      {
        // the same weights as of displacements under loads
        Point2 sum;
        for (int r = 0; r < rows.count; ++r)
          sum = sum + rows.weights[j * rows.count + r] * rate * rate * table.rows[rows.first + r].growth;
        // the table has the growth at 1 rad/s; it goes with omega^2
        growth.push_back({c * sum.x - s * sum.y, s * sum.x + c * sum.y});
      }
    return growth;
  }
} // namespace wheelrail
