#include <wheelrail/contactfiles/case_grid.h>
#include <wheelrail/contactfiles/case_problem.h>
#include <wheelrail/halfspace/kalker_coefficients.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// What of the rigid slip is no creepage or spin about the origin.
    void
    add_rigid_slip(const ContactCase &one, HalfspaceProblem &problem)
    {
      const ContactKinematics &k    = one.kinematics;
      const int                kind = one.digits.extra;
      const std::size_t        n    = std::size_t(problem.grid.size());
      if (k.spin_x == 0 && k.spin_y == 0 && kind == 0)
        return;
      // rolling along -x the middle of the step lies on the other side; shifts have none
      const bool   shift = one.digits.motion == 1;
      const double ahead = shift ? 0
                                 : (std::cos(one.rolling.direction) < 0 ? -1 : 1) * problem.spin_offset *
                                     (problem.step > 0 ? problem.step : problem.grid.dx);
      problem.rigid_slip_x.assign(n, problem.phi * millimetre * k.spin_y);
      problem.rigid_slip_y.assign(n, -problem.phi * millimetre * k.spin_x);
      for (int j = 0; j < problem.grid.my; ++j)
        for (int i = 0; i < problem.grid.mx; ++i)
          {
            const auto e = i + problem.grid.mx * j;
            if (kind == 2)
              problem.rigid_slip_y[e] -=
                problem.phi * (problem.grid.x(i) + ahead) - problem.phi * millimetre * k.spin_x;
            if (kind == 3)
              problem.rigid_slip_x[e] +=
                problem.phi * problem.grid.y(j) - problem.phi * millimetre * k.spin_y;
            if (kind == 9)
              {
                problem.rigid_slip_x[e] += (shift ? millimetre : 1) * one.extra_slip.x[e];
                problem.rigid_slip_y[e] += (shift ? millimetre : 1) * one.extra_slip.y[e];
              }
          }
    }

    /// The problem seen from the other side of the rail: vectors in the plane change sign, the spin does not.
    void
    negate(std::vector<double> &values)
    {
      for (double &value : values)
        value = -value;
    }

    /// Inclination of the surface at each row, on straight lines between the places given (C = 4).
    std::vector<double>
    angles_of(const ContactInfluence &given, const HalfspaceGrid &grid)
    {
      std::vector<double> angles;
      for (int j = 0; j < grid.my; ++j)
        {
          const double y    = grid.y(j) / millimetre;
          const auto  &s    = given.surface;
          const auto   next = std::find_if(s.begin(), s.end(), [&](const auto &p) { return p.first >= y; });
          if (next == s.begin() || next == s.end())
            angles.push_back(next == s.end() ? s.back().second : next->second);
          else
            {
              const auto &[y0, a0] = *(next - 1);
              angles.push_back(a0 + (y - y0) / (next->first - y0) * (next->second - a0));
            }
        }
      return angles;
    }

    /// Hertz's ellipsoid or half cylinder, or a paraboloid of the same force (B = 2, 3).
    void
    give_pressure(const HertzContact &hertz, const bool elliptic, HalfspaceProblem &problem)
    {
      problem.force_given  = true;
      problem.normal_force = hertz.force;
      const bool   strip   = hertz.B == 0;
      const double over    = strip ? 3 * M_PI / 8 : 4. / 3; // of the parabola's peak over p0
      problem.pressure     = sampled_distance(problem.grid, [&](const double x, const double y) {
        const double across = y / hertz.b, beside = strip ? (std::abs(across) < 1 ? 0 : 1) : across * across,
                     inside = 1 - x * x / (hertz.a * hertz.a) - beside;
        return inside <= 0 ? 0 : hertz.peak_pressure * (elliptic ? std::sqrt(inside) : over * inside);
      });
    }

    std::optional<HertzContact>
    hertz_of(const ContactCase &one)
    {
      const std::vector<double> &v = one.grid.values;
      const ContactMaterial     &m = one.material;
      const double               E =
        contact_modulus(megapascal * m.shear[0], m.poisson[0], megapascal * m.shear[1], m.poisson[1]);
      const HertzLoad load{one.digits.normal == 1,
                           (one.digits.normal == 1 ? 1 : millimetre) * one.kinematics.normal};
      switch (one.grid.kind)
        {
          case -1:
            return hertz_of_curvatures(v[0] / millimetre, v[1] / millimetre, E, load);
          case -2:
            return hertz_of_ratio(v[0] / millimetre, v[1], E, load);
          case -3:
            return hertz_of_axes(millimetre * v[0], millimetre * v[1], E, load);
          case -4:
            return hertz_of_cylinders(v[0] / millimetre, millimetre * v[1], E, load.value);
          case -5:
            return hertz_of_strip(millimetre * v[0], millimetre * v[1], E, load.value);
          default:
            return {};
        }
    }

    /// The flexibilities of simplified theory that give the forces of small creepages (Kalker 1982); with
    /// creepages given, where much slides, one weighted by them. Divided by the factor that makes the slope
    /// fall with creepage (Spiryagin, Polach and Cole 2013).
    SimplifiedTheory
    simplified_theory(const ContactCase &one, const HertzContact &hertz)
    {
      const std::array<double, 2> &G1 = one.material.shear, &nu = one.material.poisson;
      const double                 G       = 2 / (1 / G1[0] + 1 / G1[1]); // MPa, as all here; lengths in mm
      const double                 poisson = G * (nu[0] / G1[0] + nu[1] / G1[1]) / 2;
      const double                 a = hertz.a / millimetre, b = hertz.b / millimetre, c = std::sqrt(a * b);
      const auto                   C      = kalker_coefficients(a / b, poisson);
      const bool                   single = one.digits.material == 2;
      const auto                  &m      = one.material.constants;
      SimplifiedTheory             L{
        8 * a / (3 * C.c11 * G), 8 * a / (3 * C.c22 * G), M_PI * a * a / (4 * c * C.c23 * G)};
      if (single)
        L = {m[0], m[0], m[0]};
      const double limit = hertz.force * friction_of(one, one.friction.lines.front()).at(0);
      const double x = one.kinematics.x, y = one.kinematics.y, spin = one.kinematics.spin * 3 * M_PI * a / 32;
      const bool   given = one.digits.forces == 0;
      if (given && !single && limit > 0 && (x != 0 || y != 0))
        {
          const double x0 = limit / (C.c11 * c * c * G), y0 = limit / (C.c22 * c * c * G);
          const double weight = std::min(1., std::hypot(x, y) / std::hypot(x0, y0) / 3);
          const double mean =
            (x * x + y * y + spin * spin) / (x * x / L.along + y * y / L.across + spin * spin / L.spin);
          for (double *value : {&L.along, &L.across, &L.spin})
            *value += weight * (mean - *value);
        }
      const double *const k       = m.data() + (single ? 1 : 0); // K0 ALFA BETA
      const double        slope   = given && limit > 0 ? std::hypot(C.c11 * x, C.c22 * y) : 0;
      const double        epsilon = G * M_PI * a * b * k[0] * slope / (4 * limit);
      const double        factor  = k[0] * (limit > 0 ? k[1] + (1 - k[1]) / (1 + k[2] * epsilon) : 1);
      for (double *value : {&L.along, &L.across, &L.spin})
        *value *= millimetre / megapascal / factor;
      return L;
    }
  } // namespace


  HalfspaceGrid
  turned_grid(HalfspaceGrid grid)
  {
    const double last_x = grid.x(grid.mx - 1), last_y = grid.y(grid.my - 1);
    grid.x0 = -last_x;
    grid.y0 = -last_y;
    return grid;
  }

  std::vector<double>
  half_turn(std::vector<double> angles)
  {
    std::reverse(angles.begin(), angles.end());
    negate(angles);
    return angles;
  }

  void
  turn_problem(HalfspaceProblem &problem)
  {
    problem.grid = turned_grid(problem.grid);
    std::reverse(problem.row_friction.begin(), problem.row_friction.end());
    std::reverse(problem.hot_friction.begin(), problem.hot_friction.end());
    for (auto *field : {&problem.undeformed_distance, &problem.rigid_slip_x, &problem.rigid_slip_y})
      std::reverse(field->begin(), field->end());
    negate(problem.rigid_slip_x);
    negate(problem.rigid_slip_y);
    for (double *value : {&problem.xi, &problem.eta, &problem.fx, &problem.fy})
      *value = -*value;
  }

  FrictionLaw
  friction_of(const ContactCase &one, const ContactFrictionLine &line)
  {
    const std::vector<double> &c = line.constants;
    FrictionLaw                law;
    if (one.digits.law == 0)
      {
        law.at_rest = c[0];
        return law;
      }
    if (one.digits.law == 6)
      {
        law.at_rest = c[0];
        return law;
      }
    law.kind     = one.digits.law == 2   ? FrictionKind::linear
                   : one.digits.law == 3 ? FrictionKind::rational
                                         : FrictionKind::exponential;
    law.at_speed = c[0];
    law.at_rest  = c[0] + c[1] + c[3];
    if (c[1] != 0)
      law.half_velocity = millimetre * c[2];
    law.decay       = std::log(2) / law.half_velocity;
    law.second_drop = c[3];
    if (c[3] != 0)
      law.second_velocity = millimetre * c[4];
    return law;
  }

  std::vector<FrictionOfTemperature>
  hot_friction_of(const ContactCase &one, const std::vector<ContactFrictionLine> &lines)
  {
    std::vector<FrictionOfTemperature> hot;
    for (std::size_t k = 0; one.digits.law == 6 && k < lines.size(); ++k)
      hot.push_back({lines[k].constants[1], lines[k].constants[3], lines[k].constants[2]});
    return hot;
  }

  void
  set_bodies(const ContactCase &one, HalfspaceProblem &problem)
  {
    const ContactMaterial &material = one.material;
    for (const auto &[body, index] : {std::pair{&problem.body1, 0}, std::pair{&problem.body2, 1}})
      *body = {megapascal * material.shear[std::size_t(index)], material.poisson[std::size_t(index)]};
    if (one.digits.bound == 1)
      problem.normal_compliance = millimetre / megapascal * material.normal_flexibility;
    if (one.digits.motion == 0)
      return;
    if (one.digits.heat != 0 && one.digits.motion == 3)
      {
        HeatConduction &heat = problem.heat.emplace();
        for (const std::size_t body : {0, 1})
          {
            const double *const v = material.heat.data() + 4 * body; // BKTEMP HEATCP LAMBDA DENS
            heat.far[body]        = v[0];
            heat.effusivity[body] = std::sqrt(v[1] * (v[2] / millimetre) * (v[3] / std::pow(millimetre, 3)));
          }
        heat.plastic_share = material.plastic_heat;
      }
    problem.from_sliding  = one.iteration.initial_slip < 0;
    problem.memory_length = millimetre * one.friction.memory_length;
    if (one.friction.memory_speed > 0)
      problem.memory_least_speed = millimetre * one.friction.memory_speed;
    if (one.digits.material == 4)
      {
        const std::vector<double> &c = material.constants;
        problem.layer_compliance     = millimetre / megapascal * c[1] / c[0];
        if (c[2] > 0 && c[2] < 1e10)
          {
            problem.layer_yield     = megapascal * c[2];
            problem.layer_hardening = megapascal / millimetre * c[3];
          }
      }
    // unlike materials: CONTACT passes once where MAXOUT = 1
    if (one.iteration.maxout == 1 && one.digits.law == 0)
      problem.max_coupling_rounds = 1;
  }

  CaseProblem
  case_problem(const ContactCase &one)
  {
    const ControlDigits     &d = one.digits;
    const ContactKinematics &k = one.kinematics;
    CaseProblem              result;
    HalfspaceProblem        &problem = result.problem;
    result.hertz                     = hertz_of(one);
    problem.grid                     = grid_of(one.grid, result.hertz);
    problem.undeformed_distance      = distances(one, problem.grid, result.hertz);
    set_bodies(one, problem);
    if (d.influence == 4)
      result.angles = angles_of(one.influence, problem.grid);
    problem.force_given = d.normal == 1;
    if (d.bound == 2 || d.bound == 3)
      give_pressure(*result.hertz, d.bound == 2, problem);
    else
      (problem.force_given ? problem.normal_force : problem.approach) =
        (problem.force_given ? 1 : millimetre) * k.normal;
    if (d.motion == 0)
      {
        problem.motion = HalfspaceMotion::none;
        return result;
      }

    problem.friction = friction_of(one, one.friction.lines.front());
    if (d.variation == 3)
      for (const ContactFrictionLine &line : one.friction.lines)
        problem.row_friction.push_back(friction_of(one, line));
    problem.hot_friction = hot_friction_of(one, one.friction.lines);
    result.friction      = d.variation == 3 ? 1 : problem.friction.at(0);
    const bool shift = d.motion == 1; // creepages and spin are distances and an angle, the velocity is 1 mm/s
    problem.motion   = shift           ? HalfspaceMotion::shift
                       : d.motion == 2 ? HalfspaceMotion::transient
                                       : HalfspaceMotion::steady;
    problem.velocity = shift ? 1 : millimetre * one.rolling.velocity;
    if ((d.motion == 3 && d.solver == 2) || (d.motion == 2 && d.material != 4))
      problem.step = millimetre * one.rolling.step;
    if (d.material == 2 || d.material == 3)
      problem.simplified = simplified_theory(one, *result.hertz);
    problem.spin_offset                               = one.rolling.middle;
    problem.phi                                       = shift ? k.spin : k.spin / millimetre;
    problem.longitudinal_force_given                  = d.forces >= 1;
    problem.lateral_force_given                       = d.forces == 2;
    (d.forces >= 1 ? result.relative_x : problem.xi)  = (shift && d.forces == 0 ? millimetre : 1) * k.x;
    (d.forces == 2 ? result.relative_y : problem.eta) = (shift && d.forces < 2 ? millimetre : 1) * k.y;
    const double scale = result.friction * problem.normal_force; // 0 where the approach is given
    problem.fx         = scale * result.relative_x;
    problem.fy         = scale * result.relative_y;
    add_rigid_slip(one, problem);
    result.turned = !shift && std::cos(one.rolling.direction) < 0;
    if (result.turned)
      {
        turn_problem(problem);
        result.angles = half_turn(result.angles);
      }
    return result;
  }
} // namespace wheelrail
