#pragma once

#include <wheelrail/contactfiles/contact_case.h>
#include <wheelrail/geometry/plane.h>
#include <wheelrail/sections/sections_surface.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace wheelrail
{
  /// A rail or wheel section of an input file of CONTACT, seen on the right-hand side: the natural cubic
  /// spline over the chord length through its points, from kink to kink, from the track centre to the field
  /// side, y to the field side, z down [m].
  class ProfileLine
  {
  public:
    ProfileLine() = default;

    /// Points (y, z) in either order; one spline from end to end without `kinks`. Throws InputError for fewer
    /// than four points.
    explicit ProfileLine(std::vector<Point2> points, const std::string &file = "", bool kinks = true);

    /// Straight pieces from point to point, in either order.
    static ProfileLine
    straight(std::vector<Point2> points);

    /// A place on the line at the parameter t, 0 to end(), with the derivatives by t.
    struct Place
    {
      double y = 0, z = 0, dy = 0, dz = 0;

      double
      angle() const; ///< of the tangent against y, positive where it falls [rad]
    };
    Place
    at(double t) const;

    double
    end() const
    {
      return double(pieces_.size());
    }

    /// Length of the line from its first point with y >= 0, or else from its start, to t [m].
    double
    arc(double t) const;

    /// The parameter of a length, of the same zero; 0 or end() beyond the ends.
    double
    parameter(double arc) const;

    /// The line as straight pieces between points `spacing` apart along it, one of them at the length `from`:
    /// the mesh on which CONTACT takes the wheel's distance.
    ProfileLine
    chords(double from, double spacing) const;

    /// Parameters from 0 to end(), close enough for straight lines between them.
    const std::vector<double> &
    samples() const
    {
      return samples_;
    }

  private:
    /// Sets lengths and samples of the pieces.
    void
    measure();

    struct Piece
    {
      std::array<double, 4> y, z;
    };

    double
    length_within(std::size_t piece, double u) const;

    std::vector<Piece>  pieces_;
    std::vector<double> starts_; ///< lengths from the start to that of each piece [m]
    std::vector<double> samples_;
    double              zero_ = 0; ///< length from the start to that point [m]
  };

  /// The length on a section at which it passes y; of an end where it does not.
  double
  arc_at_y(const ProfileLine &line, double y);

  /// Reads the points of the profile that a line of an input file names, mirrored and scaled as the line
  /// says: y, z [m]. Throws InputError for what cannot be read.
  std::vector<Point2>
  section_points(const ContactProfile &profile, bool wheel);

  /// Reads the profile that a line of an input file names. Throws InputError for what cannot be read.
  ProfileLine
  section_line(const ContactProfile &profile, bool wheel);

  /// The surface of the slices that a line of an input file names, of a rail or a wheel, mirrored and scaled
  /// as the line says. Throws InputError for what cannot be read.
  std::shared_ptr<const SectionsSurface>
  contact_slices(const ContactProfile &profile, bool wheel);

  /// Its section at a place [m] or an angle [rad]. Throws InputError where there is none.
  ProfileLine
  section_at(const SectionsSurface &slices, double place, bool wheel = false);
} // namespace wheelrail
