#pragma once

#include <wheelrail/contact/contact_law.h>
#include <wheelrail/contact/projection.h>
#include <wheelrail/contact/window.h>

#include <mpi.h>

#include <array>
#include <functional>
#include <vector>

namespace wheelrail
{
  /// Node-to-facet penalty contact of the rail nodes (nodal quadrature) against the wheel facets, on
  /// the fine lattices of both bodies, with the gap between the true profiles. The lattices may differ;
  /// nodes that meet nodes make less noise in rolling (doc/theory/contact.md).
  ///
  /// A window of stations that follows the axle is known to all ranks (ContactWindow). They share its rail
  /// stations by turns: the closest point on the wheel (Projection) and the law there (apply_law). The forces
  /// of nodes that touch go to all ranks, and from there back to the nodes.
  class Contact
  {
  public:
    /// `half_window`: half length of the window [m]. prepare() must follow.
    Contact(RunningSurfaces surfaces, ContactLaw law, double half_window, MPI_Comm communicator);

    /// Takes the surfaces of the mesh and all that is made of them. Called again with other parts of the same
    /// endless lattices (other first stations, other rows), nodes that are stored before and after keep
    /// their histories; on lattices of another spacing all begin anew. gather() must follow.
    void
    prepare(Surface rail, Surface wheel);

    /// Centres the window at `along` [m]. `wheel_ahead` is the arc coordinate of the wheel that faces
    /// Z = along, minus along [m]. Cheap when nothing changes.
    void
    move_window(double along, double wheel_ahead);

    /// Fetches displacement and velocity (4 numbers a node) of the window's nodes. Collective.
    void
    gather(const double *displacement, const double *velocity);

    /// Gap, pressure, shear and nodal forces of the gathered state; the friction history is updated over
    /// `time_step` [s]. A zero step leaves velocities out and holds the shear tractions (static); nodes() are
    /// known to all ranks then, else after gather_nodes(). Collective.
    ContactSums
    evaluate(double time_step);

    /// Tells all ranks the nodes of all. Collective.
    void
    gather_nodes();

    /// Adds the nodal forces of the last evaluation: force has 4 numbers a node.
    void
    add_forces(double *force) const;

    /// Power of the nodal forces of the last evaluation on both bodies [W]: the part of the nodes that this
    /// rank owns. `velocity` gives that of a node of the rank [m/s].
    double
    power(const std::function<Vector3(unsigned int)> &velocity) const;

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
    set_traction(std::size_t node, const Vector3 &traction);

    const std::vector<ContactNode> &
    nodes() const
    {
      return nodes_;
    }
    const Surface &
    surface(const Body body) const
    {
      return window_.surfaces()[body];
    }
    const Surface &
    rail() const
    {
      return surface(Body::rail);
    }
    const Surface &
    wheel() const
    {
      return surface(Body::wheel);
    }
    /// Of the rail, whose nodes carry the contact.
    const Lattice &
    lattice() const
    {
      return rail().lattice;
    }
    const RunningSurfaces &
    surfaces() const
    {
      return projection_.surfaces();
    }
    const ContactLaw &
    law() const
    {
      return law_;
    }
    /// Stations of both lattices in the window.
    const PerBody<StationRange> &
    window() const
    {
      return window_.stations();
    }
    /// What one step leaves to the next: the window and its rail nodes in the order of the lattice, of
    /// which pressure, history and closest point count; all else follows from the nodal state of the bodies.
    struct State
    {
      PerBody<StationRange>    window;
      std::vector<ContactNode> nodes;
    };
    State
    state() const;
    /// Goes on from a state of a contact of the same lattice, whole on every rank.
    void
    set_state(const State &state);

    /// Force on the wheel of the rail nodes on the second of two rails, as last evaluated [N].
    Vector3
    force_of_second_rail() const;

    /// Mean velocity of the nodes of a body in the window, those of the last gather() [m/s].
    Vector3
    mean_velocity(Body body) const;

    /// Displacement of a node of the window, index in the lattice of its body, as the contact sees it:
    /// filtered, at the last gather [m].
    Vector3
    displacement(const Body body, const std::size_t node) const
    {
      return states_[body].x[node] - states_[body].reference[node];
    }
    /// Current position of a rail node in the window [m].
    const Vector3 &
    rail_position(std::size_t node) const
    {
      return states_.rail.position[node];
    }

  private:
    void
    filter_window(std::vector<Vector3> SurfaceState::*field, bool shear);
    /// A rail node in contact: the forces on the wheel, and where on it they act.
    struct Touch
    {
      std::size_t                index;
      std::array<std::size_t, 4> corners;
      std::array<double, 4>      weight;
      ContactForces              forces;
    };

    template <typename Function>
    void
    for_own_nodes(const Function &function) const;
    void
    touch(int i, int j, double time_step, ContactSums &sums, std::vector<Touch> &touches);
    bool
    find_gap(int i, int j, Facing &facing);
    ContactMotion
    motion(std::size_t index, const Facing &facing) const;
    void
    add_forces(const Touch &touch);
    bool
    at_border(int i, int j) const;

    MPI_Comm                 communicator_;
    int                      rank_ = 0, n_ranks_ = 1;
    ContactLaw               law_;
    ContactWindow            window_;
    Projection               projection_;
    PerBody<SurfaceState>    states_;
    std::vector<ContactNode> nodes_; ///< of the rail's lattice, as they are at the rank's own stations
  };
} // namespace wheelrail
