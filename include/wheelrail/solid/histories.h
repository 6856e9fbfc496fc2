#pragma once

#include <wheelrail/solid/solid.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Numbers per node or cell, `components` each.
  struct NumberedValues
  {
    unsigned int        components = 1;
    std::vector<double> values;
  };

  /// What elements keep from step to step (visit_histories()) in the order of the rank's cells. The two
  /// bodies may have elements of different forms: rows of one length hold either, with zeros behind the
  /// shorter one and in a body that cannot flow.
  std::map<std::string, NumberedValues>
  cell_histories(const Solid &solid);

  /// Fills the histories again: `rows` gives those of a cell of the rank by its number there.
  void
  set_cell_histories(Solid                                                                          &solid,
                     const std::function<const double *(const std::string &name, std::size_t cell)> &rows);
} // namespace wheelrail
