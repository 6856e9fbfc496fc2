#include <wheelrail/sampling/body_figures.h>
#include <wheelrail/solid/point_state.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelrail
{
  namespace
  {
    /// Sets the figures of the band of a rail that may yield; they stay as they are where nothing has flowed.
    void
    measure_band(const Solid           &solid,
                 const RunningSurfaces &surfaces,
                 PlasticFigures        &figures,
                 MPI_Comm               communicator)
    {
      const auto strain = nodal_plastic_strain(solid);
      double     range[3]; // largest -s, s, depth
      std::fill_n(range, 3, -std::numeric_limits<double>::infinity());
      for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
        {
          if (solid.mesh.node_body[n] != Body::rail || !(strain[n] > band_strain))
            continue;
          const auto place = surfaces.rail.place(solid.mesh.place(n));
          range[0]         = std::max(range[0], -place.s);
          range[1]         = std::max(range[1], place.s);
          range[2]         = std::max(range[2], surfaces.rail.at(place.s, place.along).n - place.n);
        }
      MPI_Allreduce(MPI_IN_PLACE, range, 3, MPI_DOUBLE, MPI_MAX, communicator);
      if (std::isinf(range[2]))
        return;
      figures.band_width  = range[1] + range[0];
      figures.band_depth  = range[2];
      figures.band_centre = 0.5 * (range[1] - range[0]);
    }
  } // namespace


  PlasticFigures
  plastic_figures(const Solid &solid, const RunningSurfaces &surfaces, MPI_Comm communicator)
  {
    PerBody<double> work;
    for (const Body body : both_bodies)
      {
        if (solid.blocks[body].plastic())
          for (const double w : solid.blocks[body].plastic_work)
            work[body] += w;
        MPI_Allreduce(MPI_IN_PLACE, &work[body], 1, MPI_DOUBLE, MPI_SUM, communicator);
      }
    PlasticFigures figures{
      largest_plastic_strain(solid, communicator), work, std::nan(""), std::nan(""), std::nan("")};
    if (solid.blocks[Body::rail].plastic())
      measure_band(solid, surfaces, figures, communicator);
    return figures;
  }


  double
  largest_plastic_strain(const Solid &solid, MPI_Comm communicator)
  {
    double largest = -1;
    for (const Body body : both_bodies)
      if (solid.blocks[body].plastic())
        for (const double strain : element_plastic_strain(solid.blocks[body]))
          largest = std::max(largest, strain);
    MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, communicator);
    return largest < 0 ? std::nan("") : largest;
  }


  double
  largest_von_mises(const Solid &solid, MPI_Comm communicator)
  {
    double largest = 0;
    for (const Body body : both_bodies)
      for (const auto &s : element_stress(solid.blocks[body], solid.displacement.data()))
        largest = std::max(largest, von_mises(s.data()));
    MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, communicator);
    return largest;
  }


  double
  largest_von_mises(const NodalStress &nodal, MPI_Comm communicator)
  {
    double largest = 0;
    for (std::size_t k = 0; k < nodal.stress.size(); k += 6)
      largest = std::max(largest, von_mises(&nodal.stress[k]));
    MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, communicator);
    return largest;
  }
} // namespace wheelrail
