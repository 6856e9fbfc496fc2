#pragma once

#include <wheelrail/bodies/body_influence.h>
#include <wheelrail/bodies/body_tables.h>
#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/halfspace/added_influence.h>

#include <array>
#include <memory>
#include <vector>

namespace wheelrail
{
  /// A body's influences as RowsInfluence::add_body() takes them.
  struct BodyInfluences
  {
    RowInfluence here, ahead; ///< of displacements, and of those seen a step further along x
  };

  /// Both in one pass of body_influence(), which takes the waves one by one: with steps of an element their
  /// lags are the same but one.
  BodyInfluences
  body_influences(const BodyTable     &table,
                  const BodyPlacement &placement,
                  const ContactRows   &rows,
                  const HalfspaceGrid &grid,
                  double               step);

  /// Where a row of elements along the track lies on both bodies.
  struct PlacedRow
  {
    double rail_arc = 0, wheel_arc = 0; ///< along the profiles [m]
    double angle   = 0;                 ///< of the contact's lateral direction against X [rad]
    double lateral = 0;                 ///< the contact's own lateral coordinate [m]
  };

  /// Both bodies under the rows of a contact: rail, wheel.
  struct PlacedBodies
  {
    std::vector<RowsInfluence::Basis> bases; ///< of the rows
    std::array<BodyPlacement, 2>      placements;
    std::array<ContactRows, 2>        rows; ///< of their tables
    std::array<BodyInfluences, 2>     influences;
  };

  /// The directions of RowsInfluence at a row inclined by `angle`: x along the track, y along the surface,
  /// n into the rail.
  RowsInfluence::Basis
  row_basis(double angle);

  /// Throws RunError as contact_rows() does.
  PlacedBodies
  place_bodies(const BodyTables             &tables,
               const ContactGeometry        &contact,
               const std::vector<PlacedRow> &rows,
               const HalfspaceGrid          &grid,
               double                        step);

  /// What both deflect beyond half-spaces, for the grid and the step that they were placed under.
  std::shared_ptr<RowsInfluence>
  added_influence(const PlacedBodies &placed, const HalfspaceGrid &grid, double step);
} // namespace wheelrail
