#pragma once

#include <wheelrail/geometry/plane.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Rail or wheel.
  enum class ProfileKind
  {
    rail,
    wheel
  };

  /// A point of a profile file with its line.
  struct FilePoint
  {
    Point2       position; ///< in the unit of the file, later in metres
    unsigned int line = 0; ///< counted from 1
  };

  inline std::vector<Point2>
  positions(const std::vector<FilePoint> &points)
  {
    std::vector<Point2> result;
    for (const FilePoint &p : points)
      result.push_back(p.position);
    return result;
  }

  /// What a profile file says, before anything is checked or changed: the points in the order and
  /// the unit of the file, x as the first column, y as the second one; only what the file itself
  /// orders (shift, rotation, bounds, mirroring, inversion of SIMPACK files, offsets and tilt of MiniProf
  /// files) is done.
  struct FileContent
  {
    std::string              format; ///< "SIMPACK", "MiniProf" or "two columns"
    std::vector<FilePoint>   points;
    std::size_t              listed = 0;          ///< points in the file, also those that it orders to drop
    Point2                   rounding;            ///< of the coordinates in the file, see rounding_of()
    double                   metres_per_unit = 0; ///< as stated by the file; 0: not stated
    bool                     kind_stated     = false;
    ProfileKind              kind            = ProfileKind::rail; ///< when stated
    unsigned int             kind_line       = 0;                 ///< where
    bool                     gauge_right = false; ///< by the habit of the format x grows to the gauge side
    bool                     down        = false; ///< by the habit of the format y points down
    std::vector<std::string> notes;               ///< what was done and what was found, for the log
  };

  /// Most characters and points that a profile file may have.
  constexpr std::size_t largest_profile_file   = 10000000;
  constexpr std::size_t largest_profile_points = 50000;

  /// Reads the text of a profile file: SIMPACK .prr and .prw (known by "header.begin" or
  /// "spline.begin"), MiniProf .ban and .whl (known by "Key=value" lines before the columns), or two
  /// columns of numbers separated by blanks, tabs, commas or semicolons with comments after
  /// !, #, % and lines of words before the first point.
  ///
  /// `file` only names the file in messages. Throws InputError that names file and line, what was
  /// found, what is accepted and what to do; it returns or throws for any bytes.
  FileContent
  parse_profile_text(const std::string &text, const std::string &file);
} // namespace wheelrail
