#include <wheelrail/solid/part.h>

namespace wheelrail
{
  std::vector<NodeInertia>
  prepare_parts(const SceneParts &parts, const Solid &solid)
  {
    std::vector<NodeInertia> inertia = node_inertia(solid);
    for (const auto &part : parts)
      part->prepare(solid, inertia);
    return inertia;
  }


  std::vector<unsigned char>
  held_nodes(const Solid &solid, const std::vector<NodeInertia> &inertia)
  {
    std::vector<unsigned char> held(inertia.size());
    for (std::size_t n = 0; n < held.size(); ++n)
      held[n] = solid.mass[n] > 0 && inertia[n].inverse_mass == 0;
    return held;
  }
} // namespace wheelrail
