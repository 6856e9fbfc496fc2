#pragma once

#include <string>

namespace wheelrail
{
  /// What a number of the input measures.
  enum class Dimension
  {
    none, ///< a pure number; fractions such as 1/40 are accepted
    length,
    mass,
    time,
    frequency,
    velocity,
    slowness, ///< time per length
    force,
    stress,
    density,
    stiffness,
    turning_stiffness, ///< moment per angle
    damping,
    mass_moment, ///< moment of inertia of a mass
    angle,
    spin, ///< angle per length
    moment,
    receptance,  ///< displacement per force
    mobility,    ///< velocity per force
    accelerance, ///< acceleration per force
    level        ///< 20 lg of a ratio
  };

  /// The value of `text` in SI units: a decimal number, then for every dimension but `none` a unit
  /// (blanks between them optional): "140 km/h" gives 38.888..., "1/40" gives 0.025.
  ///
  /// Throws InputError for a bare number where a unit is needed, a unit where none belongs, an
  /// unknown unit, a unit of another dimension, and anything that is not a finite decimal number.
  /// The text of the error says what was found and what is accepted, without naming the entry.
  double
  parse_quantity(const std::string &text, Dimension dimension);

  /// `value` [SI] as a number in `unit` with the fewest digits that parse_quantity() turns back
  /// into `value` (or the nearest that 17 digits give): (0.001, "mm") gives "1 mm". An empty unit
  /// gives the bare number.
  /// Throws std::logic_error for a unit that parse_quantity() does not know.
  std::string
  format_quantity(double value, const std::string &unit);

  /// `value` with the fewest digits that read back as the same double.
  std::string
  format_number(double value);

  /// A length [m] in millimetres, "1.25 mm", rounded to micrometres (1000 digits per mm) or as given.
  std::string
  in_mm(double length, double parts = 1000);

  /// A length of the user, or a sum of some [m], in millimetres to six decimals: no noise of rounding shows.
  std::string
  rounded_mm(double length);

  /// `value` to two digits: what is estimated should look so.
  std::string
  about(double value);

  /// A number of things to two digits: 97000, 17 million.
  std::string
  about_count(double value);

  /// Name with article for messages: "a velocity", "a pure number".
  std::string
  dimension_name(Dimension dimension);

  /// Accepted units for messages: "m/s, km/h, mm/s"; empty for Dimension::none.
  std::string
  dimension_units(Dimension dimension);

  /// A valid value for messages: "140 km/h".
  std::string
  dimension_example(Dimension dimension);

  /// The dimension that a unit measures; none of an empty one.
  /// Throws std::logic_error for a unit that parse_quantity() does not know.
  Dimension
  dimension_of(const std::string &unit);

  /// The SI unit of a dimension: "m/s"; "1" of pure numbers.
  std::string
  si_unit(Dimension dimension);
} // namespace wheelrail
