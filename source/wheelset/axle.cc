#include <wheelrail/wheelset/axle.h>

#include <cmath>
#include <set>

namespace wheelrail
{
  namespace
  {
    /// Sums over ranks in the order of the ranks, so that all of them get the same bits.
    template <std::size_t n>
    void
    ordered_sum(double (&values)[n], MPI_Comm communicator)
    {
      int size;
      MPI_Comm_size(communicator, &size);
      std::vector<double> all(n * size);
      MPI_Allgather(values, n, MPI_DOUBLE, all.data(), n, MPI_DOUBLE, communicator);
      for (std::size_t k = 0; k < n; ++k)
        {
          values[k] = 0;
          for (int r = 0; r < size; ++r)
            values[k] += all[n * r + k];
        }
    }
  } // namespace


  std::vector<unsigned int>
  boundary_nodes(const LocalMesh &mesh, const Boundary mark)
  {
    std::set<unsigned int> nodes;
    for (const auto &face : mesh.faces)
      if (face.mark == mark)
        nodes.insert(face.nodes.begin(), face.nodes.end());
    return {nodes.begin(), nodes.end()};
  }


  Axle::Axle(const AxleData &data,
             const Solid    &solid,
             const double    lift,
             const double    pitch_rate,
             MPI_Comm        communicator)
    : data_(data)
    , height_(lift)
    , lift_(lift)
    , pitch_rate_(pitch_rate)
    , communicator_(communicator)
  {
    // only nodes of own faces are known to be bore nodes; another holder learns it from its own faces or
    // from the sum below, since a bore node of a rank's cells always has a bore face in some rank's cells
    AlignedVector<double> mark(4 * solid.mesh.n_nodes(), 0.);
    for (const unsigned int n : boundary_nodes(solid.mesh, Boundary::bore))
      mark[4 * n] = 1;
    SharedSum sum(solid.mesh, communicator);
    sum(mark.data(), 1);
    double totals[2] = {0, 0};
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (mark[4 * n] > 0)
        {
          const double *X = &solid.mesh.reference[4 * n];
          bore_.push_back(n);
          arm_.push_back(Vector3{X[0], X[1], X[2]} - data.centre);
          if (solid.mesh.owned[n])
            {
              const Vector3 radial = arm_.back() - dot(arm_.back(), data.axis) * data.axis;
              totals[0] += solid.mass[n];
              totals[1] += solid.mass[n] * dot(radial, radial);
            }
        }
    ordered_sum(totals, communicator);
    total_mass_     = data.mass + totals[0];
    total_inertia_  = data.pitch_inertia + totals[1];
    applied_torque_ = data.torque;
  }


  void
  Axle::step(Solid &solid, const double time_step, const bool first)
  {
    // 1. force and moment of the wheel on the axle
    double sums[4] = {0, 0, 0, 0};
    for (std::size_t b = 0; b < bore_.size(); ++b)
      if (solid.mesh.owned[bore_[b]])
        {
          const double *f     = &solid.force[4 * bore_[b]];
          const Vector3 force = {f[0], f[1], f[2]};
          for (int i = 0; i < 3; ++i)
            sums[i] += force[i];
          sums[3] += dot(cross(rotated(arm_[b], data_.axis, angle_), force), data_.axis);
        }
    ordered_sum(sums, communicator_);
    std::copy(sums, sums + 4, reaction_);

    // 2. vertical motion with suspension, preload and weight
    const double kick       = first ? time_step / 2 : time_step;
    const double stretch    = height_ - lift_ - sprung_height_;
    const double closing    = vertical_speed_ - sprung_speed_;
    const double suspension = data_.stiffness * stretch + data_.damping * closing;
    const double weight     = (data_.sprung_mass + data_.mass) * data_.gravity;
    vertical_speed_ += kick * (sums[1] - weight - suspension) / total_mass_;
    if (data_.sprung_mass > 0)
      sprung_speed_ += kick * suspension / data_.sprung_mass;
    work_.damped += kick * data_.damping * closing * closing;

    // 3. pitch: driven by the torque, or held
    const double rate_before = pitch_rate_;
    applied_torque_          = data_.rate_held ? -sums[3] : data_.torque;
    pitch_rate_ += kick * (sums[3] + applied_torque_) / total_inertia_;
    work_.torque_work += kick * applied_torque_ * 0.5 * (rate_before + pitch_rate_);
    work_.hold_work -= kick * sums[2] * data_.velocity;

    // 4. positions
    height_ += time_step * vertical_speed_;
    sprung_height_ += time_step * sprung_speed_;
    angle_ += time_step * pitch_rate_;
    travelled_ += time_step * data_.velocity;
    place_bore(solid, time_step);
  }


  void
  Axle::place_bore(Solid &solid, const double time_step)
  {
    const Vector3 centre = data_.centre + Vector3{0, height_, travelled_};
    for (std::size_t b = 0; b < bore_.size(); ++b)
      {
        const Vector3 x = centre + rotated(arm_[b], data_.axis, angle_);
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
