#pragma once

#include <wheelrail/base/rigid_motion.h>
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

  /// The running surface of the wheel of a case of module 1, in the axes of its section: one section all
  /// around, or sections that change around it (slices).
  class WheelShape
  {
  public:
    /// Reads the profile of the case. Throws InputError for what cannot be read.
    explicit WheelShape(const ContactCase &one);

    bool
    out_of_round() const
    {
      return !columns_.empty();
    }

    /// The section below the axle.
    const ProfileLine &
    middle() const
    {
      return out_of_round() ? columns_[columns_.size() / 2] : line_;
    }

    /// The place of a parameter on the section at an angle ahead of that [rad]; beyond 0.2 rad that at 0.2.
    ProfileLine::Place
    at(double ahead, double t) const;

  private:
    ProfileLine              line_;
    double                   step_ = 0; ///< angle between columns, the middle one at 0
    std::vector<ProfileLine> columns_;
  };

  /// The point of a wheel at one x of the track: that of a parameter of its section; nothing where the wheel
  /// does not reach. `to_track`: of its section, `radius` of its origin.
  std::optional<Vector3>
  wheel_point(const WheelShape &wheel, const RigidMotion &to_track, double radius, double x, double t);
} // namespace wheelrail
