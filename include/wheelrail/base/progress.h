#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <ostream>
#include <string>

namespace wheelrail
{
  /// How far long work has come, and how long the rest will take as it has gone so far.
  class Progress
  {
  public:
    /// `share`: what is done of the whole already, from 0 to 1.
    explicit Progress(double share = 0);

    /// "34 % done, 2 min 10 s left" at a share of the whole.
    std::string
    at(double share) const;

    /// Whether it is time to print it again: 5 s after it was printed last, later where the work takes long.
    bool
    due();

  private:
    std::chrono::steady_clock::time_point begin_;
    double                                first_, told_;
  };

  /// Counts tasks that are done, from several threads, and prints it on a screen as Progress does: "120 of
  /// 308 rows, 39 % done, 12 s left".
  class TaskCount
  {
  public:
    /// `what`: the tasks in words; `done` of the `all` are done already.
    TaskCount(std::string what, std::size_t all, std::size_t done, std::ostream &screen);

    void
    one_more();

  private:
    std::string   what_;
    std::size_t   all_, done_;
    std::ostream &screen_;
    Progress      progress_;
    std::mutex    lock_;
  };
} // namespace wheelrail
