#pragma once

#include <wheelrail/input/motion_file.h>
#include <wheelrail/reference/wheelset_contact.h>
#include <wheelrail/scene/scene.h>

#include <ostream>

namespace wheelrail
{
  /// Carries out the command vehicle: half-spaces of each row of a motion, of one wheel or of both
  /// (Wheelset/Wheels), into vehicle.csv, vehicle.h5 and, when `draws`, vehicle.html in the folder
  /// <Output/Folder>-vehicle; the worst rows on the screen. Rows of an interrupted call are kept there
  /// (VehicleRows), and not solved again unless `overwrite`. Returns 0, or 2 when a row has no figures or
  /// figures that are not to be trusted.
  int
  run_vehicle_command(const Scene            &scene,
                      const WheelsetProfiles &profiles,
                      const MotionFile       &motion,
                      bool                    draws,
                      bool                    overwrite,
                      std::ostream           &out);
} // namespace wheelrail
