#include <wheelrail/base/errors.h>
#include <wheelrail/mesh/discretization.h>
#include <wheelrail/solid/boundary_nodes.h>
#include <wheelrail/solid/exchange.h>
#include <wheelrail/statics/static_system.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/linear_operator.h>
#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <string>
#include <utility>

// Linear equations of a Newton step: displacements against a rigid vertical displacement of the wheel, and
// that displacement (doc/theory/rolling.md, Static start, 2). Forces at the bore are 10^4 times those of the
// contact: the vertical balance by the hub displacement alone does not see them.
// What parts of a scene give to the static start: loads, springs, held nodes (doc/theory/rolling.md, Time
// stepping).

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
    , response_(zero())
  {
    for (std::size_t n = 0; n < mesh_.n_owned; ++n)
      // r: a rigid vertical displacement of the wheel. Unknowns are u = x + U r, and U, the hub displacement:
      // so the bodies' own stiffness drops out of the vertical balance (doc/theory/rolling.md, Static start,
      // 2).
      rigid_.begin()[4 * n + 1] = mesh_.node_body[n] == Body::wheel && !held_[n] ? 1 : 0;
    for (const unsigned int n : mesh_.hanging)
      if (mesh_.owns(n))
        rigid_.begin()[4 * n + 1] = 0;
  }


  StaticSystem::Vector
  StaticSystem::right_hand_side(const AlignedVector<double> &nodal) const
  {
    // signs: a nodal force is positive where it pushes the node along the axis; in equilibrium it is zero
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
  StaticSystem::add_to_nodes(const Vector          &increment,
                             const double           hub_displacement,
                             AlignedVector<double> &nodal) const
  {
    Vector everywhere = increment;
    everywhere.update_ghost_values();
    for (std::size_t n = 0; n < held_.size(); ++n)
      if (bore_[n])
        // the bore moves with the axle, all other nodes by x + U r, which `increment` holds already
        nodal[4 * n + 1] += hub_displacement;
      else if (!held_[n])
        for (unsigned int i = 0; i < 3; ++i)
          nodal[4 * n + i] += everywhere.begin()[4 * n + i];
    distribute(mesh_, nodal.data());
  }


  double
  StaticSystem::bore_force(const AlignedVector<double> &nodal) const
  {
    // hanging nodes are not marked: their forces are at their parents
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
    // B r: how much a rigid vertical displacement of 1 m stretches each spring
    rigid_stretch_ = multigrid_->finest().springs().stretch(rigid_.begin());
    find_lift_response();
  }


  unsigned int
  StaticSystem::solve(const Vector &forces, const double bore, const double tolerance, StaticStep &step)
  {
    // a rigid vertical displacement of the wheel moves all its nodes against the forces
    // right side of the hub displacement: r' f + bore force
    const Unknowns load = unknowns(forces, forces * rigid_ + bore);
    // | K + B'CB   B'C B r | |x|   | f           |
    // | r'B'C B    r'B'CBr | |U| = | r'f + bore  |   symmetric, positive definite once a node touches
    Unknowns           x     = unknowns(zero(), 0);
    const unsigned int steps = conjugate_gradients(
      [this](Unknowns &y, const Unknowns &of) {
        set_hub_displacement(y, product(of.block(0), hub_displacement(of), y.block(0)));
      },
      [this](Unknowns &z, const Unknowns &of) {
        set_hub_displacement(z, precondition(of.block(0), hub_displacement(of), z.block(0)));
      },
      load,
      tolerance * load.l2_norm(),
      x);
    step = {x.block(0), hub_displacement(x)};
    // u = x + U r at the free nodes
    step.increment.add(step.hub_displacement, rigid_);
    return steps;
  }


  StaticStep
  StaticSystem::precondition(const Vector &forces, const double bore)
  {
    StaticStep step       = {zero(), 0};
    step.hub_displacement = precondition(forces, forces * rigid_ + bore, step.increment);
    step.increment.add(step.hub_displacement, rigid_);
    return step;
  }


  StaticSystem::Unknowns
  StaticSystem::unknowns(const Vector &nodes, const double hub_displacement) const
  {
    dealii::IndexSet own(1);
    if (dealii::Utilities::MPI::this_mpi_process(communicator_) == 0)
      own.add_index(0);
    Unknowns x(2);
    x.block(0) = nodes;
    x.block(1).reinit(own, communicator_);
    x.collect_sizes();
    set_hub_displacement(x, hub_displacement);
    return x;
  }


  void
  StaticSystem::set_hub_displacement(Unknowns &x, const double hub_displacement)
  {
    x.block(1) = hub_displacement;
  }


  double
  StaticSystem::hub_displacement(const Unknowns &x) const
  {
    return dealii::Utilities::MPI::sum(x.block(1).locally_owned_size() > 0 ? x.block(1).local_element(0) : 0.,
                                       communicator_);
  }


  /// A rigid vertical displacement of the whole wheel, its bore included, leaves no forces but those of the
  /// springs.
  double
  StaticSystem::product(const Vector &x, const double hub_displacement, Vector &y)
  {
    StaticLevel &level = multigrid_->finest();
    level.elastic_product(x, y);
    add_stiffness_of_parts(x, y);
    std::vector<double> force = level.springs().stretch(x.begin());
    double              along = 0;
    for (std::size_t k = 0; k < force.size(); ++k)
      {
        // C B (x + U r): springs alone feel the rigid part
        force[k] = level.springs().stiffness()[k] * (force[k] + hub_displacement * rigid_stretch_[k]);
        // r' B' C B (x + U r)
        along += rigid_stretch_[k] * force[k];
      }
    level.springs().add(force, y.begin());
    return along;
  }


  void
  StaticSystem::add_stiffness_of_parts(const Vector &x, Vector &y) const
  {
    if (parts_.springs().empty())
      return;
    parts_.add_stiffness(x.begin(), y.begin());
    // K_p x with the parts' own unknowns in equilibrium (static condensation)
    y.zero_out_ghost_values(); // parts reach all nodes of the rank
    for (std::size_t n = 0; n < mesh_.n_owned; ++n)
      if (held_[n])
        std::fill_n(y.begin() + 4 * n, 3, 0.);
  }


  /// One cycle with the bore held, plus the response to a vertical displacement, which the cycle cannot know:
  /// the share of it that balances the forces along it (a coarse space of one vector, added).
  double
  StaticSystem::precondition(const Vector &forces, const double along, Vector &z)
  {
    // M^-1 = V cycle with the bore held + w w'/(w' K w)
    multigrid_->cycle(forces, z);
    // w (w' f)/(w' K w), w the response to a vertical displacement
    const double share = (forces * response_ + along) / approach_stiffness_;
    z.add(share, response_);
    return share;
  }


  /// In the flexible form, which bears a preconditioner that is not quite linear, until the norm of the
  /// residual is below `enough`.
  template <typename Values, typename Product, typename Preconditioner>
  unsigned int
  StaticSystem::conjugate_gradients(const Product        &product,
                                    const Preconditioner &preconditioner,
                                    const Values         &load,
                                    const double          enough,
                                    Values               &x)
  {
    // Polak and Ribiere's factor in place of Fletcher and Reeves': the coarse solver by rough conjugate
    // gradients is not quite linear, and with the plain one directions lose their conjugacy
    dealii::SolverControl                 control(500, enough, false, false);
    dealii::PrimitiveVectorMemory<Values> memory; // others keep their vectors
    dealii::LinearOperator<Values>        matrix, inverse;
    matrix.vmult  = product;
    inverse.vmult = preconditioner;
    try
      {
        dealii::SolverFlexibleCG<Values>(control, memory).solve(matrix, x, load, inverse);
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
      }
    if (control.last_check() != dealii::SolverControl::success)
      throw RunError("the static start did not converge: conjugate gradients stopped after " +
                     std::to_string(control.last_step()) +
                     " steps; lower Contact/Penalty scale, or take smaller coarse cells");
    cg_steps += control.last_step();
    return control.last_step();
  }


  unsigned int
  StaticSystem::solve_held(const Vector &forces, const double tolerance, Vector &increment)
  {
    return conjugate_gradients([this](Vector &y, const Vector &of) { product(of, 0, y); },
                               [this](Vector &z, const Vector &of) { multigrid_->cycle(of, z); },
                               forces,
                               tolerance * forces.l2_norm(),
                               increment);
  }


  /// A rigid vertical displacement of the wheel, minus what the springs hold back, which is solved for: not
  /// far, since it only serves as preconditioner, and from the last one. A rail that sinks on its sleepers
  /// needs it to a hundredth: with a tenth each solution takes a third more steps.
  void
  StaticSystem::find_lift_response()
  {
    // Why it serves: the softest motion of all is the wheel that goes up and down on its contact. A cycle
    // with the bore held has no part of it, and without w conjugate gradients would find it step by step.
    constexpr double tolerance = 0.01;
    Vector           load = zero(), image = zero();
    // w = (x, 1) with K (x, 1) = 0 in all rows of nodes: K x = -K r
    product(zero(), -1, load);
    solve_held(load, tolerance, response_);
    const double along = product(response_, 1, image);
    // w' K w [N/m]: stiffness of the contact against a vertical displacement
    approach_stiffness_ = response_ * image + along;
  }


  AlignedVector<double>
  element_forces_at_rest(Solid &solid)
  {
    AlignedVector<double> force(solid.force.size(), 0.);
    // no bulk viscosity: velocities are those of the start, not of this search
    ElementEnergy ignored;
    subtract_internal_force(
      solid.blocks, solid.displacement.data(), force.data(), BulkViscosity(), false, ignored);
    condense(solid.mesh, force.data());
    sum_over_ranks(solid.mesh, force.data());
    return force;
  }


  StaticParts::StaticParts(const SceneParts &parts, const Solid &solid, MPI_Comm communicator)
    : parts_(parts)
    , solid_(solid)
    , loads_(solid.force.size(), 0.)
    , springs_(solid.force.size(), 0.)
  {
    // Signs: loads [N] along the axes of the track, Y up; springs [N/m], positive, pull back to where the
    // part stands
    const std::vector<NodeInertia> inertia = prepare_parts(parts, solid);
    held_                                  = held_nodes(solid, inertia);
    for (std::size_t n = 0; n < inertia.size(); ++n)
      // weights along -Y [N]
      loads_[4 * n + 1] = -inertia[n].weight; // of one rank
    sum_over_ranks(solid.mesh, loads_.data());
    for (const auto &part : parts)
      // diagonal springs of sleepers and other parts [N/m], their own unknowns condensed
      // (doc/theory/rolling.md, Time stepping)
      part->add_springs(springs_.data());
    int any = std::any_of(springs_.begin(), springs_.end(), [](const double k) { return k > 0; }) ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, communicator);
    if (any == 0)
      // none on any rank: nothing below has to be asked, on all ranks alike, since the calls are collective
      springs_.clear();
  }


  std::vector<JoinedNodes>
  StaticParts::joined() const
  {
    // terms of low rank that condensation takes off the diagonal springs, mostly negative [N/m]
    std::vector<JoinedNodes> all;
    if (!springs_.empty())
      for (const auto &part : parts_)
        for (JoinedNodes &term : part->joined())
          all.push_back(std::move(term));
    return all;
  }


  void
  StaticParts::add_forces(AlignedVector<double> &force) const
  {
    if (!springs_.empty())
      for (const auto &part : parts_)
        part->add_static_forces(solid_, force);
  }


  void
  StaticParts::add_stiffness(const double *x, double *y) const
  {
    if (!springs_.empty())
      for (const auto &part : parts_)
        part->add_stiffness(solid_, x, y);
  }
} // namespace wheelrail
