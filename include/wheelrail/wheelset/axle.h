#pragma once

#include <wheelrail/base/vector3.h>
#include <wheelrail/solid/part.h>
#include <wheelrail/solid/solid.h>
#include <wheelrail/wheelset/guided_path.h>

#include <mpi.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace wheelrail
{
  /// What the wheel's bore is tied to, and what carries and turns it [SI].
  struct AxleData
  {
    Vector3 centre{}; ///< of the axle at the start, before loading, in the plane of the running circle
    Vector3 axis             = {1, 0, 0}; ///< unit vector towards the track centre
    double  mass             = 180;       ///< rigid half axle
    double  pitch_inertia    = 1.5;       ///< of the half axle about its own axis
    double  sprung_mass      = 10000;
    double  stiffness        = 1.15e6; ///< primary suspension
    double  damping          = 2500;
    double  gravity          = 9.81;
    double  velocity         = 0;     ///< along Z, held
    double  lateral_creepage = 0;     ///< velocity along X over that along Z, held
    double  rise             = 0;     ///< vertical velocity over that along Z at the start, on a slope
    bool    rate_held        = false; ///< the pitch rate keeps its start value
    double  torque           = 0;     ///< drive torque about `axis`, positive driving [N m]

    /// Length over which the torque changes smoothly from that of the static start to `torque` [m]; 0: at
    /// once. A step lets hub and rim swing against each other.
    double torque_ramp = 0;

    /// What leads the wheelset; none: all of the above stays as it is. `load` is what is on the rail with the
    /// loads above: changes of it act on the axle.
    std::shared_ptr<const GuidedPath> path;
  };

  /// Works and energies of axle, suspension and sprung mass [J].
  struct AxleEnergy
  {
    double kinetic   = 0; ///< of axle with the tied bore nodes, and of the sprung mass
    double potential = 0; ///< of axle and preload in gravity, and the suspension's deviation from its preload
    double damped    = 0; ///< by the suspension's damper
    double torque_work = 0; ///< of the drive torque (or of the torque that holds the rate)
    double hold_work   = 0; ///< of the forces that hold or lead the wheelset: speeds, roll and yaw
    double load_work   = 0; ///< of changes of the load
  };

  /// The rigid axle: vertical motion and pitch are free, longitudinal and lateral speed are held, roll and
  /// yaw are fixed, or all of these follow a path (GuidedPath). The bore nodes follow the axle exactly.
  class Axle : public Part
  {
  public:
    /// `hub_displacement` [m] is that of the static start, vertical, `pitch_rate` [rad/s] its start value.
    Axle(const AxleData &data, double hub_displacement, double pitch_rate, MPI_Comm communicator);

    /// Finds the bore nodes by the marks of the mesh, takes them from the loop, and adds their mass and
    /// inertia to the axle's. Collective.
    void
    prepare(const Solid &solid, std::vector<NodeInertia> &inertia) override;
    void
    enter(EnergyBalance &energies) override;

    /// Sums the forces on the bore nodes and advances the rigid motion by a step, then places the
    /// bore nodes (displacement and velocity of `solid`). Collective.
    void
    constrain(const Instant &now, Solid &solid, const std::vector<NodeInertia> &inertia) override;

    const AxleData &
    data() const
    {
      return data_;
    }
    /// Vertical position against the unloaded start [m].
    double
    height() const
    {
      return height_;
    }
    double
    pitch_rate() const
    {
      return pitch_rate_;
    }
    double
    travelled() const
    {
      return travelled_;
    }
    /// How far the middle of the wheelset has moved along X [m].
    double
    aside() const
    {
      return data_.path ? data_.path->lateral_shift.at(travelled_) - data_.path->lateral_shift.at(0)
                        : data_.lateral_creepage * travelled_;
    }
    /// Where its centre is now [m].
    Vector3
    centre() const
    {
      const Vector3 straight = data_.centre + Vector3{0, height_, travelled_};
      return straight + (data_.path ? data_.path->lead(travelled_).move : Vector3{aside(), 0, 0});
    }
    /// Its direction to the track centre now, a unit vector.
    Vector3
    axis() const
    {
      return data_.path ? data_.path->lead(travelled_).turned(data_.axis) : data_.axis;
    }
    /// Of the wheelset along the track, now [m/s].
    double
    velocity() const
    {
      return data_.path ? data_.path->velocity.at(travelled_) : data_.velocity;
    }
    /// Z of the contact, as the rigid profiles have it in the pose of now [m].
    double
    contact_along() const
    {
      return travelled_ +
             (data_.path ? data_.path->contact_along.at(travelled_) - data_.path->contact_along.at(0) : 0);
    }
    /// The arc coordinate of the wheel there, at its rolling radius [m].
    double
    contact_on_wheel(const double rolling_radius) const
    {
      return rolling_radius * angle_ +
             (data_.path ? data_.path->contact_ahead.at(travelled_) - data_.path->contact_ahead.at(0) : 0);
    }

    /// The rigid motion of the wheel from the start to now.
    class Motion
    {
    public:
      explicit Motion(const Axle &axle);

      Vector3
      operator()(const Vector3 &X) const
      {
        return now_ + lead_.turned(turn_(X - start_));
      }
      /// The place that is now at x.
      Vector3
      back(const Vector3 &x) const
      {
        return start_ + turn_back_(lead_.back(x - now_));
      }

    private:
      Vector3     start_, now_;
      RigidMotion lead_; ///< without its move
      Rotation    turn_, turn_back_;
    };
    /// Force of the wheel on the axle in the last step [N].
    Vector3
    reaction() const
    {
      return reaction_;
    }
    /// Vertical acceleration of axle and bearings in the last step [m/s2].
    double
    acceleration() const
    {
      return acceleration_;
    }
    /// Torque applied in the last step [N m].
    double
    applied_torque() const
    {
      return applied_torque_;
    }
    /// Energies with the velocities of the half step behind.
    AxleEnergy
    energy() const;

    /// Lets it turn faster by `change` [rad/s].
    void
    add_rate(const double change)
    {
      pitch_rate_ += change;
    }
    /// The torque that the ramp begins with [N m]; not set, it is what holds the rate in the first step.
    void
    set_start_torque(const double torque)
    {
      start_torque_ = torque;
    }

    /// What one step leaves to the next, as numbers that all ranks have [SI]: height, lift, vertical_speed,
    /// angle, pitch_rate, travelled, sprung_height, sprung_speed, and the works damped, torque_work,
    /// hold_work, load_work. Positions are those of the full step, speeds and works of the half step.
    std::string
    name() const override
    {
      return "axle";
    }
    PartState
    state() const override;
    void
    set_state(const PartState &state) override;

    /// The bore nodes of this rank.
    const std::vector<unsigned int> &
    bore() const
    {
      return bore_;
    }

  private:
    /// Terms of the energy energies.
    struct Terms
    {
      EnergyTerm *kinetic = nullptr, *potential = nullptr, *suspension = nullptr, *torque = nullptr,
                 *hold = nullptr, *load = nullptr;
    };
    /// Force and moment of the wheel on the axle, about its centre.
    struct Reaction
    {
      Vector3 force{}, moment{};
      double  about_axis = 0;
    };
    Reaction
    reaction_of(const Solid &solid) const;
    void
    turn_wheel(const Reaction &reaction, const VelocityUpdate &velocity_update, double time_step);
    void
    go_on(const Reaction &reaction, const VelocityUpdate &velocity_update, double time_step);
    void
    move(Solid &solid, const VelocityUpdate &velocity_update, double time_step);
    void
    write(const AxleEnergy &before);
    void
    place_bore(Solid &solid, double time_step);
    template <typename A, typename Visit>
    static void
    visit_state(A &axle, const Visit &visit);

    AxleData                  data_;
    std::vector<unsigned int> bore_;
    std::vector<Vector3>      arm_; ///< reference position of the bore nodes from the centre [m]
    double                    total_mass_ = 0, total_inertia_ = 0; ///< with the bore nodes
    double                    height_ = 0, hub_displacement_ = 0, vertical_speed_ = 0;
    double                    angle_ = 0, pitch_rate_ = 0;
    double                    travelled_     = 0;
    double                    sprung_height_ = 0, sprung_speed_ = 0; ///< against the static position
    Vector3                   reaction_{};
    double                    acceleration_   = 0;
    double                    applied_torque_ = 0;
    double                    start_torque_   = std::numeric_limits<double>::quiet_NaN();
    AxleEnergy                work_;
    Terms                     terms_;
    MPI_Comm                  communicator_;
  };

  /// Changes the displacements of the wheel between those in the track's axes and those in the axes that
  /// travel and turn with the axle.
  class WheelAxes
  {
  public:
    explicit WheelAxes(const Axle &axle);

    void
    to_wheel(Solid &solid) const;

    void
    to_track(Solid &solid) const;

  private:
    void
    change(Solid &solid, const std::function<Vector3(const Vector3 &)> &move) const;

    Axle::Motion motion_;
  };
} // namespace wheelrail
