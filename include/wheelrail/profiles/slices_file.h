#pragma once

#include <wheelrail/geometry/curve.h>
#include <wheelrail/profiles/height_grid.h>
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

  /// Whether a path is that of a slices file.
  bool
  is_slices_file(const std::string &path);

  /// The heights of slices over a profile, along its outward normal: each 0.5 mm across where slices and
  /// profile lie beside each other, smoothed across as profiles are. `radius` of the circle on which the arcs
  /// of a wheel count [m], `noise` of the points [m] (negative: as found in them). Throws InputError where a
  /// slice is more than 5 mm away from the profile or narrower than 10 mm of it.
  HeightGrid
  heights_of_slices(const Slices      &slices,
                    const Curve       &profile,
                    double             radius,
                    double             noise,
                    const std::string &path);

  /// The irregularity of such heights, smoothed along unless their `noise` is given (0 or more): before the
  /// first slice and behind the last one they stay.
  Irregularity
  slices_irregularity(const HeightGrid &heights,
                      const Slices     &slices,
                      double            place,
                      double            noise,
                      double            circumference);
} // namespace wheelrail
