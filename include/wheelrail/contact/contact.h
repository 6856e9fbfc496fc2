#pragma once

#include <wheelrail/contact/surface_filter.h>
#include <wheelrail/material/friction.h>

#include <mpi.h>

#include <vector>

namespace wheelrail
{
  /// Constants of the contact law.
  ///
  /// Pressure p = stiffness x penetration + damping x closing speed, never negative; shear traction
  /// by elastic trial with `stiffness` and return to the bound mu(v) x p, v the sliding velocity
  /// (equations 2 and 3 of Ma, Markine, Mashal and Ren 2017, as tractions instead of forces).
  struct ContactLaw
  {
    double        stiffness = 0; ///< normal and tangential, f K / h [N/m3]
    double        damping   = 0; ///< [N s/m3]
    FrictionLaw   friction;
    SurfaceFilter filter[2]; ///< of rail and wheel
  };

  /// State of one rail node that may touch the wheel. Tractions act on the rail.
  struct ContactNode
  {
    double  gap      = 1; ///< along the normal, negative in contact [m]
    double  pressure = 0; ///< [Pa]
    Vector3 normal{};     ///< out of the rail
    Vector3 shear{};      ///< elastic part, the history [Pa]
    Vector3 traction{};   ///< shear traction with its damping part [Pa]
    Vector3 slip{};       ///< velocity of the wheel against the rail beyond the elastic part [m/s]
    bool    slipping = false;

    // closest point on the wheel: facet with corner (facet_i, facet_j) and place in it
    int    facet_i = -1, facet_j = -1;
    double xi = 0.5, eta = 0.5;
  };

  /// Sums over the contact at one instant. Forces act on the wheel.
  struct ContactSums
  {
    Vector3 force{};                  ///< [N]
    double  normal_force     = 0;     ///< sum of p A [N]
    double  stored_energy    = 0;     ///< in the penalty springs [J]
    double  friction_power   = 0;     ///< [W]
    double  damping_power    = 0;     ///< [W]
    double  largest_pressure = 0;     ///< [Pa]
    int     nodes            = 0;     ///< in contact
    bool    at_border        = false; ///< the patch touches the border of the window
  };

  /// Node-to-facet penalty contact of the rail nodes (nodal quadrature) against the wheel facets, on
  /// the fine lattices of both bodies, with the gap between the true profiles. The lattices may differ;
  /// nodes that meet nodes make less noise in rolling (doc/theory/contact.md).
  ///
  /// A window of stations that follows the axle is known to all ranks, and all of them evaluate it
  /// alike, so results do not depend on the partition.
  class Contact
  {
  public:
    Contact(Surface         rail,
            Surface         wheel,
            RunningSurfaces surfaces,
            ContactLaw      law,
            double          half_window,
            MPI_Comm        communicator);

    /// Centres the window at `along` [m]. `wheel_ahead` is the arc coordinate of the wheel that faces
    /// Z = along, minus along [m]. Cheap when nothing changes.
    void
    move_window(double along, double wheel_ahead);

    /// Fetches displacement and velocity (4 numbers a node) of the window's nodes. Collective.
    void
    gather(const double *displacement, const double *velocity);

    /// Gap, pressure, shear and nodal forces of the gathered state; the friction history goes on by
    /// `time_step` [s]. A zero step leaves velocities out and holds the shear tractions (static).
    ContactSums
    evaluate(double time_step);

    /// Adds the nodal forces of the last evaluation: force has 4 numbers a node.
    void
    add_forces(double *force) const;

    /// A loaded rail node as a tangent spring along the normal, for the static start: it is stretched by
    /// the sum of weight x displacement of its nodes (filtered node and facet, numbered globally).
    struct Spring
    {
      unsigned int                                 point; ///< rail node, index in the lattice
      std::vector<std::pair<unsigned int, double>> nodes; ///< rail positive, wheel negative
      Vector3                                      normal;
      double                                       stiffness; ///< [N/m]
    };
    std::vector<Spring>
    springs() const;

    /// Sets the shear traction of a rail node [Pa], for a start with given tractions.
    void
    set_shear(std::size_t node, const Vector3 &shear);

    const std::vector<ContactNode> &
    nodes() const
    {
      return nodes_;
    }
    const Surface &
    rail() const
    {
      return rail_;
    }
    const Surface &
    wheel() const
    {
      return wheel_;
    }
    /// Of the rail, whose nodes carry the contact.
    const Lattice &
    lattice() const
    {
      return rail_.lattice;
    }
    const RunningSurfaces &
    surfaces() const
    {
      return surfaces_;
    }
    const ContactLaw &
    law() const
    {
      return law_;
    }
    /// Station range [first, last) of rail and wheel in the window.
    struct Window
    {
      int rail_first = 0, rail_last = 0, wheel_first = 0, wheel_last = 0;
    };
    const Window &
    window() const
    {
      return window_;
    }
    /// What one step leaves to the next: the window and its rail nodes in the order of the lattice, of
    /// which pressure, shear and closest point count; all else follows from the nodal state of the bodies.
    struct State
    {
      Window                   window;
      std::vector<ContactNode> nodes;
    };
    State
    state() const;
    /// Goes on from a state of a contact of the same lattice, whole on every rank.
    void
    set_state(const State &state);

    /// Current position of a rail node in the window [m].
    const Vector3 &
    rail_position(std::size_t node) const
    {
      return position_[node];
    }

  private:
    /// Filtered positions and velocities and the forces of one body's surface nodes; only the window
    /// is kept fresh.
    struct SurfaceState
    {
      std::vector<Vector3> x, reference; ///< [m]
      std::vector<Vector3> v, sliding;   ///< velocities with the normal filter and the shear filter [m/s]
      std::vector<Vector3> f, shear;     ///< normal and tangential forces [N]
    };
    /// What one rank sends of the window.
    struct Share
    {
      std::vector<std::array<unsigned int, 2>> own; ///< (body, node) sent by this rank
      std::vector<std::array<unsigned int, 2>> all; ///< in the order of arrival
      std::vector<int>                         counts, begin;
    };

    void
    share_window();
    void
    filter_window(std::vector<Vector3> SurfaceState::*field, bool shear);
    void
    wheel_normals();
    bool
    project(ContactNode &node, const Vector3 &x, int station, int row) const;
    double
    true_gap(ContactNode &node, std::size_t index, std::array<double, 4> &weight) const;
    void
    apply_law(ContactNode                 &node,
              std::size_t                  index,
              const std::array<double, 4> &weight,
              double                       time_step,
              ContactSums                 &sums);
    std::array<std::size_t, 4>
    corners(const ContactNode &node) const;
    /// Number of cells of the lattice in half the window.
    int
    half_window(const Lattice &lattice) const;

    Surface                  rail_, wheel_;
    RunningSurfaces          surfaces_;
    ContactLaw               law_;
    double                   half_window_; ///< [m]
    MPI_Comm                 communicator_;
    Window                   window_;
    double                   wheel_ahead_ = 0; ///< arc coordinate of the wheel facing Z, minus Z [m]
    Share                    share_;
    SurfaceState             state_[2];
    std::vector<Vector3>     position_;     ///< rail nodes, not filtered
    std::vector<double>      rail_offset_;  ///< of the rail's profile beyond the filtered nodes [m]
    std::vector<Vector3>     wheel_normal_; ///< out of the rail, at wheel nodes of the window
    std::vector<ContactNode> nodes_;
    std::vector<double>      send_, receive_;
  };
} // namespace wheelrail
