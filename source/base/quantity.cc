#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>

#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// SI value = number * factor / divisor. Two integers instead of one rounded factor keep
    /// 14 mm and 140 km/h equal to the nearest double of 0.014 and 140/3.6.
    struct Unit
    {
      const char *name;
      Dimension   dimension;
      double      factor;
      double      divisor;
    };


    /// The first unit of a dimension is its SI unit. Aliases come after the name that messages show.
    const std::vector<Unit> &
    units()
    {
      using D                              = Dimension;
      static const std::vector<Unit> table = {
        {"m", D::length, 1, 1},
        {"mm", D::length, 1, 1e3},
        {"um", D::length, 1, 1e6},
        {"km", D::length, 1e3, 1},
        {"kg", D::mass, 1, 1},
        {"t", D::mass, 1e3, 1},
        {"Mt", D::mass, 1e9, 1},
        {"g", D::mass, 1, 1e3},
        {"s", D::time, 1, 1},
        {"ms", D::time, 1, 1e3},
        {"us", D::time, 1, 1e6},
        {"Hz", D::frequency, 1, 1},
        {"kHz", D::frequency, 1e3, 1},
        {"m/s", D::velocity, 1, 1},
        {"km/h", D::velocity, 1, 3.6},
        {"mm/s", D::velocity, 1, 1e3},
        {"s/m", D::slowness, 1, 1},
        {"s/mm", D::slowness, 1e3, 1},
        {"N", D::force, 1, 1},
        {"kN", D::force, 1e3, 1},
        {"MN", D::force, 1e6, 1},
        {"Pa", D::stress, 1, 1},
        {"kPa", D::stress, 1e3, 1},
        {"MPa", D::stress, 1e6, 1},
        {"GPa", D::stress, 1e9, 1},
        {"N/mm2", D::stress, 1e6, 1},
        {"kg/m3", D::density, 1, 1},
        {"t/m3", D::density, 1e3, 1},
        {"g/cm3", D::density, 1e3, 1},
        {"N/m", D::stiffness, 1, 1},
        {"kN/m", D::stiffness, 1e3, 1},
        {"MN/m", D::stiffness, 1e6, 1},
        {"N/mm", D::stiffness, 1e3, 1},
        {"kN/mm", D::stiffness, 1e6, 1},
        {"N m/rad", D::turning_stiffness, 1, 1},
        {"kN m/rad", D::turning_stiffness, 1e3, 1},
        {"MN m/rad", D::turning_stiffness, 1e6, 1},
        {"N s/m", D::damping, 1, 1},
        {"kN s/m", D::damping, 1e3, 1},
        {"Ns/m", D::damping, 1, 1},
        {"kNs/m", D::damping, 1e3, 1},
        {"kg m2", D::mass_moment, 1, 1},
        {"kgm2", D::mass_moment, 1, 1},
        {"t m2", D::mass_moment, 1e3, 1},
        {"rad", D::angle, 1, 1},
        {"mrad", D::angle, 1, 1e3},
        {"deg", D::angle, M_PI, 180},
        {"1/m", D::spin, 1, 1},
        {"1/mm", D::spin, 1e3, 1},
        {"1/km", D::spin, 1, 1e3},
        {"rad/m", D::spin, 1, 1},
        {"N m", D::moment, 1, 1},
        {"kN m", D::moment, 1e3, 1},
        {"Nm", D::moment, 1, 1},
        {"kNm", D::moment, 1e3, 1},
        {"m/N", D::receptance, 1, 1},
        {"mm/N", D::receptance, 1, 1e3},
        {"mm/kN", D::receptance, 1, 1e6},
        {"um/N", D::receptance, 1, 1e6},
        {"um/kN", D::receptance, 1, 1e9},
        {"m/(N s)", D::mobility, 1, 1},
        {"mm/(N s)", D::mobility, 1, 1e3},
        {"m/(Ns)", D::mobility, 1, 1},
        {"m/s/N", D::mobility, 1, 1},
        {"m/N/s", D::mobility, 1, 1},
        {"m/Ns", D::mobility, 1, 1},
        {"mm/s/N", D::mobility, 1, 1e3},
        {"m/(s2 N)", D::accelerance, 1, 1},
        {"m/(N s2)", D::accelerance, 1, 1},
        {"m/(Ns2)", D::accelerance, 1, 1},
        {"m/s2/N", D::accelerance, 1, 1},
        {"1/kg", D::accelerance, 1, 1},
        {"dB", D::level, 1, 1},
      };
      return table;
    }

    struct DimensionText
    {
      Dimension   dimension;
      const char *article, *noun, *example;
    };

    const DimensionText &
    dimension_text(const Dimension dimension)
    {
      using D                                       = Dimension;
      static const std::vector<DimensionText> table = {
        {D::none, "a", "pure number", "0.25 or 1/40"},
        {D::length, "a", "length", "1.5 mm"},
        {D::mass, "a", "mass", "10 t"},
        {D::time, "a", "time", "2 ms"},
        {D::frequency, "a", "frequency", "500 Hz"},
        {D::velocity, "a", "velocity", "140 km/h"},
        {D::slowness, "a", "time per length", "0.05 s/m"},
        {D::force, "a", "force", "100 kN"},
        {D::stress, "a", "stress", "480 MPa"},
        {D::density, "a", "density", "7900 kg/m3"},
        {D::stiffness, "a", "stiffness", "1.15 MN/m"},
        {D::turning_stiffness, "a", "stiffness against turning", "1 MN m/rad"},
        {D::damping, "a", "damping", "2500 N s/m"},
        {D::mass_moment, "a", "moment of inertia", "1.5 kg m2"},
        {D::angle, "an", "angle", "2 mrad"},
        {D::spin, "a", "spin", "0.1 1/m"},
        {D::moment, "a", "torque", "2 kN m"},
        {D::receptance, "a", "receptance", "2 mm/kN"},
        {D::mobility, "a", "mobility", "1e-5 m/(N s)"},
        {D::accelerance, "an", "accelerance", "0.01 1/kg"},
        {D::level, "a", "level", "20 dB"},
      };
      for (const DimensionText &words : table)
        if (words.dimension == dimension)
          return words;
      throw std::logic_error("a dimension without its words");
    }

    const Unit *
    find_unit(const std::string &name)
    {
      for (const Unit &unit : units())
        if (name == unit.name)
          return &unit;
      return nullptr;
    }

    /// The spelling of the table: "N * s / m" and "kg/m^3" become "N s/m" and "kg/m3". The
    /// multi-byte characters are the middle dot, the superscripts 2 and 3 and both letters mu.
    std::string
    canonical_unit(std::string text)
    {
      const std::array<std::array<const char *, 2>, 7> spellings = {{{"*", " "},
                                                                     {"\xC2\xB7", " "},
                                                                     {"^", ""},
                                                                     {"\xC2\xB2", "2"},
                                                                     {"\xC2\xB3", "3"},
                                                                     {"\xC2\xB5", "u"},
                                                                     {"\xCE\xBC", "u"}}};
      for (const auto &pair : spellings)
        boost::replace_all(text, pair[0], pair[1]);
      boost::replace_all(text, "\t", " ");
      while (text.find("  ") != std::string::npos)
        boost::replace_all(text, "  ", " ");
      boost::replace_all(text, " /", "/");
      boost::replace_all(text, "/ ", "/");
      return boost::trim_copy(text);
    }

    /// " with its unit is needed, such as 140 km/h", or the like for pure numbers.
    std::string
    needed(const Dimension dimension)
    {
      if (dimension == Dimension::none)
        return "a pure number is needed, such as " + dimension_example(dimension);
      return dimension_name(dimension) + " with its unit is needed, such as " + dimension_example(dimension);
    }

    /// The decimal number at the start of `text`; `used` is set to the number of characters it
    /// takes. A number is digits with an optional sign, point and exponent: "inf", "nan" and
    /// hexadecimal digits are no numbers here.
    double
    leading_number(const std::string &text, std::size_t &used, const Dimension dimension)
    {
      const std::size_t sign  = (!text.empty() && text[0] == '+') ? 1 : 0;
      const char *const begin = text.data() + sign, *const end = text.data() + text.size();
      const std::size_t digit = sign + ((sign == 0 && !text.empty() && text[0] == '-') ? 1 : 0);
      const bool        looks_like_one =
        digit < text.size() && ((text[digit] >= '0' && text[digit] <= '9') || text[digit] == '.');
      double     value  = 0;
      const auto result = std::from_chars(begin, end, value);
      if (looks_like_one && result.ec == std::errc::result_out_of_range)
        throw InputError("a number too large or too small for the computer; " + needed(dimension));
      if (!looks_like_one || result.ec != std::errc() || !std::isfinite(value))
        throw InputError("not a number; " + needed(dimension));
      used = static_cast<std::size_t>(result.ptr - text.data());
      if (used < text.size() && (text[used] == 'x' || text[used] == 'X'))
        throw InputError("not a decimal number; " + needed(dimension));
      return value;
    }

    double
    parse_pure_number(const std::string &text)
    {
      std::size_t       used  = 0;
      const double      value = leading_number(text, used, Dimension::none);
      const std::string rest  = canonical_unit(text.substr(used));
      if (rest.empty())
        return value;
      if (rest[0] == '/' && rest.size() > 1)
        {
          std::size_t  used_below = 0;
          const double below      = leading_number(rest.substr(1), used_below, Dimension::none);
          if (used_below + 1 == rest.size())
            {
              if (below == 0)
                throw InputError("a division by zero; " + needed(Dimension::none));
              return value / below;
            }
        }
      if (find_unit(rest) != nullptr)
        throw InputError("the unit \"" + rest + "\" does not belong here; " + needed(Dimension::none));
      throw InputError("\"" + shown_text(rest, 40) + "\" after the number is not understood; " +
                       needed(Dimension::none));
    }

    /// Number text of `value` with the given count of significant digits.
    std::string
    digits_of(const double value, const int digits)
    {
      std::array<char, 64> buffer;
      const auto           result = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
      return std::string(buffer.data(), result.ptr);
    }
  } // namespace

  double
  parse_quantity(const std::string &text, const Dimension dimension)
  {
    const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    if (first == std::string::npos)
      throw InputError("no value; " + needed(dimension));
    const std::string trimmed = text.substr(first, last - first + 1);
    if (trimmed.size() > 200)
      throw InputError("too long for a number; " + needed(dimension));
    if (dimension == Dimension::none)
      return parse_pure_number(trimmed);

    std::size_t       used   = 0;
    const double      number = leading_number(trimmed, used, dimension);
    const std::string name   = canonical_unit(trimmed.substr(used));
    if (name.empty())
      throw InputError("a bare number; " + needed(dimension));
    if (name[0] == ',')
      throw InputError("a comma in the number; write a decimal point, such as " +
                       dimension_example(dimension));
    const Unit *unit = find_unit(name);
    if (unit == nullptr)
      throw InputError("the unit \"" + shown_text(name, 40) + "\" is not known here; " +
                       dimension_name(dimension) + " takes one of " + dimension_units(dimension));
    if (unit->dimension != dimension)
      throw InputError("the unit \"" + name + "\" is one of " + dimension_text(unit->dimension).noun + "; " +
                       dimension_name(dimension) + " takes one of " + dimension_units(dimension));
    const double value = number * unit->factor / unit->divisor;
    if (!std::isfinite(value))
      throw InputError("a number too large or too small for the computer; " + needed(dimension));
    return value;
  }

  std::string
  format_number(const double value)
  {
    std::string best;
    for (int digits = 1; digits <= 17; ++digits)
      {
        best              = digits_of(value, digits);
        double     back   = 0;
        const auto result = std::from_chars(best.data(), best.data() + best.size(), back);
        if (result.ec == std::errc() && back == value)
          break;
      }
    // to_chars writes 2e+05 for 200000: an integer that a person would write out is written out
    if (best.find('e') != std::string::npos && std::abs(value) < 1e7 && std::abs(value) >= 1)
      {
        const std::string longer = digits_of(value, 17);
        if (longer.find('.') == std::string::npos)
          best = longer;
      }
    return best;
  }

  std::string
  in_mm(const double length, const double parts)
  {
    const double rounded = std::round(length * 1e3 * parts) / parts + 0.; // not -0
    return format_number(rounded) + " mm";
  }

  std::string
  rounded_mm(const double length)
  {
    return in_mm(length, 1e6);
  }

  std::string
  format_quantity(const double value, const std::string &unit_name)
  {
    if (unit_name.empty())
      return format_number(value);
    const Unit *unit = find_unit(unit_name);
    if (unit == nullptr)
      throw std::logic_error("format_quantity: unknown unit " + unit_name);
    // the quotient is off by a rounding: the shortest text that reads back exactly is the one meant
    const double number = value * unit->divisor / unit->factor;
    for (int digits = 1; digits <= 17; ++digits)
      {
        double            back = 0;
        const std::string text = digits_of(number, digits);
        std::from_chars(text.data(), text.data() + text.size(), back);
        if (back * unit->factor / unit->divisor == value)
          return format_number(back) + " " + unit_name;
      }
    return format_number(number) + " " + unit_name;
  }

  std::string
  dimension_name(const Dimension dimension)
  {
    const DimensionText &words = dimension_text(dimension);
    return std::string(words.article) + " " + words.noun;
  }

  std::string
  dimension_units(const Dimension dimension)
  {
    std::string list;
    for (const Unit &unit : units())
      if (unit.dimension == dimension)
        list += (list.empty() ? "" : ", ") + std::string(unit.name);
    return list;
  }

  std::string
  dimension_example(const Dimension dimension)
  {
    return dimension_text(dimension).example;
  }

  std::string
  about(const double value)
  {
    return format_number(std::strtod(text("%.1e", value).c_str(), nullptr));
  }

  std::string
  about_count(const double value)
  {
    return value < 1e6 ? about(value) : about(1e-6 * value) + " million";
  }


  Dimension
  dimension_of(const std::string &unit_name)
  {
    if (unit_name.empty())
      return Dimension::none;
    const Unit *unit = find_unit(unit_name);
    if (unit == nullptr)
      throw std::logic_error("dimension_of: unknown unit " + unit_name);
    return unit->dimension;
  }


  std::string
  si_unit(const Dimension dimension)
  {
    for (const Unit &unit : units())
      if (unit.dimension == dimension && unit.factor == 1 && unit.divisor == 1)
        return unit.name;
    return "1";
  }
} // namespace wheelrail
