#include <deal.II/base/mpi.h>

#include <wheelrail/solid/solid.h>

#include <algorithm>
#include <cmath>

// Elements, lumped mass rho integral N_a dV and stable step of both bodies on this rank
// (doc/theory/element.md).

namespace wheelrail
{
  namespace
  {
    /// The rank's elements before packing.
    struct Elements
    {
      PerBody<std::vector<ElementGeometry>>             geometry;
      PerBody<std::vector<std::array<unsigned int, 8>>> cells;
    };

    /// Smallest corner Jacobian over the mean Jacobian of a cell.
    double
    corner_quality(const std::array<Vector3, 8> &X, const double volume)
    {
      // lexicographic corners: a ^ (1 << k) is the neighbour along xi_k
      double worst = 1e300;
      for (int a = 0; a < 8; ++a)
        {
          Vector3 edge[3];
          for (int k = 0; k < 3; ++k)
            {
              const int other = a ^ (1 << k);
              // edges of corner a along the natural coordinates
              edge[k] = (other > a ? 1. : -1.) * (X[other] - X[a]);
            }
          // det of the three edges of a corner over the volume: 1 of a brick, 0 or less where the cell is
          // folded
          worst = std::min(worst, dot(edge[0], cross(edge[1], edge[2])) / volume);
        }
      return worst;
    }

    Elements
    build_elements(Solid &solid, MPI_Comm communicator)
    {
      Elements     elements;
      MeshQuality &q = solid.quality;
      q.smallest     = 1e300;
      for (const auto level : solid.mesh.cell_level)
        solid.finest_level = std::max(solid.finest_level, level);
      MPI_Allreduce(MPI_IN_PLACE, &solid.finest_level, 1, MPI_UNSIGNED_CHAR, MPI_MAX, communicator);
      // each cell is an element of its body on one rank; sizes are cube roots of volumes [m]
      for (std::size_t c = 0; c < solid.mesh.cells.size(); ++c)
        {
          const Body body = solid.mesh.cell_body[c];
          const auto X    = solid.mesh.places(solid.mesh.cells[c]);
          const auto g    = element_geometry(X);
          elements.geometry[body].push_back(g);
          elements.cells[body].push_back(solid.mesh.cells[c]);
          solid.block_cells[body].push_back(c);
          // extremes over the rank's cells, for the screen and the report
          q.worst_jacobian = std::min(q.worst_jacobian, corner_quality(X, g.volume));
          q.smallest       = std::min(q.smallest, std::cbrt(g.volume));
          q.largest        = std::max(q.largest, std::cbrt(g.volume));
          q.finest_elements += solid.mesh.cell_level[c] == solid.finest_level;
        }
      q.rail_elements  = elements.cells.rail.size();
      q.wheel_elements = elements.cells.wheel.size();
      q.elements       = q.rail_elements + q.wheel_elements;
      q.hanging        = solid.mesh.hanging.size();
      q.nodes          = solid.mesh.n_owned;
      return elements;
    }

    void
    reduce_quality(MeshQuality &q, MPI_Comm communicator)
    {
      unsigned long counts[6] = {
        q.elements, q.nodes, q.hanging, q.rail_elements, q.wheel_elements, q.finest_elements};
      MPI_Allreduce(MPI_IN_PLACE, counts, 6, MPI_UNSIGNED_LONG, MPI_SUM, communicator);
      q.elements = counts[0], q.nodes = counts[1], q.hanging = counts[2];
      q.rail_elements = counts[3], q.wheel_elements = counts[4], q.finest_elements = counts[5];
      // of all ranks: sums for counts, extremes for quality
      double low[2] = {q.worst_jacobian, q.smallest};
      MPI_Allreduce(MPI_IN_PLACE, low, 2, MPI_DOUBLE, MPI_MIN, communicator);
      q.worst_jacobian = low[0], q.smallest = low[1];
      MPI_Allreduce(MPI_IN_PLACE, &q.largest, 1, MPI_DOUBLE, MPI_MAX, communicator);
    }

    void
    lump_mass(Solid &solid, const Elements &elements, MPI_Comm communicator)
    {
      PerBody<double> added{}, whole{}; // [kg]
      // row sums keep momentum and the moment of mass; consistent masses would need a solution in each step
      AlignedVector<double> mass(4 * solid.mesh.n_nodes(), 0.);
      solid.cell_mass.resize(solid.mesh.cells.size());
      for (const Body body : both_bodies)
        for (std::size_t e = 0; e < elements.cells[body].size(); ++e)
          {
            const ElementGeometry &g     = elements.geometry[body][e];
            const Elasticity      &steel = solid.blocks[body].elasticity();
            // Mass scaling: omega^2 of the element over the wanted one, where it is larger; 1 without
            // (doc/theory/element.md, Stable step)
            const double factor  = solid.choice.density_factor(element_frequency_bound(g, steel)),
                         density = factor * steel.density;
            added[body] += (factor - 1) * steel.density * g.volume;
            whole[body] += density * g.volume;
            for (int a = 0; a < 8; ++a)
              {
                // rho integral N_a dV; hanging nodes hand it to their parents with the weights of the
                // constraint
                const double share                             = density * g.node_volume[a];
                solid.cell_mass[solid.block_cells[body][e]][a] = share;
                mass[4 * elements.cells[body][e][a]] += share;
              }
          }
      condense(solid.mesh, mass.data());
      sum_over_ranks(solid.mesh, mass.data());
      solid.mass.resize(solid.mesh.n_nodes());
      for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
        // row sums of the condensed consistent mass: diagonal, and the total mass exactly
        solid.mass[n] = mass[4 * n];
      for (const unsigned int n : solid.mesh.hanging)
        solid.mass[n] = 0;
      // no scaling was asked for
      if (std::isinf(solid.choice.highest_frequency))
        return;
      for (const Body body : both_bodies)
        {
          double masses[] = {added[body], whole[body]};
          MPI_Allreduce(MPI_IN_PLACE, masses, 2, MPI_DOUBLE, MPI_SUM, communicator);
          // mass that scaling has added over the true one
          solid.quality.scaled_share[body] = masses[0] / (masses[1] - masses[0]);
        }
    }

    /// The stiffest element over all ranks. The linear bulk viscosity is a damping ratio of
    /// `coefficient` at the highest frequency; taken at the half step behind it shortens the step.
    StableStep
    find_stable_step(const Solid    &solid,
                     const Elements &elements,
                     const double    coefficient,
                     MPI_Comm        communicator)
    {
      double     largest = 0;
      StableStep stable;
      for (const Body body : both_bodies)
        for (std::size_t e = 0; e < elements.cells[body].size(); ++e)
          {
            // omega^2 goes with 1/density
            const double alone = element_frequency_bound(elements.geometry[body][e],
                                                         solid.blocks[body].elasticity()),
                         bound = alone / solid.choice.density_factor(alone);
            if (bound > largest)
              {
                largest       = bound;
                stable.scaled = bound < alone;
                stable.body   = body;
                stable.length = std::cbrt(elements.geometry[body][e].volume);
                stable.place  = {0, 0, 0};
                for (const auto &x : solid.mesh.places(elements.cells[body][e]))
                  add(stable.place, 1. / 8, x);
              }
          }
      // all ranks take the smallest step, and the place of that element for the screen
      stable.step    = stable_step(largest, coefficient);
      const auto all = dealii::Utilities::MPI::all_gather(communicator, stable);
      return *std::min_element(
        all.begin(), all.end(), [](const StableStep &a, const StableStep &b) { return a.step < b.step; });
    }
  } // namespace


  double
  stable_step(const double squared_frequency, const double viscosity)
  {
    // dt = 2/omega (sqrt(1 + b^2) - b) (doc/theory/element.md, Stable step)
    return 2 / std::sqrt(squared_frequency) * (std::sqrt(1 + viscosity * viscosity) - viscosity);
  }


  void
  prepare(Solid &solid, LocalMesh mesh, MPI_Comm communicator)
  {
    const SolidChoice choice = solid.choice;
    solid                    = Solid();
    solid.choice             = choice;
    solid.mesh               = std::move(mesh);
    // 1. Geometry of each cell; 2. packed for the kernel; 3. state at rest; 4. masses; 5. the stable step
    const Elements elements = build_elements(solid, communicator);
    for (const Body body : both_bodies)
      solid.blocks[body] = pack_elements(elements.geometry[body],
                                         elements.cells[body],
                                         choice.material[body],
                                         kernel_width,
                                         choice.form[body]);
    const std::size_t n_nodes = solid.mesh.n_nodes();
    solid.added_mass.assign(n_nodes, 0.);
    solid.displacement.assign(4 * n_nodes, 0.);
    solid.velocity.assign(4 * n_nodes, 0.);
    solid.force.assign(4 * n_nodes, 0.);
    lump_mass(solid, elements, communicator);
    solid.stable = find_stable_step(solid, elements, choice.bulk_viscosity, communicator);
    reduce_quality(solid.quality, communicator);
  }


  void
  add_band_mass(Solid &solid, const double density)
  {
    AlignedVector<double> mass(4 * solid.mesh.n_nodes(), 0.);
    // Added mass of the contact [kg/m2] on the whole strip of fine cells, constant in time
    // (doc/theory/contact.md, Added mass)
    for (const BoundaryFace &face : solid.mesh.faces)
      if (face.mark == Boundary::running && face.strip)
        {
          const std::array<Vector3, 4> X = solid.mesh.places(face.nodes);
          // a quarter of the facet's area |d1 x d2|/2, d1, d2 its diagonals, times the mass per area [kg/m2]
          const double share = density * norm(cross(X[3] - X[0], X[2] - X[1])) / 8;
          for (const unsigned int node : face.nodes)
            {
              mass[4 * node] += share;
              // in the mass of the cells, too, with which momentum is kept over a change of the mesh
              const auto &cell = solid.mesh.cells[face.cell];
              for (int a = 0; a < 8; ++a)
                solid.cell_mass[face.cell][a] += cell[a] == node ? share : 0;
            }
        }
    condense(solid.mesh, mass.data());
    sum_over_ranks(solid.mesh, mass.data());
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      solid.added_mass[n] = mass[4 * n];
  }


  MassProperties
  mass_properties(const Solid &solid, const Body body, const Vector3 &about, MPI_Comm communicator)
  {
    double sum[5] = {0, 0, 0, 0, 0};
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.owns(n) && solid.mesh.node_body[n] == body)
        {
          const Vector3 X = solid.mesh.place(n);
          // m, m X and the moment of inertia as sums over lumped masses
          sum[0] += solid.mass[n];
          for (int i = 0; i < 3; ++i)
            sum[1 + i] += solid.mass[n] * X[i];
          // about an axis along X: m (dy^2 + dz^2)
          sum[4] += solid.mass[n] * (std::pow(X[1] - about[1], 2) + std::pow(X[2] - about[2], 2));
        }
    MPI_Allreduce(MPI_IN_PLACE, sum, 5, MPI_DOUBLE, MPI_SUM, communicator);
    return {sum[0], {sum[1] / sum[0], sum[2] / sum[0], sum[3] / sum[0]}, sum[4]};
  }
} // namespace wheelrail
