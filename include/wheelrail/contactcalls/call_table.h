#pragma once

#include <wheelrail/contactfiles/solve_cases.h>
#include <wheelrail/halfspace/subsurface.h>

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// Unit conventions of CONTACT's library: what one unit of the caller is in mm and N/mm2, and the body on
  /// which forces act that the caller gets (1: body 1, -1: body 2). Forces are in N, angles in rad.
  struct CallUnits
  {
    double length = 1, stress = 1;
    int    body = 1;
  };

  /// Error codes of CONTACT's library.
  namespace call_error
  {
    constexpr int force = -26, normal = -27, tangential = -28, tolerance = -29, element = -31, profile = -32,
                  grid = -34, input = -39, other = -99;
  }

  /// A contact problem of a result element: what is asked, and what came of it.
  struct CallProblem
  {
    ContactCase one;                                      ///< all but its kinematics, which follow from these
    double      approach = 0, normal_force = 0;           ///< [mm], [N]
    double      creepage_x = 0, creepage_y = 0, spin = 0; ///< in shifts [mm], [mm], [rad]; spin [rad/mm]
    double      relative_fx = 0, relative_fy = 0;         ///< over friction times normal force
    double      cpu_seconds = 0, wall_seconds = 0;        ///< of all its calculations

    std::optional<ContactCase>   before; ///< the case that was computed last
    CaseState                    state;
    std::optional<CaseSolution>  solved;     ///< of module 3, in the axes of CONTACT, SI units
    std::optional<WheelRailCase> wheel_rail; ///< of module 1
    std::map<int, ContactPoints> blocks;     ///< of points below the surface, in mm
    /// Of a patch and a block, 21 columns of each point, as CONTACT has them.
    std::map<std::pair<int, int>, std::vector<std::vector<double>>> below;

    bool
    computed() const
    {
      return solved || wheel_rail;
    }
  };

  /// A solved contact: of module 3, or a patch of module 1.
  struct CallResult
  {
    const HalfspaceSolution    &solution;
    std::optional<HertzContact> hertz;
    const WheelRailPatch       *patch = nullptr; ///< of module 1
  };

  /// The result of a contact problem or patch. Throws InputError for a patch that there is not.
  CallResult
  call_result(const CallProblem &problem, int icp);

  struct CallElement
  {
    int                        number = 0, module = 3;
    CallUnits                  units;
    std::string                folder; ///< of its files
    std::map<int, CallProblem> problems;
  };

  /// Where messages go to, and how many.
  struct CallOutput
  {
    std::string folder, name = "contact_addon";
    bool        screen = false; ///< all on the screen
    int         level  = 1;     ///< 0: none, 1: errors and refusals
  };

  /// What a function of the library is for.
  struct CallFor
  {
    const char *name;       ///< of the function
    const int  *ire, *icp;  ///< result element and contact problem
    int         module = 0; ///< 0: both
    bool        result = false;
  };

  /// The contact problem of wheel and rail.
  constexpr int whole = -1;

  /// A sentence into the file of the library, OUTDIR/NAME.out, and on the error stream.
  void
  call_message(const std::string &sentence);

  /// Sets what call_message() does.
  void
  set_call_output(const std::function<void(CallOutput &)> &set);

  /// Makes a result element, or makes it anew. Returns 0 or call_error::element.
  int
  make_element(int number, int module, const std::string &folder);
  void
  drop_element(int number);
  void
  drop_all_elements();

  /// An argument of a function: where it lies, and the numbers that are read from there.
  struct CallArgument
  {
    CallArgument(const int *pointer);
    CallArgument(const double *numbers);
    CallArgument(double *result);

    const void   *pointer;
    const double *numbers = nullptr;
    std::size_t   count   = 1;
    void         *cleared = nullptr; ///< results that are 0 where the function fails
    std::size_t   bytes   = 0;       ///< of those
  };

  /// An array of n times `each` numbers, which may be null where n is not positive.
  CallArgument
  when(const int *n, CallArgument array, std::size_t each = 1);

  /// A result that is 0 where the function fails.
  template <typename Number>
  CallArgument
  cleared(Number *result)
  {
    CallArgument one(result);
    one.cleared = result;
    one.bytes   = sizeof(Number);
    return one;
  }

  /// The same of an array.
  CallArgument
  cleared(const int *n, double *results);

  /// Says which function has an argument that is a null pointer or holds a number that is not finite, if it
  /// has one.
  bool
  faulty(const char *function, const std::vector<CallArgument> &arguments);

  /// A text of the caller, of a path's length at most, without blanks behind it.
  std::string
  call_text(const char *text, int length);

  /// Does `work` with the contact problem of a result element. A problem is made where a function that
  /// sets values first names it; module 1 has the one problem `whole`. Where an argument is faulty(), says so
  /// and returns call_error::input; where there is no such element or problem, the module is another, a
  /// result is missing, or `work` throws, call_error::element; else 0.
  int
  with_problem(const CallFor                                           &call,
               const std::vector<CallArgument>                         &arguments,
               const std::function<void(CallElement &, CallProblem &)> &work);

  /// Computes the contact: 0, a code of call_error, or the number of elements at the edge of the grid that
  /// touch.
  int
  calculate(CallElement &element, CallProblem &problem);

  /// Stresses at the points of all blocks in all patches, from the solution.
  void
  calculate_below(CallProblem &problem);
} // namespace wheelrail
