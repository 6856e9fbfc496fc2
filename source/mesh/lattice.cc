#include <wheelrail/mesh/lattice.h>

#include <cmath>

namespace wheelrail
{
  long
  Lattice::station(const double along) const
  {
    const long own = std::lround(along / spacing_along);
    if (around == 0)
      return own;
    const double middle = first_station + 0.5 * n_along;
    return own + around * std::lround((middle - own) / around);
  }


  Lattice
  make_lattice(const SweepPlan &plan, const Body body, const Range &range, const Range &across)
  {
    const unsigned int parts  = 1u << plan.levels;
    const unsigned int blocks = plan.strip.s.size() - 1;
    Lattice            lattice;
    lattice.spacing_along = plan.block_length() / parts;
    // a range that ends at a station holds it, whatever the round-off
    lattice.first_station = static_cast<int>(std::ceil(range.s0 / lattice.spacing_along - 1e-6));
    lattice.n_along =
      static_cast<int>(std::floor(range.s1 / lattice.spacing_along + 1e-6)) - lattice.first_station + 1;
    const Range strip       = plan.whole_strip();
    lattice.spacing_lateral = (strip.s1 - strip.s0) / (double(blocks) * parts);
    const long first        = std::lround((across.s0 - strip.s0) / lattice.spacing_lateral),
               last         = std::lround((across.s1 - strip.s0) / lattice.spacing_lateral);
    lattice.s_begin         = strip.s0 + static_cast<double>(first) * lattice.spacing_lateral;
    lattice.n_lateral       = static_cast<unsigned int>(last - first + 1);
    lattice.around          = body == Body::wheel ? static_cast<int>(plan.sectors * parts) : 0;
    return lattice;
  }
} // namespace wheelrail
