#include <wheelrail/base/format_text.h>
#include <wheelrail/contactfiles/printed_blocks.h>
#include <wheelrail/contactfiles/printed_patch.h>

#include <cstddef>

namespace wheelrail
{
  namespace
  {
    using Row = std::vector<double>;

    std::string
    digits(const ContactCase &one)
    {
      const ControlDigits &d = one.written;
      std::string          lines;
      if (one.module == 1)
        lines =
          text(" CPBTNFS.  CONFIG%2d, PVTIME%2d, BOUND %2d, TANG  %2d, NORM  %2d, FORCE %2d, STRESS%2d\n",
               d.side,
               d.past,
               d.bound,
               d.motion,
               d.normal,
               d.forces,
               d.subsurface) +
          text(" VLDCMZE.  VARFRC%2d, FRCLAW%2d, DISCNS%2d, INFLCF%2d, MATER %2d, ZTRACK%2d, EWHEEL%2d\n",
               d.variation,
               d.law,
               d.grid,
               d.influence,
               d.material,
               d.geometry,
               d.extra);
      else
        lines =
          text("  PBTNFS.            PVTIME%2d, BOUND %2d, TANG  %2d, NORM  %2d, FORCE %2d, STRESS%2d\n",
               d.past,
               d.bound,
               d.motion,
               d.normal,
               d.forces,
               d.subsurface) +
          (d.variation != 0 ? text(" VLDCMZE.  VARFRC%2d,", d.variation) : "  LDCMZE.           ") +
          text(" FRCLAW%2d, DISCNS%2d, INFLCF%2d, MATER %2d, RZNORM%2d, RZTANG%2d\n",
               d.law,
               d.grid,
               d.influence,
               d.material,
               d.geometry,
               d.extra);
      return lines +
             text(" HGIAOWR.  HEAT  %2d, GAUSEI%2d, IESTIM%2d, MATFIL%2d, OUTPUT%2d, FLOW  %2d, RETURN%2d\n",
                  d.heat,
                  d.solver,
                  d.start,
                  d.matfile,
                  d.print,
                  d.trace,
                  d.after);
    }

    const char *
    motion_name(const int motion)
    {
      return motion == 1 ? "SHIFT TRANSIENT" : motion == 2 ? "TRANSIENT ROLLING" : "STEADY STATE ROLLING";
    }

    /// What is solved.
    std::string
    problem_lines(const ContactCase &one)
    {
      const ControlDigits &d     = one.digits;
      const std::string    moved = d.motion == 1 ? "SHIFT" : "CREEPAGE";
      std::string          lines;
      if (one.module == 1)
        lines = std::string(" VERTICAL PROBLEM WITH PRESCRIBED ") +
                (d.normal == 1 ? "VERTICAL FORCE" : "POSITION") + ", FULL SOLUTION\n";
      else if (d.bound == 2 || d.bound == 3)
        lines = std::string(" NORMAL PROBLEM SKIPPED, ") + (d.bound == 2 ? "ELLIPTICAL" : "PARABOLICAL") +
                " TRACTION BOUND\n";
      else
        lines = std::string(" NORMAL PROBLEM WITH PRESCRIBED ") +
                (d.normal == 1 ? "NORMAL FORCE" : "APPROACH") + ", FULL SOLUTION\n";
      if (d.motion == 0)
        return lines;
      if (one.module == 1)
        lines += std::string(" ") + motion_name(d.motion) + ", " + (d.forces == 1 ? "X-FORCE" : moved) +
                 " PRESCRIBED\n";
      else
        lines += std::string(" ") + motion_name(d.motion) + "\n " +
                 (d.forces == 0   ? moved
                  : d.forces == 1 ? "X-FORCE,  Y-CREEPAGE"
                                  : "TANGENTIAL FORCE") +
                 " PRESCRIBED\n";
      return lines + (one.iteration.maxout == 1
                        ? " JOHNSON\"S METHOD IS USED FOR THE FRICTIONAL STRESS\n"
                        : text(" PANAGIOTOPOULOS\" METHOD IS USED FOR THE FRICTIONAL STRESS. MAXOUT=%3d\n",
                               one.iteration.maxout));
    }

    std::string
    materials(const ContactCase &one)
    {
      const ContactMaterial &m  = one.material;
      const double           g1 = m.shear[0], g2 = m.shear[1], G = 2 / (1 / g1 + 1 / g2);
      const double           nu    = G * (m.poisson[0] / g1 + m.poisson[1] / g2) / 2;
      const double           K     = G * ((1 - 2 * m.poisson[0]) / g1 - (1 - 2 * m.poisson[1]) / g2) / 4;
      std::string            lines = printed_block("MATERIAL CONSTANTS",
                                        "     NU          G           AK          EPS",
                                        {nu, G, K, one.iteration.eps}) +
                          printed_block("",
                                        one.module == 1 ? "    POISS(R)    POISS(W)     GG(R)       GG(W)"
                                                        : "    POISS(1)    POISS(2)     GG(1)       GG(2)",
                                        {m.poisson[0], m.poisson[1], g1, g2});
      if (one.digits.material == 4)
        lines += printed_block(
          "INTERFACIAL LAYER PARAMETERS", "     GG3         LAYTHK      TAU_C0      K_TAU", m.constants);
      return lines;
    }

    std::string
    heat(const ContactCase &one)
    {
      const std::vector<double> &v     = one.material.heat;
      const bool                 layer = one.digits.material == 4;
      Row                        first(v.begin(), v.begin() + 4);
      if (layer)
        first.push_back(one.material.plastic_heat);
      return std::string("     BKTEMP      HEATCP      LAMBDA      DENSITY") +
             (layer ? "     BETAPL\n" : "\n") + printed_row(first) +
             printed_row(Row(v.begin() + 4, v.end())) + "\n";
    }

    std::string
    friction(const ContactCase &one)
    {
      const ControlDigits &d      = one.digits;
      std::string          names  = law_heading(d.law);
      const bool           varied = d.variation != 0;
      if (varied)
        names = (d.variation == 1   ? "      ALPHA  "
                 : d.variation == 2 ? "      SVF    "
                                    : "       IY    ") +
                names.substr(2);
      std::string lines = " FRICTION LAW PARAMETERS\n" + names + "\n";
      int         place = 0;
      for (const ContactFrictionLine &line : one.friction.lines)
        {
          Row values = line.constants;
          ++place;
          if (varied)
            values.insert(values.begin(), d.variation == 3 ? place : line.place);
          lines += printed_row(values);
        }
      return lines + "\n";
    }

    std::string
    profile_lines(const char *body, const ContactProfile &p)
    {
      return text(" %s PROFILE \"", body) + p.file + "\"\n   MIRRORY     MIRRORZ     ISMOOTH      LAMBDA\n" +
             text("%7d%12d%12d   %12.4f\n\n", p.mirror_y, p.mirror_z, p.smoothing_method, p.smoothing);
    }

    /// Where the wheelset stands, how it moves and how it is bent.
    std::string
    wheelset_lines(const ContactWheelset &w, const WheelRailCase &solved, const bool roller)
    {
      std::string lines = text(
        " WHEEL-SET POSITION AND VELOCITY\n     %s        Y_WS        Z_WS        ROLL_WS     YAW_WS    "
        "  PITCH_WS\n  %12s%12s%12.4f%12s%12s%12s\n\n",
        roller ? "X_WS" : "S_WS",
        printed_number(w.position[0]).c_str(),
        printed_number(w.position[1]).c_str(),
        solved.height / millimetre,
        printed_number(w.position[3]).c_str(),
        printed_number(w.position[4]).c_str(),
        printed_number(w.position[5]).c_str());
      lines += text(
        "    %s  VY_WS       VZ_WS       VROLL_WS    VYAW_WS     VPITCH_WS\n"
        "  %12s%12s%12s%12s%12s%12.7f\n\n",
        roller ? "VPITCH_ROL " : " VX_WS     ",
        (roller ? text("%.7f", w.velocity[0]) : printed_number(w.velocity[0])).c_str(),
        printed_number(w.velocity[1]).c_str(),
        printed_number(w.velocity[2]).c_str(),
        printed_number(w.velocity[3]).c_str(),
        printed_number(w.velocity[4]).c_str(),
        solved.pitch_rate);
      bool bent = false;
      for (const double f : w.flexible)
        bent |= f != 0;
      if (bent)
        lines +=
          " FLEXIBLE WHEEL-SET DEVIATIONS\n"
          "     DXWHL       DYWHL       DZWHL       DROLLW      DYAWW       DPITCHW\n" +
          printed_row(Row(w.flexible.begin(), w.flexible.begin() + 6)) +
          "     VXWHL       VYWHL       VZWHL       VROLLW      VYAWW       VPITCHW\n" +
          printed_row(Row(w.flexible.begin() + 6, w.flexible.end())) + "\n";
      return lines;
    }

    /// What the case read of track and wheelset, and where the wheelset stands.
    std::string
    wheel_rail_head(const ContactCase &one, const WheelRailCase &solved)
    {
      const ContactElements &e = one.elements;
      const ContactTrack    &t = one.track;
      const ContactWheelset &w = one.wheelset;
      std::string            lines;
      if (one.written.grid >= 2)
        lines += printed_block("DISCRETISATION PARAMETERS",
                               "     DX          DS          DQREL       A_SEP       D_SEP       D_COMB",
                               {e.dx, e.ds, e.relative_step, e.a_sep, e.d_sep, e.d_comb});
      if (one.written.geometry == 3)
        lines += profile_lines(one.digits.side >= 4 ? "ROLLER" : "RAIL", t.profile);
      if (one.written.geometry == 1 || one.written.geometry == 3)
        lines += t.gauge_height > 0
                   ? printed_block("TRACK DIMENSIONS AND RAIL POSITION",
                                   "    GAUGHT      GAUGWD        CANT        CURV",
                                   {t.gauge_height, t.gauge, t.cant, t.curvature})
                   : printed_block("TRACK DIMENSIONS AND RAIL POSITION",
                                   "    GAUGHT      RAILY0      RAILZ0        CANT        CURV",
                                   {t.gauge_height, t.rail_y, t.rail_z, t.cant, t.curvature});
      const bool roller   = one.digits.side >= 4;
      bool       deviates = false;
      for (const double d : t.deviation)
        deviates |= d != 0;
      if (deviates)
        lines += printed_block("RAIL IRREGULARITY",
                               "     DYRAIL      DZRAIL      DROLLR      VYRAIL      VZRAIL      VROLLR",
                               Row(t.deviation.begin(), t.deviation.end()));
      if (one.digits.forces == 3)
        lines += printed_block("MASSLESS RAIL DEFLECTION",
                               "     KY_RAIL     DY_DEFL     FY_RAIL     KZ_RAIL     DZ_DEFL     FZ_RAIL",
                               {t.springs[0],
                                solved.deflection[1] / millimetre,
                                t.springs[1],
                                t.springs[2],
                                solved.deflection[2] / millimetre,
                                t.springs[3]});
      if (one.written.extra == 3 || one.written.extra == 5)
        lines += profile_lines("WHEEL", w.profile);
      return lines + wheelset_lines(w, solved, roller);
    }

    /// Digits, kind of problem, materials and friction.
    std::string
    laws(const ContactCase &one)
    {
      std::string lines = digits(one) + problem_lines(one) + "\n";
      if (one.written.influence >= 2)
        lines += materials(one);
      if (one.written.heat == 3)
        lines += heat(one);
      if (one.written.law != 1 && one.digits.motion != 0)
        lines += friction(one);
      return lines;
    }

    std::string
    wheel_rail_blocks(const ContactCase &one, const WheelRailCase &solved)
    {
      const std::size_t n     = solved.patches.size();
      std::string       lines = text("\n WHEEL-%s CONTACT, %s WHEEL,%3zu CONTACT %s\n\n",
                               one.digits.side >= 4 ? "ROLLER" : "RAIL",
                               one.digits.side == 0 || one.digits.side == 4 ? "LEFT" : "RIGHT",
                               n,
                               n == 1 ? "PATCH" : "PATCHES") +
                          laws(one);
      lines += wheel_rail_head(one, solved);
      const Vector3 &t = solved.force_track, &w = solved.force_wheelset;
      lines += printed_block(one.digits.side >= 4 ? "TOTAL FORCES ON ROLLER" : "TOTAL FORCES ON RAIL",
                             "     FX(TR)      FY(TR)      FZ(TR)      FX(WS)      FY(WS)      FZ(WS)",
                             {t[0], t[1], t[2], w[0], w[1], w[2]});
      for (std::size_t k = 0; k < n; ++k)
        lines += patch_lines(one, solved.patches[k], k + 1);
      return lines;
    }

    std::string
    basic_blocks(const ContactCase &one, const CaseSolution &solved)
    {
      const ControlDigits     &d     = one.digits;
      const HalfspaceSolution &s     = solved.solution;
      const ContactKinematics &k     = one.kinematics;
      std::string              lines = "\n" + laws(one);
      const bool               shift = d.motion == 1;
      const double             step  = s.step > 0 ? s.step : s.grid.dx;
      if (d.motion != 0)
        {
          const std::string x = d.forces >= 1 ? "FX/FSTAT/FN " : "  CKSI      ",
                            y = d.forces == 2 ? "FY/FSTAT/FN " : "  CETA      ";
          lines += shift
                     ? printed_block("KINEMATIC CONSTANTS",
                                     "     DT          VELOC     " + x + y + "  CPHI",
                                     {1, 1, k.x, k.y, k.spin})
                     : printed_block(
                         "KINEMATIC CONSTANTS",
                         "     CHI         DQ          VELOC     " + x + y + "  CPHI",
                         {one.rolling.direction, step / millimetre, one.rolling.velocity, k.x, k.y, k.spin});
        }
      const double bound =
        d.variation == 3 || d.motion == 0 ? 1 : friction_of(one, one.friction.lines.front()).at(0);
      const PrintedPatch patch{bound, shift ? 1 : millimetre * one.rolling.velocity, one.rolling.direction};
      return lines + solution_lines(one, s, patch);
    }
  } // namespace


  std::string
  printed_blocks(const std::vector<ContactCase> &cases, const std::vector<CaseResult> &results)
  {
    std::string all;
    for (std::size_t k = 0; k < cases.size(); ++k)
      {
        const ContactCase &one = cases[k];
        all += text("\n Case %5d", one.number) +
               (one.element > 0 ? text(", result element %3d", one.element) : std::string()) + "\n";
        for (const std::string &sentence : results[k].refused)
          all += " " + sentence + "\n";
        if (results[k].wheel_rail)
          all += wheel_rail_blocks(one, *results[k].wheel_rail);
        if (results[k].solved)
          all += basic_blocks(one, *results[k].solved);
      }
    return all;
  }
} // namespace wheelrail
