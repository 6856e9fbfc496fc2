#include <wheelrail/base/errors.h>
#include <wheelrail/contactcalls/call_flags.h>
#include <wheelrail/contactcalls/call_table.h>
#include <wheelrail/contactcalls/contact_calls.h>
#include <wheelrail/contactfiles/inp_file.h>

#include <deal.II/base/multithread_info.h>

#include <string>
#include <vector>

using namespace wheelrail;

namespace
{
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
