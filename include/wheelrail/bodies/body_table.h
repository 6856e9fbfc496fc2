#pragma once

#include <wheelrail/bodies/wave_stiffness.h>
#include <wheelrail/geometry/curve.h>

#include <vector>

namespace wheelrail
{
  /// What a body deflects beyond a half-space: the remainder of its compliance, at some wavenumbers, between
  /// rows of its running surface. It is smooth where the compliance itself is singular, so that rows of 2 mm
  /// and two dozen of wavenumbers serve patches of any fineness.
  struct BodyTable
  {
    struct Row
    {
      double arc    = 0; ///< along the profile, from its first point [m]
      double angle  = 0; ///< of the running direction against x [rad]
      double width  = 0; ///< [m]
      double radius = 0; ///< of a wheel, distance from the axle; of a rail 0 [m]
      Point2 growth;     ///< of a wheel that turns with 1 rad/s: displacement (x, y) [m s^2]
    };

    bool             wheel          = false;
    double           shear_modulus  = 0; ///< [Pa]
    double           poissons_ratio = 0;
    std::vector<Row> rows; ///< ascending arc: towards the track centre
    /// Wavenumbers k of a rail [1/m], numbers n of waves around a wheel; ascending. The first `harmonics`
    /// ones of a wheel are 0, 1, 2, ...
    std::vector<double> waves;
    unsigned int        harmonics = 0;
    /// For each wave the remainder: displacements (x, y, w) of row i under tractions (x, y, i z) on row j, x
    /// to the track centre, y up, in the axes of the section; value at 3 m (3 i + a) + 3 j + b [1/Pa]. Of a
    /// wheel the half-space at n = 0 is that at `least_wave`.
    std::vector<std::vector<double>> remainder;

    static constexpr double least_wave = 0.3; ///< of a wheel, in place of 0, where a half-space is singular
  };

  /// A place of a section, whose x points to the track centre and, of a wheel, whose y is the distance from
  /// the axle, in the frame of its profile (x to the field side, y up) [m].
  Point2
  profile_place(const Point2 &node, bool wheel, double nominal_radius);

  /// Rows of `cells` cells of a section that lie on its running surface itself, not on what joins that to the
  /// rest of the section. `profile`: the running surface; `nominal_radius` of a wheel [m].
  std::vector<SurfaceRow>
  rows_on_profile(const SectionMesh &mesh,
                  const Curve       &profile,
                  bool               wheel,
                  double             nominal_radius,
                  unsigned int       cells);

  /// The table of a rail on its clamped foot or of a wheel on its bore. Of rows_on_profile(). The
  /// remainder beside a row and on itself, where the elements err, is that of a cubic
  /// through the rows two and three away. Throws RunError as WaveStiffness does.
  BodyTable
  make_body_table(const SectionMesh &mesh,
                  const Curve       &profile,
                  const Elasticity  &elasticity,
                  bool               wheel,
                  double             nominal_radius,
                  unsigned int       cells);
} // namespace wheelrail
