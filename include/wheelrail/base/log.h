#pragma once

#include <fstream>
#include <string>

namespace wheelrail
{
  /// What a tick line of a run shows [SI].
  struct TickLine
  {
    double rolled_distance    = 0; ///< [m]
    double normal_force       = 0; ///< [N]
    double longitudinal_force = 0; ///< on the wheel, positive forward [N]
    double lateral_force      = 0; ///< on the wheel, along +X [N]
    double energy_error       = 0; ///< relative to strain plus dissipated energy
    double updates_per_second = 0; ///< element updates of all ranks together [1/s]
    double seconds_left       = 0; ///< [s]
  };

  /// Writes the same lines to the screen and to a log file; on ranks other than 0 it is silent.
  class Log
  {
  public:
    /// A silent one.
    Log() = default;

    /// Writes to the screen and, when `path` is not empty, to that file (at its end when `append`).
    /// Throws RunError when the file cannot be opened.
    explicit Log(const std::string &path, bool append = false);

    /// A line of text.
    void
    line(const std::string &text);

    /// A line "  name    text" of the header, texts aligned.
    void
    value(const std::string &name, const std::string &text);

    /// A line "warning: text", for what may not be meant and can be computed.
    void
    warning(const std::string &text);

    /// A line of the table of ticks; the first one prints the head of the table before it.
    void
    tick(const TickLine &tick);

    /// Shows what goes on until the next line overwrites it; only on a terminal, never in the file.
    void
    status(const std::string &text);

  private:
    bool          screen_        = false;
    bool          terminal_      = false;
    bool          status_shown_  = false;
    bool          table_started_ = false;
    std::ofstream file_;
  };

  /// "45 s", "3 min 20 s", "2 h 5 min"; "?" for what is not a positive number.
  std::string
  format_duration(double seconds);

  /// Writes `text` into an open file, such as STDOUT_FILENO, with one call of write() for each of its lines:
  /// where errors and output, or several processes, share a file or a pipe, their lines follow each other
  /// whole. What std::cout still holds is written before. A file that takes nothing (a closed pipe, a full
  /// disk) is no fault.
  void
  print(int file, const std::string &text);
} // namespace wheelrail
