#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/log.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include <poll.h>
#include <unistd.h>

namespace wheelrail
{
  namespace
  {
    /// mpirun may put a pseudo-terminal between rank 0 and the user's file or pipe, so the launcher
    /// tells what it sees. Without a launcher the own standard output is asked, unless Open MPI
    /// started this process.
    bool
    screen_is_terminal()
    {
      if (const char *const told = std::getenv("WHEELRAIL_TERMINAL"))
        return std::strcmp(told, "1") == 0;
      return std::getenv("OMPI_COMM_WORLD_RANK") == nullptr && isatty(STDOUT_FILENO) == 1;
    }
  } // namespace

  Log::Log(const std::string &path, const bool append)
    : screen_(true)
    , terminal_(screen_is_terminal())
  {
    if (path.empty())
      return;
    file_.open(path, append ? std::ios::app : std::ios::trunc);
    if (!file_)
      throw RunError(path + ": the log file cannot be written: " + std::strerror(errno));
  }

  void
  Log::line(const std::string &text)
  {
    if (!screen_)
      return;
    print(STDOUT_FILENO, (status_shown_ ? "\r\033[K" : "") + text + "\n");
    status_shown_ = false;
    if (file_.is_open())
      file_ << text + "\n" << std::flush;
  }

  void
  Log::value(const std::string &name, const std::string &text)
  {
    constexpr std::size_t column = 24;
    line("  " + name + std::string(name.size() < column ? column - name.size() : 1, ' ') + text);
  }

  void
  Log::warning(const std::string &text)
  {
    line("warning: " + text);
  }

  void
  Log::tick(const TickLine &tick)
  {
    if (!table_started_)
      {
        line("   rolled    normal    longitudinal  lateral    energy      element       time");
        line("     mm      force kN    force kN    force kN    error      updates/s     left");
        table_started_ = true;
      }
    line(text("%9.3f  %9.3f   %9.3f   %9.3f   %9.2e   %7.2f M  %s",
              1e3 * tick.rolled_distance,
              1e-3 * tick.normal_force,
              1e-3 * tick.longitudinal_force,
              1e-3 * tick.lateral_force,
              tick.energy_error,
              1e-6 * tick.updates_per_second,
              format_duration(tick.seconds_left).c_str()));
  }

  void
  Log::status(const std::string &text)
  {
    if (!screen_ || !terminal_)
      return;
    print(STDOUT_FILENO, "\r\033[K" + text);
    status_shown_ = true;
  }

  std::string
  format_duration(const double seconds)
  {
    if (!(seconds >= 0) || seconds > 1e9)
      return "?";
    const long whole = std::lround(seconds);
    if (whole < 60)
      return std::to_string(whole) + " s";
    if (whole < 3600)
      return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
  }


  namespace
  {
    /// Whether all went out. More than one call of write() only when a signal or a full pipe cuts the first
    /// off.
    bool
    write_line(const int file, const char *bytes, std::size_t left)
    {
      while (left > 0)
        {
          const ssize_t written = ::write(file, bytes, left);
          if (written > 0)
            {
              bytes += written;
              left -= static_cast<std::size_t>(written);
            }
          else if (written < 0 && errno == EAGAIN)
            {
              pollfd ready{file, POLLOUT, 0};
              ::poll(&ready, 1, -1);
            }
          else if (written == 0 || errno != EINTR)
            return false;
        }
      return true;
    }
  } // namespace


  void
  print(const int file, const std::string &text)
  {
    std::cout << std::flush;
    for (std::size_t begin = 0, end; begin < text.size(); begin = end)
      {
        end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        if (!write_line(file, &text[begin], end - begin))
          return;
      }
  }
} // namespace wheelrail
