#include <wheelrail/base/errors.h>
#include <wheelrail/contactcalls/call_table.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <mutex>

namespace wheelrail
{
  namespace
  {
    /// The one state that all calls share. Elements are used by one thread at a time; the table by all.
    struct CallTable
    {
      std::mutex                                  lock;
      std::map<int, std::shared_ptr<CallElement>> elements;
      CallOutput                                  output;
    };

    CallTable &
    table()
    {
      static CallTable one;
      return one;
    }

    /// What a new problem of a module has before anything is set.
    ContactCase
    new_case(const CallElement &element, const int problem)
    {
      ContactCase one;
      one.module  = element.module;
      one.element = element.number;
      one.problem = problem;
      one.file    = "result element " + std::to_string(element.number) +
                 (problem > 0 ? ", contact problem " + std::to_string(problem) : std::string());
      one.digits.motion = 3;
      one.digits.normal = 1;
      one.digits.print  = 2;
      one.digits.trace  = 4;
      one.friction.lines.push_back({0, {0.3, 0.3}, 1});
      one.elements.relative_step = 1;
      one.elements.a_sep         = M_PI;
      one.elements.d_sep         = 8;
      one.elements.d_comb        = 4;
      one.elements.d_turn        = 12;
      // a call stands for a line of a file
      one.line = one.iteration.line = one.friction.line = one.rolling.line = one.material.line = 1;
      one.word_lines                                                                           = {{1, 1, 1}};
      return one;
    }
  } // namespace


  void
  call_message(const std::string &sentence)
  {
    CallTable                        &t = table();
    const std::lock_guard<std::mutex> hold(t.lock);
    if (t.output.level < 1)
      return;
    std::ofstream file(std::filesystem::path(t.output.folder) / (t.output.name + ".out"), std::ios::app);
    file << sentence << '\n';
    std::cerr << sentence << std::endl;
  }

  CallArgument::CallArgument(const int *pointer)
    : pointer(pointer)
  {
  }

  CallArgument::CallArgument(const double *numbers)
    : pointer(numbers)
    , numbers(numbers)
  {
  }

  CallArgument::CallArgument(double *result)
    : pointer(result)
  {
  }

  CallArgument
  when(const int *n, CallArgument array, const std::size_t each)
  {
    if (n && *n <= 0)
      return {n};
    array.count = n ? each * std::size_t(*n) : 0;
    return array;
  }

  CallArgument
  cleared(const int *n, double *results)
  {
    CallArgument array = when(n, results);
    if (n && *n > 0)
      {
        array.cleared = results;
        array.bytes   = sizeof(double) * std::size_t(*n);
      }
    return array;
  }

  bool
  faulty(const char *function, const std::vector<CallArgument> &arguments)
  {
    std::string fault;
    for (const CallArgument &one : arguments)
      if (!one.pointer)
        fault = "is a null pointer";
    for (const CallArgument &one : arguments)
      if (fault.empty() && one.numbers &&
          !std::all_of(one.numbers, one.numbers + one.count, [](const double v) { return std::isfinite(v); }))
        fault = "holds a number that is not finite";
    if (!fault.empty())
      call_message(std::string(function) + ": an argument " + fault + "; nothing is done");
    return !fault.empty();
  }

  std::string
  call_text(const char *text, const int length)
  {
    std::string s(text ? text : "", text ? strnlen(text, std::size_t(std::clamp(length, 0, PATH_MAX))) : 0);
    while (!s.empty() && s.back() == ' ')
      s.pop_back();
    return s;
  }

  void
  set_call_output(const std::function<void(CallOutput &)> &set)
  {
    const std::lock_guard<std::mutex> hold(table().lock);
    set(table().output);
  }

  int
  make_element(const int number, const int module, const std::string &folder)
  {
    if (number < 1 || number > 999 || (module != 1 && module != 3))
      {
        call_message("cntc_initialize: result element " + std::to_string(number) + " of module " +
                     std::to_string(module) + "; elements are 1 to 999, modules 1 and 3");
        return call_error::element;
      }
    auto element    = std::make_shared<CallElement>();
    element->number = number;
    element->module = module;
    element->folder = folder;
    if (module == 1)
      element->problems[-1].one = new_case(*element, -1);
    const std::lock_guard<std::mutex> hold(table().lock);
    table().elements[number] = std::move(element);
    return 0;
  }

  void
  drop_element(const int number)
  {
    const std::lock_guard<std::mutex> hold(table().lock);
    table().elements.erase(number);
  }

  void
  drop_all_elements()
  {
    const std::lock_guard<std::mutex> hold(table().lock);
    table().elements.clear();
  }


  namespace
  {
    std::shared_ptr<CallElement>
    element_of(const CallFor &call)
    {
      const std::lock_guard<std::mutex> hold(table().lock);
      const auto                        found = table().elements.find(*call.ire);
      if (found == table().elements.end())
        throw InputError(std::string(call.name) + ": there is no result element " +
                         std::to_string(*call.ire) + "; call cntc_initialize for it first");
      return found->second;
    }

    CallProblem &
    problem_of(const CallFor &call, CallElement &element)
    {
      const int         icp   = *call.icp;
      const std::string where = std::string(call.name) + ", result element " + std::to_string(element.number);
      if (call.module != 0 && element.module != call.module)
        throw InputError(where + ": is for module " + std::to_string(call.module) + ", the element is of " +
                         "module " + std::to_string(element.module));
      if (element.module == 1)
        return element.problems.at(-1);
      if (icp < 1)
        throw InputError(where + ": contact problem " + std::to_string(icp) +
                         "; in module 3 they are counted from 1");
      const auto found = element.problems.find(icp);
      if (found != element.problems.end())
        return found->second;
      if (call.result)
        throw InputError(where + ": there is no contact problem " + std::to_string(icp));
      CallProblem &problem = element.problems[icp];
      problem.one          = new_case(element, icp);
      return problem;
    }
  } // namespace


  CallResult
  call_result(const CallProblem &problem, const int icp)
  {
    if (problem.solved)
      return {problem.solved->solution, problem.solved->hertz, nullptr};
    const std::vector<WheelRailPatch> &patches = problem.wheel_rail->patches;
    if (icp < 1 || icp > int(patches.size()))
      throw InputError("there is no patch " + std::to_string(icp) + "; the contact has " +
                       std::to_string(patches.size()));
    const WheelRailPatch &patch = patches[std::size_t(icp - 1)];
    return {patch.solution, {}, &patch};
  }


  int
  with_problem(const CallFor                                           &call,
               const std::vector<CallArgument>                         &arguments,
               const std::function<void(CallElement &, CallProblem &)> &work)
  {
    if (faulty(call.name, {call.ire, call.icp}) || faulty(call.name, arguments))
      return call_error::input;
    for (const CallArgument &one : arguments)
      if (one.cleared)
        std::memset(one.cleared, 0, one.bytes);
    try
      {
        const std::shared_ptr<CallElement> element = element_of(call);
        CallProblem                       &problem = problem_of(call, *element);
        try
          {
            if (call.result && !problem.computed())
              throw InputError("nothing is computed yet; call cntc_calculate first");
            work(*element, problem);
            return 0;
          }
        catch (const std::exception &error)
          {
            throw InputError(std::string(call.name) + ", " + problem.one.file + ": " + error.what());
          }
      }
    catch (const std::exception &error)
      {
        call_message(error.what());
        return call_error::element;
      }
  }
} // namespace wheelrail
