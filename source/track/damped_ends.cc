#include <wheelrail/track/damped_ends.h>
#include <wheelrail/track/rail_foot.h>

#include <algorithm>

namespace wheelrail
{
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
} // namespace wheelrail
