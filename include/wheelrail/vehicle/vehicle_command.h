#pragma once

#include <wheelrail/commands/command_scene.h>

#include <ostream>

namespace wheelrail
{
  /// Carries out the command vehicle: the contact in each row of a motion, of one wheel or of both
  /// (Wheelset/Wheels), into vehicle.csv, vehicle.h5 and, with pictures, vehicle.html in the folder
  /// <Output/Folder>-vehicle; the worst rows on the screen. Rows of an interrupted call are kept there
  /// (VehicleRows), and not solved again unless --overwrite. Returns 0, or 2 when a row has no figures or
  /// figures that are not to be trusted.
  int
  act_vehicle(const po::variables_map &options, const RunFunction &run, std::ostream &out);
} // namespace wheelrail
