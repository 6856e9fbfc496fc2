#pragma once

#include <wheelrail/bodies/body_table.h>
#include <wheelrail/halfspace/added_influence.h>

#include <vector>

namespace wheelrail
{
  /// A body in a contact: where the rows of elements of the half-spaces lie on it.
  struct BodyPlacement
  {
    double              turn = 0;   ///< of the axes of the table against those of the track plane [rad]
    std::vector<double> arcs;       ///< along its own profile, of each row of elements [m]
    std::vector<double> angles;     ///< of the contact's lateral direction there against X [rad]
    double              radius = 0; ///< of a wheel, at the contact [m]
    /// The contact's lateral coordinate of each row of elements, which distances of half-spaces count in [m].
    std::vector<double> lateral;
  };

  /// The rows of a table around a contact.
  struct ContactRows
  {
    int                 first = 0, count = 0; ///< rows of the table
    std::vector<double> weights;              ///< cubic splines from them to the rows of elements: my x count
  };

  /// Rows over the range of the arcs and `beside` rows more on both sides; where the table ends, what lies
  /// beyond counts as its last row. Throws RunError where no four rows are there.
  ContactRows
  contact_rows(const BodyTable &table, const BodyPlacement &placement);

  /// The remainder of a body between those rows, back from waves to places along the track (inverse Fourier
  /// transform over k of a rail, sum over harmonics and integral beyond them for a wheel), in the axes X, Y,
  /// Z of the track. What a half-space along the contact's own lateral coordinate differs from one along the
  /// profile of the body is added, so that half-spaces of the contact plus this are the body.
  RowInfluence
  body_influence(const BodyTable           &table,
                 const BodyPlacement       &placement,
                 const ContactRows         &rows,
                 const std::vector<double> &lags);

  /// Displacement (X, Y) at each row of elements of a wheel that turns at `rate` [rad/s] [m].
  std::vector<Point2>
  growth(const BodyTable &table, const BodyPlacement &placement, const ContactRows &rows, double rate);
} // namespace wheelrail
