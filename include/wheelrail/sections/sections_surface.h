#pragma once

#include <wheelrail/geometry/plane.h>
#include <wheelrail/sections/section_column.h>
#include <wheelrail/sections/slices_file.h>

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// The running surface of a rail whose section changes along the track.
  ///
  /// Each part between two feature lines is divided into equal arc lengths on every slice, by lines that are
  /// matched from slice to slice; along the track each line is a cubic spline with knots at the slices, as in
  /// the program CONTACT. A line exists from the first to the last slice of an unbroken run that has it.
  /// Before the first and behind the last slice of the file the surface stays as it is there, or ends.
  class SectionsSurface
  {
  public:
    /// The sections stand at `placement`; `noise` of their points [m] (negative: as found in them); lines lie
    /// up to `spacing` apart [m]. `ends`: with the first and the last slice. Throws InputError that names
    /// `path` and slice for what is no surface: a slice that lies mirrored to the one before, a feature
    /// behind the end of its slice, a part on fewer than four slices in a row, an approximating spline along
    /// the track on slices that are not equally far apart or have parts that begin or end.
    SectionsSurface(const Slices      &slices,
                    const Placement   &placement,
                    double             noise,
                    const std::string &path,
                    double             spacing = 0.5e-3,
                    bool               ends    = false);

    /// The section at a place along the track [m], or the part of it between two lines. Empty where nothing
    /// is.
    SectionColumn
    column(double      place,
           std::size_t first = 0,
           std::size_t end   = std::numeric_limits<std::size_t>::max()) const;

    /// Places of the first and the last slice [m].
    double
    begin() const
    {
      return places_.front();
    }
    double
    end() const
    {
      return places_.back();
    }

    /// Largest distance of neighbouring lines [m].
    double
    spacing() const
    {
      return spacing_;
    }

    /// Two neighbouring slices between which the arc length of a part jumps by more than 30 % and 20 mm: the
    /// part ends at the first and begins anew at the second.
    struct Jump
    {
      double      begin = 0, end = 0;     ///< their places [m]
      double      before = 0, behind = 0; ///< arc lengths [m]
      std::size_t part = 0, slice = 0;    ///< from 0; of the first of them, from 1
    };
    const std::vector<Jump> &
    jumps() const
    {
      return jumps_;
    }

    /// Standard deviation of slices off their neighbours, each as a whole, which nothing smooths (0 where
    /// only digits make it) [m].
    double
    noise() const
    {
      return noise_;
    }

    /// Whether a place along the track lies on the slices [m].
    bool
    has(const double place) const
    {
      return place >= begin() && place <= end();
    }

    /// Throws InputError for a place between two slices with a jump [m].
    void
    refuse_jump(double place) const;

    const std::string &
    path() const
    {
      return path_;
    }

  private:
    /// Lines that begin and end together.
    struct Strip
    {
      std::size_t first = 0, end = 0; ///< lines
      std::vector<std::pair<std::size_t, std::size_t>>
        runs; ///< slices that have it, first and one behind the last
    };

    void
    lay_lines(const Slices &slices, const Placement &placement, double noise);
    void
    find_noise();
    /// Turns the lines into those of an approximating spline along the track.
    void
    smooth_along();
    void
    find_jumps();
    void
    find_runs();

    std::string                      path_;
    double                           spacing_ = 0, noise_ = 0;
    bool                             ends_ = false;
    std::vector<double>              places_;     ///< of the slices [m]
    std::vector<std::vector<double>> lengths_;    ///< of each part on each slice [m], 0: absent
    std::vector<std::size_t>         part_begin_; ///< first line of each part, and the last line of all
    std::vector<Strip>               strips_;
    std::vector<std::vector<Point2>>
                      lines_; ///< of each line its points on the slices, in the track plane [m]
    std::vector<Jump> jumps_;
  };
} // namespace wheelrail
