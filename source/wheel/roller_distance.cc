#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/geometry/frame_profile.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/profiles/note_lines.h>
#include <wheelrail/wheel/roller_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace wheelrail
{
  namespace
  {
    using Height = std::function<double(double)>;

    /// How far an arc of radius `crown` over the width lies below its top.
    Height
    arc(const Scene &scene, const std::string &entry, const double crown)
    {
      if (crown < 0.5 * scene.roller_width)
        throw InputError(entry_text(scene, "Half-space", entry) + ": less than half of " +
                         entry_text(scene, "Half-space", "Roller width") +
                         "; an arc over the width is needed");
      return [crown](const double y) { return crown - std::sqrt(std::max(0., crown * crown - y * y)); };
    }

    /// How far the crown of a profile file lies below y = 0 of the file.
    Height
    crown_of_file(const Scene              &scene,
                  const std::string        &entry,
                  const bool                wheel,
                  std::vector<std::string> &notes)
    {
      const std::string name     = wheel ? "Wheel" : "Rail",
                        &path    = wheel ? scene.wheel_profile : scene.rail_profile;
      ProfileFileOptions options = wheel ? scene.wheel_file : scene.rail_file;
      if (!is_file_name(path))
        throw InputError(entry_text(scene, "Half-space", entry) + ": " + entry_text(scene, "Profiles", name) +
                         " is no file; write the name of a file with the points of the crown there");
      options.roller = true;
      try
        {
          const MeasuredProfile crown = read_profile_file(path, options);
          const double          x = 0.5 * (crown.points.front().position.x + crown.points.back().position.x);
          // the file's own lateral origin stays; only the height is taken from the middle
          const Placement  unmoved;
          const CurvePoint middle =
            crown.curve.at(crown.curve.closest({x, crown.points[crown.points.size() / 2].position.y}));
          const ContactFrame frame{unmoved.to_track(middle.position), 0};
          const auto         heights = std::make_shared<const FrameProfile>(crown.curve, unmoved, frame);
          const double       at      = frame.origin.x;
          const double       low = heights->s_min() + at, high = heights->s_max() + at;
          if (low > -0.5 * scene.roller_width + 1e-6 || high < 0.5 * scene.roller_width - 1e-6)
            throw InputError(
              path + ": the crown reaches from " + in_mm(low) + " to " + in_mm(high) + "; " +
              entry_text(scene, "Half-space", "Roller width") +
              " needs as much on both sides of 0: give a smaller width, or move the origin of the file");
          for (const std::string &note : note_lines(crown.notes))
            notes.push_back("Profiles/" + name + " = " + path + ": " + note);
          return [heights, at](const double y) { return -heights->at(y - at).n; };
        }
      catch (const InputError &error)
        {
          throw InputError("Profiles/" + name + ": " + error.what());
        }
    }

    Height
    height_of(const Scene &scene, const bool wheel, std::vector<std::string> &notes)
    {
      const RollerShape &shape = wheel ? scene.wheel_roller : scene.rail_roller;
      const std::string  entry = wheel ? "Wheel roller crown" : "Rail roller crown";
      if (shape.crown == 0)
        return [](double) { return 0.; };
      return shape.crown > 0 ? arc(scene, entry, shape.crown) : crown_of_file(scene, entry, wheel, notes);
    }

    double
    curvature(const RollerShape &shape)
    {
      return shape.radius > 0 ? 1 / shape.radius : 0;
    }
  } // namespace


  RollerDistance
  roller_distance(const Scene &scene)
  {
    const double along = curvature(scene.wheel_roller) + curvature(scene.rail_roller);
    if (!(along > 0))
      throw InputError(
        "Half-space/Wheel roller radius = straight: and so is Half-space/Rail roller radius; one of "
        "them must roll");
    RollerDistance rollers;
    const Height wheel = height_of(scene, true, rollers.notes), rail = height_of(scene, false, rollers.notes);
    rollers.radius_along = 1 / along;
    rollers.high         = 0.5 * scene.roller_width;
    rollers.low          = -rollers.high;
    rollers.across       = [wheel, rail](const double y) { return wheel(y) + rail(y); };
    rollers.middle       = [wheel, rail](const double y) { return 0.5 * (wheel(y) - rail(y)); };
    rollers.lowest       = std::numeric_limits<double>::max();
    constexpr int n      = 2000;
    for (int k = 0; k <= n; ++k)
      {
        // the middle first: of a flat contact it is the lowest place
        const double y = (k % 2 ? -1 : 1) * rollers.high * ((k + 1) / 2) / (n / 2);
        if (const double d = rollers.across(y); d < rollers.lowest)
          {
            rollers.lowest    = d;
            rollers.lowest_at = y;
          }
      }
    // a cylinder counts as an arc that lies 1 um lower at its ends
    const double step = 0.25 * rollers.high;
    const double fall =
      std::max(rollers.across(std::clamp(rollers.lowest_at + step, rollers.low, rollers.high)),
               rollers.across(std::clamp(rollers.lowest_at - step, rollers.low, rollers.high))) -
      rollers.lowest;
    rollers.radius_across = step * step / (2 * std::max(fall, 6e-8));
    return rollers;
  }
} // namespace wheelrail
