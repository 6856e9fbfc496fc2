#include <wheelrail/application/command_actions.h>
#include <wheelrail/application/halfspace_command.h>
#include <wheelrail/application/places_command.h>
#include <wheelrail/application/sections_command.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/left_out.h>
#include <wheelrail/commands/command_scene.h>
#include <wheelrail/input/cross_checks.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/vehicle/creep_curve_command.h>
#include <wheelrail/vehicle/wheelset_command.h>
#include <wheelrail/wheel/given_distance.h>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    int
    halfspaces_of_wheelset(const po::variables_map        &options,
                           SceneInput                     &input,
                           const std::vector<std::string> &warnings,
                           std::ostream                   &out)
    {
      for (const char *option :
           {"contact-input", "contact-wheel-rail-input", "creep-curve", "places", "pitch"})
        if (options.count(option))
          throw InputError(std::string("--") + option + " takes one wheel; " +
                           entry_text(input.scene, "Wheelset", "Wheels") + " asks for two: set it to one");
      for (const std::string &warning : warnings)
        out << "warning: " << warning << "\n";
      print_note(drive_note(options, input), out);
      settle_bodies(input.scene, "", out);
      return run_wheelset_command(input.scene, !options.count("no-pictures"), out);
    }

    /// What true bodies do not have: irregular surfaces, one spin for the whole contact, and a problem that
    /// CONTACT could solve. Throws InputError where they are asked for; else the scene is left to
    /// half-spaces.
    void
    leave_to_half_spaces(const po::variables_map &options, Scene &scene, std::ostream &out)
    {
      const auto  curve = options.count("creep-curve") ? options["creep-curve"].as<std::string>() : "";
      std::string why;
      for (const std::string option : {"places", "pitch"})
        if (options.count(option))
          why = "--" + option + " puts the wheel on irregular half-spaces";
      if (curve.rfind("spin", 0) == 0)
        why =
          "--creep-curve \"spin ...\" gives the whole contact one spin, which bodies of their own shape do "
          "not have";
      if (options.count("contact-input"))
        why = "--contact-input writes the problem of two half-spaces";
      if (!why.empty() && scene.halfspace_bodies == ContactBodies::real)
        throw InputError(entry_text(scene, "Half-space", "Bodies") + ": " + why +
                         "; write half-spaces there");
      if (why.empty() && !curve.empty())
        why = "as creep curves are; --bodies real takes true bodies, a second a point";
      settle_bodies(scene, why, out);
    }

    int
    halfspaces_of_places(const po::variables_map &options,
                         const Scene             &scene,
                         const SceneGeometry     *geometry,
                         std::ostream            &out)
    {
      if (options.count("places") + options.count("pitch") + options.count("creep-curve") > 1)
        throw InputError("--places, --pitch and --creep-curve are different tables: give one of them");
      const bool        pitch  = options.count("pitch") > 0;
      const std::string option = pitch ? "pitch" : "places";
      if (distance_is_given(scene))
        throw InputError(entry_text(scene, "Half-space", "Undeformed distance") + ": --" + option +
                         " needs wheel and rail; set it to profiles");
      return run_places_command(scene,
                                *geometry,
                                parse_irregular_places(options[option].as<std::string>(), pitch),
                                !options.count("no-pictures"),
                                out);
    }
  } // namespace


  int
  act_halfspace(const po::variables_map &options, const RunFunction &, std::ostream &out)
  {
    require_file(options, "halfspace");
    const auto file = [&](const char *option) {
      return options.count(option) ? options[option].as<std::string>() : std::string();
    };
    if (!file("beside").empty() && file("creep-curve").empty())
      throw InputError("--beside draws points beside a creep curve: give --creep-curve, too");
    for (const char *const option : {"contact-input", "contact-wheel-rail-input"})
      if (options.count(option) && !is_built(Subject::contact_files))
        refuse_left_out(std::string("--") + option, Subject::contact_files);
    SceneInput     input = one_scene_of(options);
    const Findings found = contact_checks(input.scene);
    require_none(found.errors, input);
    print_notes(idle_entries(options, input, "halfspace"), out);
    if (input.scene.rail_by_slices())
      {
        if (file("places").empty() || input.scene.both_wheels)
          throw InputError("Profiles/Rail = " + input.scene.rail_profile +
                           ": of slices along the track halfspace takes one wheel at places: give --places "
                           "\"0:600:20 mm\"");
        return run_sections_command(input.scene, file("places"), !options.count("no-pictures"), out);
      }
    if (input.scene.both_wheels)
      return halfspaces_of_wheelset(options, input, found.warnings, out);
    leave_to_half_spaces(options, input.scene, out);
    std::optional<SceneGeometry> geometry;
    if (needs_profiles(input.scene) || !file("contact-wheel-rail-input").empty())
      geometry = require_touching(input);
    if (geometry)
      print_notes(geometry->notes, out);
    for (const std::string &warning : found.warnings)
      out << "warning: " << warning << "\n";
    if (file("creep-curve").rfind("longitudinal", 0) != 0) // which runs over what drives
      print_note(drive_note(options, input), out);
    if (!file("places").empty() || !file("pitch").empty())
      return halfspaces_of_places(options, input.scene, geometry ? &*geometry : nullptr, out);
    if (!file("creep-curve").empty())
      return run_creep_curve_command(input.scene,
                                     geometry ? &*geometry : nullptr,
                                     parse_creep_curve(file("creep-curve")),
                                     file("beside"),
                                     !options.count("no-pictures"),
                                     out);
    return run_halfspace_command(input.scene,
                                 geometry ? &*geometry : nullptr,
                                 {file("contact-input"), file("contact-wheel-rail-input")},
                                 !options.count("no-pictures"),
                                 out);
  }
} // namespace wheelrail
