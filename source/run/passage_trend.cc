#include <wheelrail/run/passage_trend.h>

#include <cmath>
#include <cstddef>
#include <cstdio>

namespace wheelrail
{
  namespace
  {
    bool
    near(const double before, const double now, const double change)
    {
      return std::abs(now - before) <= change * std::abs(before);
    }

    bool
    steady(const RoundGrowth &before, const RoundGrowth &now, const double least, const double change)
    {
      const bool flows = std::abs(now.shear) >= least || std::abs(before.shear) >= least;
      return near(before.strain, now.strain, change) && (!flows || near(before.shear, now.shear, change));
    }
  } // namespace


  PassageTrend
  trend_of(const std::vector<RoundGrowth> &rounds, const double least, const double change)
  {
    if (rounds.empty())
      return PassageTrend::open;
    const std::size_t  n    = rounds.size();
    const RoundGrowth &last = rounds.back();
    if (last.strain < least)
      return PassageTrend::shakedown;
    if (n < 3 || !steady(rounds[n - 3], rounds[n - 2], least, change) ||
        !steady(rounds[n - 2], last, least, change))
      return PassageTrend::open;
    return std::abs(last.shear) >= least ? PassageTrend::ratcheting : PassageTrend::to_and_fro;
  }


  std::string
  in_words(const PassageTrend trend, const RoundGrowth &last)
  {
    char strain[40], shear[40];
    std::snprintf(strain, sizeof(strain), "%.2g", last.strain);
    std::snprintf(shear, sizeof(shear), "%.2g", last.shear);
    const std::string forward =
      !std::isnan(last.shear)
        ? std::string(", the forward shear of the plastic zone by ") + shear + " in the last round"
      : trend == PassageTrend::shakedown
        ? " in the last round"
        : " in the last round; the run is too short to tell the forward flow";
    const std::string verdict = trend == PassageTrend::shakedown ? "the rail has shaken down"
                                : trend == PassageTrend::to_and_fro
                                  ? "the rail is in alternating plasticity (closed plastic loop)"
                                : trend == PassageTrend::ratcheting ? "the rail ratchets"
                                                                    : "the passages are not steady yet";
    return verdict + ": the largest plastic strain grew by " + strain + forward;
  }
} // namespace wheelrail
