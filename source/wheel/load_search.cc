#include <wheelrail/wheel/load_search.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  bool
  LoadSearch::carried(const double vertical)
  {
    // normal forces and friction at their bound carry between these shares; what else changes meanwhile, such
    // as the creepage, can make a secant anything
    constexpr double enough = 1e-4, least_slope = 0.1, largest_slope = 2;
    const double     missed_before = missed_, now = pressed_;
    missed_ = vertical - load_;
    if (std::abs(missed_) < enough * load_)
      return true;
    const double slope = before_ > 0 && now != before_ ? (missed_ - missed_before) / (now - before_) : slope_;
    if (slope > least_slope && slope < largest_slope)
      slope_ = slope;
    before_                      = now;
    (missed_ > 0 ? high_ : low_) = now;
    pressed_                     = std::clamp(now - missed_ / slope_, 0.2 * now, 5 * now);
    if (low_ > 0 && high_ > 0 && (pressed_ <= low_ || pressed_ >= high_))
      {
        // a bound that is passed again and again is one of before
        if (++passed_ == 4)
          {
            (pressed_ >= high_ ? high_ : low_) = 0;
            passed_                            = 0;
          }
        else
          pressed_ = 0.5 * (low_ + high_);
      }
    else
      passed_ = 0;
    return false;
  }


  void
  CreepageSearch::missed(const double miss)
  {
    constexpr double narrow = 1e-9, growth = 4;
    const double     now         = creepage_;
    (miss > 0 ? high_ : low_)    = now;
    (miss > 0 ? above_ : below_) = true;
    if (above_ && below_ && high_ - low_ < narrow) // what is searched has moved
      {
        low_ = -1, high_ = 1;
        above_ = below_ = false;
        step_           = 1e-6;
      }
    const double slope = first_ ? 0 : (miss - miss_before_) / (now - before_);
    double       step  = slope > 0 ? -miss / slope : -std::copysign(step_, miss);
    if (!(above_ && below_))
      {
        // a little more than the secant asks, so that the sign changes
        step  = std::clamp(1.05 * step, -growth * step_, growth * step_);
        step_ = std::max(step_, std::abs(step));
      }
    else if (now + step <= low_ || now + step >= high_)
      {
        // a bound that secants pass twice is one of before
        if (slope > 0 && ++passed_ == 2)
          {
            passed_                      = 0;
            (step > 0 ? high_ : low_)    = step > 0 ? 1 : -1;
            (step > 0 ? above_ : below_) = false;
            step_                        = std::abs(now - before_);
            step                         = std::clamp(step, -growth * step_, growth * step_);
          }
        else
          step = 0.5 * (low_ + high_) - now;
      }
    else
      passed_ = 0;
    before_      = now;
    miss_before_ = miss;
    first_       = false;
    creepage_    = std::clamp(now + step, -1., 1.);
    carried_     = creepage_ != now || std::abs(now) < 1;
  }
} // namespace wheelrail
