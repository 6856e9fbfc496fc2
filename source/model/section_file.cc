#include <wheelrail/model/section_file.h>
#include <wheelrail/output/replace_file.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <utility>

namespace wheelrail
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /// Places along a curve in the track plane, joints among them.
    Json
    line(const Curve &curve, const Placement &placement)
    {
      Json       x = Json::array(), y = Json::array();
      const auto add = [&](const Point2 &point) {
        const Point2 place = placement.to_track(point);
        x.push_back(place.x);
        y.push_back(place.y);
      };
      for (const Segment &segment : curve.segments())
        {
          const int n = samples_on(segment, 16);
          for (int i = 0; i < n; ++i)
            add(position_on(segment, static_cast<double>(i) / n));
        }
      add(curve.segments().back().end);
      return {{"x_m", std::move(x)}, {"y_m", std::move(y)}};
    }
  } // namespace


  void
  write_sections(const TouchingProfiles &profiles, const TrackDimensions &track, const std::string &path)
  {
    const ContactGeometry &contact = profiles.contact;
    const Json             json    = {
                     {"rail_name", std::filesystem::path(profiles.rail.name).filename().string()},
                     {"wheel_name", std::filesystem::path(profiles.wheel.name).filename().string()},
                     {"contact",
                      {{"x_m", contact.frame.origin.x},
                       {"y_m", contact.frame.origin.y},
                       {"angle_rad", contact.frame.angle}}},
                     {"rail_axis",
                      {{"x_m", contact.rail.origin.x}, {"y_m", contact.rail.origin.y}, {"angle_rad", contact.rail.angle}}},
                     {"gauge_face", {{"x_m", gauge_face(track)}, {"y_m", -track.gauge_height}}},
                     {"rail", line(profiles.rail.head, contact.rail)},
                     {"wheel", line(profiles.wheel.tread, contact.wheel)}};
    replace_file(path, json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  }


  void
  set_patch_place(const HeadPlace &place, Summary &summary)
  {
    set_figure(summary, "patch_centre_from_axis_m", place.from_axis);
    set_figure(summary, "patch_centre_from_gauge_face_m", place.from_gauge_face);
    set_figure(summary, "patch_centre_below_top_m", place.below_top);
  }
} // namespace wheelrail
