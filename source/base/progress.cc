#include <wheelrail/base/format_text.h>
#include <wheelrail/base/log.h>
#include <wheelrail/base/progress.h>

#include <algorithm>
#include <utility>

namespace wheelrail
{
  namespace
  {
    using Clock = std::chrono::steady_clock;

    double
    seconds_since(const Clock::time_point &begin)
    {
      return std::chrono::duration<double>(Clock::now() - begin).count();
    }
  } // namespace


  Progress::Progress(const double share)
    : begin_(Clock::now())
    , first_(share)
    , told_(0)
  {
  }


  std::string
  Progress::at(const double share) const
  {
    const double new_share = share - first_;
    return text("%.0f %% done", 100 * share) +
           (new_share > 0 && share < 1
              ? ", " + format_duration(seconds_since(begin_) * (1 - share) / new_share) + " left"
              : "");
  }


  bool
  Progress::due()
  {
    const double now = seconds_since(begin_);
    if (now < told_ + std::max(5., 0.1 * told_))
      return false;
    told_ = now;
    return true;
  }


  TaskCount::TaskCount(std::string what, const std::size_t all, const std::size_t done, std::ostream &screen)
    : what_(std::move(what))
    , all_(all)
    , done_(done)
    , screen_(screen)
    , progress_(all > 0 ? double(done) / all : 0)
  {
  }


  void
  TaskCount::one_more()
  {
    const std::lock_guard<std::mutex> guard(lock_);
    ++done_;
    if (done_ < all_ && progress_.due())
      screen_ << done_ << " of " << all_ << ' ' << what_ << ", " << progress_.at(double(done_) / all_)
              << std::endl;
  }
} // namespace wheelrail
