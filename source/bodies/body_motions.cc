#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/placed_bodies.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Turns and shift of each row of elements (doc/theory/bodies.md, Where both move to): phi_rail = n . d(R_rail
// t)/ds, phi_wheel = n . d(u of the wheel's remainder + growth)/ds, v = e_s . [wheel less rail + growth -
// approach e_Y], each the mean along the track over the pressure. First order alone: they are milliradians
// and tenths of a millimetre.

namespace wheelrail
{
  namespace
  {
    // changes of rows between rounds [rad], [m]
    constexpr double turn_settled = 2e-6, shift_settled = 1e-7;
  } // namespace


  // (5) and (6) of doc/theory/bodies.md
  std::vector<BodyContact::RowMotion>
  BodyContact::row_motions() const
  {
    const HalfspaceGrid       &grid = problem_.grid;
    const RowsInfluence::Given t    = tractions();
    const auto rail = added_->fixed_displacement(0, t), wheel = added_->fixed_displacement(1, t);
    // u_y of rail less wheel, half-spaces and remainder together [m]
    std::vector<double> against = displacements(*kernels_, {1}, t).front();
    added_->add_displacement(t, {{nullptr, &against, nullptr}});

    // means along the track, as the pressure of all rows is distributed there
    std::vector<double> weight(grid.mx, 0.);
    double              load = 0;
    for (int e = 0; e < grid.size(); ++e)
      {
        // one distribution along the track for all rows: a row without pressure moves, too
        weight[e % grid.mx] += solution_.pressure[e];
        load += solution_.pressure[e];
      }
    std::vector<Point2>    moved(grid.my), rim(growth_);
    std::vector<RowMotion> motions(grid.my);
    for (int j = 0; j < grid.my; ++j)
      {
        const double c = std::cos(rows_[j].angle), s = std::sin(rows_[j].angle);
        // (6): how far the wheel's steel moves along e_s = (cos a, sin a) against the rail's; the approach
        // lowers the wheel vertically
        motions[j].shift = c * growth_[j].x + s * (growth_[j].y - solution_.approach);
        for (int i = 0; i < grid.mx; ++i)
          {
            const int    e    = i + grid.mx * j;
            const double part = load > 0 ? weight[i] / load : 0;
            // `against` is rail less wheel along e_s: minus it moves the wheel
            motions[j].shift -= part * against[e];
            // (5): displacements of the remainder alone. A half-space's own surface turns with the pressure,
            // which the distance of the contact has already.
            moved[j] = moved[j] + part * Point2{rail[0][e], rail[1][e]};
            rim[j]   = rim[j] - part * Point2{wheel[0][e], wheel[1][e]};
          }
      }
    for (int j = 0; j < grid.my; ++j)
      {
        const int  low = std::max(0, j - 1), high = std::min(grid.my - 1, j + 1);
        const auto turn = [&](const std::vector<Point2> &of) {
          const Point2 change = of[high] - of[low];
          // n . du/ds, n = (-sin a, cos a), central differences, one-sided at both ends
          return (std::cos(rows_[j].angle) * change.y - std::sin(rows_[j].angle) * change.x) /
                 (grid.y(high) - grid.y(low));
        };
        motions[j].turn     = turn(moved);
        motions[j].rim_turn = turn(rim);
      }
    return motions;
  }


  BodyContact::RowMotion
  BodyContact::motion_at(const double y) const
  {
    if (motions_.empty())
      return {};
    // in rows, so that row_at() may be asked between rows and beside them
    const double place  = std::clamp((y - problem_.grid.y(0)) / problem_.grid.dy, 0., motions_.size() - 1.);
    const std::size_t j = std::min(std::size_t(place), motions_.size() - 2);
    // linear between rows; beyond them as at the end
    const double r = place - j;
    return {(1 - r) * motions_[j].turn + r * motions_[j + 1].turn,
            (1 - r) * motions_[j].shift + r * motions_[j + 1].shift,
            (1 - r) * motions_[j].rim_turn + r * motions_[j + 1].rim_turn};
  }


  double
  BodyContact::move_rows()
  {
    const HalfspaceGrid         &grid   = problem_.grid;
    const std::vector<RowMotion> before = motions_;
    // 1. Turns and shift by the solution of this round
    motions_      = row_motions();
    double change = before.empty() ? 1e3 : 0;
    // 2. New distance, angles and radius of each row that touches; `change` over what counts as settled
    for (int j = 0; j < grid.my; ++j)
      {
        if (!rows_[j].touches)
          continue;
        if (!before.empty())
          change = std::max({change,
                             std::abs(motions_[j].turn - before[j].turn) / turn_settled,
                             std::abs(motions_[j].shift - before[j].shift) / shift_settled});
        const Row moved = row_at(grid.y(j));
        if (!moved.touches)
          continue;
        for (int e = grid.mx * j; e < grid.mx * (j + 1); ++e)
          {
            // the same change along the row: the shape x^2/(2 r) stays
            problem_.undeformed_distance[e] += moved.distance - rows_[j].distance;
            problem_.normal_cosine[e] = std::cos(moved.angle);
          }
        rows_[j] = moved;
      }
    // 3. Tractions act in the turned directions; the influences themselves stay, those of the undeformed
    // sections
    std::vector<RowsInfluence::Basis> bases;
    for (const Row &row : rows_)
      bases.push_back(row_basis(row.angle));
    added_->set_bases(bases);
    return change;
  }
} // namespace wheelrail
