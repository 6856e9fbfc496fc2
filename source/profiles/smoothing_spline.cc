#include <wheelrail/base/errors.h>
#include <wheelrail/profiles/measurement_noise.h>
#include <wheelrail/profiles/smoothing_spline.h>

#include <gsl/gsl_bspline.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace wheelrail
{
  namespace
  {
    constexpr std::size_t order = 4; // cubic

    template <typename T, void (*release)(T *)>
    struct Release
    {
      void
      operator()(T *p) const
      {
        release(p);
      }
    };
    using Matrix = std::unique_ptr<gsl_matrix, Release<gsl_matrix, gsl_matrix_free>>;
    using Vector = std::unique_ptr<gsl_vector, Release<gsl_vector, gsl_vector_free>>;
    using Workspace =
      std::unique_ptr<gsl_bspline_workspace, Release<gsl_bspline_workspace, gsl_bspline_free>>;

    /// Values of the four B-splines that are not zero at s, or of a derivative of them.
    struct Basis
    {
      std::size_t first = 0;
      double      derivative[order][order]; ///< [B-spline][derivative]
    };

    /// The points of one smooth stretch in millimetres, with their chord lengths.
    struct Stretch
    {
      std::vector<Point2> points;
      std::vector<double> s, breaks, noise; ///< noise of the points [mm]
      bool                fixed_begin = false, fixed_end = false;
    };

    /// The spline of one stretch while it is fitted.
    class Fit
    {
    public:
      explicit Fit(const Stretch &stretch)
        : stretch_(stretch)
        , space_(gsl_bspline_alloc(order, stretch.breaks.size()))
        , derivatives_(gsl_matrix_alloc(order, order))
        , size_(stretch.breaks.size() + order - 2)
      {
        Vector breaks(gsl_vector_alloc(stretch.breaks.size()));
        for (std::size_t i = 0; i < stretch.breaks.size(); ++i)
          gsl_vector_set(breaks.get(), i, stretch.breaks[i]);
        gsl_bspline_knots(breaks.get(), space_.get());
        for (const double s : stretch.s)
          at_points_.push_back(basis(s));
        for (std::size_t j = 0; j + 1 < stretch.breaks.size(); ++j)
          in_intervals_.push_back(basis(0.5 * (stretch.breaks[j] + stretch.breaks[j + 1])));
      }

      Basis
      basis(const double s) const
      {
        Basis       result;
        std::size_t last = 0;
        gsl_bspline_deriv_eval_nonzero(s, order - 1, derivatives_.get(), &result.first, &last, space_.get());
        for (std::size_t i = 0; i < order; ++i)
          for (std::size_t k = 0; k < order; ++k)
            result.derivative[i][k] = gsl_matrix_get(derivatives_.get(), i, k);
        return result;
      }

      /// Point or derivative of the spline.
      Point2
      value(const Basis &b, const std::size_t derivative) const
      {
        Point2 sum;
        for (std::size_t i = 0; i < order; ++i)
          sum = sum + b.derivative[i][derivative] *
                        Point2{gsl_vector_get(x_.get(), b.first + i), gsl_vector_get(y_.get(), b.first + i)};
        return sum;
      }

      /// Unit tangent.
      Point2
      direction(const Basis &b) const
      {
        const Point2 v = value(b, 1);
        return (1 / norm(v)) * v;
      }

      /// Third derivative along the curve, minus the square of the curvature on an arc, and across, by which
      /// the curvature changes [1/mm2].
      Point2
      change_of_curve(const Basis &b) const
      {
        return {dot(direction(b), value(b, 3)), cross(direction(b), value(b, 3))};
      }

      /// Least squares of the distances over the noise plus the integral of |r'''|^2 / tau^2, with
      /// one tau for each interval [1/mm2]. `random`: one of the curves among which the profile then lies is
      /// drawn (Wahba 1983): points are off by their noise, r''' by tau over the root of the interval, from
      /// what bends the fitted curve on as it is bent.
      bool
      solve(const std::vector<double> &tau, std::mt19937_64 *const random = nullptr)
      {
        Matrix              band(gsl_matrix_calloc(size_, order));
        std::vector<Point2> to(in_intervals_.size());
        for (std::size_t j = 0; j < to.size() && random != nullptr; ++j)
          to[j] = change_of_curve(in_intervals_[j]).x * direction(in_intervals_[j]);
        x_.reset(gsl_vector_calloc(size_));
        y_.reset(gsl_vector_calloc(size_));
        std::normal_distribution<double> normal;
        const auto                       off = [&](const double deviation) {
          return random != nullptr ? Point2{deviation * normal(*random), deviation * normal(*random)}
                                                         : Point2();
        };
        const auto add =
          [&](const Basis &b, const std::size_t derivative, const double weight, const Point2 &at) {
            for (std::size_t i = 0; i < order; ++i)
              {
                const double w = weight * b.derivative[i][derivative];
                for (std::size_t k = i; k < order; ++k) // the lower triangle: row b + k, column b + i
                  *gsl_matrix_ptr(band.get(), b.first + i, k - i) += w * b.derivative[k][derivative];
                *gsl_vector_ptr(x_.get(), b.first + i) += w * at.x;
                *gsl_vector_ptr(y_.get(), b.first + i) += w * at.y;
              }
          };
        for (std::size_t p = 0; p < at_points_.size(); ++p)
          {
            const bool fixed =
              (p == 0 && stretch_.fixed_begin) || (p + 1 == at_points_.size() && stretch_.fixed_end);
            const double noise = stretch_.noise[p] * (fixed ? 1e-4 : 1);
            add(at_points_[p], 0, 1 / (noise * noise), stretch_.points[p] + off(noise));
          }
        for (std::size_t j = 0; j < in_intervals_.size(); ++j)
          {
            const double h = stretch_.breaks[j + 1] - stretch_.breaks[j];
            add(in_intervals_[j], 3, h / (tau[j] * tau[j]), to[j] + off(tau[j] / std::sqrt(h)));
          }
        return gsl_linalg_cholesky_band_decomp(band.get()) == GSL_SUCCESS &&
               gsl_linalg_cholesky_band_svx(band.get(), x_.get()) == GSL_SUCCESS &&
               gsl_linalg_cholesky_band_svx(band.get(), y_.get()) == GSL_SUCCESS;
      }

      /// Root mean square of the third derivative, or of its part across, over 0.7 mm, or three intervals, on
      /// both sides.
      std::vector<double>
      roughness(const bool across) const
      {
        const std::size_t   n = in_intervals_.size();
        std::vector<double> squares, result(n);
        for (const Basis &b : in_intervals_)
          {
            const Point2 change = change_of_curve(b);
            squares.push_back(across ? change.y * change.y : dot(change, change));
          }
        const std::vector<double> &breaks = stretch_.breaks;
        for (std::size_t j = 0; j < n; ++j)
          {
            std::size_t first = j, last = j;
            while (first > 0 && (j - first < 1 || breaks[j] - breaks[first] < 0.7))
              --first;
            while (last + 1 < n && (last - j < 1 || breaks[last + 1] - breaks[j + 1] < 0.7))
              ++last;
            double sum = 0, length = 0;
            for (std::size_t k = first; k <= last; ++k)
              {
                sum += squares[k] * (breaks[k + 1] - breaks[k]);
                length += breaks[k + 1] - breaks[k];
              }
            result[j] = std::sqrt(sum / length);
          }
        return result;
      }

      /// The pieces in metres.
      void
      append(std::vector<Segment> &segments) const
      {
        for (std::size_t j = 0; j + 1 < stretch_.breaks.size(); ++j)
          {
            const double h     = stretch_.breaks[j + 1] - stretch_.breaks[j];
            const Basis  begin = basis(stretch_.breaks[j]);
            // the third derivative jumps at the knots: taken inside
            const Point2 r = value(begin, 0), v = h * value(begin, 1), a = (0.5 * h * h) * value(begin, 2),
                         c = (h * h * h / 6) * value(in_intervals_[j], 3);
            Segment g;
            g.kind           = Segment::Kind::spline;
            g.name           = "measured";
            g.coefficients_x = {1e-3 * r.x, 1e-3 * v.x, 1e-3 * a.x, 1e-3 * c.x};
            g.coefficients   = {1e-3 * r.y, 1e-3 * v.y, 1e-3 * a.y, 1e-3 * c.y};
            g.start          = position_on(g, 0);
            g.end            = position_on(g, 1);
            segments.push_back(g);
          }
      }

    private:
      const Stretch     &stretch_;
      Workspace          space_;
      Matrix             derivatives_;
      std::size_t        size_;
      Vector             x_, y_;
      std::vector<Basis> at_points_, in_intervals_;
    };

    /// Points first to last. In gaps (of steps `usual` [m]) lie knots, too: there the curvature may change
    /// anywhere.
    Stretch
    make_stretch(const std::vector<Point2> &points,
                 const std::vector<double> &noise,
                 const std::size_t          first,
                 const std::size_t          last,
                 const double               usual)
    {
      // knots at the points, but not closer than this; below the finest radius of a profile
      constexpr double least = 0.25, in_gap = 0.5;
      Stretch          stretch;
      for (std::size_t i = first; i <= last; ++i)
        {
          stretch.points.push_back(1e3 * points[i]);
          stretch.noise.push_back(std::max(1e3 * noise[i], 2e-5));
          stretch.s.push_back(i == first ? 0 : stretch.s.back() + 1e3 * norm(points[i] - points[i - 1]));
        }
      for (std::size_t k = 0; k < stretch.s.size(); ++k)
        {
          const double s = stretch.s[k];
          if (k > 0 && is_gap(1e-3 * (s - stretch.s[k - 1]), usual))
            {
              const double begin = stretch.breaks.back();
              const int    n     = static_cast<int>((s - begin) / in_gap);
              for (int i = 1; i < n; ++i)
                stretch.breaks.push_back(begin + (s - begin) * i / n);
            }
          if (stretch.breaks.empty() || s - stretch.breaks.back() >= least)
            stretch.breaks.push_back(s);
        }
      if (stretch.breaks.back() < stretch.s.back())
        {
          if (stretch.breaks.size() > 2)
            stretch.breaks.pop_back();
          stretch.breaks.push_back(stretch.s.back());
        }
      stretch.fixed_begin = first > 0;
      stretch.fixed_end   = last + 1 < points.size();
      return stretch;
    }

    void
    fit_stretch(const Stretch &stretch, std::mt19937_64 *const random, std::vector<Segment> &segments)
    {
      // The first fit has the tau at which noise alone makes a third derivative of 1e-3 / mm2, far
      // below that of the joints of a profile; the floor of the later ones is a change of curvature
      // of 2e-4 / mm over one mm.
      constexpr double    noise_roughness = 1e-3, floor = 2e-4;
      const double        step = stretch.s.back() / static_cast<double>(stretch.s.size() - 1);
      Fit                 fit(stretch);
      std::vector<double> tau;
      for (std::size_t j = 0, p = 0; j + 1 < stretch.breaks.size(); ++j)
        {
          while (stretch.s[p] < stretch.breaks[j])
            ++p;
          const double power = stretch.noise[p] * stretch.noise[p] * step;
          const double scale = std::pow(0.0555 * power / (noise_roughness * noise_roughness), 1. / 7);
          tau.push_back(std::sqrt(power) / std::pow(scale, 3));
        }
      bool good = fit.solve(tau);
      for (int i = 0; i < 4 && good; ++i)
        {
          tau = fit.roughness(false);
          for (double &t : tau)
            t = std::max(t, floor);
          good = fit.solve(tau);
        }
      if (good && random != nullptr)
        {
          // the smoothed curve is not as rough as the profile
          tau = fit.roughness(true);
          for (double &t : tau)
            t = 2 * std::max(t, floor);
          good = fit.solve(tau, random);
        }
      if (!good)
        throw InputError(
          "the smoothing of the profile failed, since its points are too uneven: give points at "
          "steps of 0.2 mm to 1 mm, or set Profiles/Smoothing to another length");
      fit.append(segments);
    }
  } // namespace


  double
  median_step(const std::vector<Point2> &points)
  {
    std::vector<double> steps;
    for (std::size_t i = 1; i < points.size(); ++i)
      steps.push_back(norm(points[i] - points[i - 1]));
    return median(steps);
  }


  bool
  is_gap(const double step, const double usual)
  {
    return step >= 2e-3 && step >= 4 * usual;
  }


  std::vector<Segment>
  smoothing_spline(const std::vector<Point2>      &points,
                   const std::vector<std::size_t> &kinks,
                   const std::vector<double>      &noise,
                   const unsigned int              draw)
  {
    // GSL's own handler ends the program; failures are told by the return values.
    gsl_set_error_handler_off();
    std::vector<std::size_t> ends = kinks;
    ends.push_back(points.size() - 1);
    std::vector<Segment> segments;
    std::size_t          first = 0;
    std::mt19937_64      random(draw);
    const double         usual = median_step(points);
    for (const std::size_t last : ends)
      {
        if (last < first + 3)
          throw InputError("between two kinks of the profile lie fewer than four points: measure denser");
        fit_stretch(make_stretch(points, noise, first, last, usual), draw > 0 ? &random : nullptr, segments);
        first = last;
      }
    return segments;
  }


  std::vector<std::size_t>
  find_kinks(const std::vector<Point2> &points, const std::vector<double> &noise)
  {
    const double degree = M_PI / 180;
    const auto   n      = static_cast<std::ptrdiff_t>(points.size());

    // turn between the chords of at least `length` to both sides; nothing beyond the ends
    const auto turn = [&](const std::ptrdiff_t i, const double length) {
      std::ptrdiff_t a = i - 1, b = i + 1;
      while (a > 0 && norm(points[a] - points[i]) < length)
        --a;
      while (b + 1 < n && norm(points[b] - points[i]) < length)
        ++b;
      const Point2 before = points[i] - points[a], after = points[b] - points[i];
      return std::abs(std::atan2(cross(before, after), dot(before, after)));
    };

    std::vector<std::size_t> kinks;
    double                   strongest = 0;
    for (std::ptrdiff_t i = 4; i + 4 < n; ++i)
      {
        const double step = std::max(norm(points[i] - points[i - 1]), norm(points[i + 1] - points[i]));
        // the turn between chords of a length l has a deviation of sqrt(6) noise / l
        const double length = std::max({0.5e-3, 1.01 * step, 6 * std::sqrt(6.) / (20 * degree) * noise[i]});
        const double near = turn(i, length), far = turn(i, 2 * length);
        // on an arc the turn doubles with the length
        if (near < 20 * degree || far > 1.4 * near)
          continue;
        if (!kinks.empty() && i - static_cast<std::ptrdiff_t>(kinks.back()) < 4)
          {
            if (near <= strongest)
              continue;
            kinks.pop_back();
          }
        kinks.push_back(i);
        strongest = near;
      }
    return kinks;
  }
} // namespace wheelrail
