#include <wheelrail/sampling/residual.h>
#include <wheelrail/solid/point_state.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Largest von Mises stress of rail elements that have flowed and begin before z [m].
    double
    largest_before(const Solid &solid, const double z, MPI_Comm communicator)
    {
      const ElementBlocks &blocks  = solid.blocks.rail;
      const auto           strain  = element_plastic_strain(blocks);
      const auto           stress  = element_stress(blocks, solid.displacement.data());
      double               largest = -1;
      for (std::size_t e = 0; e < blocks.n_elements; ++e)
        if (strain[e] > 0 && solid.position(solid.mesh.cells[solid.block_cells.rail[e]][0])[2] < z)
          largest = std::max(largest, von_mises(stress[e].data()));
      MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, communicator);
      return largest < 0 ? std::nan("") : largest;
    }

    /// Change of the displacement along Z per distance along the outward normal of the contact frame, at
    /// nodes [1].
    std::vector<double>
    outward_change(const Model &model)
    {
      const auto          H = nodal_gradient(model.solid, model.solid.displacement.data());
      const Point2        n = model.contact->surfaces().frame.normal();
      std::vector<double> change(model.solid.mesh.n_nodes());
      for (std::size_t node = 0; node < change.size(); ++node)
        change[node] = H[9 * node + 6] * n.x + H[9 * node + 7] * n.y; // du_Z/dX, du_Z/dY
      return change;
    }

    /// Displacement along Z of the rail's nodes between two places that is the largest in size [m]; NaN
    /// without any.
    double
    forward_flow(const Solid &solid, const double from, const double to, MPI_Comm communicator)
    {
      double extent[2] = {-HUGE_VAL, -HUGE_VAL}; // -least, largest
      for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
        if (solid.mesh.node_body[n] == Body::rail && solid.mesh.reference[4 * n + 2] > from &&
            solid.mesh.reference[4 * n + 2] < to)
          {
            extent[0] = std::max(extent[0], -solid.displacement[4 * n + 2]);
            extent[1] = std::max(extent[1], solid.displacement[4 * n + 2]);
          }
      MPI_Allreduce(MPI_IN_PLACE, extent, 2, MPI_DOUBLE, MPI_MAX, communicator);
      if (std::isinf(extent[1]))
        return std::nan("");
      return extent[0] > extent[1] ? -extent[0] : extent[1];
    }
  } // namespace


  Residual
  residual_of(const Model &model, const Axle &axle, MPI_Comm communicator)
  {
    // the same place on the rail, whatever the start: the one that the wheel without an offset has just left
    const SweepPlan &plan   = model.discretization->plan();
    const double     offset = plan.start_block * plan.block_length(), behind = model.reach + offset;
    Residual         residual;
    model.contact->gather_nodes();
    residual.stress    = nodal_stress(model.solid);
    const auto forward = outward_change(model);
    residual.slices = slices_behind(model, residual.stress, axle.travelled(), behind, communicator, &forward);
    residual.largest = largest_before(model.solid, axle.travelled() - behind, communicator);
    residual.forward =
      forward_flow(model.solid, 0.5 * axle.travelled() - offset, axle.travelled() - behind, communicator);
    return residual;
  }
} // namespace wheelrail
