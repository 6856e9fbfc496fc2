#pragma once

#include <string>
#include <vector>

namespace wheelrail
{
  /// The control digits of a case of CONTACT. Their letters stand in the table of control_digits().
  struct ControlDigits
  {
    // first word: CPBTNFS; module 3 PBTNFS
    int side = 1, past = 2, bound = 0, motion = 3, normal = 0, forces = 0, subsurface = 0;
    // second word: VLDCMZE, and the number behind it: its last digit, and tens
    int variation = 0, law = 0, grid = 2, influence = 2, material = 0, geometry = 2, extra = 0;
    int damping = 0, gap_weights = 0;
    // third word: XHGIAOWR
    int debug = 0, heat = 0, solver = 0, start = 0, matfile = 0, print = 0, trace = 0, after = 0;
  };

  /// A value of a control digit.
  struct DigitValue
  {
    enum Use
    {
      taken,
      not_taken,
      kept ///< what the case before had
    };
    int         value = 0;
    std::string meaning;
    Use         use = taken;
  };

  /// A control digit: in which of the three words it stands and of which module it is (0: both).
  struct ControlDigit
  {
    char        letter;
    int         word, module;
    const char *name;
    int ControlDigits::    *place;
    std::vector<DigitValue> values; ///< all that CONTACT has
  };

  /// The one table of digits: what CONTACT has and what of it is computed here.
  const std::vector<ControlDigit> &
  control_digits();

  /// The letters of a control word (1 to 3) of a module (1 or 3), as CONTACT's guide writes them.
  std::string
  control_letters(int module, int word);

  /// The digit of a letter in a word.
  const ControlDigit &
  control_digit(int module, int word, char letter);

  /// The value's entry, null when CONTACT does not have it.
  const DigitValue *
  digit_value(const ControlDigit &digit, int value);

  /// "0 (no friction), 1 (shift) or 3 (steady rolling)": the values of these uses.
  std::string
  accepted_digits(const ControlDigit &digit, const std::vector<DigitValue::Use> &uses);
} // namespace wheelrail
