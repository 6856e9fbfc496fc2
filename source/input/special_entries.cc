#include <wheelrail/base/errors.h>
#include <wheelrail/input/special_entries.h>

#include <cmath>
#include <limits>

namespace wheelrail
{
  namespace
  {
    /// "Fine depth = auto" in solution cells.
    constexpr double automatic_depth = 5;
  } // namespace

  Entry
  inclination_entry()
  {
    Entry entry = number_entry(
      {"Track", "Rail inclination", "1/40", "Slope of the rail's axis towards the track centre."},
      Dimension::none,
      "",
      Bounds::between("0", "1/10"),
      field(&Scene::track, &TrackDimensions::inclination));
    entry.get = [](const Scene &scene) {
      const double slope = scene.track.inclination, inverse = std::round(1 / slope);
      return slope > 0 && 1 / inverse == slope ? "1/" + format_number(inverse) : format_number(slope);
    };
    return entry;
  }

  Entry
  nominal_radius_entry()
  {
    Entry      entry = number_entry({"Wheelset",
                                     "Nominal rolling radius",
                                     "460 mm",
                                     "Radius of the wheel at the running circle, 70 mm from the flange back."},
                               Dimension::length,
                               "mm",
                               Bounds::between("150 mm", "800 mm"),
                               field(&Scene::track, &TrackDimensions::nominal_radius));
    const auto set   = entry.set;
    entry.set        = [set](Scene &scene, const std::string &text) {
      set(scene, text);
      scene.wheel.nominal_radius = scene.track.nominal_radius;
    };
    return entry;
  }

  Entry
  fine_depth_entry()
  {
    Entry entry =
      number_entry({"Mesh",
                    "Fine depth",
                    "auto",
                    "Depth of the layer of solution cells below both running surfaces; auto: five "
                    "cells."},
                   Dimension::length,
                   "mm",
                   Bounds::between("0.1 mm", "50 mm"),
                   field(&Scene::fine_depth));
    const auto set = entry.set;
    const auto get = entry.get;
    entry.accepted = "auto, or " + entry.accepted;
    entry.set      = [set](Scene &scene, const std::string &text) {
      if (text == "auto")
        scene.fine_depth = 0;
      else
        set(scene, text);
    };
    entry.get = [get](const Scene &scene) {
      const bool is_auto = scene.fine_depth == 0 || scene.fine_depth == automatic_depth * scene.cell_size;
      return is_auto ? "auto" : get(scene);
    };
    return entry;
  }

  Entry
  with_auto(Entry entry, const Field<double> &place)
  {
    const auto set = entry.set;
    const auto get = entry.get;
    entry.accepted = "auto, or " + entry.accepted;
    entry.set      = [set, place](Scene &scene, const std::string &text) {
      if (text == "auto")
        place(scene) = 0;
      else
        set(scene, text);
    };
    entry.get = [get, place](const Scene &scene) {
      Scene copy = scene;
      return place(copy) == 0 ? "auto" : get(scene);
    };
    return entry;
  }

  Entry
  prepared_distance_entry()
  {
    const auto place = field(&Scene::prepared_distance);
    return with_auto(
      number_entry({"Mesh",
                    "Prepared distance",
                    "auto",
                    "The mesh is made for rolling that far, so that a run can be resumed with a "
                    "longer Run/Rolling distance; auto: Run/Rolling distance."},
                   Dimension::length,
                   "mm",
                   Bounds::above("0 mm", "10 m"),
                   place),
      place);
  }

  Entry
  checkpoint_interval_entry()
  {
    const auto place = field(&Scene::checkpoint_interval);
    return with_auto(number_entry({"Output",
                                   "Checkpoint interval",
                                   "auto",
                                   "Wall time between two saved states, for --resume; auto: one minute, or a "
                                   "hundred times what saving takes when that is longer."},
                                  Dimension::time,
                                  "s",
                                  Bounds::above("0 s", "86400 s"),
                                  place),
                     place);
  }

  Entry
  yield_stress_entry(const std::string &section, MaterialData Scene::*part)
  {
    Entry entry =
      number_entry({section, "Yield stress", "none", "Initial yield stress; none: the body stays elastic."},
                   Dimension::stress,
                   "MPa",
                   Bounds::between("1 MPa", "10 GPa"),
                   field(part, &MaterialData::yield_stress));
    const auto set = entry.set;
    const auto get = entry.get;
    entry.accepted = "none, or " + entry.accepted;
    entry.set      = [set, part](Scene &scene, const std::string &text) {
      if (text == "none")
        (scene.*part).yield_stress = std::numeric_limits<double>::infinity();
      else
        set(scene, text);
    };
    entry.get = [get, part](const Scene &scene) {
      return std::isinf((scene.*part).yield_stress) ? "none" : get(scene);
    };
    return entry;
  }

  std::vector<Entry>
  element_entries()
  {
    std::vector<Entry> list;
    const ElementForm  reduced = ElementForm::reduced, full = ElementForm::full;
    list.push_back(choice_entry<ElementForm>(
      {"Mesh",
       "Element",
       "reduced",
       "Element form; reduced: one integration point, stabilised by assumed strain; "
       "full: eight points with the mean dilatation, about twice the work."},
      {{"reduced", reduced}, {"full", full}},
      field(&Scene::element)));
    using Form = std::optional<ElementForm>;
    for (const bool rail : {true, false})
      list.push_back(
        choice_entry<Form>({"Mesh",
                            rail ? "Rail element" : "Wheel element",
                            "as Element",
                            rail ? "Element form of the rail alone." : "Element form of the wheel alone."},
                           {{"as Element", {}}, {"reduced", reduced}, {"full", full}},
                           field(rail ? &Scene::rail_element : &Scene::wheel_element)));
    return list;
  }

  void
  complete_scene(Scene &scene)
  {
    if (scene.fine_depth == 0)
      scene.fine_depth = automatic_depth * scene.cell_size;
  }
} // namespace wheelrail
