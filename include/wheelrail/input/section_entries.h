#pragma once

#include <wheelrail/input/entry_kinds.h>

#include <string>
#include <vector>

// The entries of each section of a parameter file, in the order of the listing; each function has a file of
// its own. entries() puts them together.

namespace wheelrail
{
  std::vector<Entry>
  profiles_entries();

  std::vector<Entry>
  track_entries();

  /// What supports the rail, in the section Track.
  void
  add_support_entries(EntryList &list);

  std::vector<Entry>
  wheelset_entries();

  std::vector<Entry>
  contact_entries();

  /// Of one body: `section` is Rail material or Wheel material, `part` its place in the scene.
  std::vector<Entry>
  material_entries(const std::string &section, MaterialData Scene::*part);

  std::vector<Entry>
  mesh_entries();

  std::vector<Entry>
  run_entries();

  std::vector<Entry>
  output_entries();

  std::vector<Entry>
  halfspace_entries();

  /// Of all subsections Irregularity 1, 2, ...
  std::vector<Entry>
  irregularity_entries();

  std::vector<Entry>
  wear_entries();

  std::vector<Entry>
  material_test_entries();

  std::vector<Entry>
  study_entries();
} // namespace wheelrail
