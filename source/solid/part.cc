#include <wheelrail/solid/part.h>

// Parts of a scene before the first step (doc/theory/rolling.md, Time stepping): what they add to weights and
// inertia of the nodes, and which nodes they move themselves.

namespace wheelrail
{
  // Inertia of the nodes after all parts have had their say: a part adds weights, or takes the inverse mass
  // of nodes that it moves itself. The order of the parts is that of the scene.
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
      // mass but no inverse mass: a part holds the node; hanging nodes have neither
      held[n] = solid.mass[n] > 0 && inertia[n].inverse_mass == 0;
    return held;
  }
} // namespace wheelrail
