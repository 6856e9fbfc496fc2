#include <wheelrail/base/errors.h>
#include <wheelrail/contactcalls/call_table.h>
#include <wheelrail/contactcalls/contact_calls.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Solver, materials, friction, heat.

using namespace wheelrail;

namespace
{
  void
  need(const std::string &what, const int found, const int needed)
  {
    if (found != needed)
      throw InputError(what + " needs " + std::to_string(needed) + " values, not " + std::to_string(found));
  }

  /// MAXOUT as CONTACT sets it: one pass where pressure does not shift the surfaces.
  void
  set_passes(ContactCase &one)
  {
    if (one.material.alike())
      one.iteration.maxout = 1;
    else if (one.iteration.maxout <= 1)
      one.iteration.maxout = 10;
  }

  /// The constants behind the elastic ones of a digit M, in CONTACT's units.
  std::vector<double>
  material_constants(const int M, const double *v, const CallUnits &units)
  {
    switch (M)
      {
        case 1: // FG1 FG2 TC1 TC2
          return {v[0], v[1], v[2], v[3]};
        case 2: // FLX K0 ALFA BETA
          return {v[0] * units.length / units.stress, v[1], v[2], v[3]};
        case 3:
        case 5: // K0 ALFA BETA
          return {v[0], v[1], v[2]};
        case 4: // GG3 LAYTHK TAU_C0 K_TAU
          return {v[0] * units.stress,
                  v[1] * units.length,
                  v[2] * units.stress,
                  v[3] * units.stress / units.length};
        default:
          return {};
      }
  }

  void
  set_material_kind(ContactCase &one, const int M, const double *values, const CallUnits &units)
  {
    one.digits.material       = M;
    one.material.constants    = material_constants(M, values, units);
    one.material.constants_of = M;
  }

  void
  set_elastic(ContactCase     &one,
              const double     poisson1,
              const double     poisson2,
              const double     shear1,
              const double     shear2,
              const CallUnits &units)
  {
    if (std::min(poisson1, poisson2) < 0 || std::max(poisson1, poisson2) > 0.5 ||
        !(std::min(shear1, shear2) > 0))
      throw InputError("Poisson's ratios are not from 0 to 0.5, or shear moduli are not positive");
    one.material.poisson = {{poisson1, poisson2}};
    one.material.shear   = {{shear1 * units.stress, shear2 * units.stress}};
    set_passes(one);
  }

  constexpr int constants_of[] = {0, 4, 4, 3, 4, 3}; ///< of M, behind the elastic ones

  /// The constants of one line of a friction law, in CONTACT's units, and its memory.
  ContactFrictionLine
  friction_line(const int L, const double *v, const CallUnits &units, ContactFriction &friction)
  {
    const auto memory = [&](const double length, const double velocity) {
      friction.memory_length = length;
      friction.memory_speed  = velocity;
    };
    switch (L)
      {
        case 0: // the smaller one counts
          return {0, {std::min(v[0], v[1]), std::min(v[0], v[1])}, 1};
        case 5:
          {
            // Polach's law: falling from the first coefficient to A times it, exp(-B s)
            memory(0.001, 10);
            const double rest = v[1] * v[0];
            return {0, {rest, v[0] - rest, std::log(2.) * units.length / v[2], 0, 10000}, 1};
          }
        case 6:
          memory(v[4] * units.length, v[5] * units.length);
          return {0, {v[0], v[1], v[2], v[3]}, 1};
        default:
          memory(v[5] * units.length, v[6] * units.length);
          return {
            0,
            {v[0], v[1], std::max(1e-4, v[2] * units.length), v[3], std::max(1e-4, v[4] * units.length)},
            1};
      }
  }
} // namespace

void
cntc_setsolverflags(const int    *ire,
                    const int    *icp,
                    const int    *G,
                    const int    *n_integers,
                    const int    *integers,
                    const int    *n_reals,
                    const double *reals)
{
  constexpr int counts[7][2] = {{4, 1}, {0, 0}, {5, 4}, {5, 4}, {5, 2}, {5, 8}, {1, 1}};
  with_problem({__func__, ire, icp},
               {G, n_integers, when(n_integers, integers), n_reals, when(n_reals, reals)},
               [&](CallElement &, CallProblem &problem) {
                 if (*G < 0 || *G > 6)
                   throw InputError("G = " + std::to_string(*G) + " is unknown; 0 to 6 are known");
                 need("G = " + std::to_string(*G) + ", its integers,", *n_integers, counts[*G][0]);
                 need("G = " + std::to_string(*G) + ", its reals,", *n_reals, counts[*G][1]);
                 if (*G == 1 || *G == 6) // as before; sensitivities
                   return;
                 ContactIteration &iteration = problem.one.iteration;
                 problem.one.digits.solver   = *G;
                 iteration.maxgs             = std::max(1, integers[0]);
                 iteration.maxin             = std::max(1, integers[1]);
                 iteration.maxnr             = std::max(1, integers[2]);
                 iteration.maxout            = std::max(1, integers[3]);
                 iteration.eps               = reals[0];
                 iteration.initial_slip      = *G >= 2 && *G <= 4 ? integers[4] : 0;
               });
}

void
cntc_setmaterialparameters(const int *ire, const int *icp, const int *M, const int *n, const double *values)
{
  with_problem(
    {__func__, ire, icp}, {M, n, when(n, values)}, [&](CallElement &element, CallProblem &problem) {
      ContactCase      &one  = problem.one;
      const std::string name = "M = " + std::to_string(*M);
      if (*M >= 10 && *M <= 12)
        {
          one.digits.damping = *M - 10;
          if (*M == 12)
            {
              need(name, *n, 4);
              one.material.damping.assign(values, values + 4);
            }
          return;
        }
      if (*M < 0 || *M > 5)
        throw InputError(name + " is unknown; 0 to 5 and 10 to 12 are known");
      need(name, *n, 4 + constants_of[*M]);
      set_elastic(one, values[0], values[1], values[2], values[3], element.units);
      set_material_kind(one, *M, values + 4, element.units);
    });
}

void
cntc_setmaterialproperties(const int    *ire,
                           const int    *icp,
                           const double *shear1,
                           const double *poisson1,
                           const double *shear2,
                           const double *poisson2)
{
  with_problem({__func__, ire, icp},
               {shear1, poisson1, shear2, poisson2},
               [&](CallElement &element, CallProblem &problem) {
                 set_elastic(problem.one, *poisson1, *poisson2, *shear1, *shear2, element.units);
               });
}

void
cntc_setinterfaciallayer(const int *ire, const int *icp, const int *M, const int *n, const double *values)
{
  with_problem(
    {__func__, ire, icp}, {M, n, when(n, values)}, [&](CallElement &element, CallProblem &problem) {
      if (*M < 0 || *M > 5)
        throw InputError("M = " + std::to_string(*M) + " is unknown; 0 to 5 are known");
      if (*M > 0)
        need("M = " + std::to_string(*M), *n, constants_of[*M]);
      set_material_kind(problem.one, *M, values, element.units);
    });
}

void
cntc_settemperaturedata(const int *ire, const int *icp, const int *H, const int *n, const double *values)
{
  with_problem(
    {__func__, ire, icp}, {H, n, when(n, values)}, [&](CallElement &element, CallProblem &problem) {
      ContactMaterial &material = problem.one.material;
      if (*H == 3)
        {
          need("H = 3", *n, 9);
          material.heat.assign(values, values + 8);
          for (const int body : {0, 4})
            {
              material.heat[std::size_t(body + 2)] /= element.units.length;
              material.heat[std::size_t(body + 3)] /= std::pow(element.units.length, 3);
            }
          material.plastic_heat = values[8];
        }
      else if (*H != 0 && *H != 1)
        throw InputError("H = " + std::to_string(*H) + " is unknown; 0, 1 and 3 are known");
      if (*H != 1)
        problem.one.digits.heat = *H;
    });
}

void
cntc_setfrictionmethod(const int *ire, const int *icp, const int *VL, const int *n, const double *values)
{
  constexpr int counts[] = {2, 0, 7, 7, 7, 3, 6};
  with_problem(
    {__func__, ire, icp}, {VL, n, when(n, values)}, [&](CallElement &element, CallProblem &problem) {
      const int V = *VL / 10, L = *VL % 10;
      if (*VL < 0 || V > 2 || L > 6)
        throw InputError("the method " + std::to_string(*VL) + " is unknown: 10 V + L, V to 2, L to 6");
      if (L == 1)
        return;
      if (V > 0 && element.module != 1)
        throw InputError("V = " + std::to_string(V) + " is for module 1 only");
      const bool led   = V > 0;
      const int  lines = led && *n > 0 ? int(std::lround(values[0])) : 1;
      need("the method " + std::to_string(*VL), *n, (led ? 1 : 0) + lines * (counts[L] + (led ? 1 : 0)));
      ContactFriction friction;
      friction.line   = 1;
      const double *v = values + (led ? 1 : 0);
      for (int k = 0; k < lines; ++k, v += counts[L])
        {
          const double place = led ? (V == 2 ? element.units.length : 1) * *v++ : 0;
          friction.lines.push_back(friction_line(L, v, element.units, friction));
          friction.lines.back().place = place;
        }
      problem.one.friction         = friction;
      problem.one.digits.variation = V;
      problem.one.digits.law       = L == 5 ? 4 : L;
    });
}
