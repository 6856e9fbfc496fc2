#pragma once

// The stable time step of refined meshes, against that of cubes.

#include <wheelrail/model/model.h>
#include <wheelrail/model/scene_material.h>

#include <deal.II/base/mpi.h>

#include "near.h"
#include "scenes/make_solid.h"

#include <cmath>
#include <sstream>

namespace test
{
  using namespace wheelrail;

  // Checks the step against that of cubes of the cell size (bulk viscosity 0.06), which is the edge over
  // the speed of pressure waves, shortened by the damping.
  inline void
  check_step(const double shift, const double cell, const double least)
  {
    Scene scene;
    scene.lateral_shift    = shift;
    scene.cell_size        = cell;
    scene.fine_depth       = 5 * cell;
    scene.rolling_distance = 0.005;
    Discretization discretization(MPI_COMM_WORLD, sweep_plan(scene, make_geometry(scene)));
    discretization.lay({{discretization.plan().fine}, {discretization.plan().fine}});
    const Elasticity steel = elasticity(scene.rail_material);
    const double     zeta  = scene.bulk_viscosity;
    const Solid  solid = scenes::make_solid(discretization.local_mesh(), steel, steel, zeta, MPI_COMM_WORLD);
    const double speed = std::sqrt((steel.lame_lambda() + 2 * steel.shear_modulus()) / steel.density);
    const double cubes = cell / speed * (std::sqrt(1 + zeta * zeta) - zeta);

    std::ostringstream text;
    text << "cells of " << cell * 1e3 << " mm, shift " << shift * 1e3 << " mm: step "
         << solid.stable.step * 1e6 << " us, " << solid.stable.step / cubes << " of that of cubes, at X "
         << solid.stable.place[0] * 1e3 << ", Y " << solid.stable.place[1] * 1e3 << " mm; "
         << solid.quality.elements << " elements, worst Jacobian " << solid.quality.worst_jacobian;
    BOOST_TEST((solid.stable.step > least * cubes && solid.quality.worst_jacobian > 0.2), text.str());
  }
} // namespace test
