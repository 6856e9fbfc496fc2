#pragma once

#include <wheelrail/geometry/curve.h>
#include <wheelrail/profiles/profile_file.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Sections of a body one behind the other, as the program CONTACT reads them.
  struct Slices
  {
    struct Slice
    {
      double              along = 0; ///< along the track [m], or angle around the wheel [rad]
      std::vector<Point2> points;    ///< of the section: x to the field side, y up [m]
      /// Arc lengths of the feature lines from the end at the track centre [m], negative: absent here. Empty
      /// where the file has none.
      std::vector<double> features;
      std::string         file = {}; ///< that has the points
    };
    bool wheel    = false;
    bool smoothed = false;     ///< between slices: an approximating spline, else an interpolating one
    std::vector<Slice> slices; ///< ascending
  };

  /// Reads a .slcs (rail) or .slcw (wheel) file and the files of its slices, whose paths count from its
  /// folder; in these y points to the field side and z down (in a wheel of equal radii: the change of the
  /// radius). Feature lines divide a rail into parts, which may begin and end at slices.
  ///
  /// Throws InputError that names file and line, what was found and what is accepted.
  Slices
  read_slices_file(const std::string &path, ProfileUnit unit);
} // namespace wheelrail
