#include <wheelrail/base/gather_all.h>
#include <wheelrail/contact/contact.h>
#include <wheelrail/contact/surface_filter.h>

#include <cmath>
#include <utility>

// Contact at the nodes of the rail's lattice, each with its tributary area A: forces p A and t A, the
// opposite on the wheel's facet by bilinear weights (doc/theory/contact.md, Quadrature on the nodes). Nodes
// and not Gauss points: on equal lattices one pass meets the patch test, and each node carries its friction
// history through the patch.

namespace wheelrail
{
  Contact::Contact(RunningSurfaces surfaces, ContactLaw law, const double half_window, MPI_Comm communicator)
    : communicator_(communicator)
    , law_(law)
    , window_(half_window, communicator)
    , projection_(std::move(surfaces))
  {
    MPI_Comm_rank(communicator, &rank_);
    MPI_Comm_size(communicator, &n_ranks_);
  }


  void
  Contact::move_window(const double along, const double wheel_ahead)
  {
    const StationRange before = window().rail;
    if (!window_.move(along, wheel_ahead))
      return;
    // nodes that leave the window have left the patch long ago
    const StationRange &after = window().rail;
    for (int i = before.first; i < before.last; ++i)
      if (i < after.first || i >= after.last)
        for (unsigned int j = 0; j < lattice().n_lateral; ++j)
          nodes_[lattice().index(i, j)] = ContactNode();
  }


  void
  Contact::gather(const double *displacement, const double *velocity)
  {
    // Velocities pass two filters: the normal one for dg/dt, the shear one for sliding
    // (doc/theory/contact.md, Surface filter). The rail's unfiltered position is kept beside them.
    window_.gather(displacement, velocity, states_);
    filter_window(&SurfaceState::x, false);
    filter_window(&SurfaceState::v, false);
    filter_window(&SurfaceState::slip, true);
  }


  void
  Contact::filter_window(std::vector<Vector3> SurfaceState::*field, const bool shear)
  {
    for (const Body body : both_bodies)
      filter_surface(surface(body).lattice,
                     window()[body].first,
                     window()[body].last,
                     // S on the way in (positions, velocities) and on the way out (forces)
                     shear ? shear_weights(law_.filter[body]) : normal_weights(law_.filter[body]),
                     states_[body].*field);
  }


  ContactSums
  Contact::evaluate(const double time_step)
  {
    // 1. normals of the wheel's deformed, filtered surface
    projection_.renew_normals(wheel().lattice, window().wheel, states_.wheel.x);
    for (const auto &[body, k] : window_.nodes())
      states_[body].normal_force[k] = states_[body].traction_force[k] = {0, 0, 0};

    ContactSums        sums;
    std::vector<Touch> touches;
    // 2. nodes of this rank's stations: closest point, gap, law
    for_own_nodes([&](const int i, const int j) { touch(i, j, time_step, sums, touches); });
    if (n_ranks_ > 1)
      {
        struct Part
        {
          ContactSums sums;
          int         touches;
        };
        // two calls: their sums with how many touches come, then those
        const std::vector<Part> own = {{sums, static_cast<int>(touches.size())}};
        std::vector<int>        counts;
        sums = ContactSums();
        for (const Part &part : gather_all(own, std::vector<int>(n_ranks_, 1), communicator_))
          {
            sums += part.sums;
            counts.push_back(part.touches);
          }
        touches = gather_all(touches, counts, communicator_);
        if (time_step == 0)
          gather_nodes();
      }
    // 3. forces of all nodes on both surfaces
    for (const Touch &at : touches)
      add_forces(at);
    // forces go back through the filters that places and velocities came through
    filter_window(&SurfaceState::normal_force, false);
    filter_window(&SurfaceState::traction_force, true);
    return sums;
  }


  /// Calls function(i, j) for the rail's nodes of the window at the stations that this rank evaluates, which
  /// stay the same when window and mesh move.
  template <typename Function>
  void
  Contact::for_own_nodes(const Function &function) const
  {
    for (int i = window().rail.first; i < window().rail.last; ++i)
      if (const int turn = (lattice().first_station + i) % n_ranks_; (turn + n_ranks_) % n_ranks_ == rank_)
        for (unsigned int j = 0; j < lattice().n_lateral; ++j)
          function(i, static_cast<int>(j));
  }


  Vector3
  Contact::force_of_second_rail() const
  {
    Vector3 sum{};
    for_own_nodes([&](const int i, const int j) {
      const std::size_t  k    = lattice().index(i, j);
      const ContactNode &node = nodes_[k];
      if (node.pressure > 0 && surfaces().rail.on_second_rail(states_.rail.reference[k]))
        // on the wheel: p A n - t A
        add(sum, rail().area[k], node.pressure * node.normal - node.traction);
    });
    for (double &component : sum)
      MPI_Allreduce(MPI_IN_PLACE, &component, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return sum;
  }


  void
  Contact::touch(const int           i,
                 const int           j,
                 const double        time_step,
                 ContactSums        &sums,
                 std::vector<Touch> &touches)
  {
    const std::size_t k    = lattice().index(i, j);
    ContactNode      &node = nodes_[k];
    // 1. Gap; a node that faces no facet is open
    Facing facing;
    if (!find_gap(i, j, facing))
      {
        // one that pressed in the step before has run out of the window
        sums.at_border = sums.at_border || node.pressure > 0;
        node           = ContactNode();
      }
    // an open node forgets its shear
    if (node.gap >= 0)
      {
        node.pressure = 0;
        node.elastic = node.traction = node.slip = {0, 0, 0};
        node.slipping                            = false;
        return;
      }
    // the law counts on the tributary area of the node (doc/theory/contact.md, Quadrature on the nodes)
    // 2. A static evaluation has no velocities: no damper, and the shear spring keeps its traction
    ContactMotion moves        = time_step > 0 ? motion(k, facing) : ContactMotion();
    moves.tilt                 = facing.tilt;
    const ContactForces forces = apply_law(law_, moves, time_step, rail().area[k], node, sums);
    // forces on the wheel act at the rail's node: both bodies get opposite forces, moments differ by gap
    // times traction
    add(sums.moment, 1, cross(states_.rail.x[k], forces.push + forces.drag));
    touches.push_back({k, facing.corners, facing.weight, forces});
    sums.at_border = sums.at_border || (node.pressure > 0 && at_border(i, j));
  }


  void
  Contact::gather_nodes()
  {
    struct Known
    {
      std::size_t index;
      ContactNode node;
    };
    // after a static evaluation, for output and for half-spaces of the start
    if (n_ranks_ == 1)
      return;
    std::vector<Known> own;
    for_own_nodes([&](const int i, const int j) {
      const std::size_t k = lattice().index(i, j);
      own.push_back({k, nodes_[k]});
    });
    for (const Known &known : gather_all(own, communicator_))
      nodes_[known.index] = known.node;
  }


  /// Closest point, gap and normal of the rail node (i, j); false when it faces no facet of the window.
  bool
  Contact::find_gap(const int i, const int j, Facing &facing)
  {
    const Lattice    &r = lattice(), &w = wheel().lattice;
    const std::size_t k = r.index(i, j);
    // first guess of the foot: the wheel's node at the same place along and across
    const double along = (r.first_station + i) * r.spacing_along + window_.wheel_ahead(),
                 s     = r.s_begin + j * r.spacing_lateral;
    ContactNode &node  = nodes_[k];
    if (!project(w,
                 window().wheel,
                 states_.wheel.x,
                 states_.rail.x[k],
                 static_cast<int>(std::lround(along / w.spacing_along)) - w.first_station,
                 static_cast<int>(std::lround((s - w.s_begin) / w.spacing_lateral)),
                 node.foot))
      return false;
    facing      = projection_.facing(w, states_, k, node.foot);
    node.normal = facing.normal;
    node.gap    = facing.gap;
    return true;
  }


  ContactMotion
  Contact::motion(const std::size_t index, const Facing &facing) const
  {
    ContactMotion motion;
    Vector3       velocity{};
    for (int m = 0; m < 4; ++m)
      {
        add(velocity, facing.weight[m], states_.wheel.v[facing.corners[m]]);
        add(motion.slip, facing.weight[m], states_.wheel.slip[facing.corners[m]]);
      }
    // dg/dt = (v_w - v_r) . n, v_w at the foot by the facet's weights; the true normal is n + tilt
    motion.opening = dot(velocity - states_.rail.v[index], facing.normal + facing.tilt);
    // v_s of the wheel against the rail, from velocities through the shear filter; the part along n is taken
    // off
    motion.slip = motion.slip - states_.rail.slip[index];
    add(motion.slip, -dot(motion.slip, facing.normal), facing.normal);
    return motion;
  }


  /// Those on the wheel are spread over its facet.
  void
  Contact::add_forces(const Touch &touch)
  {
    for (int m = 0; m < 4; ++m)
      {
        // the transpose of the interpolation: power of forces on nodes = force times velocity of the foot
        add(states_.wheel.normal_force[touch.corners[m]], touch.weight[m], touch.forces.push);
        add(states_.wheel.traction_force[touch.corners[m]], touch.weight[m], touch.forces.drag);
      }
    // action and reaction: sums of forces over both surfaces vanish exactly
    add(states_.rail.normal_force[touch.index], -1, touch.forces.push);
    add(states_.rail.traction_force[touch.index], -1, touch.forces.drag);
  }


  bool
  Contact::at_border(const int i, const int j) const
  {
    // within two cells of the border of window or fine zone: the run stops with a sentence
    // (doc/theory/contact.md, Window and ranks)
    const StationRange &r = window().rail, &w = window().wheel;
    const FacetPoint   &foot = nodes_[lattice().index(i, j)].foot;
    return i <= r.first + 1 || i >= r.last - 2 || j <= 1 || j + 2 >= static_cast<int>(lattice().n_lateral) ||
           foot.i <= w.first || foot.i >= w.last - 2;
  }


  void
  Contact::add_forces(double *force) const
  {
    window_.scatter(states_, force);
  }


  double
  Contact::power(const std::function<Vector3(unsigned int)> &velocity) const
  {
    double sum = 0;
    for (const auto &[body, k] : window_.own())
      {
        const Vector3 force = states_[body].normal_force[k] + states_[body].traction_force[k];
        if (force != Vector3{}) // few of the window's nodes have one
          // [W], of own nodes alone, so that ranks add up
          sum += dot(force, velocity(surface(body).local[k]));
      }
    return sum;
  }


  void
  Contact::set_traction(const std::size_t node, const Vector3 &traction)
  {
    // the history alone: evaluate() bounds it by mu p of the node and makes the traction of it
    nodes_[node].elastic = traction;
  }
} // namespace wheelrail
