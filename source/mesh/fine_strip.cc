#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/mesh/fine_strip.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace wheelrail
{
  namespace
  {
    // Last s on the way from 0 to `end` before the profile gets too steep.
    double
    steep_from(const FrameProfile &profile, const double end, const double max_slope)
    {
      // steps of some 0.03 mm on a profile that reaches 60 mm far; the place is then found by bisection
      const unsigned int n = 2000;
      for (unsigned int i = 1; i <= n; ++i)
        if (std::abs(profile.at(end * i / n).slope) >= max_slope)
          {
            double good = end * (i - 1) / n, bad = end * i / n;
            for (unsigned int step = 0; step < 50; ++step)
              {
                const double middle                                           = 0.5 * (good + bad);
                (std::abs(profile.at(middle).slope) < max_slope ? good : bad) = middle;
              }
            return good;
          }
      return end;
    }

    FineStrip
    divided(const ContactFrame &frame, const Range &strip, const unsigned int blocks)
    {
      FineStrip result{frame, {}};
      for (unsigned int i = 0; i <= blocks; ++i)
        result.s.push_back(strip.s0 + (strip.s1 - strip.s0) * i / blocks);
      return result;
    }

    void
    require(const bool good, const std::string &what, const double value)
    {
      if (!good)
        throw InputError("The fine strip cannot be laid out with " + what + " = " + in_mm(value) +
                         ": a positive length is needed.");
    }
  } // namespace


  Range
  strip_limits(const FrameProfile &wheel, const FrameProfile &rail, const double max_slope)
  {
    return {std::max(steep_from(wheel, wheel.s_min(), max_slope), steep_from(rail, rail.s_min(), max_slope)),
            std::min(steep_from(wheel, wheel.s_max(), max_slope), steep_from(rail, rail.s_max(), max_slope))};
  }


  FineStrip
  make_fine_strip(const ContactGeometry &contact,
                  const FrameProfile    &wheel,
                  const FrameProfile    &rail,
                  const double           approach,
                  const double           margin,
                  const double           block_size,
                  const Range           &also)
  {
    require(approach > 0, "an approach", approach);
    require(margin >= 0, "a margin", margin);
    require(block_size > 0, "a block size", block_size);

    const std::vector<Range> parts = interpenetration(wheel, rail, approach);
    Range                    hull  = also;
    for (const Range &range : parts)
      {
        hull.s0 = std::min(hull.s0, range.s0);
        hull.s1 = std::max(hull.s1, range.s1);
      }
    hull.s0 -= margin;
    hull.s1 += margin;

    // a width that is a whole number of blocks but for round-off gets no further one; one that is so wide
    // that its blocks fit nearly, over two rails, stays as it is, and ends where gauge corner or flange root
    // turn away from the plane that its blocks are parallel to.
    constexpr double many = 4, turned = 0.45, free = 1;
    const double     wanted = (hull.s1 - hull.s0) / block_size;
    const bool       wide   = wanted > many;
    const double     blocks = wide ? wanted : std::max(1., std::ceil(wanted - 1e-9));
    const double     middle = 0.5 * (hull.s0 + hull.s1);
    // the wheel's chamfer ends its running layer, which needs a rest beside the strip (make_running_layer())
    constexpr double chamfer = 0.5, rest = 0.3;
    Range            limits = strip_limits(wheel, rail, wide ? turned : free);
    if (wide)
      limits.s0 = std::max(limits.s0, steep_from(wheel, wheel.s_min(), chamfer) + rest * block_size);
    const Range strip{std::max(limits.s0, middle - 0.5 * blocks * block_size),
                      std::min(limits.s1, middle + 0.5 * blocks * block_size)};
    // narrower strips would have cells of less than a tenth of the wanted width
    if (!(strip.s1 - strip.s0 > 0.1 * block_size))
      throw InputError(
        "Wheel and rail are too steep at the contact point for a strip of fine cells: only " +
        in_mm(strip.s1 - strip.s0) + " are left of " + in_mm(blocks * block_size) +
        ". Choose a lateral shift without contact on the flange face, or a smaller cell size.");

    // a block a quarter wider than wanted is better than two that are nearly half as wide: narrow
    // cells cut the stable time step
    const double       width = strip.s1 - strip.s0;
    const unsigned int count =
      wide ? std::lround(width / block_size) : std::max(1., std::ceil(width / block_size - 0.25));

    return divided(contact.frame, strip, count);
  }


  FineStrip
  fine_strip_over(const ContactFrame &frame,
                  const FrameProfile &wheel,
                  const FrameProfile &rail,
                  const Range        &wanted,
                  const double        block_size)
  {
    require(block_size > 0, "a block size", block_size);
    const unsigned int blocks = std::max(1., std::ceil((wanted.s1 - wanted.s0) / block_size - 1e-9));
    const double       middle = 0.5 * (wanted.s0 + wanted.s1), half = 0.5 * blocks * block_size;
    const Range        strip{middle - half, middle + half};
    for (const FrameProfile *profile : {&wheel, &rail})
      {
        const Range limits = strip_limits(*profile, *profile);
        if (strip.s0 < limits.s0 || strip.s1 > limits.s1)
          throw InputError("Mesh/Planned strip: with whole coarse blocks it is " +
                           in_mm(strip.s1 - strip.s0) + " wide, and the " +
                           (profile == &wheel ? "wheel" : "rail") + " is too steep from " +
                           in_mm(limits.s0 > strip.s0 ? limits.s0 - middle : limits.s1 - middle) +
                           " beside its middle on (positive to the track centre); take a narrower one, or a "
                           "smaller Mesh/Coarse cell size.");
      }
    return divided(frame, strip, blocks);
  }
} // namespace wheelrail
