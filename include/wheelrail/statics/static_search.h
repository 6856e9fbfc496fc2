#pragma once

#include <wheelrail/solid/saved_plastic_state.h>
#include <wheelrail/statics/start_tractions.h>
#include <wheelrail/statics/static_start.h>
#include <wheelrail/statics/static_system.h>

#include <cmath>
#include <vector>

namespace wheelrail
{
  /// What is out of balance in one position.
  struct StaticBalance
  {
    StaticSystem::Vector residual; ///< forces on the free unknowns [N]
    double               bore = 0; ///< vertical force on bore and axle [N]
    ContactSums          sums;     ///< of the contact

    /// Largest component of the residual [N]; infinite where one is no number. Collective.
    double
    largest() const
    {
      return std::isfinite(residual.l2_norm()) ? residual.linfty_norm() : INFINITY;
    }
  };

  /// Both bodies on the way to their static equilibrium: the position is that of the solid's displacement,
  /// which the search changes. All functions are collective.
  class StaticSearch
  {
  public:
    /// Prepares the stiffness and presses the wheel rigidly into the rail, which stays as it is.
    StaticSearch(const Discretization &discretization,
                 Solid                &solid,
                 Contact              &contact,
                 const SceneParts     &parts,
                 const StaticLoads    &loads);

    /// Weight of sprung mass, axle and wheel [N].
    double
    wheel_load() const
    {
      return (loads_.axle.sprung_mass + loads_.axle.mass + wheel_mass_) * loads_.axle.gravity;
    }

    /// Contact, internal and external forces of the present position, condensed and summed. The tractions
    /// are loads here, whatever the pressures: a bound that follows them would leave no potential. Elements
    /// of a plastic material get the history of a single step from that at the making of the search.
    StaticBalance
    balance();

    /// Newton's step of elastic bodies with the springs of the moment, solved for until what is out of
    /// balance in it is below `tolerance` times that of the balance.
    StaticStep
    newton_step(const StaticBalance &balance, double tolerance);

    /// Takes the contact springs of the moment into the system.
    void
    renew_springs();

    /// An estimate of Newton's step of elastic bodies with the springs last taken, linear and symmetric in
    /// the forces: one cycle of the preconditioner, and the hub displacement that restores the balance of the
    /// bore.
    StaticStep
    preconditioned_step(const StaticSystem::Vector &residual, double bore);

    /// Work of the forces out of balance along a step [J]: minus the slope of the potential energy.
    double
    power(const StaticBalance &balance, const StaticStep &step) const;

    /// Moves both bodies by `factor` times the step.
    void
    move(const StaticStep &step, double factor);

    /// Goes along a step of elastic bodies to where the potential energy no longer falls: regula falsi
    /// (Illinois) for the work of the forces, which the closing and opening of nodes bends. Full steps can
    /// turn in circles between two patches, as in the flange root; the energy of penalty contact is convex,
    /// so that steps to its minimum do not. Gives the balance there.
    StaticBalance
    search_along(const StaticStep &step, const StaticBalance &start);

    /// Tractions for the present pressures as loads, and the rate of turning that goes with them. By how much
    /// they have changed: the creepage over itself, or the force over the wheel load, whatever is more.
    double
    renew_tractions();

    /// tread_stretch() that the tractions take account of.
    double
    stretch() const
    {
      return stretch_;
    }

    /// Sets the tractions in the contact, bounded by its pressures.
    void
    set_tractions();

    StartTractions tractions;            ///< the given ones; none before the first renewal
    double         hub_displacement = 0; ///< of the bore so far [m]
    unsigned int   cycles           = 0; ///< of the preconditioner outside of conjugate gradients so far

    /// Cycles of the preconditioner so far.
    unsigned int
    cg_steps() const
    {
      return cycles + system_.cg_steps;
    }

  private:
    void
    press();
    void
    lower_wheel(double by);
    double
    stretch_beyond_halfspaces() const;
    StartTractions
    shared_tractions() const;
    ContactSums
    contact_forces(const std::vector<Vector3> *tractions, AlignedVector<double> &force);

    Solid                  &solid_;
    Contact                &contact_;
    const StaticLoads      &loads_;
    MPI_Comm                communicator_;
    StaticSystem            system_;
    const SavedPlasticState flow_; ///< that the bodies begin with
    double                  wheel_mass_ = 0, rate_ = 0;
    double                  wheel_offset_ = 0;  ///< of its centre of gravity above the axle's line [m]
    AlignedVector<double>   drag_;              ///< nodal forces of the tractions [N]
    Vector3                 drag_sum_{};        ///< on the wheel [N]
    double                  lateral_force_ = 0; ///< on the wheel with the present tractions [N]
    double                  stretch_       = 0; ///< of the tread less that of the head, by pressure alone [-]
    std::vector<Vector3>    rail_before_; ///< displacement of its surface that the search began with [m]
  };
} // namespace wheelrail
