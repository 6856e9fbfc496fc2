#pragma once

#include <wheelrail/damage/worn_shape.h>
#include <wheelrail/vehicle/wheelset_contact.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// One kind of traffic: how wheels run, and their share of all that pass.
  struct MixRow
  {
    Scene       scene;     ///< of the wheel that is modelled, or of the right-hand one of two
    Scene       left;      ///< of the other one of a wheelset
    double      share = 1; ///< of the passages; those of a mix add up to 1
    std::string name;      ///< for messages: "row 3"
  };

  /// The rows of Wear/Mix, or the scene alone, with the wheel load [N]. Rows without traction or creepage
  /// roll freely. `weights`: what given weights add up to, else 1. Throws InputError as read_mix_file().
  std::vector<MixRow>
  mix_rows(const Scene &scene, double wheel_load, double &weights);

  /// What a passage of the mix does, in the mean; sections by the points of the shapes.
  struct MixWear
  {
    std::vector<double> rail_section, wheel_section; ///< taken off by a passage, by a turn of the wheel [m2]
    std::vector<double> rail_damage, wheel_damage;   ///< share of a life
    std::vector<double> rail_cracks, wheel_cracks;   ///< the same from crack_growth()
    double              mean_pressure = 0, peak_pressure = 0;        ///< of the rows' peaks [Pa]
    double              mean_t_gamma = 0, peak_t_gamma = 0;          ///< [N]
    Interval            pressure_within{0, 0}, t_gamma_within{0, 0}; ///< of both means; NaN: not known
    double              axle_load = 0;                               ///< [N]
    bool                at_end    = false; ///< whether a patch lies on the end of a shape
    /// Peak pressures of the half-spaces over those of the true bodies, less 1: the least and the largest of
    /// rows that were held against them; NaN: none was.
    double      bodies_low = Measures::none, bodies_high = Measures::none;
    double      with_care = 0, not_trusted = 0; ///< shares of passages with this verdict
    std::string doubts; ///< what is off in the worst row, with its name; empty: nothing
    std::string fault;  ///< why a row could not be solved, or nothing
  };

  /// Who solves which rows: the process `rank` of `size` takes each size-th one. share() is collective: it
  /// gets the rows of this process at their places in the list of all, and fills in those of the others.
  struct RowTeam
  {
    std::size_t                                 rank = 0, size = 1;
    std::function<void(std::vector<MixWear> &)> share = {};
  };

  /// The processes of an MPI job; this one alone where there is none.
  RowTeam
  team_of_job();

  /// Solves all rows with half-spaces on all processors of the team, and sums the wear of their patches
  /// (wear_profile()) at their places on both profiles. With Wheelset/Wheels = both the wheels of a row run
  /// on one axle, and the line has as many curves to either side: rail and wheel see each wheel of the row in
  /// half of the passages. Rows are added in their order, so that sums are the same bits on any number of
  /// processes and threads. Throws InputError with the row's name, on all processes, where the profiles do
  /// not touch or where friction does not carry the traction, so that the wheel locks or spins up. `held`:
  /// each row against the true bodies (hold_against_bodies()), else find_shift_effect() judges it.
  MixWear
  wear_of_mix(const std::vector<MixRow> &rows,
              const SceneProfiles       &profiles,
              const WornShape           &rail,
              const WornShape           &wheel,
              const RowTeam             &team = {},
              bool                       held = false);
} // namespace wheelrail
