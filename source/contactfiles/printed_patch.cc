#include <wheelrail/base/format_text.h>
#include <wheelrail/contactfiles/contact_case.h>
#include <wheelrail/contactfiles/printed_patch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

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


  namespace
  {
    /// Fortran's G11.3: three digits, with an exponent below 0.1 and from 1000 on.
    std::string
    three_digits(const double value)
    {
      const double size = std::abs(value);
      if (size == 0)
        return "   0.00    ";
      if (size < 0.1 || size >= 999.5)
        {
          int    exponent = int(std::floor(std::log10(size))) + 1;
          double part     = value / std::pow(10., exponent);
          if (std::abs(part) >= 0.9995)
            {
              part /= 10;
              ++exponent;
            }
          return text("%7.3fE%+03d", part, exponent);
        }
      return text("%7.*f    ", size < 0.9995 ? 3 : size < 9.995 ? 2 : size < 99.95 ? 1 : 0, value);
    }

    /// First and last column and row with contact, one element more around them.
    std::array<int, 4>
    shown_range(const HalfspaceSolution &s)
    {
      std::array<int, 4> range{{s.grid.mx, -1, s.grid.my, -1}};
      for (int j = 0; j < s.grid.my; ++j)
        for (int i = 0; i < s.grid.mx; ++i)
          if (s.state[std::size_t(i + s.grid.mx * j)] != HalfspaceSolution::exterior)
            range = {
              {std::min(range[0], i), std::max(range[1], i), std::min(range[2], j), std::max(range[3], j)}};
      return {{std::max(0, range[0] - 1),
               std::min(s.grid.mx - 1, range[1] + 1),
               std::max(0, range[2] - 1),
               std::min(s.grid.my - 1, range[3] + 1)}};
    }

    double
    value_of(const std::vector<double> &field, const std::size_t e)
    {
      return field.empty() ? 0 : field[e];
    }
  } // namespace


  std::string
  printed_number(const double value)
  {
    const double size = std::abs(value);
    if (size == 0 || size < 1e-99)
      return "0.000";
    if (size >= 9999.5 && size < 10000.5)
      return value < 0 ? "-10000." : "10000.";
    if (size < 0.09999 || size >= 9999.5)
      return text("%.3E", value);
    if (size >= 999.95)
      return text("%.0f.", value);
    return text("%.*f", size < 0.99995 ? 4 : size < 9.9995 ? 3 : size < 99.995 ? 2 : 1, value);
  }


  double
  elastic_energy(const HalfspaceSolution &s)
  {
    double sum = 0;
    for (std::size_t e = 0; e < s.pressure.size(); ++e)
      sum += s.pressure[e] * value_of(s.displacement_n, e) +
             value_of(s.traction_x, e) * value_of(s.displacement_x, e) +
             value_of(s.traction_y, e) * value_of(s.displacement_y, e);
    return 0.5 * sum * s.grid.element_area();
  }


  double
  friction_power(const HalfspaceSolution &s, const double velocity)
  {
    double sum = 0;
    for (std::size_t e = 0; e < s.traction_x.size(); ++e)
      sum += s.traction_x[e] * value_of(s.slip_x, e) + s.traction_y[e] * value_of(s.slip_y, e);
    return sum * s.grid.element_area() * velocity;
  }


  std::string
  contact_picture(const HalfspaceSolution &s, const bool rolls, const double direction)
  {
    const auto [left, right, low, high] = shown_range(s);
    if (s.contact_elements == 0)
      return " FORM OF THE CONTACT, ADHESION AND SLIP-AREA`S:\n  NO ELEMENTS IN CONTACT\n\n";
    const bool  wide  = right - left < 60;
    std::string lines = " FORM OF THE CONTACT, ADHESION AND SLIP-AREA`S:\n";
    for (int j = high; j >= low; --j)
      {
        lines += text("%6d  ", j + 1);
        for (int i = left; i <= right; ++i)
          {
            const auto state  = s.state[std::size_t(i + s.grid.mx * j)];
            const bool corner = (i == left || i == right) && (j == low || j == high);
            lines += wide ? " " : "";
            lines += state == HalfspaceSolution::adhesion ? '*'
                     : state == HalfspaceSolution::slip   ? 'S'
                     : corner                             ? 'o'
                                                          : '.';
          }
        lines += "\n";
      }
    std::string tens = "        ", units = "        ";
    for (int i = left; i <= right; ++i)
      {
        const int column = i + 1;
        tens += std::string(wide ? " " : "") + (column % 10 == 0 ? char('0' + column / 10 % 10) : ' ');
        units += std::string(wide ? " " : "") + char('0' + column % 10);
      }
    return lines + tens + "\n" + units + "\n     X  -->" +
           (rolls ? text("        Chi=%6.2f degrees", direction * 180 / M_PI) : std::string()) + "\n\n";
  }


  std::string
  element_table(const HalfspaceSolution &s, const int motion, const PrintedPatch &patch)
  {
    const bool   shift = motion == 1;
    const double unit  = shift ? millimetre : 1;
    std::string  lines =
      " QUANTITIES DISTRIBUTED OVER THE CONTACT AREA:\n"
      " \"H-PEN\" IS THE UNDEFORMED DISTANCE WITH THE APPROACH TAKEN INTO ACCOUNT.\n"
      " PN IS THE NORMAL PRESSURE, PT THE TANGENTIAL TRACTION (2-VECTOR).\n";
    lines +=
      shift
        ? " S IS THE SLIP DISTANCE PER STEP, WHICH IS OPPOSITE TO THE TANGENTIAL TRACTION.\n"
          " X, H, PEN AND S ARE IN MM, PN AND PT ARE IN N/MM^2, AND ARGUMENTS ARE IN DEGREES.\n\n"
        : " S IS THE RELATIVE SLIP VELOCITY, WHICH IS OPPOSITE TO THE TANGENTIAL TRACTION.\n"
          " X, H AND PEN ARE IN MM, PN AND PT ARE IN N/MM^2, S IS DIMENSIONLESS, ARGUMENT IS IN DEGREES.\n\n";
    const bool hot = !s.temperature[0].empty();
    lines += std::string("     X         H-PEN        PN      TRCBND    ABS(PT)     ARG(PT;-S)  ABS(S)") +
             (hot ? "       TEMP1      TEMP2\n" : "\n");
    for (int j = 0; j < s.grid.my; ++j)
      {
        bool headed = false;
        for (int i = 0; i < s.grid.mx; ++i)
          {
            const auto e = std::size_t(i + s.grid.mx * j);
            if (s.state[e] == HalfspaceSolution::exterior)
              continue;
            if (!headed)
              lines += text("\n Y = %8s     ROW %2d OF THE POTENTIAL CONTACT\n\n",
                            printed_number(s.grid.y(j) / millimetre).c_str(),
                            j + 1);
            headed          = true;
            const double tx = value_of(s.traction_x, e), ty = value_of(s.traction_y, e);
            const double mu = s.friction.empty() ? patch.friction : s.friction[e];
            // in the contact the deformed surfaces touch: h - pen = gap - u_n
            const double distance = value_of(s.gap, e) - value_of(s.displacement_n, e);
            lines += text(
              "  %-11s %s%s%s%s%8.1f    %s%s\n",
              printed_number(s.grid.x(i) / millimetre).c_str(),
              three_digits(distance / millimetre).c_str(),
              three_digits(s.pressure[e] / megapascal).c_str(),
              three_digits(mu * s.pressure[e] / megapascal).c_str(),
              three_digits(std::hypot(tx, ty) / megapascal).c_str(),
              std::atan2(ty, tx) * 180 / M_PI,
              three_digits(std::hypot(value_of(s.slip_x, e), value_of(s.slip_y, e)) / unit).c_str(),
              hot ? (three_digits(s.temperature[0][e]) + three_digits(s.temperature[1][e])).c_str() : "");
          }
      }
    return lines + "\n";
  }
} // namespace wheelrail
