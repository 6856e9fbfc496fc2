#include <wheelrail/base/errors.h>
#include <wheelrail/contactcalls/call_table.h>
#include <wheelrail/contactcalls/contact_calls.h>
#include <wheelrail/contactfiles/inp_file.h>

#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace wheelrail;

namespace
{
  constexpr int units_flag = 1933, units_mm = 1934, units_spck = 1935, units_si = 1936;

  /// A control digit by its code, with its largest value.
  struct DigitFlag
  {
    int code;
    int ControlDigits::*place;
    int                 largest;
  };

  const DigitFlag digit_flags[] = {{1967, &ControlDigits::side, 5},
                                   {1970, &ControlDigits::past, 3},
                                   {1971, &ControlDigits::bound, 6},
                                   {1972, &ControlDigits::motion, 3},
                                   {1973, &ControlDigits::normal, 1},
                                   {1974, &ControlDigits::forces, 3},
                                   {1976, &ControlDigits::law, -1},
                                   {1977, &ControlDigits::grid, 9},
                                   {1978, &ControlDigits::influence, 4},
                                   {1979, &ControlDigits::material, -1},
                                   {1980, &ControlDigits::extra, 3},
                                   {1982, &ControlDigits::heat, -1},
                                   {1983, &ControlDigits::start, 3},
                                   {1984, &ControlDigits::print, 5},
                                   {1985, &ControlDigits::trace, 9},
                                   {1986, &ControlDigits::after, 3},
                                   {1987, &ControlDigits::matfile, 2}};

  const DigitFlag *
  digit_flag(const int code)
  {
    for (const DigitFlag &entry : digit_flags)
      if (entry.code == code)
        return &entry;
    return nullptr;
  }

  void
  set_units(CallElement &element, const int value)
  {
    if (value == units_mm)
      element.units = {1, 1, 1};
    else if (value == units_si || value == units_spck)
      element.units = {1e3, 1e-6, value == units_si ? 1 : -1};
    else
      throw InputError("unit convention " + std::to_string(value) +
                       " is not available; taken are 1934 (mm), 1935 (SIMPACK) and 1936 (SI)");
  }

  void
  set_global_flag(const int code, const int value)
  {
    if (code == 2000) // how much is said
      set_call_output([&](CallOutput &output) { output.level = value; });
    else if (code != 0 && (code < 2001 || code > 2005)) // licence, input file, threads, timers, case: nothing
      call_message("cntc_setglobalflags: the code " + std::to_string(code) + " is unknown and left out");
  }

  /// Sets a flag of CONTACT's library by its code; a value that it does not have is cut to the nearest it
  /// has. Throws InputError for flags that follow from other calls; unknown codes are said and left out.
  void
  set_flag(CallElement &element, CallProblem &problem, const int code, const int value)
  {
    ContactCase &one = problem.one;
    if (code == 0) // an empty slot
      return;
    if (code == units_flag)
      return set_units(element, value);
    if (const DigitFlag *const digit = digit_flag(code))
      {
        if (digit->largest < 0)
          throw InputError("the flag " + std::to_string(code) +
                           " can be asked for only; friction, material and temperature have calls of their "
                           "own");
        const bool keeps = (code == 1977 || code == 1978) && value < 2;
        if (!keeps)
          one.digits.*digit->place = std::clamp(value, 0, digit->largest);
      }
    else if (code == 1989)
      one.influence.method = std::clamp(value, 0, 1);
    else if (code == 1990)
      one.influence.variant = std::clamp(value, 1, 4);
    else if (code == 1991)
      one.points_output = std::clamp(value, 0, 4);
    else if (code == 1992)
      one.points_file = std::clamp(value, 0, 2);
    else if (code == 1993)
      one.iteration.largest = std::clamp(value, 100, most_contact_elements);
    else if (code >= 2000)
      set_global_flag(code, value);
    else if (code != 1981 && code != 1988) // debug output, sensitivities
      call_message("cntc_setflags, " + one.file + ": the code " + std::to_string(code) +
                   " is unknown and left out");
  }

  /// The value of a flag, 0 for unknown codes.
  int
  flag(const CallElement &element, const CallProblem &problem, const int code)
  {
    if (code == units_flag)
      return element.units.body < 0 ? units_spck : element.units.length > 1 ? units_si : units_mm;
    if (const DigitFlag *const digit = digit_flag(code))
      return problem.one.digits.*digit->place;
    switch (code)
      {
        case 1989:
          return problem.one.influence.method;
        case 1990:
          return problem.one.influence.variant;
        case 1991:
          return problem.one.points_output;
        case 1992:
          return problem.one.points_file;
        case 1993:
          return int(problem.one.iteration.largest);
        case 2005:
          return problem.one.number;
        default:
          return 0;
      }
  }

  constexpr int interface_version = 2520; // of CONTACT's revision 2707

  void
  start(int *version, int *error, const int screen, const std::string &folder, const std::string &name)
  {
    // a wheel is one thread of the caller
    dealii::MultithreadInfo::set_thread_limit(1);
    set_call_output([&](CallOutput &output) {
      output.folder = folder;
      output.screen = screen == 1;
      if (!name.empty())
        output.name = name;
    });
    *version = interface_version;
    *error   = 0;
  }
} // namespace

void
cntc_initializefirst(int        *version,
                     int        *error,
                     const int  *output,
                     const char *folder,
                     const char *name,
                     const int  *folder_length,
                     const int  *name_length)
{
  if (error)
    *error = call_error::input;
  if (faulty(__func__, {version, error, output, folder_length, name_length}))
    return;
  start(version, error, *output, call_text(folder, *folder_length), call_text(name, *name_length));
}

void
cntc_initializefirst_new(int       *version,
                         int       *error,
                         const int *output,
                         const char *,
                         const char *folder,
                         const char *name,
                         const int *,
                         const int *folder_length,
                         const int *name_length)
{
  if (error)
    *error = call_error::input;
  if (faulty(__func__, {version, error, output, folder_length, name_length}))
    return;
  start(version, error, *output, call_text(folder, *folder_length), call_text(name, *name_length));
}

void
cntc_initialize(const int  *ire,
                const int  *module,
                int        *version,
                int        *error,
                const char *folder,
                const int  *folder_length)
{
  if (error)
    *error = call_error::input;
  if (faulty(__func__, {ire, module, version, error, folder_length}))
    return;
  dealii::MultithreadInfo::set_thread_limit(1);
  *version = interface_version;
  *error   = make_element(*ire, *module, call_text(folder, *folder_length));
}

void
cntc_finalize(const int *ire)
{
  if (faulty(__func__, {ire}))
    return;
  drop_element(*ire);
}

void
cntc_finalizelast()
{
  drop_all_elements();
}

void
cntc_readinpfile(const int *ire, const int *kind, const char *name, const int *name_length, int *error)
{
  const int failed = with_problem(
    {__func__, ire, &whole, 1}, {kind, name_length, error}, [&](CallElement &, CallProblem &problem) {
      if (*kind != 1988)
        throw InputError("input of kind " + std::to_string(*kind) + " is not read; taken is 1988 (module 1)");
      const std::vector<ContactCase> cases = read_inp_file(call_text(name, *name_length));
      if (cases.empty() || cases.front().module != 1)
        throw InputError(call_text(name, *name_length) + " does not begin with a case of module 1");
      problem.one = cases.front();
    });
  if (error)
    *error = failed == 0 ? 0 : call_error::input;
}

void
cntc_setglobalflags(const int *n, const int *codes, const int *values)
{
  if (faulty(__func__, {n, when(n, codes), when(n, values)}))
    return;
  for (int k = 0; k < *n; ++k)
    set_global_flag(codes[k], values[k]);
}

void
cntc_setflags(const int *ire, const int *icp, const int *n, const int *codes, const int *values)
{
  with_problem({__func__, ire, icp},
               {n, when(n, codes), when(n, values)},
               [&](CallElement &element, CallProblem &problem) {
                 for (int k = 0; k < *n; ++k)
                   set_flag(element, problem, codes[k], values[k]);
               });
}

void
cntc_getflags(const int *ire, const int *icp, const int *n, const int *codes, int *values)
{
  with_problem({__func__, ire, icp},
               {n, when(n, codes), when(n, values)},
               [&](CallElement &element, CallProblem &problem) {
                 for (int k = 0; k < *n; ++k)
                   values[k] = flag(element, problem, codes[k]);
               });
}

void
cntc_setmetadata(const int *ire, const int *icp, const int *, const int *, const double *)
{
  // for files .mat alone, which are not written
  with_problem({__func__, ire, icp}, {}, [](CallElement &, CallProblem &) {});
}
