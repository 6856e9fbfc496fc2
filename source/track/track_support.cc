#include <wheelrail/base/gather_all.h>
#include <wheelrail/track/track_support.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace wheelrail
{
  TrackSupport::TrackSupport(const TrackData &data, MPI_Comm communicator)
    : data_(data)
    , communicator_(communicator)
  {
    MPI_Comm_rank(communicator_, &rank_);
  }


  void
  TrackSupport::enter(EnergyBalance &energies)
  {
    stored_     = &energies.term("pad_energy", EnergyKind::stored);
    dissipated_ = &energies.term("pad_dissipation", EnergyKind::dissipated);
    if (!sleepers_move())
      return;
    kinetic_            = &energies.term("sleeper_energy", EnergyKind::stored);
    ballast_            = &energies.term("ballast_energy", EnergyKind::stored);
    ballast_dissipated_ = &energies.term("ballast_dissipation", EnergyKind::dissipated);
  }


  /// Along the axes of the foot.
  Vector3
  TrackSupport::turned(const Vector3 &track) const
  {
    return {dot(axes_[0], track), dot(axes_[1], track), dot(axes_[2], track)};
  }


  Vector3
  TrackSupport::turned_back(const Vector3 &foot) const
  {
    Vector3 track{};
    for (int i = 0; i < 3; ++i)
      add(track, foot[i], axes_[i]);
    return track;
  }


  void
  TrackSupport::add_forces(const Instant &now, Solid &solid)
  {
    const auto  &branches             = data_.pad_damping.branches;
    const double damper               = data_.pad_damping.damper;
    double       decay[most_branches] = {}, gain[most_branches] = {};
    for (std::size_t b = 0; b < branches.size(); ++b)
      {
        // over the step behind, with its even velocity: exact
        decay[b] = now.first ? 1 : std::exp(-now.step / branches[b].time);
        gain[b]  = now.first ? 0 : -branches[b].time * std::expm1(-now.step / branches[b].time);
      }
    std::vector<double> on_sleepers(3 * place_.size(), 0.);
    std::vector<double> on_pads(now.with_energy ? sleepers_.size() : 0, 0.);
    double              energy = 0, power = 0;
    for (std::size_t k = 0; k < bearings_.size(); ++k)
      {
        const Bearing &at = bearings_[k];
        const double  *u = &solid.displacement[4 * at.node], *v = &solid.velocity[4 * at.node];
        Vector3        moved = {u[0], u[1], u[2]}, speed = {v[0], v[1], v[2]};
        if (!place_.empty())
          {
            moved = moved - place_[at.sleeper];
            speed = speed - speed_[at.sleeper];
          }
        moved = turned(moved), speed = turned(speed);
        Vector3 force{};
        for (int i = 0; i < 3; ++i)
          {
            const double stiffness = at.share * data_.pad[i];
            double       sum = moved[i] + damper * speed[i], square = moved[i] * moved[i], lost = 0;
            for (std::size_t b = 0; b < branches.size(); ++b)
              {
                double &stretch = stretch_[k][b][i];
                stretch         = decay[b] * stretch + gain[b] * speed[i];
                sum += branches[b].share * stretch;
                square += branches[b].share * stretch * stretch;
                lost += branches[b].share * stretch * stretch / branches[b].time;
              }
            force[i] = stiffness * sum;
            energy += at.owned * 0.5 * stiffness * square;
            power += at.owned * stiffness * lost;
          }
        if (!on_pads.empty())
          on_pads[at.sleeper] -= at.owned * force[1];
        force = turned_back(force);
        for (int i = 0; i < 3; ++i)
          {
            solid.force[4 * at.node + i] -= force[i];
            if (!place_.empty())
              on_sleepers[3 * at.sleeper + i] += at.owned * force[i];
          }
      }
    stored_->here += energy;
    dissipated_->add_work(now.velocity_update.duration * power);
    if (now.with_energy)
      measure(solid, on_pads);
    if (!place_.empty())
      move_sleepers(now, on_sleepers);
  }


  /// Brings measures() up to date; `pad_forces`: pressing, this rank's share [N].
  void
  TrackSupport::measure(const Solid &solid, std::vector<double> &pad_forces)
  {
    ordered_sum(pad_forces, communicator_);
    pad_force_ = pad_pull_ = 0;
    for (const double force : pad_forces)
      {
        pad_force_ = std::max(pad_force_, force);
        pad_pull_  = std::max(pad_pull_, -force);
      }
    std::vector<double> down(n_stations_, 0.);
    for (const FootNode &at : foot_)
      down[at.station] -= at.share * solid.displacement[4 * at.node + 1];
    ordered_sum(down, communicator_);
    deflection_ = down.empty() ? 0 : *std::max_element(down.begin(), down.end());
  }


  std::vector<PartMeasure>
  TrackSupport::measures() const
  {
    std::vector<PartMeasure> all = {{"foot_deflection", "m", deflection_}};
    if (!data_.continuous)
      {
        all.push_back({"largest_pad_force", "N", pad_force_});
        all.push_back({"largest_pad_pull", "N", pad_pull_});
      }
    return all;
  }


  /// Central differences of their own; `force`: of the pads on them, this rank's share.
  void
  TrackSupport::move_sleepers(const Instant &now, std::vector<double> &force)
  {
    ordered_sum(force, communicator_);
    double kinetic = 0, potential = 0, power = 0;
    for (std::size_t s = 0; s < place_.size(); ++s)
      for (int i = 0; i < 3; ++i)
        {
          double      &place = place_[s][i], &speed = speed_[s][i];
          const double before    = speed;
          const double stiffness = data_.ballast[i], damper = stiffness * data_.ballast_damper;
          potential += 0.5 * stiffness * place * place;
          advance(place,
                  speed,
                  (force[3 * s + i] - stiffness * place - damper * speed) / data_.sleeper_mass,
                  now.velocity_update,
                  now.step);
          const double mean = 0.5 * (before + speed);
          mean_speed_[s][i] = mean;
          kinetic += 0.5 * data_.sleeper_mass * before * (now.first ? before : speed);
          power += damper * mean * mean;
        }
    if (rank_ > 0) // all ranks know the sleepers
      return;
    kinetic_->here += kinetic;
    ballast_->here += potential;
    ballast_dissipated_->add_work(now.velocity_update.duration * power);
  }


  void
  TrackSupport::account(const Instant &now, const Solid &solid, const std::vector<NodeInertia> &inertia)
  {
    if (data_.pad_damping.damper == 0)
      return;
    double power = 0;
    for (const Bearing &at : bearings_)
      if (at.owned > 0)
        {
          Vector3 speed = mean_velocity(solid, inertia, at.node, now.velocity_update);
          if (!place_.empty())
            speed = speed - mean_speed_[at.sleeper];
          speed = turned(speed);
          for (int i = 0; i < 3; ++i)
            power += at.share * data_.pad[i] * data_.pad_damping.damper * speed[i] * speed[i];
        }
    dissipated_->add_work(now.velocity_update.duration * power);
  }


  /// A spring k between masses m and M swings with k (1/m + 1/M) at most; a damper c at the half step behind
  /// counts as c/m times the frequency of the whole, since (w dt/2)^2 + (c/m) dt/2 <= 1 is stable.
  double
  TrackSupport::squared_frequency(const Solid &solid) const
  {
    const double stiffest = *std::max_element(data_.pad.begin(), data_.pad.end());
    double       node = 0, sleeper = 0, pads = 0; // [1/kg]
    for (const Bearing &at : bearings_)
      {
        node = std::max(node, at.share / (solid.mass[at.node] + solid.added_mass[at.node]));
        pads += at.owned * at.share;
      }
    MPI_Allreduce(MPI_IN_PLACE, &node, 1, MPI_DOUBLE, MPI_MAX, communicator_);
    MPI_Allreduce(MPI_IN_PLACE, &pads, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    double ballast = 0;
    if (sleepers_move())
      {
        sleeper = 1 / data_.sleeper_mass;
        ballast = *std::max_element(data_.ballast.begin(), data_.ballast.end()) / data_.sleeper_mass;
      }
    const double spring   = stiffest * (node + sleeper);
    const double damping  = spring * data_.pad_damping.damper + ballast * data_.ballast_damper; // [1/s]
    const double of_solid = 2 / solid.stable.step;
    const double highest  = 0.5 * damping + std::sqrt(0.25 * damping * damping + of_solid * of_solid);
    return spring * data_.pad_damping.highest_stiffness() + ballast + damping * highest;
  }


  PartState
  TrackSupport::state() const
  {
    PartState state;
    for (std::size_t s = 0; s < place_.size(); ++s)
      for (int i = 0; i < 3; ++i)
        {
          const std::string which                 = std::to_string(s) + "_" + std::string(1, "xyz"[i]);
          state.numbers["sleeper_" + which]       = place_[s][i];
          state.numbers["sleeper_speed_" + which] = speed_[s][i];
        }
    const std::size_t n_branches = data_.pad_damping.branches.size();
    if (n_branches == 0)
      return state;
    for (std::size_t k = 0; k < bearings_.size(); ++k)
      if (bearings_[k].owned > 0)
        {
          state.nodes.push_back(bearings_[k].key);
          for (std::size_t b = 0; b < n_branches; ++b)
            state.values.insert(state.values.end(), stretch_[k][b].begin(), stretch_[k][b].end());
        }
    return state;
  }


  void
  TrackSupport::set_state(const PartState &state)
  {
    for (std::size_t s = 0; s < place_.size(); ++s)
      for (int i = 0; i < 3; ++i)
        {
          const std::string which = std::to_string(s) + "_" + std::string(1, "xyz"[i]);
          place_[s][i]            = state.numbers.at("sleeper_" + which);
          speed_[s][i]            = state.numbers.at("sleeper_speed_" + which);
        }
    const std::size_t n_branches = data_.pad_damping.branches.size();
    if (n_branches == 0)
      return;
    std::map<std::uint64_t, std::size_t> row;
    for (std::size_t k = 0; k < state.nodes.size(); ++k)
      row[state.nodes[k]] = k;
    for (std::size_t k = 0; k < bearings_.size(); ++k)
      for (std::size_t b = 0; b < n_branches; ++b)
        for (int i = 0; i < 3; ++i)
          stretch_[k][b][i] = state.values.at(3 * (n_branches * row.at(bearings_[k].key) + b) + i);
  }


  std::complex<double>
  PadDamping::dynamic_stiffness(const std::complex<double> angular_frequency) const
  {
    const std::complex<double> iw        = std::complex<double>(0, 1) * angular_frequency;
    std::complex<double>       stiffness = 1. + iw * damper;
    for (const Branch &branch : branches)
      stiffness += branch.share * iw * branch.time / (1. + iw * branch.time);
    return stiffness;
  }


  double
  PadDamping::highest_stiffness() const
  {
    double sum = 1;
    for (const Branch &branch : branches)
      sum += branch.share;
    return sum;
  }


  PadDamping
  matched_damper(const double loss_factor, const double frequency)
  {
    return {loss_factor / (2 * M_PI * frequency), {}};
  }


  PadDamping
  constant_loss(const double loss_factor)
  {
    constexpr double relaxation[3] = {500. / 6, 500, 500. * 6}; // [Hz]
    constexpr int    samples       = 40;
    // (Im - loss Re) of 1 + sum of shares is zero at every frequency
    dealii::SymmetricTensor<2, 3> normal;
    dealii::Tensor<1, 3>          right;
    for (int k = 0; k <= samples; ++k)
      {
        const double frequency =
          constant_loss_from * std::pow(constant_loss_to / constant_loss_from, double(k) / samples);
        double row[3];
        for (int i = 0; i < 3; ++i)
          {
            const double x = frequency / relaxation[i];
            row[i]         = (x - loss_factor * x * x) / (1 + x * x);
          }
        for (int i = 0; i < 3; ++i)
          {
            right[i] += loss_factor * row[i];
            for (int j = 0; j <= i; ++j)
              normal[i][j] += row[i] * row[j];
          }
      }
    const dealii::Tensor<1, 3> share = dealii::invert(normal) * right;
    PadDamping                 damping;
    for (int i = 0; i < 3; ++i)
      damping.branches.push_back({share[i], 1 / (2 * M_PI * relaxation[i])});
    return damping;
  }
} // namespace wheelrail
