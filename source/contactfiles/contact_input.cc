#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/contactfiles/contact_input.h>

#include <algorithm>

namespace wheelrail
{
  namespace
  {
    /// A field with `per_line` elements in a line.
    void
    add_field(std::string                                    &text,
              const HalfspaceGrid                            &grid,
              const std::vector<const std::vector<double> *> &fields,
              const double                                    factor)
    {
      const int per_line = 10 / int(fields.size());
      for (int e = 0; e < grid.size(); e += per_line)
        {
          std::vector<double> numbers;
          for (int k = e; k < std::min(e + per_line, grid.size()); ++k)
            for (const auto *field : fields)
              numbers.push_back(factor * (*field)[k]);
          text += contact_line(numbers);
        }
    }
  } // namespace


  std::string
  contact_line(const std::vector<double> &numbers, const std::string &names, const int digits)
  {
    std::string text;
    for (const double number : numbers)
      text += wheelrail::text(" %.*g", digits, number);
    return text + (names.empty() ? "" : "   " + names) + "\n";
  }


  std::string
  contact_head(const std::string &title, const std::string &about)
  {
    std::string plain_title = title;
    std::replace(plain_title.begin(), plain_title.end(), '\n', ' ');
    return "% " + plain_title + "\n% input of CONTACT, revision 2707, " + about + "\n";
  }


  std::string
  contact_input(const HalfspaceProblem &problem, const std::string &title)
  {
    if (problem.friction.depends_on_speed())
      throw InputError("--contact-input writes constant friction only: set Contact/Friction law = constant");
    const HalfspaceGrid &grid     = problem.grid;
    const bool           has_slip = !problem.rigid_slip_x.empty();
    const double         mu       = problem.friction.at(0);
    const bool           alike    = problem.body1.shear_modulus == problem.body2.shear_modulus &&
                       problem.body1.poisson_ratio == problem.body2.poisson_ratio;

    std::string text = contact_head(title, "basic module; mm, N, MPa") + " 3 MODULE\n";
    text +=
      std::string(" 203") + "1" + (problem.longitudinal_force_given ? "1" : "0") + "0     P-B-T-N-F-S\n";
    text += std::string(" 02202") + (has_slip ? "9" : "0") + "     L-D-C-M-Z-E\n 0001211     H-G-I-A-O-W-R\n";
    text += contact_line({999, 200, 50, alike ? 1. : 20., 1e-6}, "MAXGS, MAXIN, MAXNR, MAXOUT, EPS");
    // a force is given over the friction limit, a creepage as it is
    const double along =
      problem.longitudinal_force_given ? problem.fx / (mu * problem.normal_force) : problem.xi;
    text +=
      contact_line({problem.normal_force, along, problem.eta, 1e-3 * problem.phi}, "FN, CKSI/FX, CETA, CPHI");
    text += contact_line({mu, mu}, "FSTAT, FKIN");
    text += " 0d";
    text += contact_line({1e3 * (problem.step > 0 ? problem.step : grid.dx), 1e3 * problem.velocity},
                         "CHI, DQ, VELOC");
    text += contact_line({problem.body1.poisson_ratio,
                          problem.body2.poisson_ratio,
                          1e-6 * problem.body1.shear_modulus,
                          1e-6 * problem.body2.shear_modulus},
                         "POISS 1,2, GG 1,2");
    text += " 1   IPOTCN\n";
    text += contact_line({double(grid.mx),
                          double(grid.my),
                          1e3 * (grid.x0 - 0.5 * grid.dx),
                          1e3 * (grid.y0 - 0.5 * grid.dy),
                          1e3 * grid.dx,
                          1e3 * grid.dy},
                         "MX,MY,XL,YL,DX,DY");
    text += " 9 1   IBASE, IPLAN: undeformed distance of every element\n";
    add_field(text, grid, {&problem.undeformed_distance}, 1e3);
    if (has_slip)
      {
        text += "% rigid slip of every element, x and y\n";
        add_field(text, grid, {&problem.rigid_slip_x, &problem.rigid_slip_y}, 1);
      }
    return text + " 0 MODULE\n";
  }
} // namespace wheelrail
