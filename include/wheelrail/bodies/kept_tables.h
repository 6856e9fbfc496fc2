#pragma once

#include <wheelrail/bodies/body_table.h>

#include <string>

namespace wheelrail
{
  /// The folder where tables are kept: WHEELRAIL_CACHE of the environment; else wheelrail in XDG_CACHE_HOME,
  /// or in .cache of the user's home; empty where there is none of them.
  std::string
  kept_tables_folder();

  /// More tables than these are not kept: those that were not used for the longest time go. One takes some 7
  /// MB.
  constexpr unsigned int most_kept_tables = 60;

  /// make_body_table(), kept in a folder under a name that follows from what the table depends on: nodes and
  /// cells of the section, rows on the profile, elastic constants, density, cells a row, code and compiler. A
  /// table that is there is read in place of making it, if the checksum of its bytes and of all it depends on
  /// is at its end; else it is made anew; one that cannot be written is not kept. Several calls at once
  /// do not disturb each other. An empty folder: nothing is kept.
  BodyTable
  kept_body_table(const std::string &folder,
                  const SectionMesh &mesh,
                  const Curve       &profile,
                  const Elasticity  &elasticity,
                  bool               wheel,
                  double             nominal_radius,
                  unsigned int       cells);
} // namespace wheelrail
