#include <wheelrail/statics/tread_stretch.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// How far the wheel's steel at the closest point of a rail node stands ahead of where a surface that is
    /// rolled out flat would have it [m].
    double
    facing_ahead(const Contact &contact, const FacetPoint &foot)
    {
      const Lattice &lattice = contact.wheel().lattice;
      const double   r       = contact.surfaces().rolling_radius;
      double         sum     = 0;
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b)
          {
            const std::size_t k = lattice.index(foot.i + a, foot.j + b);
            const double      z = contact.wheel().reference[k][2];
            sum += (a == 1 ? foot.xi : 1 - foot.xi) * (b == 1 ? foot.eta : 1 - foot.eta) *
                   (z + contact.displacement(Body::wheel, k)[2] - r * std::asin(z / r));
          }
      return sum;
    }
  } // namespace


  std::vector<Vector3>
  rail_displacements(const Contact &contact)
  {
    std::vector<Vector3> displacement(contact.nodes().size(), Vector3{});
    const StationRange  &stations = contact.window().rail;
    for (int i = stations.first; i < stations.last; ++i)
      for (unsigned int j = 0; j < contact.lattice().n_lateral; ++j)
        {
          const std::size_t k = contact.lattice().index(i, j);
          displacement[k]     = contact.displacement(Body::rail, k);
        }
    return displacement;
  }


  double
  tread_stretch(const Contact &contact, const std::vector<Vector3> &rail_before)
  {
    const Lattice      &lattice  = contact.lattice();
    const StationRange &stations = contact.window().rail;
    double              products = 0, squares = 0;
    for (unsigned int j = 0; j < lattice.n_lateral; ++j)
      {
        std::vector<std::pair<double, double>> line; // place, wheel less rail
        double                                 place = 0, apart = 0;
        for (int i = stations.first; i < stations.last; ++i)
          {
            const std::size_t  k    = lattice.index(i, j);
            const ContactNode &node = contact.nodes()[k];
            if (node.pressure <= 0)
              continue;
            const Vector3 rail = contact.displacement(Body::rail, k) - rail_before[k];
            line.emplace_back(i * lattice.spacing_along, facing_ahead(contact, node.foot) - rail[2]);
            place += line.back().first;
            apart += line.back().second;
          }
        for (const auto &[z, u] : line)
          {
            const double from_middle = z - place / line.size();
            products += from_middle * (u - apart / line.size());
            squares += from_middle * from_middle;
          }
      }
    return squares > 0 ? products / squares : 0;
  }
} // namespace wheelrail
