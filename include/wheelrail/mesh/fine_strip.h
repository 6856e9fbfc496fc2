#pragma once

#include <wheelrail/geometry/contact_geometry.h>

#include <vector>

namespace wheelrail
{
  /// The strip of both running surfaces that is to carry the finest cells: block boundaries at the
  /// same values of s on wheel and rail, so that their vertices face each other. Within the strip
  /// a block edge on the profile is parametrised so that s is linear in t.
  struct FineStrip
  {
    ContactFrame        frame;
    std::vector<double> s; ///< ascending block boundaries in the contact frame [m], two or more
  };

  /// The part of the contact frame around s = 0 in which both profiles rise or fall by less than
  /// `max_slope` against s: the widest strip in which blocks stay well shaped on both bodies [m].
  Range
  strip_limits(const FrameProfile &wheel, const FrameProfile &rail, double max_slope = 1.);

  /// The strip that covers the interpenetration of the undeformed profiles at the expected
  /// `approach` and `margin` on both sides of it [m]. It is widened symmetrically to a whole number
  /// of blocks of `block_size` [m]; where the profiles are too steep for that (strip_limits), it is
  /// cut there and divided evenly into blocks that are at most a quarter wider than `block_size`.
  /// Besides it covers `also` [m], with the margin. Throws InputError when an argument is not positive (a
  /// margin of zero is accepted) or when no strip is left.
  FineStrip
  make_fine_strip(const ContactGeometry &contact,
                  const FrameProfile    &wheel,
                  const FrameProfile    &rail,
                  double                 approach,
                  double                 margin,
                  double                 block_size,
                  const Range           &also = {});

  /// The strip that covers the range `wanted` of s in `frame` [m], widened symmetrically to a whole number of
  /// blocks of `block_size` [m], where neither profile may be too steep (strip_limits). Throws InputError
  /// when one is.
  FineStrip
  fine_strip_over(const ContactFrame &frame,
                  const FrameProfile &wheel,
                  const FrameProfile &rail,
                  const Range        &wanted,
                  double              block_size);
} // namespace wheelrail
