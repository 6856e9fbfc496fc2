#include <wheelrail/base/errors.h>
#include <wheelrail/contactcalls/call_flags.h>
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
  constexpr int interface_version = 2520; // of CONTACT's revision 2707

  /// A text of the caller: blanks stand for nothing.
  std::string
  text_of(const char *text, const int length)
  {
    std::string s(text ? text : "", text ? std::size_t(std::max(length, 0)) : 0);
    s = s.substr(0, s.find('\0'));
    while (!s.empty() && s.back() == ' ')
      s.pop_back();
    return s;
  }

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
  start(version, error, *output, text_of(folder, *folder_length), text_of(name, *name_length));
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
  start(version, error, *output, text_of(folder, *folder_length), text_of(name, *name_length));
}

void
cntc_initialize(const int  *ire,
                const int  *module,
                int        *version,
                int        *error,
                const char *folder,
                const int  *folder_length)
{
  dealii::MultithreadInfo::set_thread_limit(1);
  *version = interface_version;
  *error   = make_element(*ire, *module, text_of(folder, *folder_length));
}

void
cntc_finalize(const int *ire)
{
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
  *error = call_error::input;
  if (with_problem({"cntc_readinpfile", 1}, *ire, -1, [&](CallElement &, CallProblem &problem) {
        if (*kind != 1988)
          throw InputError("input of kind " + std::to_string(*kind) +
                           " is not read; taken is 1988 (module 1)");
        const std::vector<ContactCase> cases = read_inp_file(text_of(name, *name_length));
        if (cases.empty() || cases.front().module != 1)
          throw InputError(text_of(name, *name_length) + " does not begin with a case of module 1");
        problem.one = cases.front();
      }) == 0)
    *error = 0;
}

void
cntc_setglobalflags(const int *n, const int *codes, const int *values)
{
  for (int k = 0; k < *n; ++k)
    set_global_flag(codes[k], values[k]);
}

void
cntc_setflags(const int *ire, const int *icp, const int *n, const int *codes, const int *values)
{
  with_problem({"cntc_setflags"}, *ire, *icp, [&](CallElement &element, CallProblem &problem) {
    for (int k = 0; k < *n; ++k)
      set_flag(element, problem, codes[k], values[k]);
  });
}

void
cntc_getflags(const int *ire, const int *icp, const int *n, const int *codes, int *values)
{
  with_problem({"cntc_getflags"}, *ire, *icp, [&](CallElement &element, CallProblem &problem) {
    for (int k = 0; k < *n; ++k)
      values[k] = flag(element, problem, codes[k]);
  });
}

void
cntc_setmetadata(const int *ire, const int *icp, const int *, const int *, const double *)
{
  // for files .mat alone, which are not written
  with_problem({"cntc_setmetadata"}, *ire, *icp, [](CallElement &, CallProblem &) {});
}
