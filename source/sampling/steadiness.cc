#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/sampling/steadiness.h>

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wheelrail
{
  namespace
  {
    /// What a result is judged by.
    enum class ScaleOf
    {
      force,    ///< friction times load
      creepage, ///< its value at half saturation
      moment,   ///< friction times load times half of the gauge
      torque,   ///< friction times load times the wheel's radius
      itself,   ///< its mean
      length,   ///< of the patch along the track
      width,    ///< and across it
      shear,    ///< friction times peak pressure
      one,      ///< shares
      t_gamma   ///< force times creepage, each at its scale
    };

    /// A result of the summary that is a mean of the rows.
    struct Reported
    {
      const char *figure;
      bool        of_patch; ///< its column is in the history of the patch
      ScaleOf     scale;
      double      of_load;   ///< relative change with the load: that of Hertz's theory
      double      of_torque; ///< change over its scale with the force, over the friction bound
      bool        settles;   ///< settled_after asks for it
    };

    // of_torque of creepage and T-gamma follows from the slope of the creep curve and is not written here
    constexpr Reported reported[] = {{"normal_force", false, ScaleOf::force, 1, 0, true},
                                     {"vertical_force", false, ScaleOf::force, 1, 0, false},
                                     {"longitudinal_force", false, ScaleOf::force, 0, 1, true},
                                     {"lateral_force", false, ScaleOf::force, 0, 0, false},
                                     {"creepage", false, ScaleOf::creepage, 0, 0, true},
                                     {"yaw_moment", false, ScaleOf::moment, 0, 1, false},
                                     {"drive_torque", false, ScaleOf::torque, 0, 0, false},
                                     {"max_pressure", true, ScaleOf::itself, 1. / 3, 0, false},
                                     {"max_pressure_fitted", true, ScaleOf::itself, 1. / 3, 0, true},
                                     {"contact_area", true, ScaleOf::itself, 2. / 3, 0, true},
                                     {"patch_lateral", true, ScaleOf::itself, 1. / 3, 0, false},
                                     {"patch_longitudinal", true, ScaleOf::itself, 1. / 3, 0, false},
                                     {"patch_centre_lateral", true, ScaleOf::width, 0, 0, false},
                                     {"patch_centre_longitudinal", true, ScaleOf::length, 0, 0, false},
                                     {"max_shear_traction", true, ScaleOf::shear, 1. / 3, 1, true},
                                     {"stick_fraction", true, ScaleOf::one, 0, 1, false},
                                     {"t_gamma", true, ScaleOf::t_gamma, 0, 0, false}};

    /// Friction that counts where there is less: results of a hardly rubbing contact are not asked to be
    /// better known than those of a usual one.
    constexpr double least_friction = 0.1;
    /// Of rail head and wheel rim against each other in series, about: 1.8 m of 54E1 clamped at its foot and
    /// ends and a wheel with a straight web [N/m]. Wheel and rail creep sideways over C22 G a b over it.
    constexpr double lateral_stiffness = 6e7;
    /// What slopes may leave open, in wanted standard errors.
    constexpr double most_drift = 6;

    /// Means of a stretch that the scales are made of.
    class Scales
    {
    public:
      Scales(const History &history, const History &patches, const SteadyBasis &basis, const Range &stretch)
        : radius_(basis.radius)
      {
        const auto mean = [&](const History &table, const char *name) {
          return mean_over(column(table, "rolled_distance"), column(table, name), stretch).mean;
        };
        length_   = mean(patches, "patch_longitudinal");
        width_    = mean(patches, "patch_lateral");
        pressure_ = mean(patches, "max_pressure_fitted");
        force_    = mean(history, "longitudinal_force");
        friction_ = std::max(basis.friction, least_friction);
        normal_   = mean(history, "normal_force");
        creep     = creep_scale(friction_ * normal_, basis.shear_modulus, length_, width_);
      }

      double
      of(const Reported &result, const double mean) const
      {
        constexpr double half_gauge = 0.75;
        const double     bound      = friction_ * normal_;
        switch (result.scale)
          {
            case ScaleOf::force:
              return bound;
            case ScaleOf::creepage:
              return creep.half_saturation();
            case ScaleOf::moment:
              return bound * half_gauge;
            case ScaleOf::torque:
              return bound * radius_;
            case ScaleOf::itself:
              return std::max(std::abs(mean), 1e-300);
            case ScaleOf::length:
              return length_;
            case ScaleOf::width:
              return width_;
            case ScaleOf::shear:
              return friction_ * pressure_;
            case ScaleOf::one:
              return 1;
            case ScaleOf::t_gamma:
              return bound * creep.half_saturation(); // no better known than its factors
          }
        return 1;
      }

      /// Change of a result over its scale with a force that is off by the share 1 of the friction bound.
      double
      of_torque(const Reported &result) const
      {
        // the creepage moves on along the creep curve until the force fits
        const double slope = creep.stiffness * std::max(creep.tangent(force_), 1e-3);
        const double moved = friction_ * normal_ / slope / creep.half_saturation();
        if (result.scale == ScaleOf::creepage)
          return moved;
        if (result.scale == ScaleOf::t_gamma)
          return std::abs(force_) / (friction_ * normal_) * (1 + moved);
        return result.of_torque;
      }

      /// The path over which wheel and rail creep sideways to their lateral force.
      double
      lateral_length() const
      {
        return creep.lateral * creep.tangent(force_) / lateral_stiffness;
      }

      double
      friction_bound() const
      {
        return friction_ * normal_;
      }
      double
      force() const
      {
        return force_;
      }

    private:
      double     length_, width_, pressure_, force_, friction_, normal_, radius_;
      CreepScale creep;
    };

    std::string
    per_cent(const double share)
    {
      return text("%.2f %%", 100 * share);
    }

    /// Integral of values that are straight between their distances, from the first of them to any place.
    class Integral
    {
    public:
      Integral(const std::vector<double> &distance, const std::vector<double> &values)
        : distance_(distance)
        , values_(values)
        , sum_(values.size(), 0.)
      {
        for (std::size_t k = 1; k < values.size(); ++k)
          sum_[k] = sum_[k - 1] + 0.5 * (values[k - 1] + values[k]) * (distance[k] - distance[k - 1]);
      }

      double
      to(const double place) const
      {
        const auto above = std::upper_bound(distance_.begin(), distance_.end(), place);
        if (above == distance_.begin())
          return values_.front() * (place - distance_.front()); // as the first value before it
        const std::size_t k    = std::size_t(above - distance_.begin()) - 1;
        const double      rest = place - distance_[k];
        if (above == distance_.end())
          return sum_[k] + values_[k] * rest;
        const double slope = (values_[k + 1] - values_[k]) / (distance_[k + 1] - distance_[k]);
        return sum_[k] + rest * (values_[k] + 0.5 * slope * rest);
      }

    private:
      const std::vector<double> &distance_, &values_;
      std::vector<double>        sum_;
    };

    /// What a deviation that is known by so many degrees of freedom is multiplied with, so that twice of it
    /// leaves out as much of Student's distribution as two deviations do of the normal one.
    double
    enlarged(const std::size_t freedom)
    {
      constexpr double beyond_two = 0.0227501319; // of a normal distribution, on one side
      return 0.5 * gsl_cdf_tdist_Qinv(beyond_two, double(freedom));
    }

    /// Deviation of the means of blocks over the root of their number, and how well it is known.
    double
    error_of_blocks(const std::vector<double> &means, const std::size_t length, const std::size_t blocks)
    {
      const std::size_t   first = means.size() - blocks * length; // the last ones count
      std::vector<double> of_block(blocks, 0.);
      double              mean = 0, squares = 0;
      for (std::size_t b = 0; b < blocks; ++b)
        {
          for (std::size_t k = 0; k < length; ++k)
            of_block[b] += means[first + b * length + k] / double(length);
          mean += of_block[b] / double(blocks);
        }
      for (const double value : of_block)
        squares += (value - mean) * (value - mean);
      return std::sqrt(squares / double(blocks * (blocks - 1))) * enlarged(blocks - 1);
    }
  } // namespace


  double
  slow_length(const double velocity)
  {
    constexpr double frequency = 190;
    return velocity / (2 * M_PI * frequency);
  }


  double
  KnownResult::error() const
  {
    return std::hypot(noise, balance, trend);
  }


  Steadiness
  known_results(const History     &history,
                const History     &patches,
                const SteadyBasis &basis,
                const Range       &stretch)
  {
    Steadiness found;
    found.stretch       = stretch;
    const auto  &rolled = column(history, "rolled_distance");
    const Scales scales(history, patches, basis, stretch);
    if (std::isfinite(basis.load))
      found.load_miss = mean_over(rolled, column(history, "vertical_force"), stretch).mean / basis.load - 1;
    if (std::isfinite(basis.torque_force))
      found.torque_miss = (scales.force() - basis.torque_force) / scales.friction_bound();
    // two cells take out what repeats from cell to cell
    const double window = std::max(2e-3, 2 * basis.cell);
    for (const Reported &one : reported)
      {
        const History &table  = one.of_patch ? patches : history;
        const auto    &values = column(table, one.figure), &along = column(table, "rolled_distance");
        KnownResult    result;
        result.figure       = one.figure;
        result.mean         = mean_over(along, values, stretch);
        result.scale        = scales.of(one, result.mean.mean);
        result.of_patch     = one.of_patch;
        result.settles      = one.settles;
        result.noise        = standard_error(cell_means(along, values, stretch, basis.cell));
        result.balance      = std::hypot(one.of_load * found.load_miss * result.mean.mean,
                                    scales.of_torque(one) * found.torque_miss * result.scale);
        const Trend  trend  = trend_over(along, values, stretch, window);
        const double length = std::string(one.figure) == "lateral_force"
                                ? std::max(basis.slowest, scales.lateral_length())
                                : basis.slowest;
        // blocks of a stretch do not see what moves slower than it: its slope, known or not, is in the error
        // (doc/theory/accuracy.md); a run is kept going by slopes that are known alone
        result.trend = std::abs(trend.slope) * length;
        if (std::abs(trend.slope) > 2 * trend.slope_error)
          result.drift = result.trend;
        found.results.push_back(result);
      }
    return found;
  }


  namespace
  {
    /// The largest error that ends a run only when it is small, over what it may be; and which it is.
    double
    worst_of(const Steadiness &known, const double wanted, std::string &which)
    {
      double     worst = 0;
      const auto ask   = [&](const double share, const double allowed, const std::string &words) {
        if (!(share / allowed <= worst))
          {
            worst = share / allowed;
            which = words + " " + per_cent(share) + ", " + per_cent(allowed) + " asked for";
          }
      };
      for (const KnownResult &result : known.results)
        {
          const std::string label = figure_named(result.figure).label;
          ask(result.noise / result.scale, wanted, "noise of the " + label);
          ask(result.drift / result.scale, most_drift * wanted, "slope of the " + label);
        }
      ask(std::abs(known.load_miss), wanted, "vertical force against the load");
      ask(std::abs(known.torque_miss), wanted, "longitudinal force against the torque");
      return worst;
    }
  } // namespace


  Steadiness
  judge_steadiness(const History &history, const History &patches, const SteadyBasis &basis)
  {
    constexpr double least_cells = 8, least_of_patch = 0.75;
    Steadiness       best;
    best.open = "nothing has been recorded";
    if (history.columns.empty() || patches.columns.empty())
      return best;
    const double end   = column(history, "rolled_distance").back();
    const double patch = column(patches, "patch_longitudinal").back();
    const double first = std::max(basis.earliest, patch);
    const double least = std::max(least_cells, std::ceil(least_of_patch * patch / basis.cell));
    double       worst = std::numeric_limits<double>::infinity();
    best.open =
      "results are judged from " + in_mm(std::ceil(1e4 * (first + least * basis.cell)) / 1e4) + " rolled on";
    for (double cells = least; end - cells * basis.cell >= first * (1 - 1e-9); cells = std::ceil(1.2 * cells))
      {
        Steadiness   known = known_results(history, patches, basis, {end - cells * basis.cell, end});
        const double here  = worst_of(known, basis.standard_error, known.open);
        if (here <= 1)
          known.open.clear();
        if (here < worst)
          {
            worst = here;
            best  = std::move(known);
          }
      }
    return best;
  }


  std::vector<double>
  cell_means(const std::vector<double> &distance,
             const std::vector<double> &values,
             const Range               &stretch,
             const double               length)
  {
    if (values.empty())
      return {};
    const Integral integral(distance, values);
    const auto     cells = std::size_t(std::max(0., std::floor((stretch.s1 - stretch.s0) / length + 1e-6)));
    std::vector<double> means(cells);
    for (std::size_t k = 0; k < cells; ++k)
      {
        const double end = stretch.s1 - double(cells - 1 - k) * length;
        means[k]         = (integral.to(end) - integral.to(end - length)) / length;
      }
    return means;
  }


  double
  standard_error(const std::vector<double> &means)
  {
    constexpr std::size_t least = 4;
    if (means.size() < least)
      return std::numeric_limits<double>::infinity();
    double error = 0;
    for (std::size_t length = 1; means.size() / length >= least; ++length)
      error = std::max(error, error_of_blocks(means, length, means.size() / length));
    return error;
  }
} // namespace wheelrail
