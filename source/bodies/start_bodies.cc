#include <wheelrail/base/errors.h>
#include <wheelrail/bodies/kept_tables.h>
#include <wheelrail/bodies/placed_bodies.h>
#include <wheelrail/bodies/start_bodies.h>
#include <wheelrail/planes/contact_sections.h>

#include <algorithm>
#include <memory>
#include <vector>

// R of (4) in doc/theory/bodies.md for the patch of a static start: across the track, where it makes both
// bodies yaw against each other under tractions (doc/theory/rolling.md, What half-spaces lack).

namespace wheelrail
{
  namespace
  {
    /// The displacements along the track.
    void
    leave_out_along(RowInfluence &influence)
    {
      // the stretch along the track is that of the finite elements (tread_stretch()): it is not taken twice
      const int n = 3 * influence.rows;
      for (std::size_t k = 0; k < influence.by_lag.size(); ++k)
        // row 3 i + a of the block of a lag: a = 2 is Z
        if (k / n % 3 == 2)
          influence.by_lag[k] = 0;
    }

    class StartBodies
    {
    public:
      StartBodies(const Scene &scene, const SceneGeometry &geometry)
        : geometry_(geometry)
        , tables_(make_body_tables(scene, geometry, kept_tables_folder()))
        , sections_(geometry, {}, whole_region(geometry.contact))
      {
      }

      /// Influences know the distance along the track alone, not the place there.
      std::shared_ptr<const AddedInfluence>
      on(const StartGrid &grid)
      {
        // rounds of pressures and tractions come back to the same grids: influences of the last four are kept
        const auto same = [&](const Kept &kept) {
          const HalfspaceGrid &one = kept.grid.grid, &other = grid.grid;
          return kept.grid.s_first == grid.s_first && kept.grid.s_step == grid.s_step && one.mx == other.mx &&
                 one.my == other.my && one.dx == other.dx && one.dy == other.dy;
        };
        const auto found = std::find_if(kept_.begin(), kept_.end(), same);
        if (found != kept_.end())
          return found->added;
        constexpr std::size_t most = 4;
        if (kept_.size() == most)
          kept_.erase(kept_.begin());
        // the oldest of four has left
        kept_.push_back({grid, made_for(grid)});
        return kept_.back().added;
      }

    private:
      struct Kept
      {
        StartGrid                             grid;
        std::shared_ptr<const AddedInfluence> added;
      };

      /// Null where the patch lies beside the tables or beyond the end of the section.
      std::shared_ptr<const AddedInfluence>
      made_for(const StartGrid &grid) const
      {
        const ContactGeometry &contact = geometry_.contact;
        const Curve           &head = geometry_.rail.head, &outline = contact.outline.curve;
        // two rows held at the same end would have no distance, whose logarithm the influence takes
        if (grid.s(1) <= sections_.s_min() || grid.s(grid.grid.my - 2) >= sections_.s_max())
          return {};
        // 1. Rows on both profiles; 2. influences across the track; 3. R as the half-space solver takes it
        std::vector<PlacedRow> rows;
        for (int j = 0; j < grid.grid.my; ++j)
          {
            // places on both profiles of each row of elements, of the undeformed bodies
            const double s     = std::clamp(grid.s(j), sections_.s_min(), sections_.s_max());
            const Point2 place = sections_.rail_place(s);
            // without the motion of (5) and (6), which facing_after_shift() takes from the finite elements
            const double tw = outline.closest(contact.wheel.to_section(place));
            rows.push_back({head.length(0, head.closest(contact.rail.to_section(place))),
                            // closest point of the wheel to the rail's row: arc on the tread
                            geometry_.wheel.tread.length(0, contact.outline.on_tread(tw)),
                            // one angle for both bodies: that of the wheel's section
                            sections_.slice(s).wheel_tangent,
                            grid.grid.y(j)});
          }
        try
          {
            PlacedBodies placed = place_bodies(tables_, contact, rows, grid.grid, grid.grid.dx);
            for (BodyInfluences &influences : placed.influences)
              {
                leave_out_along(influences.here);
                leave_out_along(influences.ahead);
              }
            return added_influence(placed, grid.grid, grid.grid.dx);
          }
        // no table, no correction: the start goes on with half-spaces
        catch (const RunError &)
          {
            return {};
          }
      }

      const SceneGeometry &geometry_;
      BodyTables           tables_;
      ContactSections      sections_;
      std::vector<Kept>    kept_;
    };
  } // namespace


  BeyondHalfspaces
  bodies_of_start(const Scene &scene, const SceneGeometry &geometry)
  {
    try
      {
        // tables are made or read once for a start
        const auto bodies = std::make_shared<StartBodies>(scene, geometry);
        // asked for by the first rank alone
        return [bodies](const StartGrid &grid) { return bodies->on(grid); };
      }
    catch (const RunError &)
      {
        return {};
      }
    catch (const InputError &)
      {
        return {};
      }
  }
} // namespace wheelrail
