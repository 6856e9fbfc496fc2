#include <wheelrail/contact/contact.h>

#include <algorithm>
#include <vector>

// Normal springs of the nodes in contact for the static start: k A n (x) n between what the filters make of
// nodes of both bodies (doc/theory/rolling.md, Static start, 2).

namespace wheelrail
{
  std::vector<Contact::Spring>
  Contact::springs() const
  {
    // The stretch is n . (x_r - x_w) of filtered places, minus the gap: rail nodes have positive weights,
    // those of the wheel negative ones. Damper and shear are left out, which the static start has not.
    std::vector<Spring> springs;
    // the nodes behind the filtered node (i, j) of a body, entered with `share`
    const auto spread = [&](Spring &spring, const Body body, const int i, const int j, const double share) {
      const Surface      &surface  = this->surface(body);
      const StationRange &stations = window()[body];
      // S = I - w/2 D'D in both directions, 3 x 3 nodes (doc/theory/contact.md, Surface filter)
      const auto stencil =
        filter_stencil(surface.lattice, stations.first, stations.last, law_.filter[body].normal, i, j);
      // the filtered place x_f = sum of stencil weights times x: the spring acts on all nine nodes with these
      // weights
      for (int k = -1; k <= 1; ++k)
        for (int l = -1; l <= 1; ++l)
          if (stencil[k + 1][l + 1] != 0)
            {
              const auto   node  = surface.global_node[surface.lattice.index(i + k, j + l)];
              const auto   same  = [node](const auto &entry) { return entry.first == node; };
              const auto   known = std::find_if(spring.nodes.begin(), spring.nodes.end(), same);
              const double part  = share * stencil[k + 1][l + 1];
              if (known != spring.nodes.end())
                known->second += part;
              else
                spring.nodes.emplace_back(node, part);
            }
    };
    for (int i = window().rail.first; i < window().rail.last; ++i)
      for (unsigned int j = 0; j < lattice().n_lateral; ++j)
        {
          const std::size_t  k    = lattice().index(i, j);
          const ContactNode &node = nodes_[k];
          // Newton's stiffness has the nodes that press now
          if (node.pressure <= 0)
            continue;
          Spring spring;
          spring.point  = k;
          spring.normal = node.normal;
          // k A n (x) n with k = eps: -dp/dg of the pressure p = -eps g (doc/theory/rolling.md, Static start)
          spring.stiffness = law_.stiffness * rail().area[k];
          // nine nodes of the rail; four corners of the facet with nine each of the wheel, many of them the
          // same
          spread(spring, Body::rail, i, j, 1);
          for (int a = 0; a < 2; ++a)
            for (int b = 0; b < 2; ++b)
              spread(spring,
                     Body::wheel,
                     node.foot.i + a,
                     node.foot.j + b,
                     -(a == 1 ? node.foot.xi : 1 - node.foot.xi) *
                       (b == 1 ? node.foot.eta : 1 - node.foot.eta));
          springs.push_back(spring);
        }
    return springs;
  }
} // namespace wheelrail
