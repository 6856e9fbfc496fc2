#include <wheelrail/base/errors.h>
#include <wheelrail/mesh/discretization.h>
#include <wheelrail/solid/boundary_nodes.h>
#include <wheelrail/statics/static_system.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

// Linear equations of a Newton step: displacements against a rigid lift of the wheel, and that lift
// (doc/theory/rolling.md, Static start, 2). Forces at the bore are 10^4 times those of the contact: the
// vertical balance by the lift alone does not see them.

namespace wheelrail
{
  namespace
  {
    /// 1 for the nodes of the bore that do not hang.
    std::vector<unsigned char>
    bore_nodes(const LocalMesh &mesh)
    {
      std::vector<unsigned char> marked(mesh.n_nodes(), 0);
      for (const unsigned int n : held_boundary_nodes(mesh, Boundary::bore))
        marked[n] = 1;
      for (const unsigned int n : mesh.hanging)
        marked[n] = 0;
      return marked;
    }

    /// 1 where either list has one.
    std::vector<unsigned char>
    either(std::vector<unsigned char> marked, const std::vector<unsigned char> &others)
    {
      for (std::size_t n = 0; n < marked.size(); ++n)
        marked[n] |= others[n];
      return marked;
    }
  } // namespace


  StaticSystem::StaticSystem(const Discretization &discretization, Solid &solid, const SceneParts &parts)
    : mesh_(solid.mesh)
    , communicator_(discretization.communicator())
    , parts_(parts, solid, communicator_)
    , bore_(bore_nodes(mesh_))
    , held_(either(bore_, parts_.held()))
    , multigrid_(std::make_unique<StaticMultigrid>(
        discretization,
        solid,
        held_,
        StaticGround{parts_.springs(), StaticSprings(parts_.joined(), mesh_, held_, communicator_)}))
    , rigid_(zero())
    , response_{zero(), 1}
  {
    for (std::size_t n = 0; n < mesh_.n_owned; ++n)
      // r: a rigid vertical displacement of the wheel. Unknowns are u = x + lift r, and lift: so the bodies'
      // own stiffness drops out of the vertical balance (doc/theory/rolling.md, Static start, 2).
      rigid_.begin()[4 * n + 1] = mesh_.node_body[n] == Body::wheel && !held_[n] ? 1 : 0;
    for (const unsigned int n : mesh_.hanging)
      if (mesh_.owns(n))
        rigid_.begin()[4 * n + 1] = 0;
  }


  StaticSystem::Vector
  StaticSystem::right_hand_side(const AlignedVector<double> &nodal) const
  {
    Vector vector = zero();
    for (std::size_t n = 0; n < mesh_.n_owned; ++n)
      if (!held_[n])
        // equations of free nodes alone: forces of hanging ones are at their parents, held ones have
        // reactions
        std::copy_n(&nodal[4 * n], 3, vector.begin() + 4 * n);
    for (const unsigned int n : mesh_.hanging)
      if (mesh_.owns(n))
        std::fill_n(vector.begin() + 4 * n, 3, 0.);
    return vector;
  }


  void
  StaticSystem::add_to_nodes(const Vector &increment, const double lift, AlignedVector<double> &nodal) const
  {
    Vector everywhere = increment;
    everywhere.update_ghost_values();
    for (std::size_t n = 0; n < held_.size(); ++n)
      if (bore_[n])
        // the bore moves with the axle, all other nodes by x + lift r, which `increment` holds already
        nodal[4 * n + 1] += lift;
      else if (!held_[n])
        for (unsigned int i = 0; i < 3; ++i)
          nodal[4 * n + i] += everywhere.begin()[4 * n + i];
    distribute(mesh_, nodal.data());
  }


  double
  StaticSystem::bore_force(const AlignedVector<double> &nodal) const
  {
    double sum = 0;
    for (std::size_t n = 0; n < bore_.size(); ++n)
      if (bore_[n] && mesh_.owns(n))
        sum += nodal[4 * n + 1];
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return sum;
  }


  void
  StaticSystem::set_springs(const std::vector<Contact::Spring> &springs)
  {
    multigrid_->set_springs(springs);
    rigid_stretch_ = multigrid_->finest().springs().stretch(rigid_.begin());
    find_lift_response();
  }


  unsigned int
  StaticSystem::solve(const Vector &forces, const double bore, const double tolerance, StaticStep &step)
  {
    // a rigid lift of the wheel moves all its nodes against the forces
    // right side of the lift: r' f + bore force
    const Unknowns     load  = {forces, forces * rigid_ + bore};
    Unknowns           x     = {zero(), 0};
    const unsigned int steps = conjugate_gradients<true>(load, x, tolerance * std::sqrt(dot(load, load)));
    step                     = {std::move(x.nodes), x.lift};
    step.increment.add(step.lift, rigid_);
    return steps;
  }


  unsigned int
  StaticSystem::solve_held(const Vector &forces, const double tolerance, Vector &increment)
  {
    Unknowns           x     = {zero(), 0};
    const unsigned int steps = conjugate_gradients<false>({forces, 0}, x, tolerance * forces.l2_norm());
    increment                = std::move(x.nodes);
    return steps;
  }


  StaticStep
  StaticSystem::precondition(const Vector &forces, const double bore)
  {
    Unknowns z = {zero(), 0};
    precondition({forces, forces * rigid_ + bore}, z);
    StaticStep step = {std::move(z.nodes), z.lift};
    step.increment.add(step.lift, rigid_);
    return step;
  }


  double
  StaticSystem::dot(const Unknowns &a, const Unknowns &b) const
  {
    return a.nodes * b.nodes + a.lift * b.lift;
  }


  /// A rigid lift of the whole wheel, its bore included, leaves no forces but those of the springs.
  void
  StaticSystem::product(const Unknowns &x, Unknowns &y)
  {
    StaticLevel &level = multigrid_->finest();
    level.elastic_product(x.nodes, y.nodes);
    add_stiffness_of_parts(x.nodes, y.nodes);
    std::vector<double> force = level.springs().stretch(x.nodes.begin());
    y.lift                    = 0;
    for (std::size_t k = 0; k < force.size(); ++k)
      {
        // C B (x + lift r): springs alone feel the rigid part
        force[k] = level.springs().stiffness()[k] * (force[k] + x.lift * rigid_stretch_[k]);
        // r' B' C B (x + lift r)
        y.lift += rigid_stretch_[k] * force[k];
      }
    level.springs().add(force, y.nodes.begin());
  }


  void
  StaticSystem::add_stiffness_of_parts(const Vector &x, Vector &y) const
  {
    if (parts_.springs().empty())
      return;
    parts_.add_stiffness(x.begin(), y.begin());
    y.zero_out_ghost_values(); // parts reach all nodes of the rank
    for (std::size_t n = 0; n < mesh_.n_owned; ++n)
      if (held_[n])
        std::fill_n(y.begin() + 4 * n, 3, 0.);
  }


  /// One cycle with the bore held, plus the response to a lift, which the cycle cannot know: the share of it
  /// that balances the forces along it (a coarse space of one vector, added).
  void
  StaticSystem::precondition(const Unknowns &forces, Unknowns &z)
  {
    // M^-1 = V cycle with the bore held + w w'/(w' K w)
    multigrid_->cycle(forces.nodes, z.nodes);
    // w (w' f)/(w' K w), w the response to a lift
    const double share = dot(forces, response_) / approach_stiffness_;
    z.nodes.add(share, response_.nodes);
    z.lift = share;
  }


  /// Conjugate gradients in the flexible form (Polak and Ribiere), which bears a preconditioner that is not
  /// quite linear, until the norm of the residual is below `enough`. Without lift the bore is held, and the
  /// forces on it count for nothing.
  template <bool with_lift>
  unsigned int
  StaticSystem::conjugate_gradients(Unknowns residual, Unknowns &x, const double enough)
  {
    constexpr unsigned int most_steps = 500;
    Unknowns               z = {zero(), 0}, step = {zero(), 0}, image = {zero(), 0};
    Unknowns               before         = {zero(), 0}; // residual
    double                 product_before = 1;
    for (unsigned int k = 0;; ++k)
      {
        if (!with_lift)
          residual.lift = 0;
        const double norm = std::sqrt(dot(residual, residual));
        if (norm <= enough)
          return k;
        if (k == most_steps || !std::isfinite(norm))
          throw RunError("the static start did not converge: conjugate gradients stopped after " +
                         std::to_string(k) +
                         " steps; lower Contact/Penalty scale, or take smaller coarse cells");
        if (with_lift)
          precondition(residual, z);
        else
          multigrid_->cycle(residual.nodes, z.nodes);
        const double along = dot(residual, z);
        // beta = z_k . (r_k - r_k-1)/(z_k-1 . r_k-1): of a fixed symmetric preconditioner the second part is
        // zero
        const double share = k == 0 ? 0 : (along - dot(before, z)) / product_before;
        step.nodes.sadd(share, 1, z.nodes);
        step.lift = share * step.lift + z.lift;
        product(step, image);
        // alpha = r . z/(p . K p)
        const double length = along / dot(step, image);
        x.nodes.add(length, step.nodes);
        x.lift += length * step.lift;
        before = residual;
        residual.nodes.add(-length, image.nodes);
        residual.lift -= length * image.lift;
        product_before = along;
        ++cg_steps;
      }
  }


  /// A rigid lift of the wheel, minus what the springs hold back, which is solved for: not far, since it only
  /// serves as preconditioner, and from the last one. A rail that sinks on its sleepers needs it to a
  /// hundredth: with a tenth each solution takes a third more steps.
  void
  StaticSystem::find_lift_response()
  {
    constexpr double tolerance = 0.01;
    Unknowns         load = {zero(), 0}, image = {zero(), 0};
    // w = (x, 1) with K (x, 1) = 0 in all rows of nodes: K x = -K r
    product({zero(), -1}, load);
    const double enough = tolerance * load.nodes.l2_norm();
    product(response_, image);
    Unknowns residual = {zero(), 0};
    // residual of -K r - K x for the last x: the search starts there
    residual.nodes -= image.nodes;
    conjugate_gradients<false>(std::move(residual), response_, enough);
    product(response_, image);
    // w' K w [N/m]: stiffness of the contact against a lift
    approach_stiffness_ = dot(response_, image);
  }


  AlignedVector<double>
  element_forces_at_rest(Solid &solid)
  {
    AlignedVector<double> force(solid.force.size(), 0.);
    ElementEnergy         ignored;
    subtract_internal_force(
      solid.blocks, solid.displacement.data(), force.data(), BulkViscosity(), false, ignored);
    condense(solid.mesh, force.data());
    sum_over_ranks(solid.mesh, force.data());
    return force;
  }
} // namespace wheelrail
