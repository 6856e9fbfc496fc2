#include <wheelrail/base/format_text.h>
#include <wheelrail/contactfiles/printed_patch.h>

#include <cmath>
#include <cstddef>

namespace wheelrail
{
  /// Columns of twelve characters.
  std::string
  printed_row(const std::vector<double> &values)
  {
    std::string line = "  ";
    for (const double value : values)
      line += text("%12s", printed_number(value).c_str());
    return line + "\n";
  }

  std::string
  printed_block(const std::string &title, const std::string &names, const std::vector<double> &values)
  {
    return (title.empty() ? "" : " " + title + "\n") + names + "\n" + printed_row(values) + "\n";
  }

  const char *
  law_heading(const int law)
  {
    return law == 0   ? "     FSTAT       FKIN"
           : law == 6 ? "     FREF        TREF        DFHEAT      DTHEAT"
                      : "     FKIN        FEXP1       SABSH1      FEXP2       SABSH2";
  }


  namespace
  {
    using Row = std::vector<double>;

    std::string
    totals(const ContactCase &one, const HalfspaceSolution &s, const PrintedPatch &patch)
    {
      const ControlDigits &d     = one.digits;
      const bool           basic = one.module == 3, shift = d.motion == 1;
      const double         unit = shift ? millimetre : 1,
                   G            = 2 / (1 / one.material.shear[0] + 1 / one.material.shear[1]);
      const double bound        = patch.friction * s.fn;
      const auto   relative     = [&](const double force) { return bound > 0 ? force / bound : 0.; };
      const bool   by_rows      = d.variation == 3 || (patch.curved && d.variation == 1);
      std::string  names        = patch.curved ? "     TILDE_FN" : "     FN/G    ",
                  x             = by_rows ? "   FX/FN    " : "  FX/FSTAT/FN", y;
      y                         = by_rows ? "   FY/FN    " : basic ? " FY/FSTAT/FN " : " FS/FSTAT/FN ";
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
      Row               second_row{
        patch.curved ? s.fn : s.fn / G, first, second, s.approach / millimetre, s.peak_pressure / megapascal};
      if (!s.temperature[0].empty())
        second_row.push_back(hottest(s));
      return " TOTAL FORCES, TORSIONAL MOMENT, ELASTIC ENERGY, FRICTIONAL POWER\n" +
             std::string(basic ? "     FN          FX          FY          MZ         ELAST.EN.   "
                         : patch.curved
                           ? "     BAR_FN      BAR_FX      BAR_FS      MN         ELAST.EN.   "
                           : "     FN          FX          FS          MN         ELAST.EN.   ") +
             power + "\n" +
             printed_row({patch.curved ? patch.normal_force : s.fn,
                          d.motion == 0 ? 0 : s.fx,
                          patch.curved    ? patch.lateral_force
                          : d.motion == 0 ? 0
                                          : s.fy,
                          (patch.curved ? patch.spin_moment : s.spin_moment) / millimetre,
                          elastic_energy(s),
                          friction_power(s, patch.velocity)}) +
             names + x + y + "  APPROACH     PMAX" +
             (s.temperature[0].empty() ? "\n" : "      MAX(T1,T2)\n") + printed_row(second_row) + "\n";
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
  } // namespace


  std::string
  solution_lines(const ContactCase &one, const HalfspaceSolution &s, const PrintedPatch &patch)
  {
    return totals(one, s, patch) + statistics(s) + elements(one, s, patch);
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
    const double unit = shift ? millimetre : 1, chi = p.backwards ? M_PI : 0;
    if (one.digits.motion != 0)
      {
        if (one.digits.variation != 0 && !(p.curved && one.digits.variation == 1))
          lines +=
            printed_block("FRICTION LAW PARAMETERS", law_heading(one.digits.law), p.friction_constants);
        lines += printed_block("KINEMATIC CONSTANTS",
                               "     CHI         DQ          VELOC       CKSI        CETA        CPHI",
                               {chi,
                                shift ? 1 : p.step / millimetre,
                                shift ? 1 : p.velocity / millimetre,
                                p.creepage / unit,
                                p.lateral_creepage / unit,
                                shift ? p.spin : p.spin * millimetre});
        if (goes_on)
          lines +=
            printed_block("", "     SPINXO      SPINYO", {p.origin_x / millimetre, p.origin_y / millimetre});
      }
    const PrintedPatch patch{p.friction > 0 ? p.friction : 1,
                             shift ? 1 : p.velocity,
                             chi,
                             p.curved,
                             p.normal_force,
                             p.lateral_force,
                             p.spin_moment + p.origin_x * p.lateral_force};
    return lines + solution_lines(one, p.solution, patch);
  }
} // namespace wheelrail
