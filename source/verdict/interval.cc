#include <wheelrail/base/format_text.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/verdict/interval.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    Contributions
    of_result(const std::string &result, const Contributions &contributions)
    {
      Contributions found;
      for (const Contribution &one : contributions)
        if (one.result == result)
          found.push_back(one);
      return found;
    }

    /// Whether an interval is wider than the result itself, one of the normal contact, which is never nought:
    /// it says nothing. Forces and creepages may be nought, and theirs does.
    bool
    says_nothing(const std::string &result, const double value, const Interval &interval)
    {
      for (const char *size : {"max_pressure",
                               "max_pressure_fitted",
                               "contact_area",
                               "patch_lateral",
                               "patch_longitudinal",
                               "approach"})
        if (result == size)
          return interval.high - interval.low > value;
      return false;
    }
  } // namespace


  Interval
  interval_of(const std::string &result, const double value, const Contributions &contributions)
  {
    const Contributions causes = of_result(result, contributions);
    double              shift = 0, squares = 0;
    for (const Contribution &cause : causes)
      {
        shift += cause.shift;
        squares += cause.spread * cause.spread;
      }
    const double spread = std::sqrt(squares);
    if (causes.empty() || !std::isfinite(value + shift + spread))
      return {Summary::none, Summary::none};
    Interval found{value + std::min(0., shift - spread), value + std::max(0., shift + spread)};
    // friction takes work and never gives it, and a part is between nothing and the whole
    for (const char *name : {"t_gamma", "frictional_power", "archard_section", "stick_fraction"})
      if (result == name)
        found.low = std::max(found.low, std::min(0., value));
    if (result == "stick_fraction")
      found.high = std::min(found.high, std::max(1., value));
    return found;
  }


  Known
  known_within(const std::string   &result,
               const double         value,
               const double         least,
               const Contributions &contributions)
  {
    const Interval interval = interval_of(result, value, contributions);
    Known          known;
    known.within = std::max(value - interval.low, interval.high - value) / std::max(std::abs(value), least);
    double most  = -1;
    for (const Contribution &cause : of_result(result, contributions))
      if (const double part = std::abs(cause.shift) + cause.spread; !(part <= most))
        {
          most        = part;
          known.cause = cause.cause;
        }
    if (most >= 0 && std::isnan(known.within))
      known.within = std::numeric_limits<double>::infinity(); // there are causes, and one has no bound
    return known;
  }


  void
  set_intervals(const Contributions &contributions, Summary &summary)
  {
    for (const Figure &figure : all_figures())
      {
        const double   value    = get_figure(summary, figure.key());
        const Interval interval = interval_of(figure.name, value, contributions);
        if (!std::isfinite(interval.low) || says_nothing(figure.name, value, interval))
          continue;
        set_figure(summary, figure.key("_low"), interval.low);
        set_figure(summary, figure.key("_high"), interval.high);
      }
  }


  std::vector<std::string>
  interval_keys(const std::string &key)
  {
    const Figure *const figure = figure_with_key(key);
    return figure ? std::vector<std::string>{figure->key("_low"), figure->key("_high")}
                  : std::vector<std::string>();
  }


  std::string
  shown_interval(const Summary &summary, const std::string &name)
  {
    const Figure &figure = figure_named(name);
    const double  low    = get_figure(summary, figure.key("_low")),
                 high    = get_figure(summary, figure.key("_high"));
    return std::isfinite(low) && std::isfinite(high) ? figure.shown(low) + " to " + figure.shown(high) : "";
  }


  std::string
  contributions_as_csv(const Contributions &contributions)
  {
    std::string table = "result,unit,cause,shift,spread\n";
    for (const Figure &figure : all_figures())
      for (const Contribution &one : of_result(figure.name, contributions))
        table += text("%s,%s,%s,%.6g,%.6g\n",
                      figure.name,
                      figure.si_unit().c_str(),
                      one.cause.c_str(),
                      one.shift,
                      one.spread);
    return table;
  }
} // namespace wheelrail
