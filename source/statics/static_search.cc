#include <deal.II/base/mpi.h>

#include <wheelrail/mesh/discretization.h>
#include <wheelrail/output/root.h>
#include <wheelrail/statics/facing_surfaces.h>
#include <wheelrail/statics/static_search.h>

#include <algorithm>
#include <cmath>

// Equilibrium of wheel and rail under wheel load, weight, preload and centrifugal load
// (doc/theory/rolling.md, Static start), from the explicit kernel's own forces. Penalty contact under given
// loads has a convex potential, so that a search along each Newton step ends at its minimum.

namespace wheelrail
{
  namespace
  {
    /// From the axle's line to a place.
    Vector3
    radial_arm(const Vector3 &X, const AxleData &axle)
    {
      // only the distance from the axle's line feels the rotation, also when yaw turns the line
      const Vector3 arm = X - axle.centre;
      // r = (X - c) - ((X - c) . a) a, a the axle's direction
      return arm - dot(arm, axle.axis) * axle.axis;
    }

    /// Centrifugal load of the wheel, per node.
    void
    add_centrifugal_load(const Solid           &solid,
                         const AxleData        &axle,
                         const double           rate,
                         AlignedVector<double> &force)
    {
      for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
        if (solid.mesh.node_body[n] == Body::wheel)
          {
            const double *X      = &solid.mesh.reference[4 * n];
            const Vector3 radial = radial_arm({X[0], X[1], X[2]}, axle);
            for (int i = 0; i < 3; ++i)
              // m omega^2 r, at the place before deformation
              force[4 * n + i] += solid.mass[n] * rate * rate * radial[i];
          }
    }

    /// `lateral`: force on the wheel along X [N], of which the force along a wheelset with yaw takes a part.
    StartTractions
    wanted_tractions(const Solid       &solid,
                     const Contact     &contact,
                     const StaticLoads &loads,
                     const double       load,
                     const double       lateral,
                     const double       stretch)
    {
      // body 1 is the rail, as in start_tractions()
      const HalfspaceSteels bodies = {solid.blocks.rail.elasticity(), solid.blocks.wheel.elasticity()};
      const StartMotion     motion = {loads.axle.velocity, loads.axle.lateral_creepage, stretch};
      const double          force =
        // F cos(yaw) + F_x sin(yaw) = traction coefficient x load: along a wheelset with yaw the lateral
        // force on the wheel has a part
        (loads.traction_coefficient * load - lateral * std::sin(loads.yaw)) / std::cos(loads.yaw);
      return loads.rate_held
               ? start_tractions_at_creepage(contact, loads.creepage, bodies, motion, loads.beyond)
               : start_tractions(contact, force, bodies, motion, loads.beyond);
    }
  } // namespace


  StaticSearch::StaticSearch(const Discretization &discretization,
                             Solid                &solid,
                             Contact              &contact,
                             const SceneParts     &parts,
                             const StaticLoads    &loads)
    : solid_(solid)
    , contact_(contact)
    , loads_(loads)
    , communicator_(discretization.communicator())
    , system_(discretization, solid, parts)
    , flow_(solid.blocks)
  {
    const AxleData      &axle = loads.axle;
    const MassProperties wheel =
      mass_properties(solid, Body::wheel, axle.centre, discretization.communicator());
    // What is out of balance by itself in a mesh that is finer on one side: m omega^2 e. The axle of the run
    // is rigid and bears it (below, balance()).
    wheel_mass_ = wheel.mass;
    // e: height of the wheel's centre of mass over the axle; zero of an even mesh
    wheel_offset_ = radial_arm(wheel.centre, axle)[1];
    // omega = V/(r cos(yaw)) without creepage
    rate_ = loads.axle.velocity / loads.forward_radius;
    contact_.gather(solid_.displacement.data(), solid_.velocity.data());
    // displacements that the rail brings along from passages before: they are no stretch of this contact
    rail_before_ = rail_displacements(contact_);
    press();
  }


  /// Presses the bodies into each other rigidly: the part of the undeformed profiles that dips in by
  /// kik_piotrowski of the approach is close to the true patch. A wheel on a flat first has to come down to
  /// the rail, or no spring would tell Newton's method where that is.
  void
  StaticSearch::press()
  {
    constexpr int most = 3; // steeper places may be nearer once the wheel has come down
    // 0.55 of the approach (Kik and Piotrowski 1996): the interpenetration of undeformed profiles has then
    // about the size of the patch
    lower_wheel(kik_piotrowski * loads_.first_approach);
    // springs exist at nodes that touch alone: at least one has to, or the first step has no stiffness
    // against the wheel's weight
    for (int k = 0; k < most; ++k)
      {
        contact_.gather(solid_.displacement.data(), solid_.velocity.data());
        if (contact_.evaluate(0).nodes > 0)
          return;
        double least = HUGE_VAL;
        for (const ContactNode &node : contact_.nodes())
          if (norm(node.normal) > 0) // faces the wheel
            // vertical distance = gap over the cosine of the normal, at least a tenth
            least = std::min(least, node.gap / std::max(node.normal[1], 0.1));
        if (!std::isfinite(least))
          return;
        lower_wheel(least + kik_piotrowski * loads_.first_approach);
      }
  }


  /// Lowers the wheel as a rigid body, from where it is [m].
  void
  StaticSearch::lower_wheel(const double by)
  {
    hub_displacement -= by;
    for (unsigned int n = 0; n < solid_.mesh.n_nodes(); ++n)
      if (solid_.mesh.node_body[n] == Body::wheel)
        solid_.displacement[4 * n + 1] = hub_displacement;
  }


  StaticBalance
  StaticSearch::balance()
  {
    // 1. Bodies at rest here, one step from the history at the begin: plastic strains of trial positions are
    // not kept
    flow_.restore(solid_.blocks);
    // forces out of balance: elements, centrifugal load, weight and what parts give, contact, tractions found
    // before
    AlignedVector<double> force = element_forces_at_rest(solid_);
    // 2. Given loads [N]
    add_centrifugal_load(solid_, loads_.axle, rate_, force);
    for (std::size_t k = 0; k < force.size(); ++k)
      force[k] += system_.parts().loads()[k];
    system_.parts().add_forces(force);
    // 3. Contact under pressure alone, then the shear tractions as given loads
    contact_.gather(solid_.displacement.data(), solid_.velocity.data());
    StaticBalance balance;
    balance.sums = contact_forces(nullptr, force);
    for (std::size_t k = 0; k < drag_.size(); ++k)
      force[k] += drag_[k];
    balance.sums.force = balance.sums.force + drag_sum_;
    // 4. Forces out of balance on free nodes and on the bore
    balance.residual = system_.right_hand_side(force);
    // a mesh finer at one place than elsewhere is a wheel a little out of balance, which the axle bears
    // vertical balance of the axle: bore force - (M + m_a) g - the unbalance m omega^2 e
    balance.bore = system_.bore_force(force) -
                   (loads_.axle.sprung_mass + loads_.axle.mass) * loads_.axle.gravity -
                   wheel_mass_ * rate_ * rate_ * wheel_offset_;
    return balance;
  }


  /// Adds the forces of contact with these tractions, bounded by friction; null: without.
  ContactSums
  StaticSearch::contact_forces(const std::vector<Vector3> *tractions, AlignedVector<double> &force)
  {
    for (std::size_t k = 0; k < contact_.nodes().size(); ++k)
      contact_.set_traction(k, tractions ? (*tractions)[k] : Vector3{});
    const ContactSums sums = contact_.evaluate(0);
    contact_.add_forces(force.data());
    return sums;
  }


  StaticStep
  StaticSearch::newton_step(const StaticBalance &balance, const double tolerance)
  {
    // The contact's own tangent: springs k A n (x) n of nodes in contact; how normals turn with the
    // displacements is left out.
    renew_springs();
    StaticStep step;
    system_.solve(balance.residual, balance.bore, tolerance, step);
    return step;
  }


  void
  StaticSearch::renew_springs()
  {
    system_.set_springs(contact_.springs());
  }


  StaticStep
  StaticSearch::preconditioned_step(const NodeVector &residual, const double bore)
  {
    ++cycles;
    return system_.precondition(residual, bore);
  }


  double
  StaticSearch::power(const StaticBalance &balance, const StaticStep &step) const
  {
    // work of the forces out of balance along the step: minus the slope of the potential
    return balance.residual * step.increment + balance.bore * step.hub_displacement;
  }


  void
  StaticSearch::move(const StaticStep &step, const double factor)
  {
    NodeVector increment = step.increment;
    // u += factor (x + U r)
    increment *= factor;
    system_.add_to_nodes(increment, factor * step.hub_displacement, solid_.displacement);
    hub_displacement += factor * step.hub_displacement;
  }


  StaticBalance
  StaticSearch::search_along(const StaticStep &step, const StaticBalance &start)
  {
    // the slope of the convex potential is zero at its minimum along the step: root of power(at), at = 1
    // first
    // Signs: power > 0 before the minimum, < 0 beyond it. The full step is taken where it has not passed the
    // minimum, or where it has halved the residual; else the root is bracketed.
    const double  first = power(start, step), before = start.largest();
    double        at = 0, low = 0, high = 1, power_low = first, power_high = 0;
    double        next = 1, last = 0;
    StaticBalance balance;
    for (int trial = 0; trial < 12; ++trial)
      {
        move(step, next - at);
        at                 = next;
        balance            = this->balance();
        const double value = power(balance, step);
        const bool   good  = trial == 0 && (value > 0 || balance.largest() < 0.5 * before);
        if (good || first <= 0 || std::abs(value) < 0.1 * first)
          break;
        const bool same_end = value * last > 0;
        if (value > 0)
          {
            low = at, power_low = value;
            // Illinois: the end that stays twice counts half, so that it does not stay for good (Dowell and
            // Jarratt 1971)
            power_high *= same_end ? 0.5 : 1;
          }
        else
          {
            high = at, power_high = value;
            power_low *= same_end ? 0.5 : 1;
          }
        last = value;
        // regula falsi
        next = low + (high - low) * power_low / (power_low - power_high);
      }
    return balance;
  }


  /// That of pressure which half-spaces of the two materials do not have. Unlike ones have one of their own,
  /// which the solution for the tractions finds; it is not taken twice.
  double
  StaticSearch::stretch_beyond_halfspaces() const
  {
    // equal E and nu: the coupling K of half-spaces vanishes (doc/theory/halfspace.md, Equations)
    const Elasticity &rail = solid_.blocks.rail.elasticity(), &wheel = solid_.blocks.wheel.elasticity();
    const bool        alike =
      rail.youngs_modulus == wheel.youngs_modulus && rail.poissons_ratio == wheel.poissons_ratio;
    return alike ? tread_stretch(contact_, rail_before_) : 0;
  }


  /// Half-spaces and true bodies are held by one rank alone; all get the same bits.
  StartTractions
  StaticSearch::shared_tractions() const
  {
    StartTractions found;
    on_root(communicator_, [&]() {
      found = wanted_tractions(solid_, contact_, loads_, wheel_load(), lateral_force_, stretch_);
    });
    return dealii::Utilities::MPI::broadcast(communicator_, found);
  }


  double
  StaticSearch::renew_tractions()
  {
    if (tractions.traction.empty()) // so far pressure alone
      stretch_ = stretch_beyond_halfspaces();
    // 1. Tractions and creepage for the pressures of this position
    const StartTractions before = std::move(tractions);
    tractions                   = shared_tractions();
    // omega = V/(r cos(yaw)) (1 + creepage)
    rate_ = loads_.axle.velocity / loads_.forward_radius * (1 + tractions.creepage);
    if (!loads_.tractions)
      tractions.traction.assign(tractions.traction.size(), Vector3{});
    // 2. Their nodal forces, which stay as given loads until the next time
    drag_.assign(solid_.force.size(), 0.);
    AlignedVector<double> pressures(solid_.force.size(), 0.);
    // forces with tractions less those without: the shear part, bounded by mu p, which acts as a given load
    // until it is found anew
    const Vector3 whole         = contact_forces(&tractions.traction, drag_).force;
    drag_sum_                   = whole - contact_forces(nullptr, pressures).force;
    const double before_lateral = lateral_force_;
    lateral_force_              = whole[0];
    for (std::size_t k = 0; k < drag_.size(); ++k)
      drag_[k] -= pressures[k];
    // 3. How much has changed, as shares of the creepage and of the wheel load
    const double least = 1e-300; // of a creepage that is 0
    return std::max(
      {std::abs(tractions.creepage - before.creepage) / std::max(std::abs(tractions.creepage), least),
       // changes of creepage, of the longitudinal force and, with yaw, of the lateral force along the
       // wheelset
       std::abs(tractions.force - before.force) / wheel_load(),
       std::abs((lateral_force_ - before_lateral) * std::sin(loads_.yaw)) / wheel_load()});
  }


  void
  StaticSearch::set_tractions()
  {
    AlignedVector<double> ignored(solid_.force.size(), 0.);
    if (!tractions.traction.empty())
      contact_forces(&tractions.traction, ignored);
  }
} // namespace wheelrail
