#pragma once

#include <wheelrail/halfspace/contact_heat.h>
#include <wheelrail/material/friction.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// Frictional contact of two elastic half-spaces on a rectangular grid: what is asked and what comes back.
//
// The contact frame: x along rolling (the frame moves along +x over both bodies), y lateral, n normal to
// the contact plane, out of body 2 into body 1. Spin turns x towards y.
// Body 1 is the upper one (n > 0), body 2 the lower one. Tractions t and the pressure p are those on body 1
// (p along +n, positive when it presses); body 2 carries the opposite. Displacement differences u and the
// rigid slip w are "body 1 minus body 2"; so friction opposes the slip: t = -mu p s / |s|.
// For a wheel on a rail take the wheel as body 1: the longitudinal force of a driving wheel is then positive,
// its creepage negative. Tractions on the rail are the negative ones; equivalently the rail is body 1.
//
// Fields are arrays of mx * my values, x fastest: value(i, j) = field[i + mx * j].

namespace wheelrail
{
  /// A rectangle of mx x my elements, each dx x dy [m]; x0, y0 is the centre of the first element.
  struct HalfspaceGrid
  {
    int    mx = 0, my = 0;
    double dx = 0, dy = 0;
    double x0 = 0, y0 = 0;

    int
    size() const
    {
      return mx * my;
    }
    double
    x(const int i) const
    {
      return x0 + i * dx;
    }
    double
    y(const int j) const
    {
      return y0 + j * dy;
    }
    double
    element_area() const
    {
      return dx * dy;
    }
  };

  /// The grid with elements of about dx x dy whose centres are symmetric to (x, y) = (0, 0) and which covers
  /// |x| <= half_x, |y| <= half_y; an element is centred at 0 (odd counts).
  HalfspaceGrid
  centred_grid(double half_x, double half_y, double dx, double dy);

  /// Isotropic elastic half-space: shear modulus [Pa] and Poisson's ratio [-].
  struct HalfspaceBody
  {
    double shear_modulus = 210e9 / 2.6;
    double poisson_ratio = 0.3;
  };

  enum class HalfspaceMotion
  {
    none,      ///< normal problem, no friction
    shift,     ///< one step: body 1 moves over body 2; creepages are distances [m] (spin: an angle [rad])
    transient, ///< one step of rolling over the distance `step` after `previous`
    steady     ///< steady rolling
  };

  struct HalfspaceSolution;
  class AddedInfluence;

  /// Simplified theory, FASTSIM (Kalker 1982): a point gives way under its own traction alone, by these
  /// flexibilities for creepage along and across and for spin [m/Pa]. An approximation, of forces to some 10
  /// %.
  struct SimplifiedTheory
  {
    double along = 0, across = 0, spin = 0;
  };

  struct HalfspaceProblem
  {
    HalfspaceGrid grid;
    /// Distance of the undeformed surfaces at the element centres [m], any shape; only differences matter
    /// to the solution with a given force, the zero of the approach lies where it is 0.
    std::vector<double> undeformed_distance;
    HalfspaceBody       body1, body2;
    /// What the bodies deflect beyond half-spaces, on this grid (added_influence.h); null: nothing. How
    /// tractions move the surfaces along the normal through it is taken from the guess that solve_rolling()
    /// is given: the caller repeats until pressure and tractions have settled to each other.
    std::shared_ptr<const AddedInfluence> added;
    /// Of conformal contact, where the normal turns from row to row: the cosine of its angle to the direction
    /// of the approach, per element, positive. The normal force is then that along the approach, the sum of
    /// pressure times cosine. Empty: 1.
    std::vector<double> normal_cosine;

    bool   force_given  = true; ///< normal_force is given and the approach is found, or the reverse
    double normal_force = 0;    ///< [N]
    double approach     = 0;    ///< [m]
    /// Pressure of every element [Pa], when it is known: the normal problem is then left out, with its
    /// displacements, gap and approach. Empty: found from what is above.
    std::vector<double> pressure;

    HalfspaceMotion motion = HalfspaceMotion::steady;
    FrictionLaw     friction{0.5};
    /// Of each row of the grid, where friction differs across; empty: the one above.
    std::vector<FrictionLaw> row_friction;
    double velocity = 1; ///< of rolling [m/s]; for a shift: distance unit per second; for the law
    /// Slip distance over which the coefficient comes to what the law has at the slip velocity v [m]:
    /// d mu / dt = -max(v, v_0) / memory_length (mu - mu(v)); what runs in, or did not touch before a step,
    /// has the coefficient at rest (Vollebregt and Schuttelaars 2012). 0: at once.
    double memory_length      = 0;
    double memory_least_speed = 1e-3; ///< v_0 [m/s]
    /// Falling friction may have several solutions: that found from sliding with the rolling velocity on,
    /// with the most slip, in place of that from rest on, with the least.
    bool from_sliding = false;
    /// Heat of friction in steady rolling: the temperatures of the surfaces are found. `hot_friction`, of
    /// each row of the grid or one for all: what it adds to the coefficients of the laws; empty: nothing.
    std::optional<HeatConduction>      heat;
    std::vector<FrictionOfTemperature> hot_friction;
    /// A bed of springs under the pressure, each for itself, beside the half-spaces [m3/N].
    double normal_compliance = 0;
    /// Thickness over shear modulus of an elastic layer between the bodies (roughness, sand, water, rust):
    /// its shear displacement is that times the traction [m/Pa]. It has no part in the normal problem.
    double layer_compliance = 0;
    /// Shear stress at which the layer yields [Pa] (0: never), and its rise with each metre of plastic shift
    /// [Pa/m]; a fall ends at a tenth. Where the traction reaches it below friction's limit, the layer shears
    /// along the traction and nothing slips (Hou, Kalousek and Magel 1997). Yield stress and plastic shift
    /// stay with the material; fresh material rolls in.
    double                          layer_yield = 0, layer_hardening = 0;
    std::optional<SimplifiedTheory> simplified; ///< in place of the half-spaces' shear, in steady rolling
    double                          step = 0;   ///< rolled distance of one step [m]; 0: the element length dx

    /// Rigid slip over rolling velocity: w_x = xi - phi y, w_y = eta + phi (x + spin_offset * step).
    /// With a force given, the creepage of that direction is the first guess.
    double xi = 0, eta = 0;
    double phi         = 0;       ///< [1/m]
    double spin_offset = 1. / 6.; ///< where within the step the spin is taken (CONTACT: 1/6)
    /// Added to the rigid slip above, per element [-]; empty: nothing. E.g. r(y) omega / V - 1 with the rail
    /// as body 1.
    std::vector<double> rigid_slip_x, rigid_slip_y;

    bool   longitudinal_force_given = false; ///< fx is given and xi is found
    bool   lateral_force_given      = false; ///< fy is given and eta is found (with fx only)
    double fx = 0, fy = 0;                   ///< on body 1 [N]

    /// The law of row j.
    const FrictionLaw &
    friction_of_row(const int j) const
    {
      return row_friction.empty() ? friction : row_friction[std::size_t(j)];
    }

    const HalfspaceSolution *previous =
      nullptr; ///< for shift and transient: the state before (same grid); none: 0

    double normal_tolerance     = 1e-7; ///< gap error over approach
    double tangential_tolerance = 1e-5; ///< error of tractions over their peak (rms)
    double coupling_tolerance =
      1e-4; ///< change between rounds of pressure and friction coefficients, over their peaks
    int max_normal_iterations = 2000;
    int max_newton_steps      = 60; ///< before the slower fall-back
    int max_coupling_rounds   = 100;
  };

  struct HalfspaceSolution
  {
    enum State : unsigned char
    {
      exterior = 0,
      adhesion = 1,
      slip     = 2,
      plastic  = 3 ///< the layer yields
    };

    HalfspaceGrid       grid;                                           ///< the grid really used
    double              step = 0;                                       ///< the step really used [m]
    std::vector<double> pressure;                                       ///< [Pa]
    std::vector<double> traction_x, traction_y;                         ///< on body 1 [Pa]
    std::vector<double> displacement_n, displacement_x, displacement_y; ///< body 1 minus body 2 [m]
    std::vector<double> gap;                                            ///< of the deformed surfaces [m]
    std::vector<double> slip_x, slip_y; ///< relative slip [-] in the contact, 0 outside (shift: [m])
    std::vector<double> friction;       ///< the coefficient in each element
    std::vector<double> yield_stress; ///< of a layer that yields, after the step [Pa]; 0: fresh; empty: none
    std::vector<double> plastic_x, plastic_y; ///< its plastic shift, body 1 less body 2 [m]
    /// Of the surfaces of bodies 1 and 2, per element [deg C]; empty without heat.
    std::array<std::vector<double>, 2> temperature;
    std::vector<unsigned char>         state;

    double approach = 0;             ///< [m]
    double fn = 0, fx = 0, fy = 0;   ///< [N], on body 1
    double spin_moment = 0;          ///< about n at (0, 0), on body 1 [N m]
    double xi = 0, eta = 0, phi = 0; ///< as in the problem, found ones included

    /// What the creepages do against the tractions for each metre rolled, the T-gamma of wear laws [J/m]:
    /// minus the sum of traction times rigid slip. In steady rolling of like materials friction takes all of
    /// it, since what the elastic slip does at one place comes back at another. The sum of traction times
    /// slip of the elements tends to it from below, with the first power of their length: 15 % less on
    /// 33 elements over the patch. NaN but for steady rolling.
    double creepage_work = 0;
    /// The same work from where it is done: the sum of the means of traction at both ends of a particle's
    /// path over an element times its slip (friction_work()) [J/m]. It is that of the creepages, where no
    /// displacement follows from a traction across it: not for unlike materials or true bodies, whose
    /// pressure takes part.
    double friction_work = 0;

    double peak_pressure = 0, peak_shear = 0;                            ///< [Pa]
    double area = 0, adhesion_area = 0, slip_area = 0, plastic_area = 0; ///< [m2], whole elements
    double length_x = 0, width_y = 0; ///< extents of the contact, whole elements [m]
    int    contact_elements = 0;

    int         normal_iterations = 0, newton_steps = 0, krylov_iterations = 0, coupling_rounds = 0;
    double      normal_residual = 0, tangential_residual = 0; ///< in the measure of the tolerances
    bool        normal_converged = false, tangential_converged = false, coupling_converged = false;
    bool        within_friction   = true;  ///< false: friction does not carry the force, no tractions
    bool        touches_grid_edge = false; ///< the contact reaches the outermost elements: enlarge the grid
    std::string not_reached;               ///< empty, or what was not reached, in words

    bool
    converged() const
    {
      return normal_converged && tangential_converged && coupling_converged;
    }
  };

  /// Solves the normal problem, the tangential problem and, for unlike materials, their coupling
  /// (alternately, Panagiotopoulos 1975); with friction that depends on the slip velocity its coefficients,
  /// too. Given pressures are taken as they are; unlike materials then still shift under them. Throws
  /// InputError for impossible input (sizes, moduli); a force that friction does not carry and a
  /// tolerance that was not reached are named in the solution, which then holds the best state found.
  HalfspaceSolution
  solve_rolling(const HalfspaceProblem &problem);

  /// Throws InputError for sizes that do not match, or values without meaning.
  void
  check_problem(const HalfspaceProblem &problem);

  /// An undeformed distance h(x, y) [m] at the element centres.
  std::vector<double>
  sampled_distance(const HalfspaceGrid &grid, const std::function<double(double, double)> &h);
} // namespace wheelrail
