// What the contact keeps of the mesh and from one step, or mesh, to the next.

#include <wheelrail/contact/contact.h>
#include <wheelrail/contact/surface_filter.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Where the node (0, 0) of one lattice lies in another part of the same endless lattice.
    struct Shift
    {
      bool same     = false; ///< the lattices are parts of one
      int  stations = 0, rows = 0;
    };

    Shift
    shift_between(const Lattice &before, const Lattice &after)
    {
      // both lattices are parts of one endless lattice where their spacings agree and their rows differ by a
      // whole number
      const auto alike = [](const double a, const double b) { return std::abs(a - b) <= 1e-9 * b; };
      Shift      shift;
      shift.same = before.n_along > 0 && alike(before.spacing_along, after.spacing_along) &&
                   alike(before.spacing_lateral, after.spacing_lateral);
      if (!shift.same)
        return shift;
      // stations count from Z = 0, rows from s_begin
      const double rows = (before.s_begin - after.s_begin) / after.spacing_lateral;
      shift.stations    = before.first_station - after.first_station;
      shift.rows        = static_cast<int>(std::lround(rows));
      shift.same        = std::abs(rows - shift.rows) < 1e-6;
      return shift;
    }

    /// The nodes of a lattice after the one before has moved along the endless lattice.
    std::vector<ContactNode>
    moved_nodes(const std::vector<ContactNode> &nodes,
                const PerBody<Lattice>         &before,
                const PerBody<Lattice>         &after)
    {
      // A history belongs to a particle of the rail, and a particle keeps its station and row on the endless
      // lattice, whatever part of it is stored.
      std::vector<ContactNode> moved(std::size_t(after.rail.n_along) * after.rail.n_lateral);
      const Shift              rail = shift_between(before.rail, after.rail),
                  wheel             = shift_between(before.wheel, after.wheel);
      if (!rail.same)
        return moved;
      for (int i = 0; i < static_cast<int>(before.rail.n_along); ++i)
        for (int j = 0; j < static_cast<int>(before.rail.n_lateral); ++j)
          {
            const int k = i + rail.stations, l = j + rail.rows;
            if (k < 0 || l < 0 || k >= static_cast<int>(after.rail.n_along) ||
                l >= static_cast<int>(after.rail.n_lateral))
              continue;
            ContactNode &node = moved[after.rail.index(k, l)];
            node              = nodes[before.rail.index(i, j)];
            // the same place on the wheel, in the numbers of the new lattice
            const FacetPoint foot{
              node.foot.i + wheel.stations, node.foot.j + wheel.rows, node.foot.xi, node.foot.eta};
            // a facet of the wheel needs both of its nodes in each direction
            const bool stored = node.foot.i >= 0 && wheel.same && foot.i >= 0 && foot.j >= 0 &&
                                foot.i + 1 < static_cast<int>(after.wheel.n_along) &&
                                foot.j + 1 < static_cast<int>(after.wheel.n_lateral);
            // a foot that is not stored is searched again
            node.foot = stored ? foot : FacetPoint();
          }
      return moved;
    }
  } // namespace


  Vector3
  Contact::mean_velocity(const Body body) const
  {
    const unsigned int  rows     = surface(body).lattice.n_lateral;
    const StationRange &stations = window()[body];
    const double        nodes    = double(stations.last - stations.first) * rows;
    Vector3             mean{};
    for (int i = stations.first; i < stations.last; ++i)
      for (unsigned int j = 0; j < rows; ++j)
        // of the window's nodes, each counted once
        add(mean, 1 / nodes, states_[body].v[surface(body).lattice.index(i, j)]);
    return mean;
  }


  void
  Contact::prepare(Surface rail, Surface wheel)
  {
    const PerBody<Lattice> before = {surface(Body::rail).lattice, surface(Body::wheel).lattice},
                           after  = {rail.lattice, wheel.lattice};
    nodes_                        = moved_nodes(nodes_, before, after);
    window_.prepare(std::move(rail), std::move(wheel));
    for (const Body body : both_bodies)
      {
        SurfaceState               &state = states_[body];
        const std::vector<Vector3> &X     = surface(body).reference;
        state.x = state.reference = X;
        state.v.assign(X.size(), {0, 0, 0});
        state.slip = state.normal_force = state.traction_force = state.v;
        // offsets w(X) count from the filtered places of the undeformed nodes, since gaps are between
        // filtered positions: the filter cuts a crown by w/2 D'D of it, which the offset gives back
        // (doc/theory/contact.md, Surface filter)
        filter_surface(surface(body).lattice,
                       0,
                       surface(body).lattice.n_along,
                       normal_weights(law_.filter[body]),
                       state.reference);
      }
    states_.rail.position = surface(Body::rail).reference;
    projection_.prepare(states_);
  }


  Contact::State
  Contact::state() const
  {
    // stations are the slow index: the window is one stretch of the array
    const auto first = nodes_.begin() + lattice().index(window().rail.first, 0);
    const auto last  = nodes_.begin() + lattice().index(window().rail.last, 0);
    return {window(), {first, last}};
  }


  void
  Contact::set_state(const State &state)
  {
    window_.set_stations(state.window);
    std::fill(nodes_.begin(), nodes_.end(), ContactNode());
    std::copy(
      state.nodes.begin(), state.nodes.end(), nodes_.begin() + lattice().index(window().rail.first, 0));
  }
} // namespace wheelrail
