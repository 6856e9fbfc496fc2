#include <wheelrail/contact/contact.h>

#include <algorithm>

namespace wheelrail
{
  Contact::State
  Contact::state() const
  {
    const auto first = nodes_.begin() + rail_.lattice.index(window_.rail_first, 0);
    const auto last  = nodes_.begin() + rail_.lattice.index(window_.rail_last, 0);
    return {window_, {first, last}};
  }


  void
  Contact::set_state(const State &state)
  {
    window_ = state.window;
    std::fill(nodes_.begin(), nodes_.end(), ContactNode());
    std::copy(
      state.nodes.begin(), state.nodes.end(), nodes_.begin() + rail_.lattice.index(window_.rail_first, 0));
    share_window();
  }


  std::vector<Contact::Spring>
  Contact::springs() const
  {
    std::vector<Spring> springs;
    for (int i = window_.rail_first; i < window_.rail_last; ++i)
      for (unsigned int j = 0; j < rail_.lattice.n_lateral; ++j)
        {
          const std::size_t  k    = rail_.lattice.index(i, j);
          const ContactNode &node = nodes_[k];
          if (node.pressure <= 0)
            continue;
          Spring spring;
          spring.rail     = k;
          const auto   c  = corners(node);
          const double xi = node.xi, eta = node.eta;
          spring.weight    = {(1 - xi) * (1 - eta), xi * (1 - eta), (1 - xi) * eta, xi * eta};
          spring.wheel     = {unsigned(c[0]), unsigned(c[1]), unsigned(c[2]), unsigned(c[3])};
          spring.normal    = node.normal;
          spring.stiffness = law_.stiffness * rail_.area[k];
          springs.push_back(spring);
        }
    return springs;
  }


  void
  Contact::set_shear(const std::size_t node, const Vector3 &shear)
  {
    nodes_[node].shear = shear;
  }
} // namespace wheelrail
