#include <wheelrail/solid/energy_balance.h>

#include <cmath>
#include <vector>

// Energy balance of doc/theory/rolling.md: stored + dissipated - supplied stays what it was at the first
// step.

namespace wheelrail
{
  EnergyTerm &
  EnergyBalance::term(const std::string &name, const EnergyKind kind)
  {
    for (EnergyTerm &term : terms_)
      if (term.name == name)
        return term;
    terms_.push_back({name, kind});
    return terms_.back();
  }


  double
  EnergyBalance::operator[](const std::string &name) const
  {
    for (const EnergyTerm &term : terms_)
      if (term.name == name)
        return term.value;
    return 0;
  }


  double
  EnergyBalance::sum(const EnergyKind kind) const
  {
    double total = 0;
    for (const EnergyTerm &term : terms_)
      if (term.kind == kind)
        // [J], all ranks
        total += term.value;
    return total;
  }


  void
  EnergyBalance::begin_step()
  {
    for (EnergyTerm &term : terms_)
      {
        term.here = 0;
        // works up to n - 1/2
        term.before = term.work;
      }
  }


  void
  EnergyBalance::balance(const bool first, MPI_Comm communicator)
  {
    std::vector<double> values;
    for (const EnergyTerm &term : terms_)
      // all at the full step n: `here` belongs to n, works run to n - 1/2 (before) and n + 1/2 (work), of
      // which the mean is taken (doc/theory/rolling.md, Energy balance)
      values.push_back(term.here + (first ? term.before : 0.5 * (term.before + term.work)));
    MPI_Allreduce(MPI_IN_PLACE, values.data(), values.size(), MPI_DOUBLE, MPI_SUM, communicator);
    std::size_t k = 0;
    for (EnergyTerm &term : terms_)
      term.value = values[k++];
    // residual = stored + dissipated - supplied, less the same at the first step; over strain plus dissipated
    // energy, since the kinetic energy of rolling is a hundred thousand times as large
    // signs: supplied works are positive when they add energy, dissipated ones when they take it
    // (doc/manual/signs.md, Works and energies)
    const double total = stored() + dissipated() - supplied();
    if (!state_.started)
      state_.start = total;
    // the first balance is the reference: the start may bring any energy
    state_.started = true;
    residual_      = total - state_.start;
    state_.error   = std::abs(residual_) / ((*this)["strain_energy"] + dissipated());
  }


  EnergyBalance::State
  EnergyBalance::state() const
  {
    // stored energies follow from the state itself; works are sums over time and have to be kept
    State state = state_;
    for (const EnergyTerm &term : terms_)
      if (term.kind != EnergyKind::stored)
        state.works[term.name] = term.work;
    return state;
  }


  void
  EnergyBalance::set_state(const State &state)
  {
    // [J]; parts add to `here` and to the works on each rank, the balance sums them over all
    for (EnergyTerm &term : terms_)
      if (const auto found = state.works.find(term.name); found != state.works.end())
        term.work = found->second;
    // the start of the balance goes on through a resume: the residual counts from the first step of the run
    state_ = state;
    state_.works.clear();
  }
} // namespace wheelrail
