#include <wheelrail/base/format_text.h>
#include <wheelrail/contactfiles/printed_blocks.h>
#include <wheelrail/contactfiles/printed_elements.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace wheelrail
{
  namespace
  {
    using Row = std::vector<double>;

    /// Columns of twelve characters.
    std::string
    row(const Row &values)
    {
      std::string line = "  ";
      for (const double value : values)
        line += text("%12s", printed_number(value).c_str());
      return line + "\n";
    }

    std::string
    block(const std::string &title, const std::string &names, const Row &values)
    {
      return (title.empty() ? "" : " " + title + "\n") + names + "\n" + row(values) + "\n";
    }

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
          (d.variation != 0 ? text(" VLDCMZE.  VARFRC%2d,", d.variation) : text("  LDCMZE.           ")) +
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
      std::string            lines = block("MATERIAL CONSTANTS",
                                "     NU          G           AK          EPS",
                                {nu, G, K, one.iteration.eps}) +
                          block("",
                                one.module == 1 ? "    POISS(R)    POISS(W)     GG(R)       GG(W)"
                                                : "    POISS(1)    POISS(2)     GG(1)       GG(2)",
                                {m.poisson[0], m.poisson[1], g1, g2});
      if (one.digits.material == 4)
        lines += block(
          "INTERFACIAL LAYER PARAMETERS", "     GG3         LAYTHK      TAU_C0      K_TAU", m.constants);
      return lines;
    }

    std::string
    friction(const ContactCase &one)
    {
      const ControlDigits &d = one.digits;
      std::string          names =
        d.law == 0 ? "     FSTAT       FKIN" : "     FKIN        FEXP1       SABSH1      FEXP2       SABSH2";
      const bool varied = d.variation != 0;
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
          lines += row(values);
        }
      return lines + "\n";
    }

    std::string
    profile_lines(const char *body, const ContactProfile &p)
    {
      return text(" %s PROFILE \"", body) + p.file + "\"\n   MIRRORY     MIRRORZ     ISMOOTH      LAMBDA\n" +
             text("%7d%12d%12d   %12.4f\n\n", p.mirror_y, p.mirror_z, p.smoothing_method, p.smoothing);
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
        lines += block("DISCRETISATION PARAMETERS",
                       "     DX          DS          DQREL       A_SEP       D_SEP       D_COMB",
                       {e.dx, e.ds, e.relative_step, e.a_sep, e.d_sep, e.d_comb});
      if (one.written.geometry == 3)
        lines += profile_lines("RAIL", t.profile);
      if (one.written.geometry == 1 || one.written.geometry == 3)
        lines += t.gauge_height > 0 ? block("TRACK DIMENSIONS AND RAIL POSITION",
                                            "    GAUGHT      GAUGWD        CANT        CURV",
                                            {t.gauge_height, t.gauge, t.cant, t.curvature})
                                    : block("TRACK DIMENSIONS AND RAIL POSITION",
                                            "    GAUGHT      RAILY0      RAILZ0        CANT        CURV",
                                            {t.gauge_height, t.rail_y, t.rail_z, t.cant, t.curvature});
      bool deviates = false;
      for (const double d : t.deviation)
        deviates |= d != 0;
      if (deviates)
        lines += block("RAIL IRREGULARITY",
                       "     DYRAIL      DZRAIL      DROLLR      VYRAIL      VZRAIL      VROLLR",
                       Row(t.deviation.begin(), t.deviation.end()));
      if (one.written.extra == 3 || one.written.extra == 5)
        lines += profile_lines("WHEEL", w.profile);
      lines += text(
        " WHEEL-SET POSITION AND VELOCITY\n     S_WS        Y_WS        Z_WS        ROLL_WS     YAW_WS    "
        "  PITCH_WS\n  %12s%12s%12.4f%12s%12s%12s\n\n",
        printed_number(w.position[0]).c_str(),
        printed_number(w.position[1]).c_str(),
        solved.height / millimetre,
        printed_number(w.position[3]).c_str(),
        printed_number(w.position[4]).c_str(),
        printed_number(w.position[5]).c_str());
      lines += text(
        "     VX_WS       VY_WS       VZ_WS       VROLL_WS    VYAW_WS     VPITCH_WS\n"
        "  %12s%12s%12s%12s%12s%12.7f\n\n",
        printed_number(w.velocity[0]).c_str(),
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
          row(Row(w.flexible.begin(), w.flexible.begin() + 6)) +
          "     VXWHL       VYWHL       VZWHL       VROLLW      VYAWW       VPITCHW\n" +
          row(Row(w.flexible.begin() + 6, w.flexible.end())) + "\n";
      return lines;
    }

    std::string
    totals(const ContactCase &one, const HalfspaceSolution &s, const PrintedPatch &patch)
    {
      const ControlDigits &d     = one.digits;
      const bool           basic = one.module == 3, shift = d.motion == 1;
      const double         unit = shift ? millimetre : 1,
                   G            = 2 / (1 / one.material.shear[0] + 1 / one.material.shear[1]);
      const double bound        = patch.friction * s.fn;
      const auto   relative     = [&](const double force) { return bound > 0 ? force / bound : 0.; };
      const bool   by_rows      = d.variation == 3;
      std::string  names = "     FN/G    ", x = by_rows ? "   FX/FN    " : "  FX/FSTAT/FN", y;
      y            = by_rows ? "   FY/FN    " : basic ? " FY/FSTAT/FN " : " FS/FSTAT/FN ";
      double first = relative(s.fx), second = relative(s.fy);
      if (basic && d.motion != 0 && d.forces >= 1)
        {
          x     = shift ? "   SHIFT X   " : "   CREEP X   ";
          first = s.xi / unit;
        }
      if (basic && d.motion != 0 && d.forces == 2)
        {
          y      = shift ? "  SHIFT Y   " : "  CREEP Y   ";
          second = s.eta / unit;
        }
      const std::string power = shift && basic ? "FRIC.WORK" : "FRIC.POWER";
      return " TOTAL FORCES, TORSIONAL MOMENT, ELASTIC ENERGY, FRICTIONAL POWER\n" +
             std::string(basic ? "     FN          FX          FY          MZ         ELAST.EN.   "
                               : "     FN          FX          FS          MN         ELAST.EN.   ") +
             power + "\n" +
             row({s.fn,
                  d.motion == 0 ? 0 : s.fx,
                  d.motion == 0 ? 0 : s.fy,
                  s.spin_moment / millimetre,
                  elastic_energy(s),
                  friction_power(s, patch.velocity)}) +
             names + x + y + "  APPROACH     PMAX\n" +
             row({s.fn / G, first, second, s.approach / millimetre, s.peak_pressure / megapascal}) + "\n";
    }

    std::string
    statistics(const HalfspaceSolution &s)
    {
      const double element = s.grid.element_area();
      return " CONTACT STATISTICS\n N: NUMBER OF ELEMENTS IN REGION,  I: NUMBER OF ITERATIONS,\n"
             " POT: POTENTIAL CONTACT AREA,  CON: CONTACT,  ADH: ADHESION\n"
             "    NPOT   NCON   NADH  NSLIP  INORM  ITANG\n" +
             text("%8d%7d%7ld%7ld%7d%7d\n\n",
                  s.grid.size(),
                  s.contact_elements,
                  std::lround(s.adhesion_area / element),
                  std::lround(s.slip_area / element),
                  s.normal_iterations,
                  s.newton_steps);
    }

    std::string
    elements(const ContactCase &one, const HalfspaceSolution &s, const PrintedPatch &patch)
    {
      std::string lines;
      if (one.digits.print >= 3)
        lines += contact_picture(s, one.digits.motion >= 2, patch.direction);
      if (one.digits.print >= 5)
        lines += element_table(s, one.digits.motion, patch);
      return lines;
    }

    std::string
    patch_lines(const ContactCase &one, const WheelRailPatch &p, const std::size_t number)
    {
      std::string earlier;
      for (const int k : p.earlier)
        earlier += text("%s%3d", earlier.empty() ? "" : ",", k);
      const bool  goes_on = one.digits.motion == 1 || one.digits.motion == 2;
      std::string lines   = text(" ----- DATA FOR CONTACT PATCH %2zu ", number);
      if (goes_on && one.digits.past != 2)
        lines += earlier.empty() ? "(NEW PATCH) " : "(PREV" + earlier + ") ";
      lines +=
        "-----\n\n CONTACT REFERENCE LOCATION\n"
        "     XCP(TR)     YCP(TR)     ZCP(TR)    DELTCP(TR)   YCP(R)      ZCP(R)\n" +
        text("  %12.4f%12.4f%12.4f%12.4f%12.4f%12.4f\n\n",
             p.in_track[0] / millimetre,
             p.in_track[1] / millimetre,
             p.in_track[2] / millimetre,
             p.angle,
             p.on_rail[1] / millimetre,
             p.on_rail[2] / millimetre) +
        "     XCP(W)      YCP(W)      ZCP(W)\n" +
        text("  %12.4f%12.4f%12.4f\n\n",
             p.on_wheel[0] / millimetre,
             p.on_wheel[1] / millimetre,
             p.on_wheel[2] / millimetre);
      const bool   shift = one.digits.motion == 1;
      const double unit  = shift ? millimetre : 1;
      if (one.digits.motion != 0)
        {
          if (one.digits.variation != 0)
            lines += block("FRICTION LAW PARAMETERS", "     FSTAT       FKIN", {p.friction, p.friction});
          lines += block("KINEMATIC CONSTANTS",
                         "     CHI         DQ          VELOC       CKSI        CETA        CPHI",
                         {0,
                          shift ? 1 : p.step / millimetre,
                          shift ? 1 : p.velocity / millimetre,
                          p.creepage / unit,
                          p.lateral_creepage / unit,
                          shift ? p.spin : p.spin * millimetre});
          if (goes_on)
            lines += block("", "     SPINXO      SPINYO", {p.origin_x / millimetre, p.origin_y / millimetre});
        }
      const PrintedPatch patch{p.friction > 0 ? p.friction : 1, shift ? 1 : p.velocity, 0};
      return lines + totals(one, p.solution, patch) + statistics(p.solution) +
             elements(one, p.solution, patch);
    }

    std::string
    wheel_rail_blocks(const ContactCase &one, const WheelRailCase &solved)
    {
      const std::size_t n     = solved.patches.size();
      std::string       lines = text("\n WHEEL-RAIL CONTACT, %s WHEEL,%3zu CONTACT %s\n\n",
                               one.digits.side == 0 || one.digits.side == 4 ? "LEFT" : "RIGHT",
                               n,
                               n == 1 ? "PATCH" : "PATCHES") +
                          digits(one) + problem_lines(one) + "\n";
      if (one.written.influence >= 2)
        lines += materials(one);
      if (one.written.law != 1 && one.digits.motion != 0)
        lines += friction(one);
      lines += wheel_rail_head(one, solved);
      const Vector3 &t = solved.force_track, &w = solved.force_wheelset;
      lines += block("TOTAL FORCES ON RAIL",
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
      std::string              lines = "\n" + digits(one) + problem_lines(one) + "\n";
      if (one.written.influence >= 2)
        lines += materials(one);
      if (one.written.law != 1 && d.motion != 0)
        lines += friction(one);
      const bool   shift = d.motion == 1;
      const double step  = s.step > 0 ? s.step : s.grid.dx;
      if (d.motion != 0)
        {
          const std::string x = d.forces >= 1 ? "FX/FSTAT/FN " : "  CKSI      ",
                            y = d.forces == 2 ? "FY/FSTAT/FN " : "  CETA      ";
          lines +=
            shift ? block("KINEMATIC CONSTANTS",
                          "     DT          VELOC     " + x + y + "  CPHI",
                          {1, 1, k.x, k.y, k.spin})
                  : block("KINEMATIC CONSTANTS",
                          "     CHI         DQ          VELOC     " + x + y + "  CPHI",
                          {one.rolling.direction, step / millimetre, one.rolling.velocity, k.x, k.y, k.spin});
        }
      const double bound =
        d.variation == 3 || d.motion == 0 ? 1 : friction_of(one, one.friction.lines.front()).at(0);
      const PrintedPatch patch{bound, shift ? 1 : millimetre * one.rolling.velocity, one.rolling.direction};
      return lines + totals(one, s, patch) + statistics(s) + elements(one, s, patch);
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
