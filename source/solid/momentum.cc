#include <deal.II/base/tensor.h>

#include <wheelrail/base/gather_all.h>
#include <wheelrail/solid/momentum.h>
#include <wheelrail/solid/transfer.h>

#include <array>

// Linear and angular momentum over a change of the mesh: interpolated velocities on other nodal masses have
// others. Rigid motions are added, first to what has changed, then to all.

namespace wheelrail
{
  namespace
  {
    /// A velocity field of rigid motion.
    struct RigidField
    {
      Vector3 centre{}, velocity{}, spin{};

      Vector3
      operator()(const Vector3 &x) const
      {
        // v + omega x (x - c)
        return velocity + cross(spin, x - centre);
      }
    };

    /// Sums over nodes, each with a mass: mass, first and second moments, linear and angular momentum about
    /// the origin.
    struct Moments
    {
      enum
      {
        mass     = 0,
        first    = 1, ///< three
        second   = 4, ///< xx, xy, xz, yy, yz, zz
        linear   = 10,
        rotation = 13,
        count    = 16
      };
      std::array<double, count> sums{};

      void
      add(const double m, const Vector3 &x, const Vector3 &v)
      {
        // angular momentum about the origin, x cross m v
        const Vector3 l = cross(x, v);
        sums[mass] += m;
        int k = second;
        for (int i = 0; i < 3; ++i)
          {
            sums[first + i] += m * x[i];
            sums[linear + i] += m * v[i];
            sums[rotation + i] += m * l[i];
            for (int j = i; j < 3; ++j)
              sums[k++] += m * x[i] * x[j];
          }
      }

      Vector3
      three(const int at) const
      {
        return {sums[at], sums[at + 1], sums[at + 2]};
      }
      Vector3
      momentum() const
      {
        return three(linear);
      }
      Vector3
      angular() const
      {
        return three(rotation);
      }

      /// The field of this mass that has a linear and an angular momentum (about the origin).
      RigidField
      field(const Vector3 &momentum, const Vector3 &angular) const
      {
        // Least squares of a rigid field to velocities with masses as weights: the field that has the same
        // linear and angular momentum.
        RigidField field;
        if (!(sums[mass] > 0))
          return field;
        // v = P/M, omega = I^-1 (L - c x P)
        const double M = sums[mass];
        field.centre   = (1 / M) * three(first);
        field.velocity = (1 / M) * momentum;
        // spin about the centre of mass
        const Vector3 l = angular - cross(field.centre, momentum);
        // second moments about the centre: xx, xy, xz, yy, yz, zz
        std::array<double, 6> s;
        int                   k = 0;
        for (int i = 0; i < 3; ++i)
          for (int j = i; j < 3; ++j, ++k)
            // Steiner: second moments about the centre of mass
            s[k] = sums[second + k] - M * field.centre[i] * field.centre[j];
        // scaled by the trace of the second moments, so that the limit below has no unit
        const double         size    = s[0] + s[3] + s[5];
        const double         I[3][3] = {// inertia I = sum of m (x.x 1 - x (x) x); omega = I^-1 L
                                {s[3] + s[5], -s[1], -s[2]},
                                {-s[1], s[0] + s[5], -s[4]},
                                {-s[2], -s[4], s[0] + s[3]}};
        dealii::Tensor<2, 3> inertia;
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            inertia[i][j] = I[i][j] / size;
        // nodes on a line cannot spin about it
        if (!(size > 0) || dealii::determinant(inertia) < 1e-9)
          return field;
        const auto inverse = dealii::invert(inertia);
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            field.spin[i] += inverse[i][j] * l[j] / size;
        return field;
      }
      RigidField
      field() const
      {
        return field(momentum(), angular());
      }
    };

    /// Over the owned nodes that have mass in mass[4 node + part]; the free ones alone when `inertia` is
    /// given.
    Moments
    moments(const Solid                    &solid,
            const AlignedVector<double>    &mass,
            const int                       part,
            const std::vector<NodeInertia> *inertia,
            MPI_Comm                        communicator)
    {
      // positions of the moment, x = X + u: angular momentum is that of the deformed bodies
      Moments moments;
      for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
        if (solid.mesh.owns(n) && mass[4 * n + part] > 0 && (!inertia || (*inertia)[n].inverse_mass > 0))
          moments.add(
            mass[4 * n + part], solid.position(static_cast<unsigned int>(n)), vector_at(solid.velocity, n));
      ordered_sum(moments.sums, communicator);
      return moments;
    }

    /// Mass at the nodes of the cells of a body that have changed: behind and ahead; of all its cells.
    AlignedVector<double>
    nodal_mass(const Solid                              &solid,
               const Body                                body,
               const std::function<bool(std::uint64_t)> &is_changed,
               const double                              middle)
    {
      AlignedVector<double> mass(4 * solid.mesh.n_nodes(), 0.);
      for (std::size_t c = 0; c < solid.mesh.cells.size(); ++c)
        if (solid.mesh.cell_body[c] == body)
          {
            // columns 0 and 1: mass of changed cells behind and ahead of the middle; 2: of all cells [kg]
            const bool changed = is_changed(solid.mesh.cell_key[c]);
            double     z       = 0;
            for (const unsigned int n : solid.mesh.cells[c])
              z += solid.position(n)[2] / 8;
            for (unsigned int a = 0; a < 8; ++a)
              {
                double *at = &mass[4 * solid.mesh.cells[c][a]];
                at[2] += solid.cell_mass[c][a];
                if (changed)
                  // cells behind the middle of the wheel and ahead of it have changed on their own: a field
                  // for each side
                  at[z > middle] += solid.cell_mass[c][a];
              }
          }
      condense(solid.mesh, mass.data());
      sum_over_ranks(solid.mesh, mass.data());
      return mass;
    }

    /// Both sides as one, where they touch or one of them has no cells.
    void
    join_sides(AlignedVector<double> &before, AlignedVector<double> &after, MPI_Comm communicator)
    {
      // nodes with mass behind, ahead, on both sides
      std::array<double, 3> have{};
      for (std::size_t k = 0; k < after.size(); k += 4)
        {
          have[0] += after[k] > 0;
          have[1] += after[k + 1] > 0;
          have[2] += after[k] > 0 && after[k + 1] > 0;
        }
      ordered_sum(have, communicator);
      // no node has mass of both sides
      if (have[0] > 0 && have[1] > 0 && have[2] == 0)
        return;
      for (AlignedVector<double> *mass : {&before, &after})
        for (std::size_t k = 0; k < mass->size(); k += 4)
          {
            // a node between both sides would get the fields of both
            (*mass)[k] += (*mass)[k + 1];
            (*mass)[k + 1] = 0;
          }
    }

    /// Adds share x field to the free nodes that have mass in mass[4 node + part].
    void
    add_field(Solid                                         &solid,
              const AlignedVector<double>                   &mass,
              const int                                      part,
              const std::vector<NodeInertia>                &inertia,
              const std::function<Vector3(const Vector3 &)> &field)
    {
      for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
        if (inertia[n].inverse_mass > 0 && mass[4 * n + part] > 0)
          {
            // the part of a node's mass that belongs to these cells, so that the sum of m v is that of the
            // field on them
            const double  share = mass[4 * n + part] * inertia[n].inverse_mass;
            const Vector3 v     = field(solid.position(static_cast<unsigned int>(n)));
            for (int i = 0; i < 3; ++i)
              solid.velocity[4 * n + i] += share * v[i];
          }
    }
  } // namespace


  void
  conserve_momentum(const Solid                              &before,
                    Solid                                    &after,
                    const std::function<bool(std::uint64_t)> &is_changed,
                    const double                              middle,
                    const std::vector<NodeInertia>           &inertia,
                    MPI_Comm                                  communicator)
  {
    constexpr int all = 2; // part of nodal_mass()
    for (const Body body : both_bodies)
      {
        // masses of the two meshes differ by what chords of other cells gain or lose against the true profile
        auto mass_before = nodal_mass(before, body, is_changed, middle);
        auto mass        = nodal_mass(after, body, is_changed, middle);
        join_sides(mass_before, mass, communicator);
        for (int side = 0; side < 2; ++side)
          {
            // fields from the masses of either mesh alone, so that a rigid motion of the whole gives wanted =
            // have and nothing changes
            const Moments was = moments(before, mass_before, side, nullptr, communicator),
                          is  = moments(after, mass, side, nullptr, communicator);
            if (!(was.sums[0] > 0 && is.sums[0] > 0))
              continue;
            // 1. changed cells, behind and ahead of the middle: their rigid motion before in place of that of
            // the interpolated velocities
            const RigidField wanted = was.field(), have = is.field();
            add_field(after, mass, side, inertia, [&](const Vector3 &x) { return wanted(x) - have(x); });
          }
        // 2. what the whole body still lacks of linear and angular momentum, as a rigid motion of its free
        // nodes
        const Moments was        = moments(before, mass_before, all, nullptr, communicator),
                      is         = moments(after, mass, all, nullptr, communicator),
                      free       = moments(after, mass, all, &inertia, communicator);
        const RigidField lacking = free.field(was.momentum() - is.momentum(), was.angular() - is.angular());
        add_field(after, mass, all, inertia, lacking);
      }
    distribute(after.mesh, after.velocity.data());
  }


  double
  body_energy(Solid                          &solid,
              const std::vector<NodeInertia> &inertia,
              const double                    time_step,
              MPI_Comm                        communicator)
  {
    // [J] at the full step n, from velocities at n - 1/2; bulk viscosity left out, which stores nothing
    distribute(solid.mesh, solid.velocity.data());
    AlignedVector<double> force(4 * solid.mesh.n_nodes(), 0.);
    ElementEnergy         energy;
    subtract_internal_force(
      solid.blocks, solid.displacement.data(), force.data(), BulkViscosity{}, true, energy);
    condense(solid.mesh, force.data());
    std::array<double, 1> sum{energy.strain + energy.stabilisation + energy.plastic_work};
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      if (inertia[n].inverse_mass > 0)
        {
          const double *const v = &solid.velocity[4 * n], *const f = &force[4 * n];
          // v(n-1/2) m v(n+1/2)/2 = m v^2/2 + dt f . v/2 with v = v(n-1/2), f the elements' forces and the
          // weight
          sum[0] += 0.5 * time_step * (f[0] * v[0] + f[1] * v[1] + f[2] * v[2] - inertia[n].weight * v[1]);
          // potential of the weight, m g u_y
          sum[0] += inertia[n].weight * solid.displacement[4 * n + 1];
          if (solid.mesh.owns(n))
            sum[0] += 0.5 / inertia[n].inverse_mass * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        }
    ordered_sum(sum, communicator);
    return sum[0];
  }
} // namespace wheelrail
