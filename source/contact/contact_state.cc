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

} // namespace wheelrail
