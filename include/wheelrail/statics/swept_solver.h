#pragma once

#include <wheelrail/material/elasticity.h>
#include <wheelrail/mesh/swept_grid.h>
#include <wheelrail/solid/element_form.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace wheelrail
{
  /// The stiffness of one body's coarse blocks, solved for exactly. Displacements and forces have three
  /// components in the directions of the track for each corner of each section: 3 x (n_corners x section +
  /// corner) + component.
  ///
  /// Coarse blocks are one section swept along. Of a rail, section after section, that is a band matrix as
  /// wide as two sections. A wheel is a ring of equal sectors: Fourier's series over the sectors, in the
  /// directions that turn with them, leaves one matrix as large as a section for each of half the sectors
  /// (block-circulant matrices, e.g. Davis 1979).
  class SweptSolver
  {
  public:
    virtual ~SweptSolver() = default;

    /// Forces [N] become displacements [m]; those of held nodes must be zero and stay so.
    virtual void
    solve(std::vector<double> &x) = 0;
  };

  /// `held`: 1 for nodes that do not move, n_corners x n_sections; on a wheel all around or nowhere.
  /// `ground`: springs along the axes of the nodes of a rail [N/m], or empty; those of a wheel are left out.
  /// Throws std::logic_error when a wheel is held at parts of a circle, std::runtime_error when the body can
  /// move rigidly.
  std::unique_ptr<SweptSolver>
  make_swept_solver(const SweptGrid                  &grid,
                    const Elasticity                 &material,
                    ElementForm                       form,
                    const std::vector<unsigned char> &held,
                    const std::vector<Vector3>       &ground = {});

  /// What the solver of a body stores [bytes].
  double
  swept_solver_memory(const SweptGrid &grid);
} // namespace wheelrail
