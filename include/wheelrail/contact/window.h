#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/contact/surface.h>
#include <wheelrail/contact/surface_state.h>

#include <mpi.h>

#include <vector>

namespace wheelrail
{
  /// The window of the contact: the stations of both lattices that follow the axle. Its nodes are known to
  /// all ranks; each is sent by the rank that owns it.
  class ContactWindow
  {
  public:
    /// A node of the window: index in the lattice of the body.
    struct Node
    {
      Body         body;
      unsigned int index;
    };

    /// `half_length`: of the window along the track [m].
    ContactWindow(double half_length, MPI_Comm communicator);

    /// Takes the surfaces, as they are now stored, and chooses the stations at the place of the last move.
    void
    prepare(Surface rail, Surface wheel);

    /// Centres the window at `along` [m]. `wheel_ahead` is the arc coordinate of the wheel that faces Z =
    /// along, minus along [m]. Whether other stations than before lie in it. Cheap when they are the same.
    bool
    move(double along, double wheel_ahead);

    /// Chooses the stations themselves, as a saved state holds them.
    void
    set_stations(const PerBody<StationRange> &stations);

    /// Brings displacement and velocity (4 numbers a node) of the window's nodes to all ranks: fills
    /// position, x, v and slip. Collective.
    void
    gather(const double *displacement, const double *velocity, PerBody<SurfaceState> &states);

    /// Adds the forces of the window's nodes to those that this rank holds; force has 4 numbers a node.
    void
    scatter(const PerBody<SurfaceState> &states, double *force) const;

    const PerBody<Surface> &
    surfaces() const
    {
      return surfaces_;
    }
    const PerBody<StationRange> &
    stations() const
    {
      return stations_;
    }
    /// In the order of arrival.
    const std::vector<Node> &
    nodes() const
    {
      return nodes_;
    }
    /// Those that this rank owns.
    const std::vector<Node> &
    own() const
    {
      return own_;
    }
    double
    wheel_ahead() const
    {
      return wheel_ahead_;
    }

  private:
    PerBody<StationRange>
    stations_around(double along, double wheel_ahead) const;
    void
    share();

    double                half_length_; ///< [m]
    MPI_Comm              communicator_;
    PerBody<Surface>      surfaces_;
    PerBody<StationRange> stations_;
    double                along_ = 0, wheel_ahead_ = 0; ///< of the last move [m]
    std::vector<Node>     own_, nodes_;                 ///< sent by this rank, and all
    std::vector<int>      counts_, begin_;              ///< of the numbers that each rank sends
    std::vector<double>   send_, receive_;
  };
} // namespace wheelrail
