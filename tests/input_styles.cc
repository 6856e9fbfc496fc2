// label: fast

// The parameters as JSON and XML: deal.II's ParameterHandler reads both back to the same scene, and refuses
// what the entries refuse.

#include "check.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/input/parameter_handler.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/run/simulation.h>

#include <deal.II/base/parameter_handler.h>

#include <sstream>

using namespace wheelrail;
using test::check;
using test::check_text;

namespace
{
  Scene
  changed_scene()
  {
    return scene_from_text("",
                           "none",
                           {"Title = a <b> & \"c\", 50 % slower",
                            "Wheelset/Velocity = 80 km/h",
                            "Wheelset/Roll = from contact",
                            "Track/Rail inclination = 1/20",
                            "Rail material/Young's modulus = 206 GPa",
                            "Rail material/Yield stress = 480 MPa",
                            "Mesh/Fine depth = 7 mm",
                            "Mesh/Rail element = full",
                            "Profiles/Smoothing = 0.01 mm",
                            "Output/Volume fields = false"})
      .scene;
  }

  std::string
  printed(const std::string &style)
  {
    std::ostringstream out;
    const RunFunction  run = [](const Scene &, const SceneGeometry &, const RunOptions &) { return 0; };
    execute({"parameters", style, "--set", "Run/Rolling distance = 30 mm"}, run, out);
    return out.str();
  }

  void
  test_round_trip()
  {
    const Scene scene = changed_scene();
    {
      Scene                    back;
      dealii::ParameterHandler handler;
      declare_entries(handler, back);
      std::istringstream in(print_parameters(scene, ParameterStyle::json));
      handler.parse_input_from_json(in);
      check_text(print_parameters(back), print_parameters(scene), "JSON reads back");
    }
    {
      Scene                    back;
      dealii::ParameterHandler handler;
      declare_entries(handler, back);
      std::istringstream in(print_parameters(scene, ParameterStyle::xml));
      handler.parse_input_from_xml(in);
      check_text(print_parameters(back), print_parameters(scene), "XML reads back");
    }
    check_text(print_parameters(scene_from_text(print_parameters(scene), "listing", {}).scene),
               print_parameters(scene),
               "a parameter file reads back");
  }

  void
  test_commands()
  {
    for (const std::string style : {"--json", "--xml"})
      {
        Scene                    scene;
        dealii::ParameterHandler handler;
        declare_entries(handler, scene);
        std::istringstream in(printed(style));
        if (style == "--json")
          handler.parse_input_from_json(in);
        else
          handler.parse_input_from_xml(in);
        check(scene.rolling_distance == 0.03, "parameters " + style + ": value of --set");
      }
    check(printed("--xml").find("a length above 0 mm, at most 10 m") != std::string::npos,
          "XML tells what is accepted");
    check(printed("--xml").find("[Selection torque|rate ]") != std::string::npos,
          "a choice is a list in deal.II's parameter GUI");
  }

  /// The patterns are those of the entries, also when ParameterHandler reads by itself.
  void
  test_patterns()
  {
    Scene                    scene;
    dealii::ParameterHandler handler;
    declare_entries(handler, scene);
    const auto refuses = [&](const std::string &section, const std::string &name, const std::string &value) {
      try
        {
          set_entry(handler, section, name, value);
        }
      catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &)
        {
          return true;
        }
      return false;
    };
    check(refuses("Wheelset", "Velocity", "140"), "a bare number");
    check(refuses("Wheelset", "Velocity", "140 kN"), "a unit of another kind");
    check(refuses("Wheelset", "Velocity", "900 km/h"), "a number beyond the range");
    check(refuses("Wheelset", "Drive", "torqe"), "a misspelt choice");
    check(refuses("Mesh", "Fine depth", "automatic"), "a word in place of a number");
    check(refuses("Profiles", "Rail", "UIC 60"), "neither a standard profile nor a file");
    check(refuses("Output", "Ticks", "2.5"), "a fraction for a whole number");
    check(refuses("Output", "Folder", ""), "no text");
    check(!refuses("Mesh", "Fine depth", "auto") && !refuses("Wheelset", "Velocity", "40 m/s"),
          "a word beside numbers, another unit");
    check(scene.velocity == 40, "the value is in the scene");
    for (const Entry &entry : entries())
      set_entry(handler, entry.section, entry.name, entry.default_text);
    check_text(print_parameters(scene), print_parameters(Scene()), "the defaults match their patterns");
  }
} // namespace

int
main()
{
  test_round_trip();
  test_commands();
  test_patterns();
  return test::report();
}
