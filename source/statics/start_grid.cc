#include <wheelrail/planes/common_creepage.h>
#include <wheelrail/statics/start_grid.h>

#include <algorithm>
#include <cmath>

// Elements of the start: an odd number to each node, at most 0.42 mm or a 60th of the patch; patches whose
// inclinations differ by 0.1 rad have planes of their own. p^2 is interpolated, since Hertz's p^2 is a
// paraboloid and straight near the edge.

namespace wheelrail
{
  namespace
  {
    /// Columns of loaded nodes that follow one another.
    struct Columns
    {
      int    first = 0, last = 0;
      double load        = 0; ///< [N]
      double inclination = 0; ///< mean over the load [rad]
    };

    /// Sum of the normal forces of a column's nodes [N].
    double
    column_load(const Contact &contact, const unsigned int j)
    {
      // normal force as p A, positive in compression
      double sum = 0;
      for (unsigned int i = 0; i < contact.lattice().n_along; ++i)
        {
          const std::size_t k = contact.lattice().index(i, j);
          sum += contact.nodes()[k].pressure * contact.rail().area[k];
        }
      return sum;
    }

    /// Adds columns with their load to those before them.
    void
    join(Columns &columns, const Columns &next)
    {
      const double load = columns.load + next.load;
      columns.last      = next.last;
      // mean over the load
      columns.inclination = (columns.load * columns.inclination + next.load * next.inclination) / load;
      columns.load        = load;
    }

    std::vector<Columns>
    columns_in_planes(const Contact &contact)
    {
      // 1. Loaded columns that follow one another are a patch; 2. patches whose mean inclinations differ by
      // less than 0.1 rad share a plane, since a half-space has one normal. The inclination is the mean over
      // the force.
      const Lattice       &lattice = contact.lattice();
      std::vector<Columns> patches, planes;
      for (unsigned int j = 0; j < lattice.n_lateral; ++j)
        if (const double load = column_load(contact, j); load > 0)
          {
            const int     at = static_cast<int>(j);
            const Columns one{
              at, at, load, inclination(contact.surfaces(), lattice.s_begin + at * lattice.spacing_lateral)};
            if (!patches.empty() && patches.back().last == at - 1)
              join(patches.back(), one);
            else
              patches.push_back(one);
          }
      for (const Columns &patch : patches)
        if (!planes.empty() && std::abs(patch.inclination - planes.back().inclination) < same_plane)
          join(planes.back(), patch);
        else
          planes.push_back(patch);
      return planes;
    }

    StartGrid
    grid_over(const Contact &contact, const Columns &columns)
    {
      const Lattice &lattice = contact.lattice();
      // 1. Extent of the loaded nodes along the track
      int i0 = lattice.n_along, i1 = -1;
      for (unsigned int i = 0; i < lattice.n_along; ++i)
        for (int j = columns.first; j <= columns.last; ++j)
          if (contact.nodes()[lattice.index(i, j)].pressure > 0)
            i0 = std::min<int>(i0, i), i1 = std::max<int>(i1, i);
      const double spacing_across =
        // rows have equal distances across the frame; on a plane inclined against it they lie farther apart
        lattice.spacing_lateral / std::cos(columns.inclination - contact.surfaces().frame.angle);
      // 2. One line of open nodes around them, inside the lattice: the patch may end anywhere up to these
      StartGrid loaded;
      loaded.first_i       = std::max(0, i0 - 1);
      loaded.first_j       = std::max(0, columns.first - 1);
      loaded.n_i           = std::min<int>(lattice.n_along - 1, i1 + 1) - loaded.first_i + 1;
      loaded.n_j           = std::min<int>(lattice.n_lateral - 1, columns.last + 1) - loaded.first_j + 1;
      const double extent  = std::min(loaded.n_i * lattice.spacing_along, loaded.n_j * spacing_across);
      const double largest = std::max(0.42e-3, extent / 60);
      // 3. An odd number of elements a node, so that one of them has its middle at the node
      while (std::max(lattice.spacing_along, spacing_across) > largest * loaded.parts)
        loaded.parts += 2;
      // 4. Origin: the middle of the first element, half a node's elements before the node
      loaded.grid.mx      = loaded.n_i * loaded.parts;
      loaded.grid.my      = loaded.n_j * loaded.parts;
      loaded.grid.dx      = lattice.spacing_along / loaded.parts;
      loaded.grid.dy      = spacing_across / loaded.parts;
      const double before = 0.5 * (loaded.parts - 1); // elements before the node's own place
      loaded.grid.x0 =
        (lattice.first_station + loaded.first_i) * lattice.spacing_along - before * loaded.grid.dx;
      loaded.s_step  = lattice.spacing_lateral / loaded.parts;
      loaded.s_first = lattice.s_begin + loaded.first_j * lattice.spacing_lateral - before * loaded.s_step;
      loaded.grid.y0 = loaded.s_first;
      return loaded;
    }

    /// Squares of the nodes' pressures of the grid. Where a line of loaded nodes along the track or across it
    /// ends, the next node gets what a straight line through the last two has there: below zero, so that the
    /// patch ends between both, where its pressure does.
    class SquaredPressures
    {
    public:
      SquaredPressures(const Contact &contact, const StartGrid &loaded)
        : n_i_(loaded.n_i)
        , n_j_(loaded.n_j)
        , square_(std::size_t(n_i_) * n_j_, 0.)
      {
        for (int i = 0; i < n_i_; ++i)
          for (int j = 0; j < n_j_; ++j)
            square_[i + std::size_t(n_i_) * j] =
              // Hertz: p^2 = p0^2 (1 - x^2/a^2 - y^2/b^2)
              std::pow(contact.nodes()[loaded.node(contact.lattice(), i, j)].pressure, 2);
        const std::vector<double> inside = square_;
        const auto                at     = [&](const int i, const int j) {
          return i >= 0 && j >= 0 && i < n_i_ && j < n_j_ ? inside[i + std::size_t(n_i_) * j] : 0;
        };
        for (int i = 0; i < n_i_; ++i)
          for (int j = 0; j < n_j_; ++j)
            if (at(i, j) == 0)
              {
                // an open node beside several loaded ones takes the mean of what their lines say
                double sum = 0;
                int    n   = 0;
                for (int a = -1; a <= 1; ++a)
                  for (int b = -1; b <= 1; ++b)
                    if ((a != 0 || b != 0) && at(i + a, j + b) > 0)
                      {
                        // straight line through the last two nodes, at the next one; never above 0, where no
                        // node presses
                        sum += std::min(0., 2 * at(i + a, j + b) - at(i + 2 * a, j + 2 * b));
                        ++n;
                      }
                if (n > 0)
                  square_[i + std::size_t(n_i_) * j] = sum / n;
              }
      }

      double
      operator()(const int i, const int j) const
      {
        return i >= 0 && j >= 0 && i < n_i_ && j < n_j_ ? square_[i + std::size_t(n_i_) * j] : 0;
      }

    private:
      int                 n_i_, n_j_;
      std::vector<double> square_;
    };
  } // namespace


  double
  inclination(const RunningSurfaces &surfaces, const double s)
  {
    // angle of the wheel's section against X
    return surfaces.frame.angle + std::atan(surfaces.outline.at(s).slope);
  }


  std::vector<StartGrid>
  start_grids(const Contact &contact)
  {
    std::vector<StartGrid> grids;
    for (const Columns &columns : columns_in_planes(contact))
      grids.push_back(grid_over(contact, columns));
    return grids;
  }


  std::vector<double>
  element_pressures(const Contact &contact, const StartGrid &loaded)
  {
    const SquaredPressures square(contact, loaded);
    std::vector<double>    pressure(loaded.grid.size(), 0.);
    for (int i = 0; i < loaded.n_i; ++i)
      for (int j = 0; j < loaded.n_j; ++j)
        {
          double sum = 0;
          for (int a = 0; a < loaded.parts; ++a)
            for (int b = 0; b < loaded.parts; ++b)
              {
                const int da = 2 * a - loaded.parts + 1, db = 2 * b - loaded.parts + 1;
                // distance of the element from its node, in spacings: p^2 bilinear between four nodes
                const double u = 0.5 * std::abs(da) / loaded.parts, v = 0.5 * std::abs(db) / loaded.parts;
                const int    k = i + (da < 0 ? -1 : 1), l = j + (db < 0 ? -1 : 1);
                const double q = (1 - u) * ((1 - v) * square(i, j) + v * square(i, l)) +
                                 u * ((1 - v) * square(k, j) + v * square(k, l));
                sum += pressure[loaded.element(i, j, a, b)] = std::sqrt(std::max(0., q));
              }
          const double scale =
            // node's pressure over the mean of its elements: the load stays what the nodes carry
            sum > 0 ? std::sqrt(std::max(0., square(i, j))) * loaded.parts * loaded.parts / sum : 0;
          for (int a = 0; a < loaded.parts; ++a)
            for (int b = 0; b < loaded.parts; ++b)
              pressure[loaded.element(i, j, a, b)] *= scale;
        }
    return pressure;
  }


  std::vector<double>
  in_midst_of_step(const HalfspaceGrid &grid, const std::vector<double> &pressure)
  {
    // x grows ahead. Index e of the solution stands for the place half an element behind e
    // (doc/theory/accuracy.md, Edges of the patch); at_elements() takes its tractions back.
    std::vector<double> mean(grid.size(), 0.);
    for (int e = 0; e < grid.size(); ++e)
      {
        // half of each pressure acts on the element, half on the one ahead: (p_e + p_e-1)/2, the load stays
        mean[e] += 0.5 * pressure[e];
        mean[e % grid.mx + 1 < grid.mx && pressure[e + 1] > 0 ? e + 1 : e] += 0.5 * pressure[e];
      }
    return mean;
  }


  VectorField
  at_elements(const HalfspaceGrid &grid, const std::vector<double> &pressure, const HalfspaceSolution &behind)
  {
    VectorField traction{behind.traction_x, behind.traction_y};
    for (int e = 0; e < grid.size(); ++e)
      {
        if (behind.state[e] == HalfspaceSolution::exterior)
          continue;
        const int  ahead = e % grid.mx + 1 < grid.mx ? e + 1 : e;
        const bool first = ahead == e || behind.state[ahead] == HalfspaceSolution::exterior;
        // the solution has tractions at the end of a step, half an element behind its middle: mean of e and e
        // + 1; the leading element begins at 0
        double x = 0.5 * (behind.traction_x[e] + (first ? 0 : behind.traction_x[ahead])),
               y = 0.5 * (behind.traction_y[e] + (first ? 0 : behind.traction_y[ahead]));
        if (behind.state[e] == HalfspaceSolution::slip &&
            (first || behind.state[ahead] == HalfspaceSolution::slip))
          {
            const double size = std::hypot(x, y);
            // where both slip, |t| = mu p of the element itself
            const double scale = size > 0 ? behind.friction[e] * pressure[e] / size : 0;
            x *= scale;
            y *= scale;
          }
        traction[0][e] = x;
        traction[1][e] = y;
      }
    return traction;
  }
} // namespace wheelrail
