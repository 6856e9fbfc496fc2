#include <wheelrail/mesh/lattice.h>

#include <cmath>

namespace wheelrail
{
  Lattice
  make_lattice(const SweepPlan &plan)
  {
    const unsigned int parts  = 1u << plan.levels;
    const unsigned int blocks = plan.strip.s.size() - 1;
    Lattice            lattice;
    lattice.spacing_along = plan.block_length() / parts;
    lattice.first_station = static_cast<int>(std::ceil(plan.fine_begin / lattice.spacing_along));
    lattice.n_along =
      static_cast<int>(std::floor(plan.fine_end / lattice.spacing_along)) - lattice.first_station + 1;
    lattice.s_begin         = plan.strip.s.front();
    lattice.n_lateral       = blocks * parts + 1;
    lattice.spacing_lateral = (plan.strip.s.back() - plan.strip.s.front()) / (lattice.n_lateral - 1);
    return lattice;
  }
} // namespace wheelrail
