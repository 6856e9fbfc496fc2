#include <wheelrail/mesh/section_smoothing.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    // |J|^2 + |J|^2 / det^2 for the corner p of a cell with the next corners along its two edges, all
    // in units of the wanted cell. A folded cell counts as one of hardly any area: the sum stays
    // finite and falls as the cell opens.
    double
    distortion(const Point2 &p, const Point2 &x, const Point2 &y)
    {
      constexpr double least =
        0.02; // of the area of a wanted cell: far below that of any cell that is accepted
      const Point2 a = x - p, b = y - p;
      const double size = dot(a, a) + dot(b, b), det = cross(a, b);
      const double open = 0.5 * (det + std::sqrt(det * det + 4 * least * least));
      return size + size / (open * open);
    }

    // One block: its four edges as points at equal steps of the block coordinates. Curved edges are
    // sampled once, since their ends stay; an edge between two corners that may move is straight.
    class SmoothBlock
    {
    public:
      SmoothBlock(const Section &section, const unsigned int block)
        : corner_(section.blocks[block].corner)
      {
        for (unsigned int e = 0; e < 4; ++e)
          {
            const unsigned int a = corner_[ends[e][0]], b = corner_[ends[e][1]];
            const auto         found = section.curved.find({{std::min(a, b), std::max(a, b)}});
            if (found != section.curved.end())
              for (unsigned int i = 0; i <= n; ++i)
                bulge_[e].push_back(
                  found->second((a < b ? i : n - i) / double(n)) -
                  ((n - i) / double(n) * section.corners[a] + i / double(n) * section.corners[b]));
            curved_ = curved_ || !bulge_[e].empty();
          }
      }

      double
      distortion_sum(const Section &section, const double block_size) const
      {
        const unsigned int cells = curved_ ? n : 1;
        const double       scale = cells / block_size;
        Point2             p[n + 1][n + 1];
        for (unsigned int j = 0; j <= cells; ++j)
          for (unsigned int i = 0; i <= cells; ++i)
            p[j][i] = scale * position(section, i, j, cells);

        double sum = 0;
        for (unsigned int j = 0; j < cells; ++j)
          for (unsigned int i = 0; i < cells; ++i)
            for (const double f : {distortion(p[j][i], p[j][i + 1], p[j + 1][i]),
                                   distortion(p[j][i + 1], p[j + 1][i + 1], p[j][i]),
                                   distortion(p[j + 1][i + 1], p[j + 1][i], p[j][i + 1]),
                                   distortion(p[j + 1][i], p[j][i], p[j + 1][i + 1])})
              sum += f * f;
        return sum / (cells * cells);
      }

    private:
      static constexpr unsigned int n          = 4; // cells in each direction of a block with curved edges
      static constexpr unsigned int ends[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}}; // bottom, top, left, right

      std::array<unsigned int, 4>        corner_;
      std::array<std::vector<Point2>, 4> bulge_; // of an edge over its chord, empty for straight edges
      bool                               curved_ = false;

      // the bilinear position plus the bulges of the edges, which vanish at the corners
      Point2
      position(const Section     &section,
               const unsigned int i,
               const unsigned int j,
               const unsigned int cells) const
      {
        const double       x = i / double(cells), y = j / double(cells);
        const auto         c        = [&](const unsigned int k) { return section.corners[corner_[k]]; };
        Point2             p        = (1 - y) * ((1 - x) * c(0) + x * c(1)) + y * ((1 - x) * c(2) + x * c(3));
        const unsigned int along[4] = {i, i, j, j};
        const double       weight[4] = {1 - y, y, 1 - x, x};
        for (unsigned int e = 0; e < 4; ++e)
          if (!bulge_[e].empty())
            p = p + weight[e] * bulge_[e][along[e]];
        return p;
      }
    };
  } // namespace


  void
  smooth_section(Section &section, const std::vector<bool> &movable, const double block_size)
  {
    std::vector<SmoothBlock>               blocks;
    std::vector<std::vector<unsigned int>> blocks_at(section.corners.size());
    for (unsigned int b = 0; b < section.blocks.size(); ++b)
      {
        blocks.emplace_back(section, b);
        for (const unsigned int c : section.blocks[b].corner)
          blocks_at[c].push_back(b);
      }

    // a pattern search (Hooke and Jeeves, 1961) for each corner in turn, with steps of its own from a fifth
    // of a block down to a ten-thousandth: eleven halvings, so that 80 sweeps are more than enough
    std::vector<double> step(section.corners.size(), 0.2 * block_size);
    for (unsigned int sweep = 0; sweep < 80; ++sweep)
      for (unsigned int c = 0; c < section.corners.size(); ++c)
        {
          if (!movable[c] || step[c] < 1e-4 * block_size)
            continue;
          const auto sum = [&] {
            double result = 0;
            for (const unsigned int b : blocks_at[c])
              result += blocks[b].distortion_sum(section, block_size);
            return result;
          };
          Point2       best   = section.corners[c];
          const Point2 centre = best;
          double       lowest = sum();
          for (unsigned int direction = 0; direction < 8; ++direction)
            {
              const double angle = 0.25 * M_PI * direction;
              section.corners[c] = centre + step[c] * Point2{std::cos(angle), std::sin(angle)};
              if (const double value = sum(); value < lowest)
                {
                  lowest = value;
                  best   = section.corners[c];
                }
            }
          section.corners[c] = best;
          if (norm(best - centre) == 0)
            step[c] *= 0.5;
        }
  }
} // namespace wheelrail
