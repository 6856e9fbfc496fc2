#pragma once

#include <wheelrail/base/vector3.h>
#include <wheelrail/solid/exchange.h>
#include <wheelrail/solid/kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <mpi.h>

namespace wheelrail
{
  /// What limits the step of the central difference scheme.
  struct StableStep
  {
    double  step = 0; ///< 2 / omega_max of the stiffest element, bulk viscosity included [s]
    Body    body = Body::rail;
    Vector3 place{};                  ///< centre of the governing element [m]
    double  length           = 0;     ///< cube root of its volume [m]
    bool    lowered_by_edges = false; ///< the whole mesh swings faster than its stiffest element: free edges
    double  of_parts         = 0;     ///< share of the step that springs and dampers of parts have taken
    bool    scaled           = false; ///< stiffer elements have a larger density (SolidChoice)
  };

  /// Of a highest squared frequency [1/s2], where the bulk viscosity has the damping ratio `viscosity` at
  /// that frequency and is taken at the half step behind [s].
  double
  stable_step(double squared_frequency, double viscosity);

  /// Quality of the hexahedra over all ranks.
  struct MeshQuality
  {
    std::size_t     elements = 0, nodes = 0, hanging = 0;
    std::size_t     rail_elements = 0, wheel_elements = 0, finest_elements = 0;
    double          worst_jacobian = 1;        ///< smallest corner Jacobian over the mean one, 1 for bricks
    double          smallest = 0, largest = 0; ///< cube roots of volumes [m]
    PerBody<double> scaled_share{};            ///< what mass scaling adds to the masses of the bodies
  };

  /// Mass properties of one body over all ranks, from the lumped masses.
  struct MassProperties
  {
    double  mass = 0;    ///< [kg]
    Vector3 centre{};    ///< centre of gravity [m]
    double  inertia = 0; ///< about the axis through `about` along X [kg m2]
  };

  /// What the bodies are made of, whatever their mesh.
  struct SolidChoice
  {
    PerBody<MaterialLaw> material;
    PerBody<ElementForm> form{};
    double               bulk_viscosity = 0; ///< coefficient of the linear bulk viscosity

    /// Mass scaling: elements whose squared frequency (element_frequency_bound()) lies above this have so
    /// much larger a density that it does not; infinitely large: none [1/s2].
    double highest_frequency = HUGE_VAL;

    /// The factor of their density.
    double
    density_factor(const double squared_frequency) const
    {
      return std::max(1., squared_frequency / highest_frequency);
    }
  };

  /// The deformable bodies of one rank: packed elements, lumped mass, and the nodal state.
  ///
  /// What a step leaves to the next, and a checkpoint must hold: displacement, velocity, and of each
  /// of the blocks viscous, history, plastic_work and flowed (the last three are empty in elastic
  /// bodies).
  struct Solid
  {
    LocalMesh                         mesh;
    PerBody<ElementBlocks>            blocks;
    PerBody<std::vector<std::size_t>> block_cells; ///< cell number of each packed element

    AlignedVector<double> mass;       ///< n_nodes, lumped, summed over ranks; zero at hanging nodes [kg]
    AlignedVector<double> added_mass; ///< n_nodes, bipenalty mass of the contact surfaces [kg]
    /// Share of each vertex in the mass of a cell, added mass included, before hanging nodes pass theirs on
    /// to their parents [kg].
    std::vector<std::array<double, 8>> cell_mass;

    AlignedVector<double> displacement; ///< 4 x n_nodes [m]
    AlignedVector<double> velocity;     ///< 4 x n_nodes, at the half step behind [m/s]
    AlignedVector<double> force;        ///< 4 x n_nodes [N]

    SolidChoice   choice;
    unsigned char finest_level = 0; ///< over all ranks
    StableStep    stable;
    MeshQuality   quality;

    /// Current position of a node [m].
    Vector3
    position(const unsigned int node) const
    {
      return mesh.place(node) + vector_at(displacement, node);
    }
  };

  /// Takes a mesh and fills all that follows from it, at rest: packs the elements, lumps the mass (row sums
  /// of the condensed consistent mass), and finds the stable step. solid.choice stays. Collective.
  void
  prepare(Solid &solid, LocalMesh mesh, MPI_Comm communicator);

  /// Gives the running surfaces of both bodies, in the strip where contact can happen, an added mass of
  /// `density` [kg/m2] all along: a quarter of a face's share to each of its nodes, be they fine or coarse,
  /// so that it is carried from mesh to mesh as the mass of the material is. Collective.
  void
  add_band_mass(Solid &solid, double density);

  /// Collective.
  MassProperties
  mass_properties(const Solid &solid, Body body, const Vector3 &about, MPI_Comm communicator);

  /// Nodal gradients of a field (displacements, velocities; 4 numbers a node, with hanging nodes), the
  /// volume-weighted means of the adjacent elements: 9 numbers a node, row-major. Collective.
  std::vector<double>
  nodal_gradient(const Solid &solid, const double *field);

  /// Nodal accumulated plastic strains by the same means: one number a node [1]. Collective.
  std::vector<double>
  nodal_plastic_strain(const Solid &solid);
} // namespace wheelrail
