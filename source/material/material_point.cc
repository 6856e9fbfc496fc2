#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/material/material_point.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

// One point of a steel under given strains and stresses, by the very code of the elements: strains whose
// stress is wanted are found by Newton's method.

namespace wheelrail
{
  namespace
  {
    /// Solves A x = b for as many unknowns as b has, by elimination with pivots of the columns; A in rows.
    std::vector<double>
    solve(std::vector<std::vector<double>> A, std::vector<double> b)
    {
      const std::size_t n = b.size();
      for (std::size_t k = 0; k < n; ++k)
        {
          std::size_t pivot = k;
          for (std::size_t i = k + 1; i < n; ++i)
            if (std::abs(A[i][k]) > std::abs(A[pivot][k]))
              pivot = i;
          std::swap(A[k], A[pivot]);
          std::swap(b[k], b[pivot]);
          for (std::size_t i = k + 1; i < n; ++i)
            {
              // Gauss's elimination with partial pivoting
              const double factor = A[i][k] / A[k][k];
              for (std::size_t j = k; j < n; ++j)
                A[i][j] -= factor * A[k][j];
              b[i] -= factor * b[k];
            }
        }
      // back substitution
      for (std::size_t k = n; k-- > 0;)
        {
          for (std::size_t j = k + 1; j < n; ++j)
            b[k] -= A[k][j] * b[j];
          b[k] /= A[k][k];
        }
      return b;
    }

    double
    largest(const std::vector<double> &values)
    {
      double most = 0;
      for (const double value : values)
        // a stress that is no number counts as infinitely far off: the step is halved
        most = std::isfinite(value) ? std::max(most, std::abs(value)) : HUGE_VAL;
      return most;
    }
  } // namespace


  MaterialPoint::MaterialPoint(const MaterialLaw &law)
    : law_(law)
    , rows_(history_rows(law), 0.)
  {
  }


  MaterialPoint::Response
  MaterialPoint::respond(const SixNumbers &strain) const
  {
    const auto of_law = [&](const auto &law) {
      using Law = std::decay_t<decltype(law)>;
      typename Law::template History<Simd<1>> history(law);
      Response                                response;
      response.rows = rows_;
      // always from the history before this step: respond() changes nothing of the point
      history.load(rows_.data());
      Simd<1> E[6], S[6], work = 0.;
      for (int k = 0; k < 6; ++k)
        E[k] = strain[k];
      // one step of the law (doc/manual/material.md, Theory): Green's strain E to the second Piola-Kirchhoff
      // stress S, components xx, yy, zz, yz, xz, xy of the tensor, and the plastic work of the step
      point_response(law, E, history, S, work);
      for (int k = 0; k < 6; ++k)
        response.stress[k] = S[k][0];
      history.store(response.rows.data());
      response.work = work[0];
      if constexpr (has_history<Law>)
        {
          // a = integral of sqrt(2/3 dE_p : dE_p)
          response.accumulated = history.accumulated[0];
          response.hardening   = law.hardening_energy(history)[0];
        }
      return response;
    };
    return std::visit(of_law, law_);
  }


  std::vector<std::vector<double>>
  MaterialPoint::slope_of_stress(const SixNumbers               &strain,
                                 const Response                 &response,
                                 const std::vector<std::size_t> &free,
                                 const std::vector<double>      &miss) const
  {
    constexpr double                 probe = 1e-8;
    std::vector<std::vector<double>> slope(free.size(), std::vector<double>(free.size()));
    for (std::size_t j = 0; j < free.size(); ++j)
      {
        // six columns at most: the law has no tangent of its own, since the explicit kernels need none
        SixNumbers probed = strain;
        // towards the wanted stress, so that the slope is that of flow when that goes on
        const double step = miss[j] < 0 ? -probe : probe;
        probed[free[j]] += step;
        // dS_i/dE_j by a one-sided difference of 1e-8, about the root of round-off: the law has a corner at
        // yield, where a central one would mix elastic and plastic slopes
        const Response there = respond(probed);
        for (std::size_t i = 0; i < free.size(); ++i)
          slope[i][j] = (there.stress[free[i]] - response.stress[free[i]]) / step;
      }
    return slope;
  }


  void
  MaterialPoint::go_to(const PointTarget &target)
  {
    // free components: E_k such that S_k = wanted; the others are given. Newton's method, steps halved until
    // the largest missing stress falls. Each try is one step of the law from the same history, so that tries
    // leave no trace.
    const double             enough = 1e-13 * elasticity(law_).youngs_modulus;
    std::vector<std::size_t> free;
    SixNumbers               strain = strain_;
    for (std::size_t k = 0; k < 6; ++k)
      if (target.of_stress[k])
        free.push_back(k);
      else
        strain[k] = target.value[k];
    // wanted less present stress of the free components [Pa]
    const auto missing = [&](const Response &response) {
      std::vector<double> values;
      for (const std::size_t k : free)
        values.push_back(target.value[k] - response.stress[k]);
      return values;
    };

    Response            response = respond(strain);
    std::vector<double> miss     = missing(response);
    for (int iteration = 0; largest(miss) > enough; ++iteration)
      {
        // dE = (dS/dE)^-1 (wanted - S)
        const std::vector<double> change = solve(slope_of_stress(strain, response, free, miss), miss);
        const double              before = largest(miss);
        double                    part   = 1;
        for (int halving = 0; halving < 40 && !(largest(miss) < before); ++halving, part *= 0.5)
          {
            SixNumbers next = strain;
            for (std::size_t j = 0; j < free.size(); ++j)
              next[free[j]] += part * change[j];
            Response            there         = respond(next);
            std::vector<double> missing_there = missing(there);
            if (largest(missing_there) < before)
              {
                strain   = next;
                response = std::move(there);
                miss     = std::move(missing_there);
              }
          }
        if (iteration < 60 && largest(miss) < before)
          continue;
        if (before < 1e4 * enough)
          break; // as near as round-off lets it come
        throw RunError(
          text("no strain gives the stresses that are asked for, %.4g MPa are missing: the steel does "
               "not bear more",
               1e-6 * before));
      }
    strain_      = strain;
    stress_      = response.stress;
    rows_        = std::move(response.rows);
    accumulated_ = response.accumulated;
    hardening_   = response.hardening;
    // integral of S : dE_p [J/m3]
    work_ += response.work;
  }


  SixNumbers
  MaterialPoint::plastic_strain() const
  {
    const Elasticity &constants = elasticity(law_);
    const double      nu        = constants.poissons_ratio;
    // of the present state alone, so that it serves all laws
    const double trace   = stress_[0] + stress_[1] + stress_[2];
    SixNumbers   plastic = strain_;
    for (std::size_t k = 0; k < 6; ++k)
      // E_p = E - S/(2 mu) + nu/E tr(S) I: Hooke's law inverted, E_e = ((1 + nu) S - nu tr(S) I)/E
      plastic[k] -= ((1 + nu) * stress_[k] - (k < 3 ? nu * trace : 0.)) / constants.youngs_modulus;
    return plastic;
  }
} // namespace wheelrail
