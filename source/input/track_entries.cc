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
    using S = Scene;

    void
    add_inclination(EntryList &list)
    {
      Entry &entry = list.number({"Rail inclination", "", "0", "1/10"},
                                 field(&S::track, &TrackDimensions::inclination),
                                 "Slope of the rail's axis towards the track centre; 1/40 or 1:40.");
      entry.set    = [set = entry.set](Scene &scene, std::string text) {
        // a slope is written 1:40 on drawings
        if (const std::size_t colon = text.find(':'); colon != std::string::npos)
          text[colon] = '/';
        set(scene, text);
      };
      entry.get = [](const Scene &scene) {
        const double slope = scene.track.inclination, inverse = std::round(1 / slope);
        return slope > 0 && 1 / inverse == slope ? "1/" + format_number(inverse) : format_number(slope);
      };
    }
  } // namespace


  std::vector<Entry>
  track_entries()
  {
    EntryList list("Track");
    list.number({"Gauge", "mm", "500 mm", "2000 mm"},
                field(&S::track, &TrackDimensions::gauge),
                "Distance between the two rails, at the gauge height.");
    list.number({"Gauge height", "mm", "5 mm", "30 mm"},
                field(&S::track, &TrackDimensions::gauge_height),
                "Depth below the top of the rail at which the gauge is measured.");
    add_inclination(list);
    list.number({"Rail length", "m", "200 mm", "30 m"},
                field(&S::rail_length),
                "Length of the modelled piece of rail.");
    add_support_entries(list);
    list.number(
      {"Radius", "m", "-100 km", "100 km"},
      field(&S::track_radius),
      "Of the curve that the wheelset runs along, for half-spaces (halfspace, vehicle); positive: the curve "
      "goes to the left, so that the right-hand wheel is the outer one. Runs roll straight on.",
      {{"straight", std::numeric_limits<double>::infinity()}});
    list.number({"Cant", "mm", "-300 mm", "300 mm"},
                field(&S::cant),
                "Height of the right-hand rail above the left-hand one, with Wheelset/Wheels = both: radius, "
                "cant and velocity then share the load of the axle between its wheels; positive in a curve "
                "to the left, negative in one to the right. none: both wheels carry the load as given.",
                {{"none", std::numeric_limits<double>::infinity()}});
    list.number({"Track shift factor", "", "0.1", "2"},
                field(&S::prudhomme_factor),
                "k of Prud'homme's limit k (10 kN + P/3) of the sum of the lateral forces of an axle with "
                "the load P; 1 for track in good condition, 0.85 for others.");
    return list.entries;
  }
} // namespace wheelrail
