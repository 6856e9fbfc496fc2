#include <wheelrail/base/format_text.h>
#include <wheelrail/contactfiles/control_digits.h>

#include <algorithm>
#include <stdexcept>

namespace wheelrail
{
  namespace
  {
    /// Values such as "0 none; 1= as before; 2! read": = keeps, ! is not computed here.
    std::vector<DigitValue>
    digit_values(const std::string &text)
    {
      std::vector<DigitValue> values;
      for (const std::string &part : split_list(text, ';'))
        {
          const bool marked = part[1] != ' ';
          values.push_back({part[0] - '0',
                            part.substr(marked ? 3 : 2),
                            part[1] == '!'   ? DigitValue::not_taken
                            : part[1] == '=' ? DigitValue::kept
                                             : DigitValue::taken});
        }
      return values;
    }

    std::vector<ControlDigit>
    digit_table()
    {
      using D = ControlDigits;
      struct Entry
      {
        char        letter;
        int         word, module;
        const char *name;
        int ControlDigits::*place;
        const char         *values;
      };
      const std::vector<Entry> entries{
        {'C', 1, 1, "configuration", &D::side, "0 left rail; 1 right rail; 4 left roller; 5 right roller"},
        {'P',
         1,
         0,
         "past",
         &D::past,
         "0 after the case before; 1 the same for the normal part; 2 new start; 3 the same instant again"},
        {'B',
         1,
         3,
         "bound",
         &D::bound,
         "0 full solution; 1 with normal springs; 2 elliptic pressure; 3 parabolic pressure; 4! two half "
         "ellipses; 5! KPEC; 6! ANALYN"},
        {'B', 1, 1, "bound", &D::bound, "0 full solution; 1 with normal springs; 5! KPEC; 6! ANALYN"},
        {'T', 1, 3, "motion", &D::motion, "0 no friction; 1 shift; 2 transient rolling; 3 steady rolling"},
        {'T', 1, 1, "motion", &D::motion, "0 no friction; 1 shift; 2 transient rolling; 3 steady rolling"},
        {'N', 1, 3, "normal problem", &D::normal, "0 approach given; 1 force given"},
        {'N', 1, 1, "normal problem", &D::normal, "0 height of the wheelset given; 1 force given"},
        {'F',
         1,
         3,
         "tangential problem",
         &D::forces,
         "0 creepages given; 1 FX and CETA given; 2 FX and FY given"},
        {'F', 1, 1, "tangential problem", &D::forces, "0 pitch rate given; 1 FX_WS given; 3 rail on springs"},
        {'S',
         1,
         0,
         "stresses below the surface",
         &D::subsurface,
         "0 none; 1 points of the case before; 2 the same, other output; 3 new points"},

        {'V', 2, 3, "variation of friction", &D::variation, "0 none; 3 by rows of the grid"},
        {'V',
         2,
         1,
         "variation of friction",
         &D::variation,
         "0 none; 1 by surface inclination; 2 along the track"},
        {'L',
         2,
         0,
         "friction law",
         &D::law,
         "0 Coulomb; 1= as before; 2 linear in the slip velocity; 3 rational; 4 exponential; 6 by "
         "temperature"},
        {'D', 2, 3, "potential contact", &D::grid, "0= as before; 1= as before; 2 new"},
        {'D',
         2,
         1,
         "discretisation",
         &D::grid,
         "0= as before; 1= as before; 2 planar, contact locus; 3 planar, slip of the surfaces; 4 "
         "conformal; 5 planar, grid search; 6! planar, grid search of steep slopes; 7! initial contact "
         "point; 8! oblique view; 9! oblique view"},
        {'C',
         2,
         0,
         "influence functions",
         &D::influence,
         "0= as before; 1= as before; 2 half-space; 3! half-space, bilinear; 4 half-space with angle "
         "correction; 9! from a file"},
        {'M',
         2,
         1,
         "material",
         &D::material,
         "0 elastic; 1! viscoelastic; 2! FASTSIM, one flexibility; 3! FASTSIM, three flexibilities; 4 "
         "interfacial layer; 5! FaStrip"},
        {'M',
         2,
         3,
         "material",
         &D::material,
         "0 elastic; 1! viscoelastic; 2 FASTSIM, one flexibility; 3 FASTSIM, three flexibilities; 4 "
         "interfacial layer; 5! FaStrip"},
        {'Z', 2, 3, "undeformed distance", &D::geometry, "0= as before; 1= as before; 2 new"},
        {'Z',
         2,
         1,
         "track",
         &D::geometry,
         "0= as before; 1 new dimensions; 2 new deviations; 3 new dimensions, profile and deviations"},
        {'E',
         2,
         3,
         "extra rigid slip",
         &D::extra,
         "0 none; 1= as before; 2 no spin in w_y; 3 no spin in w_x; 9 new, by elements"},
        {'E',
         2,
         1,
         "wheelset",
         &D::extra,
         "0= as before; 1 new position; 2 new position and velocity; 3 new dimensions, profile, position and "
         "velocity; 4 new position, velocity and flexibility; 5 all new, with flexibility"},
        {'G', 4, 0, "gap weights", &D::gap_weights, "0 none; 1! with weights; 2! with weights"},
        {'M', 4, 0, "damping", &D::damping, "0 none; 1= as before; 2! new"},

        {'X', 3, 0, "debug output", &D::debug, "0 none; 1 some"},
        {'H', 3, 0, "heat", &D::heat, "0 none; 1= as before; 3 new"},
        {'G',
         3,
         0,
         "solver",
         &D::solver,
         "0 default; 1= as before; 2 ConvexGS; 3 SteadyGS; 4 default with relaxation; 5 GDsteady"},
        {'I',
         3,
         0,
         "starting values",
         &D::start,
         "0 none; 1 of the case before; 2 of the case before; 3 of the case before"},
        {'A', 3, 0, "file .mat", &D::matfile, "0 none; 1 of the contact; 2 of the whole grid"},
        {'O',
         3,
         0,
         "printed output",
         &D::print,
         "0 none; 1 least; 2 totals; 3 picture; 4 profiles; 5 elements"},
        {'W',
         3,
         0,
         "printed flow",
         &D::trace,
         "0 none; 1 some; 2 some; 3 some; 4 some; 5 some; 6 more; 7 more; 8 more; 9 all"},
        {'R',
         3,
         0,
         "what follows",
         &D::after,
         "0 a case; 1 a MODULE line; 2 a case, this one is checked only; 3 a MODULE line, this case is "
         "checked only"},
      };
      std::vector<ControlDigit> table;
      for (const Entry &entry : entries)
        table.push_back(
          {entry.letter, entry.word, entry.module, entry.name, entry.place, digit_values(entry.values)});
      return table;
    }
  } // namespace


  const std::vector<ControlDigit> &
  control_digits()
  {
    static const std::vector<ControlDigit> table = digit_table();
    return table;
  }

  std::string
  control_letters(const int module, const int word)
  {
    return word == 1 ? (module == 1 ? "CPBTNFS" : "PBTNFS") : word == 2 ? "VLDCMZE" : "XHGIAOWR";
  }

  const ControlDigit &
  control_digit(const int module, const int word, const char letter)
  {
    for (const ControlDigit &digit : control_digits())
      if (digit.letter == letter && digit.word == word && (digit.module == 0 || digit.module == module))
        return digit;
    throw std::logic_error(std::string("no control digit ") + letter);
  }

  const DigitValue *
  digit_value(const ControlDigit &digit, const int value)
  {
    for (const DigitValue &entry : digit.values)
      if (entry.value == value)
        return &entry;
    return nullptr;
  }

  std::string
  accepted_digits(const ControlDigit &digit, const std::vector<DigitValue::Use> &uses)
  {
    std::vector<std::string> parts;
    for (const DigitValue &entry : digit.values)
      if (std::find(uses.begin(), uses.end(), entry.use) != uses.end())
        parts.push_back(std::to_string(entry.value) + " (" + entry.meaning + ")");
    std::string text;
    for (std::size_t k = 0; k < parts.size(); ++k)
      text += (k == 0 ? "" : k + 1 == parts.size() ? " or " : ", ") + parts[k];
    return text;
  }
} // namespace wheelrail
