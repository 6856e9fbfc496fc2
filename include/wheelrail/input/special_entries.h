#pragma once

#include <wheelrail/input/entry_kinds.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Track/Rail inclination, written as in track engineering: 1/40.
  Entry
  inclination_entry();

  /// Wheelset/Nominal rolling radius: a value of the track geometry and of the wheel section.
  Entry
  nominal_radius_entry();

  /// Mesh/Fine depth: a length or "auto", stored as 0 until complete_scene() knows the cell size.
  Entry
  fine_depth_entry();

  /// A number for which "auto" is accepted, too, and stored as 0.
  Entry
  with_auto(Entry entry, const Field<double> &place);

  /// Mesh/Prepared distance: a length or "auto".
  Entry
  prepared_distance_entry();

  /// Output/Checkpoint interval: a wall time or "auto".
  Entry
  checkpoint_interval_entry();

  /// Yield stress of one body: a stress or "none", stored as infinity.
  Entry
  yield_stress_entry(const std::string &section, MaterialData Scene::*part);

  /// Mesh/Element, Rail element, Wheel element: the form of both bodies, or of one of them.
  std::vector<Entry>
  element_entries();

  /// Replaces values that depend on others ("auto") once all entries are read.
  void
  complete_scene(Scene &scene);
} // namespace wheelrail
