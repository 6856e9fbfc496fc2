#include <wheelrail/receptance/track_waves.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/lapack_templates.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using SeatComplex = std::complex<double>;
    using SeatWaves   = std::vector<SectionWaves::Wave>;

    /// What a seat can do: a force of the foot, even over the length of the pad or tilting over it.
    struct SeatForce
    {
      FootForce    force;
      Spread::Kind spread;
    };
    constexpr SeatForce    seat_forces[] = {{normal_even, Spread::even},
                                            {normal_even, Spread::tilt},
                                            {normal_tilt, Spread::even},
                                            {normal_bend, Spread::even},
                                            {across_even, Spread::even},
                                            {along_even, Spread::even},
                                            {along_tilt, Spread::even}};
    constexpr unsigned int n_seat        = 7;
    using SeatMatrix                     = std::array<std::array<SeatComplex, n_seat>, n_seat>;

    /// Means of waves over two pads, even or tilting each, one `ahead` of the other [m].
    class SeatMeans
    {
    public:
      SeatMeans(const Spread &even, const Spread &tilt, const double ahead, const SeatWaves &waves)
      {
        const Spread *const of[] = {&even, &tilt};
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2; ++b)
            for (int odd = 0; odd < 2; ++odd)
              {
                const SpreadPair pair(*of[a], *of[b], ahead, odd);
                for (const auto &wave : waves)
                  means_[a][b][odd].push_back(pair.mean(wave.k));
              }
      }

      const std::vector<SeatComplex> &
      operator()(const Spread::Kind a, const Spread::Kind b, const bool odd) const
      {
        return means_[a == Spread::tilt][b == Spread::tilt][odd];
      }

    private:
      std::vector<SeatComplex> means_[2][2][2];
    };

    bool
    is_along(const FootForce force)
    {
      return force == along_even || force == along_tilt;
    }

    /// Pads and sleepers below them, one behind the other: force on the rail over its displacement, negative.
    SeatMatrix
    seat_stiffness(const TrackData                &track,
                   const std::vector<SeatComplex> &pads,
                   const std::array<Vector3, 2>   &foot,
                   const SeatComplex               w)
    {
      SeatMatrix z{};
      for (unsigned int i = 0; i < n_seat; ++i)
        z[i][i] = pads[seat_forces[i].force];
      if (track.rigid_sleepers)
        return z;
      // a sleeper moves without turning
      constexpr unsigned int moves[3] = {4, 0, 5};
      const Vector3          axes[3]  = {foot[0], foot[1], {0, 0, 1}};
      using Matrix                    = dealii::Tensor<2, 3, SeatComplex>;
      Matrix sleeper, both;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int a = 0; a < 3; ++a)
            sleeper[i][j] += axes[i][a] * axes[j][a] *
                             (track.ballast[a] * (1. + SeatComplex(0, 1) * w * track.ballast_damper) -
                              w * w * track.sleeper_mass);
      both = sleeper;
      for (int i = 0; i < 3; ++i)
        both[i][i] += pads[seat_forces[moves[i]].force];
      const Matrix behind = dealii::invert(both) * sleeper;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          z[moves[i]][moves[j]] = pads[seat_forces[moves[i]].force] * behind[i][j];
      return z;
    }

    void
    solve_in_place(std::vector<SeatComplex> &matrix, std::vector<SeatComplex> &values)
    {
      const int        n = values.size(), one = 1;
      int              code = 0;
      std::vector<int> pivot(n);
      dealii::getrf(&n, &n, matrix.data(), &n, pivot.data(), &code);
      dealii::getrs("N", &n, &one, matrix.data(), &n, pivot.data(), values.data(), &n, &code);
    }

    /// What a seat moves under the forces of another, by how many bays it is ahead of it. `pads`: even and
    /// tilting; pairs of them are few.
    std::vector<SeatMatrix>
    seats_between(const SectionWaves          &section,
                  const unsigned int           first_foot,
                  const SeatWaves             &waves,
                  const std::array<Spread, 2> &pads,
                  const double                 spacing,
                  const int                    seats)
    {
      const SeatMeans          here(pads[0], pads[1], 0, waves), ahead(pads[0], pads[1], spacing, waves);
      std::vector<SeatComplex> factors, bay;
      for (const auto &wave : waves)
        bay.push_back(std::exp(SeatComplex(0, -spacing) * wave.k));
      std::vector<SeatMatrix> between(seats);
      for (unsigned int i = 0; i < n_seat; ++i)
        for (unsigned int j = 0; j < n_seat; ++j)
          {
            const bool odd = is_along(seat_forces[i].force) != is_along(seat_forces[j].force);
            for (int bays = 0; bays < seats; ++bays)
              {
                if (bays < 2)
                  factors = (bays == 0 ? here : ahead)(seat_forces[i].spread, seat_forces[j].spread, odd);
                else
                  for (std::size_t m = 0; m < waves.size(); ++m)
                    factors[m] *= bay[m];
                between[bays][i][j] = section.response(
                  waves, first_foot + seat_forces[i].force, first_foot + seat_forces[j].force, factors);
              }
          }
      return between;
    }

    /// 1 + G Z of all seats, column after column; G by how many bays one is ahead of the other.
    std::vector<SeatComplex>
    seat_equations(const std::vector<SeatMatrix> &between, const SeatMatrix &z)
    {
      const int                seats = between.size(), n = n_seat * seats;
      std::vector<SeatComplex> matrix(std::size_t(n) * n, 0.);
      for (int a = 0; a < seats; ++a)
        for (int b = 0; b < seats; ++b)
          for (unsigned int i = 0; i < n_seat; ++i)
            for (unsigned int j = 0; j < n_seat; ++j)
              {
                SeatComplex sum = a == b && i == j ? 1 : 0;
                for (unsigned int l = 0; l < n_seat; ++l)
                  sum += (a >= b ? between[a - b][i][l] : between[b - a][l][i]) * z[l][j];
                matrix[n_seat * a + i + std::size_t(n) * (n_seat * b + j)] = sum;
              }
      return matrix;
    }
  } // namespace


  /// Forces of seats on the free rail, -Z times what the rail moves there: (1 + G Z) u = G F.
  void
  TrackWaves::add_sleepers(const SeatComplex w, const SeatWaves &waves, std::vector<SeatComplex> &moved) const
  {
    constexpr int each_side = 15;
    const double  middle = face_place_.front(), spacing = track_.spacing;
    const double  nearest = std::round((middle - track_.first) / spacing);
    const int     seats = 2 * each_side + 1, n = n_seat * seats;
    const auto place  = [&](const int seat) { return track_.first + (nearest + seat - each_side) * spacing; };
    const auto spread = [&](const unsigned int i) {
      return Spread{seat_forces[i].spread, 0.5 * track_.pad_length};
    };
    std::vector<SeatComplex> factors(waves.size());

    const std::vector<SeatMatrix> between =
      seats_between(*waves_, first_foot_, waves, {{spread(0), spread(1)}}, spacing, seats);

    // from a force at a face to the seats: symmetric, so that it is also from seats to the face
    const double                            reach = 0.5 * track_.pad_length + face_spread_.half;
    std::array<std::vector<SeatComplex>, 2> far; // even and tilting pads that the face does not lie above
    for (unsigned int i = 0; i < 2; ++i)
      {
        const SpreadPair pair(spread(i), face_spread_, reach, false);
        for (const auto &wave : waves)
          far[i].push_back(pair.mean(wave.k) * std::exp(SeatComplex(0, reach) * wave.k));
      }
    const auto to_seats = [&](const unsigned int face, const double at) {
      std::vector<SeatComplex> g(n);
      for (int s = 0; s < seats; ++s)
        {
          const double             away = place(s) - at;
          std::vector<SeatComplex> between_them;
          if (std::abs(away) >= reach)
            for (const auto &wave : waves)
              between_them.push_back(std::exp(SeatComplex(0, -std::abs(away)) * wave.k));
          for (unsigned int i = 0; i < n_seat; ++i)
            {
              const bool odd = is_along(seat_forces[i].force), tilts = seat_forces[i].spread == Spread::tilt;
              if (between_them.empty())
                {
                  const SpreadPair pair(spread(i), face_spread_, away, odd);
                  for (std::size_t m = 0; m < waves.size(); ++m)
                    factors[m] = pair.mean(waves[m].k);
                }
              else
                for (std::size_t m = 0; m < waves.size(); ++m)
                  factors[m] = (away < 0 && odd != tilts ? -1. : 1.) * far[tilts][m] * between_them[m];
              g[n_seat * s + i] = waves_->response(waves, first_foot_ + seat_forces[i].force, face, factors);
            }
        }
      return g;
    };
    const SeatMatrix         z      = seat_stiffness(track_, pad_stiffness(w), axes_, w);
    std::vector<SeatComplex> matrix = seat_equations(between, z);
    std::vector<SeatComplex> rail   = to_seats(face_force_[0], middle);
    solve_in_place(matrix, rail);
    for (std::size_t f = 0; f < face_place_.size(); ++f)
      {
        const auto g = to_seats(face_force_[f], face_place_[f]);
        for (int s = 0; s < seats; ++s)
          for (unsigned int i = 0; i < n_seat; ++i)
            for (unsigned int j = 0; j < n_seat; ++j)
              moved[f] -= g[n_seat * s + i] * z[i][j] * rail[n_seat * s + j];
      }
  }
} // namespace wheelrail
