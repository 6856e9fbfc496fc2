#include <wheelrail/model/scene_parts.h>
#include <wheelrail/solid/part.h>
#include <wheelrail/track/rail_foot.h>
#include <wheelrail/track/scene_track.h>

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Mass damping that rises smoothly towards both ends of the rail, so that waves die there and do not
    /// come back: force -c m v with c = c_end (x/L)^2, x from the begin of the damped stretch on. It acts on
    /// the mean of the velocities of both half steps, which leaves the stable step as it is.
    ///
    /// Energy: `end_dissipation`.
    class DampedEnds : public Part
    {
    public:
      /// `length` of either damped stretch [m].
      DampedEnds(double length, MPI_Comm communicator);

      void
      prepare(const Solid &solid, std::vector<NodeInertia> &inertia) override;
      void
      enter(EnergyBalance &energies) override;
      void
      constrain(const Instant &now, Solid &solid, const std::vector<NodeInertia> &inertia) override;
      void
      account(const Instant &now, const Solid &solid, const std::vector<NodeInertia> &inertia) override;

      /// c_end [1/s].
      double
      highest_rate() const;

    private:
      struct Damped
      {
        unsigned int node;
        double       rate;  ///< [1/s]
        double       owned; ///< mass that this rank counts [kg]
      };

      double              length_;
      MPI_Comm            communicator_;
      std::vector<Damped> nodes_;
      EnergyTerm         *dissipated_ = nullptr;
    };

    DampedEnds::DampedEnds(const double length, MPI_Comm communicator)
      : length_(length)
      , communicator_(communicator)
    {
    }

    /// A wave with the group velocity v comes back with exp(-integral of c/v) of its amplitude, half of the
    /// exponent in both directions. Waves of bending have 2 km/s at most; a hundred and fiftieth of them may
    /// come back: c_end L/3 = 2000 m/s x 5. More damping throws back slow waves, for which it then rises too
    /// fast.
    double
    DampedEnds::highest_rate() const
    {
      constexpr double fastest = 2e3, logarithm = 5;
      return 3 * fastest * logarithm / length_;
    }

    void
    DampedEnds::prepare(const Solid &solid, std::vector<NodeInertia> &)
    {
      const LocalMesh &mesh  = solid.mesh;
      const FootPiece  whole = whole_foot(mesh, communicator_);
      nodes_.clear();
      for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
        if (mesh.node_body[n] == Body::rail && solid.mass[n] > 0)
          {
            const double z = mesh.reference[4 * n + 2];
            const double x = std::max(whole[0] + length_ - z, z - whole[1] + length_) / length_;
            if (x > 0)
              nodes_.push_back(
                {n, highest_rate() * x * x, mesh.owns(n) ? solid.mass[n] + solid.added_mass[n] : 0});
          }
    }

    void
    DampedEnds::enter(EnergyBalance &energies)
    {
      dissipated_ = &energies.term("end_dissipation", EnergyKind::dissipated);
    }

    void
    DampedEnds::constrain(const Instant &now, Solid &solid, const std::vector<NodeInertia> &inertia)
    {
      for (const Damped &damped : nodes_)
        if (const double inverse = inertia[damped.node].inverse_mass; inverse > 0)
          {
            const Vector3 mean  = mean_velocity(solid, inertia, damped.node, now.velocity_update);
            const double  share = damped.rate / inverse / (1 + 0.5 * damped.rate * now.velocity_update.gain);
            for (int i = 0; i < 3; ++i)
              solid.force[4 * damped.node + i] -= share * mean[i];
          }
    }

    void
    DampedEnds::account(const Instant &now, const Solid &solid, const std::vector<NodeInertia> &inertia)
    {
      double power = 0;
      for (const Damped &damped : nodes_)
        if (damped.owned > 0)
          {
            const Vector3 mean = mean_velocity(solid, inertia, damped.node, now.velocity_update);
            power += damped.rate * damped.owned * dot(mean, mean);
          }
      dissipated_->add_work(now.velocity_update.duration * power);
    }
  } // namespace


  TrackData
  track_data(const TrackSettings &scene, const double farther)
  {
    const SupportData &support = scene.support;
    TrackData          track;
    track.continuous  = support.kind == RailSupport::continuous_pads;
    track.spacing     = support.spacing;
    track.first       = support.first_sleeper - farther;
    track.pad_length  = support.pad_length;
    track.pad_damping = support.pad_damping == PadLoss::constant
                          ? constant_loss(support.pad_loss)
                          : matched_damper(support.pad_loss, support.pad_frequency);
    // stiffnesses are given at that frequency
    const double at_rest = 1 / track.pad_damping.dynamic_stiffness(2 * M_PI * support.pad_frequency).real();
    track.pad = at_rest * Vector3{support.pad_lateral, support.pad_stiffness, support.pad_longitudinal};
    track.rigid_sleepers = std::isinf(support.sleeper_mass);
    track.sleeper_mass   = support.sleeper_mass;
    track.ballast        = {support.ballast_lateral, support.ballast_stiffness, support.ballast_longitudinal};
    track.ballast_damper = matched_damper(support.ballast_loss, support.ballast_frequency).damper;
    return track;
  }


  void
  add_track(const Scene &scene, const double farther, MPI_Comm communicator, SceneParts &parts)
  {
    if (scene.support.kind != RailSupport::clamped_foot)
      parts.push_back(std::make_unique<TrackSupport>(track_data(scene, farther), communicator));
    if (scene.support.damped_ends > 0)
      parts.push_back(std::make_unique<DampedEnds>(scene.support.damped_ends, communicator));
  }
} // namespace wheelrail
