#include <wheelrail/base/gather_all.h>
#include <wheelrail/solid/boundary_nodes.h>
#include <wheelrail/wheelset/axle.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  Axle::Axle(const AxleData &data, const double lift, const double pitch_rate, MPI_Comm communicator)
    : data_(data)
    , height_(lift)
    , lift_(lift)
    , pitch_rate_(pitch_rate)
    , applied_torque_(data.torque)
    , communicator_(communicator)
  {
  }


  void
  Axle::prepare(const Solid &solid, std::vector<NodeInertia> &inertia)
  {
    bore_ = held_boundary_nodes(solid.mesh, Boundary::bore, communicator_);
    arm_.clear();
    double totals[2] = {0, 0};
    for (const unsigned int n : bore_)
      {
        const double *X         = &solid.mesh.reference[4 * n];
        inertia[n].inverse_mass = 0;
        arm_.push_back(Vector3{X[0], X[1], X[2]} - data_.centre);
        if (solid.mesh.owned[n])
          {
            const Vector3 radial = arm_.back() - dot(arm_.back(), data_.axis) * data_.axis;
            totals[0] += solid.mass[n];
            totals[1] += solid.mass[n] * dot(radial, radial);
          }
      }
    ordered_sum(totals, communicator_);
    total_mass_    = data_.mass + totals[0];
    total_inertia_ = data_.pitch_inertia + totals[1];
  }


  void
  Axle::enter(EnergyBook &book)
  {
    terms_ = {&book.term("kinetic_energy", EnergyKind::stored),
              &book.term("potential_energy", EnergyKind::stored),
              &book.term("suspension_dissipation", EnergyKind::dissipated),
              &book.term("torque_work", EnergyKind::supplied),
              &book.term("speed_hold_work", EnergyKind::supplied)};
  }


  void
  Axle::constrain(const Instant &now, Solid &solid, const std::vector<NodeInertia> &)
  {
    const AxleEnergy before = energy();
    move(solid, now.kick, now.step);
    if (now.with_energy)
      write(before);
  }


  void
  Axle::write(const AxleEnergy &before)
  {
    // positions belong to the full step, speeds and works to the half steps around it: their means. All ranks
    // have the same axle: one of them enters it.
    int rank;
    MPI_Comm_rank(communicator_, &rank);
    if (rank > 0 || terms_.kinetic == nullptr)
      return;
    const AxleEnergy after = energy();
    terms_.kinetic->here += 0.5 * (before.kinetic + after.kinetic);
    terms_.potential->here += before.potential;
    terms_.suspension->here += 0.5 * (before.damped + after.damped);
    terms_.torque->here += 0.5 * (before.torque_work + after.torque_work);
    terms_.hold->here += 0.5 * (before.hold_work + after.hold_work);
  }


  void
  Axle::move(Solid &solid, const Kick &kick, const double time_step)
  {
    // 1. force and moment of the wheel on the axle
    double         sums[4] = {0, 0, 0, 0};
    const Rotation turn(data_.axis, angle_);
    for (std::size_t b = 0; b < bore_.size(); ++b)
      if (solid.mesh.owned[bore_[b]])
        {
          const double *f     = &solid.force[4 * bore_[b]];
          const Vector3 force = {f[0], f[1], f[2]};
          for (int i = 0; i < 3; ++i)
            sums[i] += force[i];
          sums[3] += dot(cross(turn(arm_[b]), force), data_.axis);
        }
    ordered_sum(sums, communicator_);
    std::copy(sums, sums + 4, reaction_);

    // 2. vertical motion with suspension, preload and weight
    const double stretch    = height_ - lift_ - sprung_height_;
    const double closing    = vertical_speed_ - sprung_speed_;
    const double suspension = data_.stiffness * stretch + data_.damping * closing;
    const double weight     = (data_.sprung_mass + data_.mass) * data_.gravity;
    advance(height_, vertical_speed_, (sums[1] - weight - suspension) / total_mass_, kick, time_step);
    if (data_.sprung_mass > 0)
      advance(sprung_height_, sprung_speed_, suspension / data_.sprung_mass, kick, time_step);
    work_.damped += kick.duration * data_.damping * closing * closing;

    // 3. pitch: driven by the torque, or held
    const double rate_before = pitch_rate_;
    applied_torque_          = data_.rate_held ? -sums[3] : data_.torque;
    advance(angle_, pitch_rate_, (sums[3] + applied_torque_) / total_inertia_, kick, time_step);
    work_.torque_work += kick.duration * applied_torque_ * 0.5 * (rate_before + pitch_rate_);
    work_.hold_work -= kick.duration * (sums[2] + sums[0] * data_.lateral_creepage) * data_.velocity;

    // 4. along the track and aside, and the bore nodes
    travelled_ += time_step * data_.velocity;
    place_bore(solid, time_step);
  }


  void
  Axle::place_bore(Solid &solid, const double time_step)
  {
    const Vector3  now = centre();
    const Rotation turn(data_.axis, angle_);
    for (std::size_t b = 0; b < bore_.size(); ++b)
      {
        const Vector3 x = now + turn(arm_[b]);
        for (int i = 0; i < 3; ++i)
          {
            const double u                       = x[i] - solid.mesh.reference[4 * bore_[b] + i];
            solid.velocity[4 * bore_[b] + i]     = (u - solid.displacement[4 * bore_[b] + i]) / time_step;
            solid.displacement[4 * bore_[b] + i] = u;
          }
      }
  }


  void
  Axle::set_state(const State &state)
  {
    height_         = state.height;
    lift_           = state.lift;
    vertical_speed_ = state.vertical_speed;
    angle_          = state.angle;
    pitch_rate_     = state.pitch_rate;
    travelled_      = state.travelled;
    sprung_height_  = state.sprung_height;
    sprung_speed_   = state.sprung_speed;
    work_           = state.work;
  }


  AxleEnergy
  Axle::energy() const
  {
    AxleEnergy   energy  = work_;
    const double stretch = height_ - lift_ - sprung_height_;
    energy.kinetic       = 0.5 * total_mass_ * vertical_speed_ * vertical_speed_ +
                     0.5 * total_inertia_ * pitch_rate_ * pitch_rate_ +
                     0.5 * data_.sprung_mass * sprung_speed_ * sprung_speed_;
    energy.potential =
      (data_.sprung_mass + data_.mass) * data_.gravity * height_ + 0.5 * data_.stiffness * stretch * stretch;
    return energy;
  }
} // namespace wheelrail
