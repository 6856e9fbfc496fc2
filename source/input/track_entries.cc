#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using B = Bounds;
    using S = Scene;

    Entry
    inclination_entry()
    {
      Entry entry = number_entry(
        {"Track", "Rail inclination", "Slope of the rail's axis towards the track centre; 1/40 or 1:40."},
        Dimension::none,
        "",
        Bounds::between("0", "1/10"),
        field(&Scene::track, &TrackDimensions::inclination));
      entry.set = [set = entry.set](Scene &scene, std::string text) {
        // a slope is written 1:40 on drawings
        if (const std::size_t colon = text.find(':'); colon != std::string::npos)
          text[colon] = '/';
        set(scene, text);
      };
      entry.get = [](const Scene &scene) {
        const double slope = scene.track.inclination, inverse = std::round(1 / slope);
        return slope > 0 && 1 / inverse == slope ? "1/" + format_number(inverse) : format_number(slope);
      };
      return entry;
    }
  } // namespace


  std::vector<Entry>
  track_entries()
  {
    std::vector<Entry> list;
    list.push_back(length_entry({"Track", "Gauge", "Distance between the two rails, at the gauge height."},
                                "mm",
                                B::between("500 mm", "2000 mm"),
                                field(&S::track, &TrackDimensions::gauge)));
    list.push_back(length_entry(
      {"Track", "Gauge height", "Depth below the top of the rail at which the gauge is measured."},
      "mm",
      B::between("5 mm", "30 mm"),
      field(&S::track, &TrackDimensions::gauge_height)));
    list.push_back(inclination_entry());
    list.push_back(length_entry({"Track", "Rail length", "Length of the modelled piece of rail."},
                                "m",
                                B::between("200 mm", "30 m"),
                                field(&S::rail_length)));
    add_support_entries(list);
    const auto radius = field(&S::track_radius);
    list.push_back(with_word(
      number_entry(
        {"Track",
         "Radius",
         "Of the curve that the wheelset runs along, for half-spaces (halfspace, vehicle); positive: "
         "the curve goes to the left, so that the right-hand wheel is the outer one. Runs roll "
         "straight on."},
        Dimension::length,
        "m",
        B::between("-100 km", "100 km"),
        radius),
      "straight",
      std::numeric_limits<double>::infinity(),
      radius));
    const auto cant = field(&S::cant);
    list.push_back(with_word(
      length_entry(
        {"Track",
         "Cant",
         "Height of the right-hand rail above the left-hand one, with Wheelset/Wheels = both: radius, "
         "cant and velocity then share the load of the axle between its wheels; positive in a curve "
         "to the left, negative in one to the right. none: both wheels carry the load as given."},
        "mm",
        B::between("-300 mm", "300 mm"),
        cant),
      "none",
      std::numeric_limits<double>::infinity(),
      cant));
    list.push_back(
      pure_entry({"Track",
                  "Track shift factor",
                  "k of Prud'homme's limit k (10 kN + P/3) of the sum of the lateral forces of an "
                  "axle with the load P; 1 for track that lies well, 0.85 for others."},
                 B::between("0.1", "2"),
                 field(&S::prudhomme_factor)));
    return list;
  }
} // namespace wheelrail
