#pragma once

#include <mpi.h>

#include <list>
#include <map>
#include <string>

namespace wheelrail
{
  /// What becomes of an energy.
  enum class EnergyKind
  {
    stored,     ///< a state: comes back
    dissipated, ///< gone, a sum over time
    supplied,   ///< brought in by forces from outside, a sum over time
    noted       ///< no part of the balance: a part of another term, or where one of the residual comes from
  };

  /// One named energy [J]: what parts add to it on this rank, and its value over all ranks.
  struct EnergyTerm
  {
    std::string name;
    EnergyKind  kind   = EnergyKind::stored;
    double      here   = 0; ///< at the full step, added anew in each step that asks for energies
    double      before = 0; ///< sum of works up to the half step behind
    double      work   = 0; ///< the same up to the half step ahead
    double      value  = 0; ///< at the full step of the last balance, of all ranks

    /// Adds the work of the velocity_update around the full step.
    void
    add_work(const double of_update)
    {
      work += of_update;
    }

    /// Adds the work of the step behind, all of it done at the full step.
    void
    add_done(const double of_step)
    {
      before += of_step;
      work += of_step;
    }
  };

  /// The energy balance of a scene as named terms: what is stored plus what is dissipated less what is
  /// supplied stays as it was at the start. The parts of a scene enter their terms and keep them up to date.
  class EnergyBalance
  {
  public:
    /// The term of this name, entered when it is new. The reference stays good as long as the energies.
    EnergyTerm &
    term(const std::string &name, EnergyKind kind);

    /// Value of a term over all ranks at the last balance [J]; 0 when no part has entered it.
    double
    operator[](const std::string &name) const;

    /// All terms in the order of their entering.
    const std::list<EnergyTerm> &
    terms() const
    {
      return terms_;
    }

    /// Before the parts are asked for the energies and works of a step.
    void
    begin_step();

    /// Sums the terms over the ranks and balances them; the first balance is the start. Works count by the
    /// mean of both half steps; when the velocity_update begins at the full step (`first`), those before it.
    /// Collective.
    void
    balance(bool first, MPI_Comm communicator);

    double
    stored() const
    {
      return sum(EnergyKind::stored);
    }
    double
    dissipated() const
    {
      return sum(EnergyKind::dissipated);
    }
    double
    supplied() const
    {
      return sum(EnergyKind::supplied);
    }
    /// Stored plus dissipated less supplied energy at the first balance [J].
    double
    start() const
    {
      return state_.start;
    }
    /// What the terms fail to add up to since the start [J].
    double
    residual() const
    {
      return residual_;
    }
    /// |residual| over strain plus dissipated energy.
    double
    error() const
    {
      return state_.error;
    }

    /// What one step leaves to the next.
    struct State
    {
      bool                          started = false;
      double                        start   = 0; ///< [J]
      double                        error   = 0; ///< of the last balance
      std::map<std::string, double> works;       ///< of this rank [J]
    };
    State
    state() const;
    /// Goes on from a state; works of terms that were not entered are left out.
    void
    set_state(const State &state);

  private:
    double
    sum(EnergyKind kind) const;

    std::list<EnergyTerm> terms_;
    State                 state_; ///< without works, which are in the terms
    double                residual_ = 0;
  };
} // namespace wheelrail
