#include <wheelrail/output/fields.h>

#include <stdexcept>

namespace wheelrail
{
  const std::vector<double> *
  find_column(const History &table, const std::string &name)
  {
    for (std::size_t c = 0; c < table.names.size(); ++c)
      if (table.names[c] == name)
        return &table.columns[c];
    return nullptr;
  }


  const std::vector<double> &
  column(const History &table, const std::string &name)
  {
    if (const auto *found = find_column(table, name))
      return *found;
    throw std::logic_error("no history column " + name);
  }
} // namespace wheelrail
