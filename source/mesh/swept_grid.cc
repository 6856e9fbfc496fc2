#include <deal.II/base/symmetric_tensor.h>

#include <wheelrail/mesh/swept_grid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace wheelrail
{
  namespace
  {
    constexpr Point2 unknown{std::numeric_limits<double>::quiet_NaN(), 0};

    /// Coordinate of the place (i, j) of a lattice of n parts along an edge, from the smaller corner on.
    int
    along_edge(const std::array<unsigned int, 4> &corner,
               const unsigned int                 edge,
               const int                          i,
               const int                          j,
               const int                          n)
    {
      const int t = edge < 2 ? j : i;
      return corner[Section::edge_corners[edge][0]] < corner[Section::edge_corners[edge][1]] ? t : n - t;
    }

    double
    smallest_stretch(const std::array<Vector3, 8> &X)
    {
      dealii::Tensor<2, 3> J; // mean edges in the rows
      for (unsigned int v = 0; v < 8; ++v)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int i = 0; i < 3; ++i)
            J[k][i] += (v >> k & 1 ? 0.25 : -0.25) * X[v][i];
      const auto inverse = dealii::symmetrize(dealii::invert(J) * dealii::transpose(dealii::invert(J)));
      return 1 / std::sqrt(dealii::eigenvalues(inverse)[0]);
    }
  } // namespace


  SweptGrid::SweptGrid(const SweepPlan &plan, const Body body)
    : plan_(&plan)
    , body_(body)
    , n_columns_(body == Body::rail ? static_cast<int>(plan.rail_stations.size()) - 1
                                    : static_cast<int>(plan.sectors))
    , parts_(1 << plan.levels)
    , moved_(plan.surfaces[body].moves_mesh())
    , at_corner_(section().corners.size())
    , measures_(plan.levels + 1)
  {
    std::map<Section::EdgeKey, std::uint32_t> number;
    for (int b = 0; b < n_blocks(); ++b)
      {
        const auto &corner = section().blocks[b].corner;
        auto       &edges  = edges_.emplace_back();
        auto       &marks  = marks_.emplace_back();
        for (unsigned int e = 0; e < 4; ++e)
          {
            const auto key            = Section::edge_key(corner, e);
            const auto [entry, fresh] = number.try_emplace(key, number.size());
            if (fresh)
              at_edge_.emplace_back();
            edges[e] = entry->second;
            at_edge_[edges[e]].push_back({b, e});
            at_corner_[corner[e]].push_back({b, e});
            const auto found = section().boundary.find(key);
            marks[e]         = found == section().boundary.end() ? Boundary::free : found->second;
          }
      }
    first_edge_point_  = section().corners.size();
    first_inner_point_ = first_edge_point_ + number.size() * (parts_ - 1);
    places_.assign(first_inner_point_, unknown);
    inner_places_.resize(n_blocks());
    for (auto &of_level : measures_)
      of_level.resize(n_blocks());
  }


  std::uint32_t
  SweptGrid::point(const int block, const int i, const int j) const
  {
    const auto &corner = section().blocks[block].corner;
    const bool  side_i = i == 0 || i == parts_, side_j = j == 0 || j == parts_;
    if (side_i && side_j)
      return corner[(i > 0) + 2 * (j > 0)];
    if (side_i || side_j)
      {
        const unsigned int edge = side_i ? i > 0 : 2 + (j > 0);
        return first_edge_point_ + edges_[block][edge] * (parts_ - 1) +
               along_edge(corner, edge, i, j, parts_) - 1;
      }
    return first_inner_point_ + (std::uint32_t(block) * (parts_ - 1) + j - 1) * (parts_ - 1) + i - 1;
  }


  std::uint64_t
  SweptGrid::vertex_key(const int block, const int i, const int j, const int station) const
  {
    const std::uint64_t place = closed() ? station % (n_columns_ * parts_) : station;
    return static_cast<std::uint64_t>(body_) << 62 | std::uint64_t(point(block, i, j)) << 24 | place;
  }


  Point2
  SweptGrid::place(const int block, const int i, const int j) const
  {
    const std::uint32_t n     = point(block, i, j);
    const std::size_t   inner = std::size_t(parts_ - 1) * (parts_ - 1);
    if (n >= first_inner_point_ && inner_places_[block].empty())
      inner_places_[block].assign(inner, unknown);
    Point2 &p =
      n < first_inner_point_ ? places_[n] : inner_places_[block][n - first_inner_point_ - block * inner];
    if (std::isnan(p.x))
      p = section().position(block, double(i) / parts_, double(j) / parts_);
    return p;
  }


  Vector3
  SweptGrid::at_station(const Point2 &p, const int station) const
  {
    if (body_ == Body::rail)
      {
        const int    k  = std::min(station / parts_, n_columns_ - 1);
        const double xi = double(station - k * parts_) / parts_;
        const double z0 = plan_->rail_stations[k], z1 = plan_->rail_stations[k + 1];
        return {p.x, p.y, z0 + xi * (z1 - z0)};
      }
    const double angle = 2 * M_PI * (double(station % (n_columns_ * parts_)) / parts_) / plan_->sectors;
    // the section's lateral coordinate points to the track centre, the wheel's own x to the field side
    return plan_->surfaces.pose().position(-p.x, p.y, -angle);
  }


  Vector3
  SweptGrid::position(const int block, const int i, const int j, const int station) const
  {
    const Vector3         X       = at_station(place(block, i, j), station);
    const RunningSurface &surface = plan_->surfaces[body_];
    return moved_ ? surface.moved(X) : X;
  }


  std::uint64_t
  SweptGrid::vertex_key(const CellPlace &cell, const unsigned int v) const
  {
    const int size = parts_ >> cell.level, i = cell.i + (v & 1), j = cell.j + (v >> 1 & 1),
              k = cell.k + (v >> 2);
    return vertex_key(cell.block, i * size, j * size, k * size);
  }


  Vector3
  SweptGrid::position(const CellPlace &cell, const unsigned int v) const
  {
    const int size = parts_ >> cell.level, i = cell.i + (v & 1), j = cell.j + (v >> 1 & 1),
              k = cell.k + (v >> 2);
    return position(cell.block, i * size, j * size, k * size);
  }


  std::array<Vector3, 3>
  SweptGrid::axes(const int section) const
  {
    if (body_ == Body::rail)
      return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const auto    at    = [&](const Point2 &p) { return at_station(p, section * parts_); };
    const Vector3 along = at({1, 1}) - at({0, 1}), outwards = at({0, 2}) - at({0, 1});
    return {along, outwards, cross(along, outwards)};
  }


  std::array<Vector3, 8>
  SweptGrid::coarse_vertices(const int block, const int column) const
  {
    std::array<Vector3, 8> X;
    for (int v = 0; v < 8; ++v)
      X[v] = position(block, (v & 1) * parts_, (v >> 1 & 1) * parts_, (column + (v >> 2)) * parts_);
    return X;
  }


  const SweptGrid::Measures &
  SweptGrid::measures(const CellPlace &cell) const
  {
    std::vector<Measures> &of_block = measures_[cell.level][cell.block];
    if (of_block.empty())
      of_block.resize(std::size_t(1) << 2 * cell.level);
    Measures &m = of_block[(std::size_t(cell.j) << cell.level) + cell.i];
    if (m.width >= 0)
      return m;
    const RunningSurfaces &surfaces = plan_->surfaces;
    const int              size     = parts_ >> cell.level;
    double                 low[2], high[2]; // across, depth
    std::fill(low, low + 2, std::numeric_limits<double>::max());
    std::fill(high, high + 2, std::numeric_limits<double>::lowest());
    std::array<Vector3, 8> X;
    // where the track is divided as the wheel is; the box lies nowhere else
    const double length = plan_->block_length() / (1 << cell.level);
    for (unsigned int v = 0; v < 4; ++v)
      {
        const Point2 p = place(cell.block, (cell.i + (v & 1)) * size, (cell.j + (v >> 1)) * size);
        Vector3      foot{p.x, p.y, 0};
        if (body_ == Body::wheel)
          {
            X[v]     = at_station(p, 0);
            X[v + 4] = at_station(p, size);
            foot     = X[v];
          }
        else
          {
            X[v]     = foot;
            X[v + 4] = {p.x, p.y, length};
          }
        const auto   where    = surfaces[body_].place(foot);
        const double s        = std::clamp(where.s, plan_->strip.s.front(), plan_->strip.s.back());
        const double above    = surfaces[body_].smooth(s).n - where.n,
                     depth    = body_ == Body::rail ? above : -above;
        const double value[2] = {where.s, depth};
        for (unsigned int k = 0; k < 2; ++k)
          {
            low[k]  = std::min(low[k], value[k]);
            high[k] = std::max(high[k], value[k]);
          }
      }
    m.across = {low[0], high[0]};
    m.depth  = low[1] - plan_->fine_depth;
    m.width  = smallest_stretch(X);
    return m;
  }


  double
  SweptGrid::section_distance(const CellPlace &cell, const Range &across) const
  {
    const Measures &m     = measures(cell);
    const Range     strip = plan_->whole_strip();
    return std::max(
      {m.across.s0 - std::min(across.s1, strip.s1), std::max(across.s0, strip.s0) - m.across.s1, m.depth});
  }


  double
  SweptGrid::width(const CellPlace &cell) const
  {
    return measures(cell).width;
  }


  double
  SweptGrid::along(const unsigned int level, const int k) const
  {
    if (body_ == Body::wheel)
      return -plan_->block_length() * k / (1 << level);
    const int    column = std::min(k >> level, n_columns_ - 1);
    const double z0 = plan_->rail_stations[column], z1 = plan_->rail_stations[column + 1];
    return z0 + double(k - (column << level)) / (1 << level) * (z1 - z0);
  }


  bool
  SweptGrid::in_strip(const int block) const
  {
    CellPlace cell;
    cell.block            = block;
    const Range     strip = plan_->whole_strip();
    const double    more  = 1e-3 * (strip.s1 - strip.s0);
    const Measures &m     = measures(cell);
    return m.across.s0 < strip.s1 - more && m.across.s1 > strip.s0 + more;
  }


  std::vector<SweptGrid::SectionCell>
  SweptGrid::touching(const unsigned int level, const int block, const int i, const int j) const
  {
    std::vector<SectionCell> cells;
    const int                n   = 1 << level;
    const auto               add = [&](const int b, const int x, const int y) {
      for (int q = std::max(y - 1, 0); q <= std::min(y, n - 1); ++q)
        for (int p = std::max(x - 1, 0); p <= std::min(x, n - 1); ++p)
          cells.push_back({b, p, q});
    };
    const auto &corner = section().blocks[block].corner;
    const bool  side_i = i == 0 || i == n, side_j = j == 0 || j == n;
    if (side_i && side_j)
      for (const Neighbour &other : at_corner_[corner[(i > 0) + 2 * (j > 0)]])
        add(other.block, other.own & 1 ? n : 0, other.own >> 1 ? n : 0);
    else if (side_i || side_j)
      {
        const unsigned int edge = side_i ? i > 0 : 2 + (j > 0);
        const int          t    = along_edge(corner, edge, i, j, n);
        for (const Neighbour &other : at_edge_[edges_[block][edge]])
          {
            const auto &own = section().blocks[other.block].corner;
            const int   u =
              own[Section::edge_corners[other.own][0]] < own[Section::edge_corners[other.own][1]] ? t : n - t;
            if (other.own < 2)
              add(other.block, other.own == 1 ? n : 0, u);
            else
              add(other.block, u, other.own == 3 ? n : 0);
          }
      }
    else
      add(block, i, j);
    return cells;
  }
} // namespace wheelrail
