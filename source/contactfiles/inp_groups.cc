#include <wheelrail/contactfiles/inp_groups.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Kinematic constants of module 3, which every case states.
    void
    read_kinematics(InpWords &words, ContactCase &one)
    {
      const ControlDigits &d = one.digits;
      const InpGroup       group =
        words.group(std::string(d.normal == 0 ? "PEN " : "FN ") + (d.forces >= 1 ? "FX " : "CKSI ") +
                    (d.forces == 2 ? "FY " : "CETA ") + "CPHI {SPINXO} {SPINYO}");
      const auto &v  = group.values;
      one.kinematics = {v[0], v[1], v[2], v[3], group.value(4), group.value(5), group.line};
      if (d.normal == 1 && !(v[0] > 0))
        words.fail(group.line, "FN is not positive, as a force that presses is");
    }

    std::string
    friction_names(const int law)
    {
      return law == 0 ? "FSTAT FKIN" : law == 6 ? "FREF TREF DFHEAT DTHEAT" : "FKIN F1 SH1 F2 SH2";
    }

    /// Method and variant of C = 4, in module 3 the surface, too.
    void
    read_surface(InpWords &words, ContactCase &one)
    {
      const InpGroup group = words.group(one.module == 1 ? "#IF_METH #VARIANT" : "#IF_METH #VARIANT #NN");
      one.influence        = {int(group.values[0]), int(group.values[1]), {}, "", group.line};
      if (one.module == 3 && group.value(2) < 1)
        words.fail(group.line, "NN, the number of points of the surface of C = 4, is not positive");
      for (int k = 0; k < int(group.value(2)); ++k)
        {
          const InpGroup pair    = words.group("Y @ALPHA");
          auto          &surface = one.influence.surface;
          if (k > 0 && pair.values[0] <= surface.back().first)
            words.fail(pair.line, "Y of the surface of C = 4 does not ascend");
          surface.emplace_back(pair.values[0], pair.values[1]);
        }
    }
  } // namespace


  void
  read_friction(InpWords &words, ContactCase &one, const std::size_t count)
  {
    const ControlDigits &d     = one.digits;
    const bool           led   = d.variation == 1 || d.variation == 2;
    const std::string    names = (led ? (d.variation == 1 ? "@ALPHA " : "SVF ") : "") + friction_names(d.law);
    one.friction               = {};
    for (std::size_t k = 0; k < count; ++k)
      {
        const InpGroup group = words.group(names);
        if (k == 0)
          one.friction.line = group.line;
        one.friction.lines.push_back({led ? group.values[0] : 0, group.from(led ? 1 : 0), group.line});
        const std::vector<double> &c = one.friction.lines.back().constants;
        if (d.law == 0 && std::abs(c[0] - c[1]) > 1e-3 * std::max(std::abs(c[0]), std::abs(c[1])))
          words.fail(group.line, "FSTAT and FKIN differ; Coulomb's law (L = 0) needs equal ones");
        if (d.law >= 2 && d.law <= 4 && ((c[1] != 0 && c[2] <= 0) || (c[3] != 0 && c[4] <= 0)))
          words.fail(group.line,
                     "SH1 or SH2, at which half of a term of the friction law is gone, is not positive");
        if (d.law == 6 && (c[0] <= 0 || c[3] <= 0))
          words.fail(
            group.line,
            "FREF or DTHEAT, the friction and the range of temperatures over which it changes, is not "
            "positive");
        if (led && k > 0 && one.friction.lines[k - 1].place >= group.values[0])
          words.fail(group.line, "the lines of the friction variation do not rise in their first value");
      }
    if (d.law >= 2)
      {
        const InpGroup group       = words.group("MEMDST MEM_S0");
        one.friction.memory_length = group.values[0];
        one.friction.memory_speed  = group.values[1];
      }
  }

  void
  read_general_groups(InpWords &words, ContactCase &one)
  {
    const ControlDigits &written = one.written, &d = one.digits;
    if (written.solver != 1)
      {
        const InpGroup group = words.group("#MAXGS #MAXIN #MAXNR #MAXOUT EPS {#NPOT_MAX}");
        const auto    &v     = group.values;
        one.iteration        = {int(v[0]),
                                int(v[1]),
                                int(v[2]),
                                int(v[3]),
                                v[4],
                                group.value(5, one.iteration.largest),
                                0,
                                group.line};
        if (written.solver == 2 || written.solver == 3)
          one.iteration.initial_slip = int(words.group("OMEGAH OMEGAS #INISLP OMGSLP").values[2]);
        else if (written.solver == 4)
          one.iteration.initial_slip = int(words.group("#INISLP OMGSLP").values[0]);
        else if (written.solver == 5)
          words.group("FDECAY BETATH KDOWFB D_IFC D_LIN D_CNS D_SLP POW_S");
      }
    if (one.module == 3)
      read_kinematics(words, one);
    if (written.law != 1 && d.variation != 3)
      {
        std::size_t count = 1;
        if (d.variation != 0)
          {
            const InpGroup group = words.group("#NVF");
            if (group.values[0] < 1 || group.values[0] > 10)
              words.fail(group.line, "NVF, the lines of the friction variation, is not from 1 to 10");
            count = std::size_t(group.values[0]);
          }
        read_friction(words, one, count);
      }
    if (one.module == 3 && written.influence >= 2 && d.motion >= 2)
      {
        const InpGroup group = words.group("@CHI DQ VELOC {FACPHI}");
        const auto    &v     = group.values;
        one.rolling          = {v[0], v[1], v[2], group.value(3, 1. / 6), group.line};
        if (v[1] <= 0 || v[2] <= 0)
          words.fail(group.line,
                     "DQ and VELOC, the rolled distance of a step and the velocity, are not positive");
      }
  }

  void
  read_material_groups(InpWords &words, ContactCase &one)
  {
    const ControlDigits &d        = one.digits;
    ContactMaterial     &material = one.material;
    if (one.written.influence == 4)
      read_surface(words, one);
    if (one.written.influence == 9)
      {
        const InpGroup group = words.group("'CFNAME");
        one.influence        = {0, 4, {}, group.text, group.line};
      }
    if (one.written.influence >= 2)
      {
        const InpGroup group = words.group("POISS1 POISS2 GG1 GG2");
        const auto    &v     = group.values;
        if (std::min(v[0], v[1]) < 0 || std::max(v[0], v[1]) > 0.5 || std::min(v[2], v[3]) <= 0)
          words.fail(
            group.line,
            "Poisson's ratios POISS1, POISS2 are not from 0 to 0.5, or the shear moduli GG1, GG2 are "
            "not positive");
        material.poisson = {{v[0], v[1]}};
        material.shear   = {{v[2], v[3]}};
        material.line    = group.line;
        if (d.bound == 1)
          material.normal_flexibility = words.group("FLXZ").values[0];
        const char *const names[] = {"",
                                     "FG1 FG2 TC1 TC2",
                                     "FLX K0 ALFA BETA",
                                     "K0 ALFA BETA",
                                     "GG3 LAYTHK TAU_C0 K_TAU",
                                     "K0 ALFA BETA"};
        material.constants.clear();
        if (d.material > 0)
          material.constants = words.group(names[d.material]).values;
        material.constants_of = d.material;
      }
    if (one.written.damping == 2)
      material.damping = words.group("CDAMPN CDAMPT DFNMAX DFTMAX").values;
    if (one.written.heat == 3)
      {
        material.heat.clear();
        for (int body = 1; body <= 2; ++body)
          {
            const InpGroup group = words.group("BKTEMP HEATCP LAMBDA DENS");
            if (body == 1)
              material.heat_line = group.line;
            if (std::min({group.values[1], group.values[2], group.values[3]}) <= 0)
              words.fail(group.line,
                         "HEATCP, LAMBDA and DENS, what a body takes up of heat, are not positive");
            material.heat.insert(material.heat.end(), group.values.begin(), group.values.end());
          }
        if (d.material == 4)
          material.plastic_heat = words.group("BETAPL").values[0];
      }
  }

} // namespace wheelrail
