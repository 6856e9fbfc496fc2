#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/mesh/section_builder.h>
#include <wheelrail/mesh/section_smoothing.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace wheelrail
{
  namespace
  {
    Section::EdgeKey
    key(const unsigned int a, const unsigned int b)
    {
      return {{std::min(a, b), std::max(a, b)}};
    }

    // Fraction of the chain's length at each of its corners.
    std::vector<double>
    fractions(const SectionBuilder &builder, const Side &side)
    {
      std::vector<double> result{0.};
      for (unsigned int i = 1; i < side.size(); ++i)
        result.push_back(result.back() + norm(builder.point(side[i]) - builder.point(side[i - 1])));
      for (double &fraction : result)
        fraction /= result.back();
      return result;
    }

    /// Means of a curve over at most `reach` to each side, less near its ends, which stay.
    std::function<Point2(double)>
    rounded(const std::function<Point2(double)> &curve, const double reach)
    {
      return [curve, reach](const double t) {
        constexpr int samples = 8;
        const double  step    = std::min({reach, t, 1 - t}) / samples;
        Point2        sum;
        for (int k = -samples; k <= samples; ++k)
          sum = sum + curve(t + k * step);
        return (1. / (2 * samples + 1)) * sum;
      };
    }

    void
    check_block(const Section &section, const unsigned int block, const std::string &name)
    {
      const auto &c = section.blocks[block].corner;
      for (const auto &[origin, x, y] : {std::array<unsigned int, 3>{{c[0], c[1], c[2]}},
                                         {{c[1], c[3], c[0]}},
                                         {{c[3], c[2], c[1]}},
                                         {{c[2], c[0], c[3]}}})
        {
          const Point2 &p = section.corners[origin];
          if (!(cross(section.corners[x] - p, section.corners[y] - p) > 0))
            throw RunError(
              "The section mesh has a folded block in its part '" + name + "' at (" + in_mm(p.x) + ", " +
              in_mm(p.y) +
              "). The fine strip or the dimensions leave too little room there: reduce the block "
              "size, narrow the strip, or check the dimensions of the section.");
        }
    }
  } // namespace


  Side
  part(const Side &side, const unsigned int first, const unsigned int last)
  {
    return Side(side.begin() + first, side.begin() + last + 1);
  }


  Side
  joined(const Side &a, const Side &b)
  {
    Side result = a;
    result.insert(result.end(), b.begin() + 1, b.end());
    return result;
  }


  unsigned int
  columns_left(const std::vector<Point2> &top, const std::array<Point2, 4> &bottom, const unsigned int middle)
  {
    const unsigned int n    = top.size() - 1;
    unsigned int       best = 1;
    double             cost = std::numeric_limits<double>::max();
    for (unsigned int left = 1; left + middle < n; ++left)
      {
        const std::array<unsigned int, 3> count{{left, middle, n - left - middle}};
        double                            sum = 0;
        for (unsigned int part = 0, k = 0; part < 3; ++part)
          for (unsigned int i = 0; i < count[part]; ++i, ++k)
            {
              const double x = bottom[part].x + (bottom[part + 1].x - bottom[part].x) * i / count[part];
              sum += (top[k].x - x) * (top[k].x - x);
            }
        if (sum < cost)
          {
            cost = sum;
            best = left;
          }
      }
    return best;
  }


  unsigned int
  SectionBuilder::corner(const Point2 &p)
  {
    section_.corners.push_back(p);
    return section_.corners.size() - 1;
  }


  void
  SectionBuilder::curve(const unsigned int a, const unsigned int b, std::function<Point2(double)> curve)
  {
    if (a < b)
      section_.curved[key(a, b)] = std::move(curve);
    else
      section_.curved[key(a, b)] = [curve = std::move(curve)](const double t) { return curve(1 - t); };
  }


  void
  SectionBuilder::mark(const Side &side, const Boundary boundary)
  {
    for (unsigned int i = 1; i < side.size(); ++i)
      section_.boundary[key(side[i - 1], side[i])] = boundary;
  }


  Side
  SectionBuilder::along(const unsigned int  first,
                        const unsigned int  last,
                        const CurveStretch &stretch,
                        const unsigned int  n)
  {
    Side side{first};
    for (unsigned int i = 1; i < n; ++i)
      side.push_back(corner(stretch(double(i) / n)));
    side.push_back(last);
    for (unsigned int i = 0; i < n; ++i)
      curve(side[i], side[i + 1], [stretch, i, n](const double t) { return stretch((i + t) / n); });
    return side;
  }


  Side
  SectionBuilder::straight(const unsigned int first, const unsigned int last, const unsigned int n)
  {
    Side side{first};
    for (unsigned int i = 1; i < n; ++i)
      {
        const double t = double(i) / n;
        side.push_back(corner((1 - t) * point(first) + t * point(last)));
      }
    side.push_back(last);
    return side;
  }


  void
  SectionBuilder::patch(const std::string &name,
                        const Side        &bottom,
                        const Side        &top,
                        const Side        &left,
                        const Side        &right)
  {
    const unsigned int n = bottom.size() - 1, m = left.size() - 1;
    if (top.size() != n + 1 || right.size() != m + 1 || bottom.front() != left.front() ||
        bottom.back() != right.front() || top.front() != left.back() || top.back() != right.back())
      throw RunError("The sides of the section part '" + name +
                     "' do not meet. This is a defect of the program.");

    const std::vector<double> b = fractions(*this, bottom), t = fractions(*this, top);
    const std::vector<double> l = fractions(*this, left), r = fractions(*this, right);

    Side below = bottom;
    for (unsigned int j = 1; j <= m; ++j)
      {
        Side row{left[j]};
        for (unsigned int i = 1; i < n && j < m; ++i)
          {
            // where the lines that join equal fractions of opposite sides cross
            const double dx = t[i] - b[i], dy = r[j] - l[j];
            const double x = (b[i] + l[j] * dx) / (1 - dx * dy), y = l[j] + x * dy;

            const Point2 bilinear = (1 - y) * ((1 - x) * point(bottom[0]) + x * point(bottom[n])) +
                                    y * ((1 - x) * point(top[0]) + x * point(top[n]));
            row.push_back(corner((1 - y) * point(bottom[i]) + y * point(top[i]) + (1 - x) * point(left[j]) +
                                 x * point(right[j]) - bilinear));
          }
        row.push_back(right[j]);
        if (j == m)
          row = top;
        for (unsigned int i = 0; i < n; ++i)
          {
            section_.blocks.push_back({{{below[i], below[i + 1], row[i], row[i + 1]}}});
            patch_of_block_.push_back(name);
          }
        below = row;
      }
  }


  void
  SectionBuilder::smooth(const unsigned int first,
                         const unsigned int last,
                         const Side        &fixed,
                         const double       block_size)
  {
    std::map<Section::EdgeKey, unsigned int> use;
    for (const auto &block : section_.blocks)
      for (const auto &[i, j] : {std::array<unsigned int, 2>{{0, 1}}, {{1, 3}}, {{2, 3}}, {{0, 2}}})
        ++use[key(block.corner[i], block.corner[j])];

    std::vector<bool> movable(section_.corners.size(), false);
    std::fill(movable.begin() + first, movable.begin() + last + 1, true);
    for (const unsigned int corner : fixed)
      movable[corner] = false;
    for (const auto &[edge, blocks] : use)
      if (blocks == 1)
        movable[edge[0]] = movable[edge[1]] = false;
    smooth_section(section_, movable, block_size);
  }


  void
  SectionBuilder::round_edges(const Side &exact)
  {
    std::set<Section::EdgeKey> kept;
    for (unsigned int i = 1; i < exact.size(); ++i)
      kept.insert(key(exact[i - 1], exact[i]));
    constexpr unsigned int parts      = 16;
    constexpr double       least_sine = 0.2;
    for (unsigned int block = 0; block < section_.blocks.size(); ++block)
      {
        const auto               &corner = section_.blocks[block].corner;
        decltype(section_.curved) sharp;
        for (unsigned int edge = 0; edge < 4; ++edge)
          if (const auto found = section_.curved.find(Section::edge_key(corner, edge));
              found != section_.curved.end() && kept.count(found->first) == 0 &&
              section_.boundary.count(found->first) != 0 &&
              section_.boundary.at(found->first) == Boundary::running)
            sharp.insert(*found);
        for (double reach = 0.05; !sharp.empty() && reach <= 0.5 &&
                                  block_quality(section_, block, parts).min_scaled_jacobian < least_sine;
             reach += 0.05)
          for (const auto &[edge, curve] : sharp)
            section_.curved[edge] = rounded(curve, reach);
      }
  }


  void
  SectionBuilder::check() const
  {
    for (unsigned int block = 0; block < section_.blocks.size(); ++block)
      check_block(section_, block, patch_of_block_[block]);
  }
} // namespace wheelrail
