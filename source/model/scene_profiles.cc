#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/measured_profiles.h>
#include <wheelrail/model/scene_profiles.h>

namespace wheelrail
{
  namespace
  {
    /// Reads a file and makes the profile of it; messages get the name of the entry in front.
    template <typename Make>
    auto
    from_file(const std::string        &entry,
              const std::string        &path,
              const ProfileFileOptions &options,
              const Make               &make,
              std::vector<std::string> *notes)
    {
      try
        {
          MeasuredProfile measured = read_profile_file(path, options);
          auto            profile  = make(measured, measured.notes);
          if (notes)
            for (const std::string &note : measured.notes)
              notes->push_back(entry + " = " + path + ": " + note);
          return profile;
        }
      catch (const InputError &error)
        {
          throw InputError(entry + ": " + error.what());
        }
    }
  } // namespace


  bool
  is_file_name(const std::string &name)
  {
    return name.find_first_of("./") != std::string::npos;
  }


  RailProfile
  scene_rail(const Scene &scene, std::vector<std::string> *notes)
  {
    if (!is_file_name(scene.rail_profile))
      return rail_profile(scene.rail_profile);
    return from_file(
      "Profiles/Rail",
      scene.rail_profile,
      scene.rail_file,
      [&](const MeasuredProfile &measured, std::vector<std::string> &more) {
        return measured_rail(measured, scene.rail_body, more);
      },
      notes);
  }


  WheelProfile
  scene_wheel(const Scene &scene, std::vector<std::string> *notes)
  {
    if (!is_file_name(scene.wheel_profile))
      return wheel_profile(scene.wheel_profile);
    return from_file(
      "Profiles/Wheel",
      scene.wheel_profile,
      scene.wheel_file,
      [&](const MeasuredProfile &measured, std::vector<std::string> &more) {
        return measured_wheel(measured, scene.wheel.rim_width, more);
      },
      notes);
  }


  std::vector<std::string>
  profile_notes(const Scene &scene)
  {
    std::vector<std::string> notes;
    if (is_file_name(scene.wheel_profile))
      scene_wheel(scene, &notes);
    if (is_file_name(scene.rail_profile))
      scene_rail(scene, &notes);
    return notes;
  }
} // namespace wheelrail
