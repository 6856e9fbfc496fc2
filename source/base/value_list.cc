#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/base/value_list.h>

#include <cmath>
#include <sstream>

namespace wheelrail
{
  ValueList
  parse_value_list(const std::string &text, const double most)
  {
    const bool          is_range = text.find(':') != std::string::npos;
    std::vector<double> numbers;
    std::istringstream  parts(text);
    for (std::string part; std::getline(parts, part, is_range ? ':' : ',');)
      try
        {
          numbers.push_back(parse_quantity(part, Dimension::none));
        }
      catch (const InputError &)
        {
          return {{}, "\"" + part + "\" is not a number"};
        }
    if (numbers.empty() || (is_range && numbers.size() != 3))
      return {{}, "not understood"};
    if (!is_range)
      return {numbers, ""};
    const double first = numbers[0], last = numbers[1], step = numbers[2];
    if (!(step > 0) || last < first)
      return {{}, "the step must be positive and the last value not below the first"};
    const double count = std::floor((last - first) / step * (1 + 1e-12) + 1e-9);
    if (count > most)
      return {{}, "more than " + format_number(most) + " values"};
    numbers.clear();
    for (double i = 0; i <= count; ++i)
      numbers.push_back(first + i * step);
    return {numbers, ""};
  }
} // namespace wheelrail
