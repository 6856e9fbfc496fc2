#include <wheelrail/base/gather_all.h>
#include <wheelrail/solid/boundary_nodes.h>
#include <wheelrail/wheelset/axle.h>

#include <cmath>

namespace wheelrail
{
  Axle::Axle(const AxleData &data,
             const double    hub_displacement,
             const double    pitch_rate,
             MPI_Comm        communicator)
    : data_(data)
    , height_(hub_displacement)
    , hub_displacement_(hub_displacement)
    , vertical_speed_(data.velocity * data.rise)
    , pitch_rate_(pitch_rate)
    , applied_torque_(data.torque)
    , communicator_(communicator)
  {
  }


  void
  Axle::prepare(const Solid &solid, std::vector<NodeInertia> &inertia)
  {
    bore_ = held_boundary_nodes(solid.mesh, Boundary::bore);
    arm_.clear();
    double totals[2] = {0, 0};
    for (const unsigned int n : bore_)
      {
        inertia[n].inverse_mass = 0;
        arm_.push_back(solid.mesh.place(n) - data_.centre);
        if (solid.mesh.owns(n))
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
  Axle::enter(EnergyBalance &energies)
  {
    terms_ = {&energies.term("kinetic_energy", EnergyKind::stored),
              &energies.term("potential_energy", EnergyKind::stored),
              &energies.term("suspension_dissipation", EnergyKind::dissipated),
              &energies.term("torque_work", EnergyKind::supplied),
              &energies.term("speed_hold_work", EnergyKind::supplied),
              data_.path ? &energies.term("load_work", EnergyKind::supplied) : nullptr};
  }


  void
  Axle::constrain(const Instant &now, Solid &solid, const std::vector<NodeInertia> &)
  {
    const AxleEnergy before = energy();
    move(solid, now.velocity_update, now.step);
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
    if (terms_.load)
      terms_.load->here += 0.5 * (before.load_work + after.load_work);
  }


  Axle::Reaction
  Axle::reaction_of(const Solid &solid) const
  {
    enum
    {
      force_sum  = 0,
      about_axis = 3,
      moment_sum = 4,
      n_sums     = 7
    };
    double       sums[n_sums] = {};
    const Motion place(*this);
    const auto   axis = this->axis(), now = centre();
    for (std::size_t b = 0; b < bore_.size(); ++b)
      if (solid.mesh.owns(bore_[b]))
        {
          const double *f      = &solid.force[4 * bore_[b]];
          const Vector3 force  = {f[0], f[1], f[2]};
          const Vector3 moment = cross(place(data_.centre + arm_[b]) - now, force);
          for (int i = 0; i < 3; ++i)
            {
              sums[force_sum + i] += force[i];
              sums[moment_sum + i] += moment[i];
            }
          sums[about_axis] += dot(moment, axis);
        }
    ordered_sum(sums, communicator_);
    Reaction reaction;
    for (int i = 0; i < 3; ++i)
      {
        reaction.force[i]  = sums[force_sum + i];
        reaction.moment[i] = sums[moment_sum + i];
      }
    reaction.about_axis = sums[about_axis];
    return reaction;
  }


  void
  Axle::move(Solid &solid, const VelocityUpdate &velocity_update, const double time_step)
  {
    const Reaction reaction = reaction_of(solid);
    reaction_               = reaction.force;

    // (m_a + m_b) y'' = F_y - (M + m_a) g - k s - c s', M y_M'' = k s + c s' (doc/theory/rolling.md, Axle):
    // vertical motion with suspension, preload and weight; the suspension is too slow to bring a change of
    // the load to the axle
    const double stretch    = height_ - hub_displacement_ - sprung_height_;
    const double closing    = vertical_speed_ - sprung_speed_;
    const double suspension = data_.stiffness * stretch + data_.damping * closing;
    const double weight     = (data_.sprung_mass + data_.mass) * data_.gravity;
    const double added      = data_.path ? data_.path->load.at(0) - data_.path->load.at(travelled_) : 0;
    const double before     = vertical_speed_;
    acceleration_           = (reaction.force[1] - weight - suspension + added) / total_mass_;
    advance(height_, vertical_speed_, acceleration_, velocity_update, time_step);
    work_.load_work += velocity_update.duration * added * 0.5 * (before + vertical_speed_);
    if (data_.sprung_mass > 0)
      advance(sprung_height_, sprung_speed_, suspension / data_.sprung_mass, velocity_update, time_step);
    work_.damped += velocity_update.duration * data_.damping * closing * closing;

    turn_wheel(reaction, velocity_update, time_step);
    go_on(reaction, velocity_update, time_step);
    place_bore(solid, time_step);
  }


  void
  Axle::turn_wheel(const Reaction &reaction, const VelocityUpdate &velocity_update, const double time_step)
  {
    // (I_a + I_b) omega' = moment of the bore forces + T (doc/theory/rolling.md, Axle):
    // driven by the torque, or held
    const double rate_before = pitch_rate_, moment = reaction.about_axis;
    applied_torque_ = data_.path ? data_.path->torque.at(travelled_) : data_.torque;
    if (travelled_ < data_.torque_ramp)
      {
        if (std::isnan(start_torque_))
          start_torque_ = -moment;
        const double left = 0.5 * (1 + std::cos(M_PI * travelled_ / data_.torque_ramp));
        applied_torque_ += left * (start_torque_ - applied_torque_);
      }
    if (data_.rate_held)
      {
        const double wanted =
          data_.path ? data_.path->pitch_rate.at(travelled_ + 0.5 * time_step * velocity()) : pitch_rate_;
        applied_torque_ = total_inertia_ * (wanted - pitch_rate_) / velocity_update.duration - moment;
      }
    advance(angle_, pitch_rate_, (moment + applied_torque_) / total_inertia_, velocity_update, time_step);
    work_.torque_work += velocity_update.duration * applied_torque_ * 0.5 * (rate_before + pitch_rate_);
  }


  void
  Axle::go_on(const Reaction &reaction, const VelocityUpdate &velocity_update, const double time_step)
  {
    const Vector3 &force = reaction.force;
    if (!data_.path)
      {
        work_.hold_work -=
          velocity_update.duration * (force[2] + force[0] * data_.lateral_creepage) * data_.velocity;
        travelled_ += time_step * data_.velocity;
        return;
      }
    const GuidedPath::Rate rate = data_.path->rate(travelled_);
    work_.hold_work -= velocity_update.duration * velocity() *
                       (force[2] + dot(force, rate.centre) + dot(reaction.moment, rate.spin));
    travelled_ += time_step * data_.path->velocity.at(travelled_ + 0.5 * time_step * velocity());
  }


  void
  Axle::place_bore(Solid &solid, const double time_step)
  {
    const Motion place(*this);
    for (std::size_t b = 0; b < bore_.size(); ++b)
      {
        const Vector3 x = place(data_.centre + arm_[b]);
        for (int i = 0; i < 3; ++i)
          {
            const double u                       = x[i] - solid.mesh.reference[4 * bore_[b] + i];
            solid.velocity[4 * bore_[b] + i]     = (u - solid.displacement[4 * bore_[b] + i]) / time_step;
            solid.displacement[4 * bore_[b] + i] = u;
          }
      }
  }


  Axle::Motion::Motion(const Axle &axle)
    : start_(axle.data_.centre)
    , now_(axle.centre())
    , turn_(axle.data_.axis, axle.angle_)
    , turn_back_(axle.data_.axis, -axle.angle_)
  {
    if (axle.data_.path)
      {
        lead_      = axle.data_.path->lead(axle.travelled_);
        lead_.move = {};
      }
  }


  /// Calls visit(name, number) for all that one step leaves to the next.
  template <typename A, typename Visit>
  void
  Axle::visit_state(A &axle, const Visit &visit)
  {
    visit("height", axle.height_);
    visit("lift", axle.hub_displacement_);
    visit("vertical_speed", axle.vertical_speed_);
    visit("angle", axle.angle_);
    visit("pitch_rate", axle.pitch_rate_);
    visit("travelled", axle.travelled_);
    visit("sprung_height", axle.sprung_height_);
    visit("sprung_speed", axle.sprung_speed_);
    visit("damped", axle.work_.damped);
    visit("torque_work", axle.work_.torque_work);
    visit("hold_work", axle.work_.hold_work);
    visit("load_work", axle.work_.load_work);
  }


  PartState
  Axle::state() const
  {
    PartState state;
    visit_state(*this, [&](const char *name, const double number) { state.numbers[name] = number; });
    return state;
  }


  void
  Axle::set_state(const PartState &state)
  {
    visit_state(*this, [&](const char *name, double &number) { number = state.numbers.at(name); });
  }


  AxleEnergy
  Axle::energy() const
  {
    AxleEnergy   energy  = work_;
    const double stretch = height_ - hub_displacement_ - sprung_height_;
    energy.kinetic       = 0.5 * total_mass_ * vertical_speed_ * vertical_speed_ +
                     0.5 * total_inertia_ * pitch_rate_ * pitch_rate_ +
                     0.5 * data_.sprung_mass * sprung_speed_ * sprung_speed_;
    energy.potential =
      (data_.sprung_mass + data_.mass) * data_.gravity * height_ + 0.5 * data_.stiffness * stretch * stretch;
    return energy;
  }


  WheelAxes::WheelAxes(const Axle &axle)
    : motion_(axle)
  {
  }


  void
  WheelAxes::change(Solid &solid, const std::function<Vector3(const Vector3 &)> &move) const
  {
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::wheel)
        {
          const Vector3 x = move(solid.position(n));
          for (int i = 0; i < 3; ++i)
            solid.displacement[4 * n + i] = x[i] - solid.mesh.reference[4 * n + i];
        }
  }


  void
  WheelAxes::to_wheel(Solid &solid) const
  {
    change(solid, [&](const Vector3 &x) { return motion_.back(x); });
  }


  void
  WheelAxes::to_track(Solid &solid) const
  {
    change(solid, [&](const Vector3 &x) { return motion_(x); });
  }
} // namespace wheelrail
