#include <wheelrail/bodies/placed_bodies.h>

#include <cmath>
#include <cstddef>
#include <vector>

// Where the rows of elements lie on the profiles of both bodies, and R of (4) in doc/theory/bodies.md from
// that.
//
// R at lags i dx and at i dx + step: displacement here, and where the particle was one step before, for the
// slip (u - u')/dq.

namespace wheelrail
{
  RowsInfluence::Basis
  row_basis(const double angle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    // fixed axes X (to the track centre), Y (up), Z (forwards) in rows; columns x = Z, y = (c, s) along the
    // rail's profile, n = (s, -c) down into the rail, body 1: x x y is -n, out of the rail, about which spins
    // count
    return {{0, c, s, 0, s, -c, 1, 0, 0}};
  }


  PlacedBodies
  place_bodies(const BodyTables             &tables,
               const ContactGeometry        &contact,
               const std::vector<PlacedRow> &rows,
               const HalfspaceGrid          &grid,
               const double                  step)
  {
    // 0 the rail, 1 the wheel; both count the contact's lateral coordinate along the rail
    PlacedBodies placed;
    for (const PlacedRow &row : rows)
      {
        placed.bases.push_back(row_basis(row.angle));
        placed.placements[0].arcs.push_back(row.rail_arc);
        placed.placements[1].arcs.push_back(row.wheel_arc);
        for (BodyPlacement &placement : placed.placements)
          {
            placement.angles.push_back(row.angle);
            placement.lateral.push_back(row.lateral);
          }
      }
    // axes of a section against those of the track: inclination of the rail, roll of the wheel
    placed.placements[0].turn   = contact.rail.angle;
    placed.placements[1].turn   = contact.wheel.angle;
    placed.placements[1].radius = contact.rolling_radius;
    for (const int body : {0, 1})
      {
        // rows of the tables that bear on these elements, and R between them
        const BodyTable &table = body == 0 ? tables.rail : tables.wheel;
        placed.rows[body]      = contact_rows(table, placed.placements[body]);
        placed.influences[body] =
          body_influences(table, placed.placements[body], placed.rows[body], grid, step);
      }
    return placed;
  }


  std::shared_ptr<RowsInfluence>
  added_influence(const PlacedBodies &placed, const HalfspaceGrid &grid, const double step)
  {
    // R_rail + R_wheel of (4): the wheel has minus the tractions, and its displacement is subtracted
    auto added = std::make_shared<RowsInfluence>(grid, placed.bases);
    for (const BodyInfluences &influence : placed.influences)
      added->add_body(influence.here, influence.ahead, step);
    return added;
  }


  BodyInfluences
  body_influences(const BodyTable     &table,
                  const BodyPlacement &placement,
                  const ContactRows   &rows,
                  const HalfspaceGrid &grid,
                  const double         step)
  {
    std::vector<double>       lags  = RowsInfluence::lags(grid, 0);
    const std::vector<double> ahead = RowsInfluence::lags(grid, step);
    // lags i dx and i dx + step: for a step of one element the second set is the first moved on by one, and
    // only one lag is new
    const std::ptrdiff_t count = lags.size(), next = step == grid.dx ? 1 : count;
    lags.insert(lags.end(), ahead.end() - next, ahead.end());
    BodyInfluences       result{body_influence(table, placement, rows, lags), {}};
    std::vector<double> &all   = result.here.by_lag;
    const std::ptrdiff_t block = all.size() / lags.size();
    result.ahead               = {result.here.rows,
                                  result.here.weights,
                                  std::vector<double>(all.begin() + next * block, all.begin() + (next + count) * block)};
    all.resize(count * block);
    return result;
  }
} // namespace wheelrail
