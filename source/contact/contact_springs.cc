#include <wheelrail/contact/contact.h>

#include <algorithm>
#include <cstdlib>

namespace wheelrail
{
  std::vector<Contact::Spring>
  Contact::springs() const
  {
    std::vector<Spring> springs;
    // the nodes behind the filtered node (i, j) of a body, entered with `share`
    const auto spread = [&](Spring &spring, const int body, const int i, const int j, const double share) {
      const Surface &surface = body == 0 ? rail_ : wheel_;
      const int      first   = body == 0 ? window_.rail_first : window_.wheel_first;
      const int      last    = body == 0 ? window_.rail_last : window_.wheel_last;
      const auto     stencil = filter_stencil(surface.lattice, first, last, law_.filter[body].normal, i, j);
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
    for (int i = window_.rail_first; i < window_.rail_last; ++i)
      for (unsigned int j = 0; j < rail_.lattice.n_lateral; ++j)
        {
          const std::size_t  k    = rail_.lattice.index(i, j);
          const ContactNode &node = nodes_[k];
          // feet more than two cells away belong to iterates far from the solution; no matrix has room
          // for them
          const bool far = std::abs(2 * (node.facet_i - i) + 1) > 3 ||
                           std::abs(2 * (node.facet_j - static_cast<int>(j)) + 1) > 3;
          if (node.pressure <= 0 || far)
            continue;
          Spring spring;
          spring.point     = k;
          spring.normal    = node.normal;
          spring.stiffness = law_.stiffness * rail_.area[k];
          spread(spring, 0, i, j, 1);
          for (int a = 0; a < 2; ++a)
            for (int b = 0; b < 2; ++b)
              spread(spring,
                     1,
                     node.facet_i + a,
                     node.facet_j + b,
                     -(a == 1 ? node.xi : 1 - node.xi) * (b == 1 ? node.eta : 1 - node.eta));
          springs.push_back(spring);
        }
    return springs;
  }
} // namespace wheelrail
