#include <wheelrail/geometry/running_surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace wheelrail
{
  RunningSurface::RunningSurface(FrameProfile head, const ContactFrame &frame, const Placement &section)
    : frame_(frame)
    , section_(std::move(head))
  {
    pose_.section = section;
  }


  RunningSurface::RunningSurface(FrameProfile        tread,
                                 const ContactFrame &frame,
                                 const WheelPose    &pose,
                                 const double        radius)
    : body_(Body::wheel)
    , frame_(frame)
    , pose_(pose)
    , radius_(radius)
    , section_(std::move(tread))
  {
  }


  void
  RunningSurface::set_irregularities(std::shared_ptr<const Irregularities> irregularities,
                                     const double                          origin)
  {
    irregular_ = irregularities && !irregularities->empty() ? std::move(irregularities) : nullptr;
    origin_    = origin;
  }


  void
  RunningSurface::draw_irregularities(const RunningSurface &other, const unsigned int draw)
  {
    constexpr unsigned int apart  = 1000; // numbers of the next one and of the other body
    Irregularities         drawn  = other.irregularities();
    unsigned int           number = draw + (body_ == Body::wheel ? 100 * apart : 0);
    for (Irregularity &one : drawn)
      {
        if (one.drawn)
          one.at = one.drawn(number);
        number += apart;
      }
    set_irregularities(std::make_shared<const Irregularities>(std::move(drawn)), other.origin_);
  }


  const Irregularities &
  RunningSurface::irregularities() const
  {
    static const Irregularities none;
    return irregular_ ? *irregular_ : none;
  }


  RunningSurface::Place
  RunningSurface::place(const Vector3 &X) const
  {
    if (body_ == Body::rail)
      {
        const Point2 q = frame_.to_frame({X[0], X[1]});
        return {q.x, q.y, X[2]};
      }
    const Point2 q = frame_.to_frame(pose_.on_section(X));
    return {q.x, q.y, radius_ * pose_.angle(X)};
  }


  IrregularHeight
  RunningSurface::raised(const double s, const FrameProfile::Value &smooth, const double along) const
  {
    const double across = pose_.section.to_section(frame_.to_track({s, smooth.n})).x;
    return height_at(*irregular_, 2 * M_PI * radius_, across, origin_ + along);
  }


  SurfaceHeight
  RunningSurface::at(const double s, const double along) const
  {
    FrameProfile::Value smooth = section_.at(s);
    if (!irregular_)
      return {smooth.n, smooth.slope, 0};
    const double    outwards = body_ == Body::rail ? 1 : -1;
    IrregularHeight h        = raised(s, smooth, along);
    if (h.height == 0 && h.across == 0 && h.along == 0)
      return {smooth.n, smooth.slope, 0};
    // the place of the smooth section whose normal leads to s; heights are small against its radii
    double from = s;
    for (int k = 0; k < 3; ++k)
      {
        from   = s + outwards * h.height * smooth.slope / std::sqrt(1 + smooth.slope * smooth.slope);
        smooth = section_.at(from);
        h      = raised(from, smooth, along);
      }
    const double secant = std::sqrt(1 + smooth.slope * smooth.slope), angle = std::atan(smooth.slope);
    // x of the section over the length of the profile in the direction of s
    const double across = -std::cos(frame_.angle + angle - pose_.section.angle);
    // height h along the normal: n + h cos(angle) at s - h sin(angle), the angle grows by atan(dh/dl), and
    // along the track the slope is that of h over cos(angle)
    return {smooth.n + outwards * h.height / secant,
            std::tan(angle + std::atan(outwards * h.across * across)),
            outwards * h.along * secant};
  }


  RunningSurface::Curvature
  RunningSurface::curvature(const double s, const double along, const double span) const
  {
    const double outwards = body_ == Body::rail ? 1 : -1;
    const auto   before = at(s - 0.5 * span, along), after = at(s + 0.5 * span, along), here = at(s, along);
    const double secant = std::sqrt(1 + here.slope * here.slope);
    // -n''/(1 + n'^2)^(3/2) by differences over `span`, positive where convex; along the track 1/r of the
    // wheel and what irregularities add
    return {outwards * (before.slope - after.slope) / (span * secant * secant * secant),
            (radius_ > 0 ? 1 / radius_ : 0) +
              outwards * (at(s, along - 0.5 * span).slope_along - at(s, along + 0.5 * span).slope_along) /
                (span * secant)};
  }


  std::vector<Kink>
  RunningSurface::kinks() const
  {
    std::vector<Kink> kinks;
    for (const Irregularity &one : irregularities())
      for (const Kink &kink : one.kinks)
        kinks.push_back({kink.along - origin_, kink.aside});
    std::sort(kinks.begin(), kinks.end(), [](const Kink &a, const Kink &b) { return a.along < b.along; });
    return kinks;
  }


  Range
  RunningSurface::gap() const
  {
    for (const Irregularity &one : irregularities())
      if (one.gap)
        return {one.begin - origin_, one.end - origin_};
    constexpr double far = std::numeric_limits<double>::infinity();
    return {far, far};
  }


  bool
  RunningSurface::has_second_rail() const
  {
    return std::any_of(irregularities().begin(), irregularities().end(), [](const Irregularity &one) {
      return one.second != nullptr;
    });
  }


  bool
  RunningSurface::on_second_rail(const Vector3 &X) const
  {
    const Place  p      = place(X);
    const double across = pose_.section.to_section(frame_.to_track({p.s, p.n})).x;
    return std::any_of(irregularities().begin(), irregularities().end(), [&](const Irregularity &one) {
      return one.second && one.second(across, origin_ + p.along);
    });
  }


  double
  RunningSurface::offset(const Vector3 &X) const
  {
    const double outwards = body_ == Body::rail ? 1 : -1;
    if (!irregular_)
      {
        const Point2 q     = frame_.to_frame(body_ == Body::rail ? Point2{X[0], X[1]} : pose_.on_section(X));
        const auto   value = section_.at(q.x);
        // w(X) of doc/theory/contact.md: height above the place times the cosine, its distance along the
        // normal to first order
        return outwards * (value.n - q.y) / std::sqrt(1 + value.slope * value.slope);
      }
    const Place         p     = place(X);
    const SurfaceHeight value = at(p.s, p.along);
    return outwards * (value.n - p.n) / std::sqrt(1 + value.slope * value.slope);
  }


  RunningSurface::OffsetSlopes
  RunningSurface::offset_slopes(const Place &place) const
  {
    if (!irregular_)
      return {};
    const FrameProfile::Value smooth = section_.at(place.s);
    const double              across = pose_.section.to_section(frame_.to_track({place.s, smooth.n})).x;
    const IrregularHeight     h =
      height_at(*irregular_, 2 * M_PI * radius_, across, origin_ + place.along, CarriedBy::offset);
    return {-h.across * std::cos(frame_.angle + std::atan(smooth.slope) - pose_.section.angle), h.along};
  }


  bool
  RunningSurface::moves_mesh() const
  {
    return std::any_of(irregularities().begin(), irregularities().end(), [](const Irregularity &one) {
      return one.carried == CarriedBy::mesh;
    });
  }


  Vector3
  RunningSurface::moved(const Vector3 &X) const
  {
    const double              outwards = body_ == Body::rail ? 1 : -1;
    const Place               p        = place(X);
    const double              s        = section_.within(p.s);
    const FrameProfile::Value smooth   = section_.at(s);
    // nodes below the surface move less, linearly down to `blend_depth`
    const double share = 1 - std::max(0., outwards * (smooth.n - p.n)) / blend_depth;
    if (share <= 0)
      return X;
    const double          across = pose_.section.to_section(frame_.to_track({s, smooth.n})).x;
    const IrregularHeight h =
      height_at(*irregular_, 2 * M_PI * radius_, across, origin_ + p.along, CarriedBy::mesh);
    if (h.height == 0)
      return X;
    const double secant = std::sqrt(1 + smooth.slope * smooth.slope), rise = outwards * share * h.height;
    const Point2 to = frame_.to_track({p.s - rise * smooth.slope / secant, p.n + rise / secant});
    if (body_ == Body::rail)
      return {to.x, to.y, X[2]};
    const Point2 section = pose_.section.to_section(to);
    return pose_.position(section.x, pose_.nominal_radius - section.y, pose_.angle(X));
  }


  RunningSurface::Place
  RunningSurface::unmoved(const Vector3 &X) const
  {
    Place p = place(X);
    if (!moves_mesh())
      return p;
    const double outwards = body_ == Body::rail ? 1 : -1, s = p.s;
    for (int k = 0; k < 20; ++k)
      {
        const FrameProfile::Value smooth = section_.at(section_.within(p.s));
        const double across = pose_.section.to_section(frame_.to_track({section_.within(p.s), smooth.n})).x;
        const double rise =
          outwards *
          height_at(*irregular_, 2 * M_PI * radius_, across, origin_ + p.along, CarriedBy::mesh).height;
        p.s = s + rise * smooth.slope / std::sqrt(1 + smooth.slope * smooth.slope);
        p.n = smooth.n;
      }
    return p;
  }
} // namespace wheelrail
