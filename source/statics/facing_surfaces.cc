#include <wheelrail/statics/facing_surfaces.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// What half-spaces lack of a start, read from the finite elements: stretch of the tread against the head, and
// the shift of the steel that faces a row (doc/theory/rolling.md, What half-spaces lack).

namespace wheelrail
{
  namespace
  {
    /// Mean over the corners of the wheel's facet at a closest point, of their numbers in the wheel's
    /// lattice.
    template <typename Value>
    auto
    at_foot(const Contact &contact, const FacetPoint &foot, const Value &value)
    {
      const Lattice &lattice = contact.wheel().lattice;
      const auto     line    = [&](const int b) {
        return (1 - foot.xi) * value(lattice.index(foot.i, foot.j + b)) +
               foot.xi * value(lattice.index(foot.i + 1, foot.j + b));
      };
      // bilinear in the facet
      return (1 - foot.eta) * line(0) + foot.eta * line(1);
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
    // e = (slope of what the wheel's steel lies ahead) - (slope of u_z of the rail) over z, z the place along
    // the track [m]; both dimensionless, positive where the tread is stretched more than the head. e adds to
    // the rigid slip w_x (doc/theory/rolling.md, Shear tractions). With u_z alone for the wheel the
    // flattening of its surface would count as stretch: the arc is z + z^3/(6 r^2).
    const Lattice      &lattice  = contact.lattice();
    const StationRange &stations = contact.window().rail;
    const double        r        = contact.surfaces().rolling_radius;
    double              products = 0, squares = 0;
    for (unsigned int j = 0; j < lattice.n_lateral; ++j)
      {
        std::vector<std::pair<double, double>> line; // place, wheel less rail
        double                                 place = 0, apart = 0;
        for (int i = stations.first; i < stations.last; ++i)
          {
            const std::size_t  k    = lattice.index(i, j);
            const ContactNode &node = contact.nodes()[k];
            // outside the patch surfaces are not pressed together, and their stretch does not enter rolling
            if (node.pressure <= 0)
              continue;
            // how far the wheel's steel stands ahead of where a surface that is rolled out flat would have it
            const double ahead = at_foot(contact, node.foot, [&](const std::size_t corner) {
              const double z = contact.wheel().reference[corner][2];
              // how far the wheel's steel has moved along its own arc: z + u_z less r asin(z/r)
              // (doc/theory/rolling.md, What half-spaces lack)
              return z + contact.displacement(Body::wheel, corner)[2] - r * std::asin(z / r);
            });
            const double rail  = contact.displacement(Body::rail, k)[2] - rail_before[k][2];
            line.emplace_back(i * lattice.spacing_along, ahead - rail);
            place += line.back().first;
            apart += line.back().second;
          }
        for (const auto &[z, u] : line)
          {
            const double from_middle = z - place / line.size();
            // slope of least squares over the loaded nodes of each line, summed over the lines
            products += from_middle * (u - apart / line.size());
            squares += from_middle * from_middle;
          }
      }
    // one slope for all lines, each about its own middle: a line of n nodes counts with n^3
    return squares > 0 ? products / squares : 0;
  }


  double
  facing_after_shift(const Contact &contact, const StartGrid &loaded)
  {
    // -v of equation (6) of doc/theory/bodies.md, mean over the pressure [m], v = e_s . (u_wheel - u_rail),
    // e_s = (cos, sin) of the row's inclination. Positive: the steel that faces a row lies farther towards
    // the track centre on its profile.
    double aside = 0, load = 0;
    for (int j = 0; j < loaded.n_j; ++j)
      {
        const double angle = inclination(contact.surfaces(), loaded.s(loaded.parts * j));
        for (int i = 0; i < loaded.n_i; ++i)
          {
            const std::size_t k = loaded.node(contact.lattice(), i, j);
            const double      p = contact.nodes()[k].pressure;
            if (p <= 0)
              continue;
            const Vector3 wheel = at_foot(contact, contact.nodes()[k].foot, [&](const std::size_t corner) {
              return contact.displacement(Body::wheel, corner);
            });
            const Vector3 apart = wheel - contact.displacement(Body::rail, k);
            // wheel less rail along e_s = (cos, sin), mean over the pressure, with minus sign: the steel at s
            // lay at s - v
            aside -= p * (std::cos(angle) * apart[0] + std::sin(angle) * apart[1]);
            load += p;
          }
      }
    return load > 0 ? aside / load : 0;
  }
} // namespace wheelrail
