#pragma once

#include <wheelrail/bodies/body_influence.h>

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
} // namespace wheelrail
