#pragma once

#include <wheelrail/geometry/curve.h>

#include <vector>

namespace wheelrail
{
  /// A profile seen in the contact frame as a single-valued height n(s), evaluated on the exact
  /// segments. Rail heights are of the rail surface, wheel heights of the wheel surface.
  class FrameProfile
  {
  public:
    /// Takes the connected part of `curve` around s = 0 whose slope against s stays below
    /// `max_slope`; `s_min`, `s_max` are its range. Where the curve passes s = 0 more than once,
    /// the pass nearest to n = 0 counts. The curve must run towards +s there, as the heads and
    /// treads of profiles.h do. Throws InputError when it does not pass s = 0 with such a slope.
    FrameProfile(const Curve        &curve,
                 const Placement    &placement,
                 const ContactFrame &frame,
                 double              max_slope = 1.2);

    /// Height n [m] and slope dn/ds at s [m]; s outside the range is clamped.
    struct Value
    {
      double n = 0, slope = 0;
    };
    Value
    at(double s) const;

    /// Curve parameter at s.
    double
    parameter(double s) const;

    double
    s_min() const
    {
      return s_min_;
    }
    double
    s_max() const
    {
      return s_max_;
    }

    /// The ends of the range and the joints of segments between them, ascending [m].
    const std::vector<double> &
    joints() const
    {
      return joints_;
    }

  private:
    /// The part of one segment inside the range, carried over into the frame.
    struct Piece
    {
      int    segment = 0;
      Point2 start; ///< (s, n) of the segment's start; its end follows for a line
      Point2 end;
      Point2 centre;   ///< (s, n) of an arc's centre
      double side = 0; ///< of an arc: +1 above its centre, -1 below
    };

    /// Abscissa x of a polynomial piece, or u of a spline piece, at s, by Newton steps.
    double
    abscissa(const Piece &piece, double s) const;

    const Piece &
    piece_at(double s) const;

    Curve               curve_;
    Point2              origin_;  ///< (s, n) of the origin of the section
    Point2              ex_, ey_; ///< its axes
    double              s_min_ = 0, s_max_ = 0;
    std::vector<double> joints_;
    std::vector<Piece>  pieces_; ///< piece i covers joints_[i] to joints_[i + 1]
  };

  /// Places s that both profiles have, ascending: the ends of that range, all joints within, and others
  /// between them no farther than `spacing` apart [m].
  std::vector<double>
  common_places(const FrameProfile &wheel, const FrameProfile &rail, double spacing);

  /// Undeformed distance d(s) = n_wheel(s) - n_rail(s) [m] at rolling coordinate 0; zero at s = 0.
  double
  undeformed_distance(const FrameProfile &wheel, const FrameProfile &rail, double s);

  /// Lateral ranges [s0, s1] (ascending) where the undeformed profiles interpenetrate when the
  /// wheel is lowered along n by `approach` [m]. The profiles are sampled every 0.1 mm and at their
  /// joints; the ends are refined to round-off.
  struct Range
  {
    double s0 = 0, s1 = 0;
  };
  std::vector<Range>
  interpenetration(const FrameProfile &wheel, const FrameProfile &rail, double approach);

  /// Part of the approach by which undeformed bodies have to be lowered to overlap over about their patch
  /// (Kik and Piotrowski, 1996).
  constexpr double kik_piotrowski = 0.55;
} // namespace wheelrail
