#include <wheelrail/solid/exchange.h>
#include <wheelrail/statics/static_parts.h>

#include <algorithm>
#include <utility>

// What parts of a scene give to the static start: loads, springs, held nodes (doc/theory/rolling.md, Time
// stepping).

namespace wheelrail
{
  StaticParts::StaticParts(const SceneParts &parts, const Solid &solid, MPI_Comm communicator)
    : parts_(parts)
    , solid_(solid)
    , loads_(solid.force.size(), 0.)
    , springs_(solid.force.size(), 0.)
  {
    // Signs: loads [N] along the axes of the track, Y up; springs [N/m], positive, pull back to where the
    // part stands
    const std::vector<NodeInertia> inertia = prepare_parts(parts, solid);
    held_                                  = held_nodes(solid, inertia);
    for (std::size_t n = 0; n < inertia.size(); ++n)
      // weights along -Y [N]
      loads_[4 * n + 1] = -inertia[n].weight; // of one rank
    sum_over_ranks(solid.mesh, loads_.data());
    for (const auto &part : parts)
      // diagonal springs of sleepers and other parts [N/m], their own unknowns condensed
      // (doc/theory/rolling.md, Time stepping)
      part->add_springs(springs_.data());
    int any = std::any_of(springs_.begin(), springs_.end(), [](const double k) { return k > 0; }) ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, communicator);
    if (any == 0)
      // none on any rank: nothing below has to be asked, on all ranks alike, since the calls are collective
      springs_.clear();
  }


  std::vector<JoinedNodes>
  StaticParts::joined() const
  {
    // terms of low rank that condensation takes off the diagonal springs, mostly negative [N/m]
    std::vector<JoinedNodes> all;
    if (!springs_.empty())
      for (const auto &part : parts_)
        for (JoinedNodes &term : part->joined())
          all.push_back(std::move(term));
    return all;
  }


  void
  StaticParts::add_forces(AlignedVector<double> &force) const
  {
    if (!springs_.empty())
      for (const auto &part : parts_)
        part->add_static_forces(solid_, force);
  }


  void
  StaticParts::add_stiffness(const double *x, double *y) const
  {
    if (!springs_.empty())
      for (const auto &part : parts_)
        part->add_stiffness(solid_, x, y);
  }
} // namespace wheelrail
