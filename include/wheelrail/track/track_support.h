#pragma once

#include <wheelrail/solid/part.h>
#include <wheelrail/track/rail_foot.h>

#include <array>
#include <complex>
#include <cstdint>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Damping of a spring with the stiffness 1 at rest. Its dynamic stiffness at the angular frequency w is
  ///
  ///     1 + i w damper + sum over branches of share i w time / (1 + i w time).
  struct PadDamping
  {
    /// A spring and a damper behind one another (Maxwell), beside the spring.
    struct Branch
    {
      double share; ///< stiffness of its spring over that at rest
      double time;  ///< of relaxation: damper over spring [s]
    };

    double              damper = 0; ///< over the stiffness at rest [s]
    std::vector<Branch> branches;

    /// At the angular frequency [rad/s]; one with a negative imaginary part belongs to motions that fade.
    std::complex<double>
    dynamic_stiffness(std::complex<double> angular_frequency) const;

    /// Of motions too fast for the branches to relax: 1 + sum of the shares.
    double
    highest_stiffness() const;
  };

  /// One damper beside the spring, whose loss factor is `loss_factor` at `frequency` [Hz] and grows in
  /// proportion to it.
  PadDamping
  matched_damper(double loss_factor, double frequency);

  /// Lowest and highest frequency between which constant_loss() keeps its loss factor [Hz].
  constexpr double constant_loss_from = 100, constant_loss_to = 2000;

  /// Three branches that keep the loss factor constant: relaxation at 83, 500 and 3000 Hz, shares by least
  /// squares of Im - loss factor x Re. Causality (Kramers 1927, Kronig 1926) then stiffens the spring with
  /// frequency: with 0.25 by 18 % from 449 to 1261 Hz.
  PadDamping
  constant_loss(double loss_factor);

  /// What carries the rail [SI]. Stiffnesses of pads in the axes of the rail's foot (across, normal, along),
  /// of ballast in those of the track (X, Y, Z).
  struct TrackData
  {
    bool       continuous = false; ///< the pads are spread evenly along the rail
    double     spacing    = 0.6;   ///< of sleepers, and of pads
    double     first      = 0.3;   ///< Z of the middle of one of the sleepers
    double     pad_length = 0.15;  ///< along the rail
    Vector3    pad{};              ///< stiffness of one pad at rest [N/m]
    PadDamping pad_damping;
    bool       rigid_sleepers = true; ///< that do not move
    double     sleeper_mass   = 0;    ///< below one rail [kg]
    Vector3    ballast{};             ///< stiffness below one end of a sleeper [N/m]
    double     ballast_damper = 0;    ///< over its stiffness [s]
  };

  /// Pads under the foot of the rail, each a field of springs and dampers over the area that it touches, and
  /// the sleepers below them: rigid masses that move without turning, on springs and dampers to the ground.
  /// The ends of the rail are free. Pads pull as they press: clips hold the rail down.
  ///
  /// Energies: `pad_energy`, `pad_dissipation`; with sleepers that move `sleeper_energy` (kinetic),
  /// `ballast_energy`, `ballast_dissipation`. Theory: doc/manual/track.md.
  class TrackSupport : public Part
  {
  public:
    TrackSupport(const TrackData &data, MPI_Comm communicator);

    void
    prepare(const Solid &solid, std::vector<NodeInertia> &inertia) override;
    void
    enter(EnergyBalance &energies) override;
    void
    add_forces(const Instant &now, Solid &solid) override;
    void
    account(const Instant &now, const Solid &solid, const std::vector<NodeInertia> &inertia) override;
    double
    squared_frequency(const Solid &solid) const override;

    /// `foot_deflection`: largest sinking of the foot, mean over its width [m]. Of pads apart from each other
    /// also `largest_pad_force` and `largest_pad_pull` [N]: what the most loaded pad bears normal to the
    /// foot, and what the most lifted one holds (0: none is lifted).
    std::vector<PartMeasure>
    measures() const override;

    void
    add_stiffness(const Solid &solid, const double *x, double *y) const override;
    void
    add_springs(double *stiffness) const override;
    std::vector<JoinedNodes>
    joined() const override;
    void
    start(const Solid &solid) override;

    std::string
    name() const override
    {
      return "track";
    }
    PartState
    state() const override;
    void
    set_state(const PartState &state) override;

    /// The middles of the sleepers below the rail, along the track [m]; empty when pads are continuous.
    const std::vector<double> &
    sleepers() const
    {
      return sleepers_;
    }
    /// How each of them has moved [m]; zero when they are rigid.
    const std::vector<Vector3> &
    sleeper_places() const
    {
      return place_;
    }
    /// What the pads bear in the position of a solid at rest, along the axes of the track [N]. Collective.
    Vector3
    force_at_rest(const Solid &solid) const;

  private:
    /// A node on a pad, with what this has of the stiffness of one whole pad.
    struct Bearing
    {
      unsigned int  node;
      unsigned int  sleeper; ///< zero when pads are continuous
      double        share;
      double        owned; ///< 1 when this rank counts it, else 0
      std::uint64_t key;   ///< of the node, from mesh to mesh and from rank to rank
    };
    /// A node of the foot on one of its stations along the track.
    struct FootNode
    {
      unsigned int node, station;
      double       share; ///< of the mean over the width: one over the nodes of the station
    };
    static constexpr unsigned int most_branches = 3;
    /// How far the springs of the branches are stretched along the axes of the foot [m].
    using Stretch = std::array<Vector3, most_branches>;

    /// Node and stretches over all ranks, to be found again on another mesh.
    struct Kept
    {
      std::uint64_t key;
      Vector3       place;
      Stretch       stretch;
    };

    bool
    sleepers_move() const
    {
      return !data_.continuous && !data_.rigid_sleepers;
    }
    void
    find_bearings(const Solid &solid);
    void
    find_foot(const Solid &solid);
    void
    keep_stretches(const std::vector<Kept> &kept);
    std::vector<Kept>
    stretches_of_all() const;
    Vector3
    turned(const Vector3 &track) const;
    Vector3
    turned_back(const Vector3 &foot) const;
    std::vector<Vector3>
    condensed(const double *x) const;
    void
    move_sleepers(const Instant &now, std::vector<double> &force);
    void
    measure(const Solid &solid, std::vector<double> &pad_forces);

    TrackData              data_;
    MPI_Comm               communicator_;
    std::array<Vector3, 3> axes_{}; ///< of the foot
    std::vector<FootNode>  foot_;   ///< that this rank counts
    unsigned int           n_stations_ = 0;
    std::vector<double>    sleepers_;
    std::vector<Bearing>   bearings_;
    std::vector<Vector3>   at_;      ///< of the bearings, in the reference [m]
    std::vector<Stretch>   stretch_; ///< of the bearings
    std::vector<Vector3>   place_, speed_,
      mean_speed_;                            ///< of the sleepers: at full, at half steps, around the last
    std::vector<std::array<double, 9>> give_; ///< inverse of what holds a sleeper, pads and ballast [m/N]
    double      deflection_ = 0, pad_force_ = 0, pad_pull_ = 0; ///< as measures() has them
    int         rank_   = 0;
    EnergyTerm *stored_ = nullptr, *dissipated_ = nullptr, *kinetic_ = nullptr, *ballast_ = nullptr,
               *ballast_dissipated_ = nullptr;
  };
} // namespace wheelrail
