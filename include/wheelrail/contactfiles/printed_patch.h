#pragma once

#include <wheelrail/contactfiles/wheel_rail_case.h>
#include <wheelrail/halfspace/problem.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// What the printed blocks of a patch need beside its solution.
  struct PrintedPatch
  {
    double friction  = 1; ///< FSTAT
    double velocity  = 1; ///< VELOC [m/s]; 1 in shifts
    double direction = 0; ///< CHI [rad]
    /// On a curved surface: force along the normal and across, moment, in the axes of the reference.
    bool   curved       = false;
    double normal_force = 0, lateral_force = 0, spin_moment = 0;
  };

  /// A number as CONTACT prints it: four digits, with an exponent below 0.1 and from 10 000 on.
  std::string
  printed_number(double value);

  /// Half the work of the tractions on the displacements [J].
  double
  elastic_energy(const HalfspaceSolution &solution);

  /// Sum of traction times slip over the elements, negative [W]; in shifts the work [J].
  double
  friction_power(const HalfspaceSolution &solution, double velocity);

  /// The form of the contact: a line a row of elements, the last one first; . outside, * adhesion, S slip.
  std::string
  contact_picture(const HalfspaceSolution &solution, bool rolls, double direction);

  /// Distances, pressures, tractions and slips of the elements in contact, row by row, in CONTACT's units.
  std::string
  element_table(const HalfspaceSolution &solution, int motion, const PrintedPatch &patch);

  /// A line of numbers in columns of twelve characters.
  std::string
  printed_row(const std::vector<double> &values);

  /// Such a line under its title, if it has one, and the names of its columns.
  std::string
  printed_block(const std::string &title, const std::string &names, const std::vector<double> &values);

  /// The names of the constants of a friction law (L).
  const char *
  law_heading(int law);

  /// Forces, statistics and, as the digit O asks, elements of a solution.
  std::string
  solution_lines(const ContactCase &one, const HalfspaceSolution &s, const PrintedPatch &patch);

  /// The blocks of a patch of module 1, its number counted from 1.
  std::string
  patch_lines(const ContactCase &one, const WheelRailPatch &p, std::size_t number);
} // namespace wheelrail
