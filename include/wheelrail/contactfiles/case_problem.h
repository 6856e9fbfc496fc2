#pragma once

#include <wheelrail/contactfiles/contact_case.h>
#include <wheelrail/halfspace/hertz.h>
#include <wheelrail/halfspace/problem.h>

#include <optional>
#include <vector>

namespace wheelrail
{
  /// A case of module 3 as a problem of half-spaces.
  struct CaseProblem
  {
    HalfspaceProblem problem;
    /// The case rolls along -x (CHI = 180d): the problem is the case turned by half a turn about the normal.
    bool turned = false;
    /// FX, FY over `friction` (FSTAT; 1 where friction differs from row to row) times the normal force, where
    /// that is to be found first (N = 0, F >= 1).
    double                      relative_x = 0, relative_y = 0, friction = 1;
    std::optional<HertzContact> hertz;  ///< of IPOTCN < 0
    std::vector<double>         angles; ///< of the surface in each row of the grid (C = 4), or empty [rad]
  };

  /// The problem of a case of module 3 without refusals(), in SI units, with the signs of CONTACT, which are
  /// those of HalfspaceProblem. Elements outside of a planform (IPLAN) lie far apart. In steady rolling the
  /// step is the element length, as CONTACT sets it, but with ConvexGS (G = 2).
  CaseProblem
  case_problem(const ContactCase &one);

  /// The friction law of a line of constants.
  FrictionLaw
  friction_of(const ContactCase &one, const ContactFrictionLine &line);

  /// What temperature adds to friction on each of its lines (L = 6); none with other laws.
  std::vector<FrictionOfTemperature>
  hot_friction_of(const ContactCase &one, const std::vector<ContactFrictionLine> &lines);

  /// Sets what the bodies are made of, the heat that they take up, the layer between them and the memory of
  /// friction.
  void
  set_bodies(const ContactCase &one, HalfspaceProblem &problem);

  /// Turns a problem by half a turn about the normal through (0, 0): rolling along -x becomes one along x.
  void
  turn_problem(HalfspaceProblem &problem);

  /// Angles of rows [rad] so turned.
  std::vector<double>
  half_turn(std::vector<double> angles);

  /// A grid after half a turn about the normal through (0, 0).
  HalfspaceGrid
  turned_grid(HalfspaceGrid grid);
} // namespace wheelrail
