#pragma once

#include <wheelrail/contactfiles/section_line.h>
#include <wheelrail/sections/sections_surface.h>

#include <memory>
#include <optional>
#include <vector>

namespace wheelrail
{
  /// The running surface of the rail of a case of module 1, in the axes of its section: one section all
  /// along, a section around a roller whose axle lies at z = NOMRADR, or sections that change along the
  /// track.
  class RailShape
  {
  public:
    /// Reads the profile of the case. Throws InputError for what cannot be read.
    explicit RailShape(const ContactCase &one);

    /// Whether the section differs from place to place along the track.
    bool
    varies() const
    {
      return radius_ > 0 || slices_;
    }

    /// The section under the wheelset.
    const ProfileLine &
    middle() const
    {
      return middle_;
    }

    /// The section at x along the track from there [m]; nothing where no rail is.
    std::optional<ProfileLine>
    at(double x) const;

  private:
    std::vector<Point2>                    points_;
    double                                 radius_ = 0; ///< of the roller at z = 0
    double                                 along_  = 0; ///< S_WS
    std::shared_ptr<const SectionsSurface> slices_;
    ProfileLine                            middle_;
  };
} // namespace wheelrail
