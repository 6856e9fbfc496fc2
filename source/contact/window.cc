#include <wheelrail/contact/window.h>

#include <algorithm>
#include <cmath>
#include <utility>

// Stations around the axle whose nodes can touch, half length sqrt(2 r approach) and two cells more
// (doc/theory/contact.md, Window and ranks).

namespace wheelrail
{
  ContactWindow::ContactWindow(const double half_length, MPI_Comm communicator)
    : half_length_(half_length)
    , communicator_(communicator)
  {
  }


  void
  ContactWindow::prepare(Surface rail, Surface wheel)
  {
    surfaces_ = {std::move(rail), std::move(wheel)};
    set_stations(stations_around(along_, wheel_ahead_));
  }


  bool
  ContactWindow::move(const double along, const double wheel_ahead)
  {
    // most steps leave the stations as they are
    along_                               = along;
    wheel_ahead_                         = wheel_ahead;
    const PerBody<StationRange> stations = stations_around(along, wheel_ahead);
    if (stations.rail == stations_.rail && stations.wheel == stations_.wheel)
      return false;
    set_stations(stations);
    return true;
  }


  void
  ContactWindow::set_stations(const PerBody<StationRange> &stations)
  {
    stations_ = stations;
    share();
  }


  PerBody<StationRange>
  ContactWindow::stations_around(const double along, const double wheel_ahead) const
  {
    const auto range = [&](const Lattice &lattice, const double place, const int beyond) {
      const int middle = static_cast<int>(std::lround(place / lattice.spacing_along)) - lattice.first_station;
      // stations from middle - half to middle + half, cut to those that are stored
      const int half = static_cast<int>(std::ceil(half_length_ / lattice.spacing_along)) + beyond;
      return StationRange{std::max(0, middle - half), std::min<int>(lattice.n_along, middle + half + 1)};
    };
    // the wheel's part reaches further, so that every rail node finds a facet
    return {range(surfaces_.rail.lattice, along, 0), range(surfaces_.wheel.lattice, along + wheel_ahead, 2)};
  }


  void
  ContactWindow::share()
  {
    int rank, size;
    MPI_Comm_rank(communicator_, &rank);
    MPI_Comm_size(communicator_, &size);
    // Numbers of all ranks in one order, from the owners listed alike everywhere: no lists have to be sent in
    // a step, only 6 numbers a node, displacement and velocity.
    std::vector<std::vector<Node>> by_rank(size);
    for (const Body body : both_bodies)
      {
        const Surface &surface = surfaces_[body];
        for (int i = stations_[body].first; i < stations_[body].last; ++i)
          for (unsigned int j = 0; j < surface.lattice.n_lateral; ++j)
            {
              const unsigned int k = surface.lattice.index(i, j);
              // each node is sent by its owner
              by_rank[surface.owner[k]].push_back({body, k});
            }
      }
    own_ = by_rank[rank];
    nodes_.clear();
    counts_.assign(size, 0);
    begin_.assign(size, 0);
    for (int r = 0; r < size; ++r)
      {
        begin_[r]  = 6 * nodes_.size();
        counts_[r] = 6 * by_rank[r].size();
        nodes_.insert(nodes_.end(), by_rank[r].begin(), by_rank[r].end());
      }
    send_.resize(6 * own_.size());
    receive_.resize(6 * nodes_.size());
  }


  void
  ContactWindow::gather(const double *displacement, const double *velocity, PerBody<SurfaceState> &states)
  {
    double *out = send_.data();
    for (const auto &[body, k] : own_)
      {
        const unsigned int node = surfaces_[body].local[k];
        for (int i = 0; i < 3; ++i)
          *out++ = displacement[4 * node + i];
        for (int i = 0; i < 3; ++i)
          *out++ = velocity[4 * node + i];
      }
    if (counts_.size() > 1)
      MPI_Allgatherv(send_.data(),
                     send_.size(),
                     MPI_DOUBLE,
                     receive_.data(),
                     counts_.data(),
                     begin_.data(),
                     MPI_DOUBLE,
                     communicator_);
    else
      receive_ = send_;
    // all ranks get all numbers in the order of nodes_
    const double *in = receive_.data();
    for (const auto &[body, k] : nodes_)
      {
        SurfaceState  &state = states[body];
        const Vector3 &X     = surfaces_[body].reference[k];
        // x = X + u; the velocity is filtered twice, through the normal and through the shear filter
        state.x[k] = {X[0] + in[0], X[1] + in[1], X[2] + in[2]};
        state.v[k] = state.slip[k] = {in[3], in[4], in[5]};
        if (body == Body::rail)
          state.position[k] = state.x[k];
        in += 6;
      }
  }


  void
  ContactWindow::scatter(const PerBody<SurfaceState> &states, double *force) const
  {
    for (const auto &[body, k] : nodes_)
      {
        // each rank adds them at all nodes that it holds, its own and copies alike: forces of phase 3 of a
        // step need no sum over ranks (doc/theory/rolling.md, Time stepping)
        const int node = surfaces_[body].local[k];
        if (node >= 0)
          for (int i = 0; i < 3; ++i)
            // [N], on every rank that holds the node
            force[4 * node + i] += states[body].normal_force[k][i] + states[body].traction_force[k][i];
      }
  }
} // namespace wheelrail
