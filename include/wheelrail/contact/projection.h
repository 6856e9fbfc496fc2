#pragma once

#include <wheelrail/contact/surface.h>
#include <wheelrail/contact/surface_state.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// Closest point on the wheel: the facet with the corner (i, j) of its lattice and the place in it, 0 to 1
  /// along and across. A negative i: none yet.
  struct FacetPoint
  {
    int    i = -1, j = -1;
    double xi = 0.5, eta = 0.5;
  };

  /// What a rail node finds on the wheel.
  struct Facing
  {
    std::array<std::size_t, 4> corners; ///< of the facet, indices of the lattice
    std::array<double, 4>      weight;  ///< of the corners at the closest point
    Vector3                    normal;  ///< out of the rail
    double                     gap;     ///< along the normal, of the true profiles [m]
    Vector3 tilt{}; ///< gradient of the height above the facet: normal + tilt is the true normal
  };

  /// Closest point of the rail's nodes on the facets of the wheel, and the gap between the true profiles
  /// there: facets and filter hide a part of them, which is kept as an offset of every place.
  class Projection
  {
  public:
    explicit Projection(RunningSurfaces surfaces);

    /// Takes the filtered places of the undeformed nodes.
    void
    prepare(const PerBody<SurfaceState> &states);

    /// Normals of the wheel's nodes at `stations`, continuous over the facets, from their places.
    void
    renew_normals(const Lattice &wheel, const StationRange &stations, const std::vector<Vector3> &x);

    /// The gap of the rail node `index` at its closest point.
    Facing
    facing(const Lattice               &wheel,
           const PerBody<SurfaceState> &states,
           std::size_t                  index,
           const FacetPoint            &point) const;

    const RunningSurfaces &
    surfaces() const
    {
      return surfaces_;
    }

  private:
    Vector3
    tilt(const Vector3 &X, const Vector3 &normal) const;

    RunningSurfaces      surfaces_;
    bool                 wheel_offsets_ = false; ///< the wheel has irregularities that are offsets of the gap
    std::vector<double>  rail_offset_;           ///< of the rail's profile beyond the filtered nodes [m]
    std::vector<Vector3> wheel_normal_;          ///< out of the rail
  };

  /// Closest point of `place` on the facets between the nodes `x` of a lattice at `stations` [m]; starts from
  /// `point`, or from the node (station, row) where it lies on none of them. False when the foot lies
  /// beyond the outermost facets.
  bool
  project(const Lattice              &lattice,
          const StationRange         &stations,
          const std::vector<Vector3> &x,
          const Vector3              &place,
          int                         station,
          int                         row,
          FacetPoint                 &point);
} // namespace wheelrail
