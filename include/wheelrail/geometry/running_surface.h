#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/base/vector3.h>
#include <wheelrail/geometry/irregularity.h>
#include <wheelrail/geometry/section_heights.h>
#include <wheelrail/geometry/wheel_pose.h>

#include <memory>
#include <vector>

namespace wheelrail
{
  /// Height of a running surface in a contact frame.
  struct SurfaceHeight
  {
    double n           = 0; ///< [m]
    double slope       = 0; ///< dn/ds
    double slope_along = 0; ///< dn over the place along
  };

  /// The running surface of one body before it deforms: a section that is swept along Z (rail) or around the
  /// axle (wheel), with irregularities on top. It is asked for places and heights by whatever needs the
  /// shape: mesh, contact, half-spaces, pictures.
  ///
  /// Heights are counted in a contact frame of the section: for a rail that of the contact, for a wheel
  /// that at the same point in the track plane of the straight wheel (WheelPose). Steel lies below n for a
  /// rail, above n for a wheel.
  class RunningSurface
  {
  public:
    RunningSurface() = default;

    /// A rail whose section is placed at `section`.
    RunningSurface(FrameProfile head, const ContactFrame &frame, const Placement &section);

    /// A wheel; arcs count on the circle of `radius` [m].
    RunningSurface(FrameProfile tread, const ContactFrame &frame, const WheelPose &pose, double radius);

    /// Takes the heights of the section from a table, see SectionHeights.
    void
    tabulate(double s0, double s1)
    {
      section_.tabulate(s0, s1);
    }

    /// Puts irregularities on the surface. `origin`: their place along that Z = 0 or the lowest line of the
    /// wheel have [m].
    void
    set_irregularities(std::shared_ptr<const Irregularities> irregularities, double origin = 0);

    const Irregularities &
    irregularities() const;

    /// The same irregularities on another surface of the body, with the places along `further` [m] ahead.
    void
    take_irregularities(const RunningSurface &other, double further = 0)
    {
      set_irregularities(other.irregular_, other.origin_ + further);
    }

    /// The same, with others of the measured ones that their noise leaves possible (Irregularity::drawn).
    void
    draw_irregularities(const RunningSurface &other, unsigned int draw);

    /// Place of a reference point: coordinates in the frame (of a wheel point after turning it back to the
    /// section), and along the track: Z, or the arc in front of the contact [m].
    struct Place
    {
      double s = 0, n = 0, along = 0;
    };
    Place
    place(const Vector3 &X) const;

    /// Of the smooth section.
    FrameProfile::Value
    smooth(const double s) const
    {
      return section_.at(s);
    }

    /// Of the surface with its irregularities at the place s, along [m]. A point of the smooth surface is
    /// moved along the normal of its section, which also moves it across: exact up to the product of height
    /// and curvature in the slope.
    SurfaceHeight
    at(double s, double along) const;

    /// Curvatures of the surface across (that of the section) and along (over Z or the arc), positive convex
    /// [1/m], as second differences over `span` [m].
    struct Curvature
    {
      double across = 0, along = 0;
    };
    Curvature
    curvature(double s, double along, double span) const;

    /// Places along where the slope jumps [m], ascending. Those across are the joints of profile().
    std::vector<Kink>
    kinks() const;

    /// The gap between two rails, along [m]; infinitely far where there is one rail.
    Range
    gap() const;

    /// Whether two rails lie under the wheel, and whether a reference point is on the second of them.
    bool
    has_second_rail() const;
    bool
    on_second_rail(const Vector3 &X) const;

    /// How far the surface protrudes beyond a reference point X of a facet, along the outward normal of the
    /// section [m]; positive over the chords of a convex profile.
    double
    offset(const Vector3 &X) const;

    /// Slopes of the irregularities that the contact carries as offsets, outwards over s and along, at a
    /// place; zero where the mesh carries all.
    struct OffsetSlopes
    {
      double across = 0, along = 0;
    };
    OffsetSlopes
    offset_slopes(const Place &place) const;

    /// Depth over which nodes below the surface take a part of its irregularities [m].
    static constexpr double blend_depth = 25e-3;

    /// Whether nodes of the mesh are moved by irregularities.
    bool
    moves_mesh() const;

    /// Where a reference point of the smooth body lies when its surface has the irregularities that the mesh
    /// carries: moved along the normal of the section by all of their height on the surface, and by a part
    /// that falls linearly to nothing at the blend depth below it. Beside the strip that is tabulated the
    /// heights of its edge hold.
    Vector3
    moved(const Vector3 &X) const;

    /// Where such a point of the surface lay on the smooth one.
    Place
    unmoved(const Vector3 &X) const;

    /// The exact smooth section.
    const FrameProfile &
    profile() const
    {
      return section_.profile();
    }
    const ContactFrame &
    frame() const
    {
      return frame_;
    }
    const WheelPose &
    pose() const
    {
      return pose_;
    }

  private:
    /// Of the irregularities at the place s of the smooth section.
    IrregularHeight
    raised(double s, const FrameProfile::Value &smooth, double along) const;

    Body                                  body_ = Body::rail;
    ContactFrame                          frame_;
    WheelPose                             pose_;       ///< of a rail its section alone counts
    double                                radius_ = 0; ///< of the arcs of a wheel [m]
    SectionHeights                        section_;
    std::shared_ptr<const Irregularities> irregular_; ///< null: smooth
    double                                origin_ = 0;
  };
} // namespace wheelrail
