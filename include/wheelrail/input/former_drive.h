#pragma once

#include <wheelrail/input/parameters.h>

#include <string>

namespace wheelrail
{
  /// For one version: what to say of a scene that says nowhere what drives its wheel, which was driven with
  /// a quarter of its load and now rolls freely. Empty where its text or --set has the traction coefficient,
  /// where Drive = rate, or where a table of its motion or of its passages, or an axis of its study, says
  /// what drives. Of scenes in a passage list each one is asked. Tables that cannot be read are left to those
  /// who need them.
  std::string
  former_drive_note(const SceneInput &input);
} // namespace wheelrail
