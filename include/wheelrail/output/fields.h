#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace wheelrail
{
  /// One named field on the points of a mesh, one, three or six numbers a point.
  struct PointField
  {
    std::string         name;
    std::string         unit;           ///< "Pa", "m", "m/s", "1"
    unsigned int        components = 1; ///< 1, 3, or 6: a symmetric tensor as xx yy zz xy yz xz
    std::vector<double> values;         ///< components x points, point by point
  };

  /// The part of a mesh of hexahedra (8 points a cell) or quadrilaterals (4) that one rank holds,
  /// in current positions; cell points in lexicographic order, which is deal.II's.
  struct FieldMesh
  {
    unsigned int                       points_per_cell = 8;
    std::vector<std::array<double, 3>> points; ///< [m]
    std::vector<unsigned int>          cells;  ///< points_per_cell x cells
    std::vector<PointField>            fields;
    std::vector<std::uint8_t>          body; ///< of each cell: 0 rail, 1 wheel; empty: not written
  };

  /// The contact patch on the rail surface at one instant, on a structured grid of surface nodes:
  /// index = i * n_lateral + j, i along the track (rolling direction), j towards the track centre.
  /// Stored tractions act on the rail.
  struct PatchFields
  {
    double              time = 0, rolled_distance = 0; ///< [s], [m]
    unsigned int        n_along = 0, n_lateral = 0;
    std::vector<double> along;            ///< position relative to the axle along Z [m]
    std::vector<double> lateral;          ///< contact frame coordinate s [m]
    std::vector<double> gap;              ///< signed gap, negative = penetration [m]
    std::vector<double> pressure;         ///< [Pa]
    std::vector<double> traction_along;   ///< shear traction on the rail along the track [Pa]
    std::vector<double> traction_lateral; ///< along s [Pa]
    std::vector<double> slip_along;       ///< slip velocity of the wheel against the rail, over V [1]
    std::vector<double> slip_lateral;
    std::vector<double> state; ///< 0 open, 1 stick, 2 slip
    std::vector<double> area;  ///< tributary area [m2]
  };

  /// A growing table of histories; all columns have one value a row.
  struct History
  {
    std::vector<std::string>         names; ///< "time", "normal_force", ...
    std::vector<std::string>         units; ///< "s", "N", ...
    std::vector<std::vector<double>> columns;
  };

  /// The column of that name; null when there is none.
  const std::vector<double> *
  find_column(const History &table, const std::string &name);

  /// The same; throws std::logic_error when there is none.
  const std::vector<double> &
  column(const History &table, const std::string &name);
} // namespace wheelrail
