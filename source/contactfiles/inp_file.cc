#include <wheelrail/base/errors.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/contactfiles/case_checks.h>
#include <wheelrail/contactfiles/inp_file.h>
#include <wheelrail/contactfiles/inp_groups.h>

#include <array>
#include <map>

namespace wheelrail
{
  namespace
  {
    /// Takes the value of a digit; those that keep get what counted in the case before.
    void
    set_digit(const InpWords     &words,
              ContactCase        &one,
              const ContactCase  *before,
              const ControlDigit &digit,
              const int           value)
    {
      const DigitValue *const entry = digit_value(digit, value);
      const std::string       text  = std::string(1, digit.letter) + " = " + std::to_string(value);
      if (!entry)
        words.fail(words.line(),
                   "the digit " + text + " (" + digit.name + ") is unknown; it may be " +
                     accepted_digits(digit, {DigitValue::taken, DigitValue::not_taken, DigitValue::kept}));
      one.written.*digit.place = value;
      one.digits.*digit.place  = value;
      if (entry->use != DigitValue::kept)
        return;
      const bool has_default =
        digit.place == &ControlDigits::solver || digit.place == &ControlDigits::damping;
      if (!before && !has_default)
        words.fail(words.line(),
                   "the digit " + text + " (" + digit.name + ") keeps what the case before has, but " +
                     words.within + " is the first one; write one of " +
                     accepted_digits(digit, {DigitValue::taken, DigitValue::not_taken}));
      one.digits.*digit.place = before ? before->digits.*digit.place : 0;
    }

    void
    read_digits(InpWords &words, ContactCase &one, const ContactCase *before)
    {
      for (int word = 1; word <= 3; ++word)
        {
          const std::string letters = control_letters(one.module, word);
          const std::string text    = words.control_word(letters);
          one.word_lines[word - 1]  = words.line();
          for (std::size_t k = 0; k < letters.size(); ++k)
            set_digit(words, one, before, control_digit(one.module, word, letters[k]), text[k] - '0');
          if (word == 2)
            {
              const int more = words.further_integer("GM").value_or(1);
              set_digit(words, one, before, control_digit(one.module, 4, 'M'), more % 10);
              set_digit(words, one, before, control_digit(one.module, 4, 'G'), more / 10);
            }
        }
      one.line = one.word_lines[0];
      if (!before)
        {
          one.digits.past  = 2;
          one.digits.start = 0;
        }
      if (one.digits.debug == 1)
        words.group("#PSFLCIN");
    }

    void
    read_case(InpWords &words, ContactCase &one, const ContactCase *before)
    {
      read_digits(words, one, before);
      read_general_groups(words, one);
      read_material_groups(words, one);
      if (one.module == 1)
        read_wheel_rail_groups(words, one);
      else
        read_grid_groups(words, one);
      read_points(words, one);
      // as CONTACT does, for this case and those that keep it
      if (one.digits.influence != 4 && one.digits.influence != 9 && one.material.alike())
        one.iteration.maxout = 1;
      check_case(one, before);
    }

    struct ModuleLine
    {
      int module = 0, element = 0, problem = 0;
    };

    ModuleLine
    read_module(InpWords &words)
    {
      if (words.at_end())
        words.fail(
          words.line(),
          "the file ends without the line \"0 MODULE\"; it is cut off, or that line is missing behind "
          "the last case");
      const InpGroup   group = words.group("#MODULE {#REID} {#CPID}");
      const ModuleLine line{int(group.values[0]), int(group.value(1)), int(group.value(2))};
      if (line.module != 0 && line.module != 1 && line.module != 3)
        words.fail(group.line,
                   "MODULE " + std::to_string(line.module) +
                     " is unknown; 1 (wheel and rail), 3 (basic contact) or 0 (end of the file) is needed; "
                     "digit R of the case before tells whether a MODULE line follows");
      if (line.element < 0 || line.element > 999 || line.problem < 0)
        words.fail(group.line,
                   "result element " + std::to_string(line.element) + ", contact problem " +
                     std::to_string(line.problem) +
                     "; elements from 1 to 999 and problems from 1 on are needed");
      return line;
    }
  } // namespace


  std::vector<ContactCase>
  read_inp_text(const std::string &text, const std::string &path)
  {
    InpWords                                  words(text, path);
    std::map<std::array<int, 3>, ContactCase> kept;
    std::map<int, int>                        count; // cases of each result element
    std::vector<ContactCase>                  cases;
    for (ModuleLine line = read_module(words); line.module != 0;)
      {
        const std::array<int, 3> key{line.module, line.element, line.module == 3 ? line.problem : 0};
        const auto               last   = kept.find(key);
        const ContactCase *const before = last == kept.end() ? nullptr : &last->second;
        ContactCase              one    = before ? *before : ContactCase();
        one.file                        = path;
        one.module                      = line.module;
        one.element                     = line.element;
        one.problem                     = line.problem;
        one.number                      = ++count[line.element];
        words.within                    = "case " + std::to_string(one.number) +
                       (line.element > 0 ? " of result element " + std::to_string(line.element) : "");
        words.notes.clear();
        read_case(words, one, before);
        one.notes = words.notes;
        cases.push_back(one);
        const bool module_follows = one.digits.after % 2 == 1;
        kept[key]                 = std::move(one);
        if (module_follows)
          line = read_module(words);
      }
    return cases;
  }

  std::vector<ContactCase>
  read_inp_file(const std::string &path)
  {
    std::string text;
    try
      {
        text = read_whole_file(path);
      }
    catch (const RunError &error)
      {
        throw InputError(std::string(error.what()) + " An input file of CONTACT (.inp) is needed.");
      }
    return read_inp_text(text, path);
  }
} // namespace wheelrail
