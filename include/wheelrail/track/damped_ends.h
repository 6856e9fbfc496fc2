#pragma once

#include <wheelrail/solid/part.h>

#include <mpi.h>

#include <vector>

namespace wheelrail
{
  /// Mass damping that rises smoothly towards both ends of the rail, so that waves die there and do not come
  /// back: force -c m v with c = c_end (x/L)^2, x from the begin of the damped stretch on. It acts on the
  /// mean of the velocities of both half steps, which leaves the stable step as it is.
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
} // namespace wheelrail
