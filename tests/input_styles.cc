// label: fast

// Parameters and deal.II's ParameterHandler: it reads the ready files, JSON and XML to the same scene as the
// program, which reads JSON and XML itself, and refuses what the entries refuse.

#include "messages.h"
#include "other_values.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/input/parameter_handler.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/run/simulation.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/property_tree/json_parser.hpp>

#include <filesystem>
#include <functional>
#include <sstream>
#include <vector>

using namespace wheelrail;
using test::message_of;
using test::same_text;

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

  /// The listing of what a handler by itself makes of some input.
  std::string
  by_handler(const std::function<void(dealii::ParameterHandler &)> &parse)
  {
    Scene                    scene;
    dealii::ParameterHandler handler;
    declare_entries(handler, scene);
    parse(handler);
    return print_parameters(scene);
  }

  BOOST_AUTO_TEST_CASE(test_round_trip)
  {
    std::vector<std::string> sets;
    for (const auto &value : test::other_values())
      sets.push_back(value.first + " = " + value.second);
    for (const Scene &scene : {changed_scene(), scene_from_text("", "none", sets).scene})
      {
        const std::string listing = print_parameters(scene);
        const std::string json    = print_parameters(scene, ParameterStyle::json),
                          xml     = print_parameters(scene, ParameterStyle::xml);
        std::istringstream json_in(json), xml_in(xml);
        BOOST_TEST(same_text(by_handler([&](auto &handler) { handler.parse_input_from_json(json_in); }),
                             listing,
                             "ParameterHandler reads JSON"));
        BOOST_TEST(same_text(by_handler([&](auto &handler) { handler.parse_input_from_xml(xml_in); }),
                             listing,
                             "ParameterHandler reads XML"));
        BOOST_TEST(same_text(by_handler([&](auto &handler) { handler.parse_input_from_string(listing); }),
                             listing,
                             "ParameterHandler reads the listing"));
        const auto read_back = [](const std::string &text, const std::string &name) {
          return print_parameters(scene_from_text(text, name, {}).scene);
        };
        BOOST_TEST(same_text(read_back(json, "x.json"), listing, "a JSON file is read"));
        BOOST_TEST(same_text(read_back(xml, "x.xml"), listing, "an XML file is read"));
        BOOST_TEST(same_text(read_back(listing, "x.prm"), listing, "a parameter file is read"));
        BOOST_TEST(same_text(read_back(scene_from_text(json, "x.json", {}).text, "input.prm"),
                             listing,
                             "and what is kept of JSON is a parameter file"));
      }
    const SceneInput input = scene_from_text(
      "{\"Title\": \" a {b|c}  d \", \"Run\": {\"Rolling distance\": \"30 mm\"}, "
      "\"Output\": {\"Ticks\": 13}}",
      "x.json",
      {"Run/Rolling distance = 40 mm"});
    BOOST_TEST(
      (input.scene.title == "a {b|c}  d" && input.scene.ticks == 13 && input.scene.rolling_distance == 0.04),
      "JSON of values alone, with --set");
    BOOST_TEST(
      same_text(input.text,
                "set Title = a {b|c}  d\nsubsection Run\n  set Rolling distance = 30 mm\nend\nsubsection "
                "Output\n  set Ticks = 13\nend\n",
                "its text"));
  }

  BOOST_AUTO_TEST_CASE(test_faults)
  {
    const auto message = [](const std::string &text, const std::string &name) {
      return message_of([&]() { scene_from_text(text, name, {}); });
    };
    BOOST_TEST(same_text(
      message("{\"Titel\": \"a\", \"Runs\": {\"Ticks\": \"1\"}, \"Wheelset\": {\"Velocity\": \"140\", "
              "\"Velocity\": \"1 m/s\"}, \"Title\": \"a # b\"}",
              "x.json"),
      "x.json: Titel: no such entry; the nearest is Title\n"
      "x.json: subsection Runs: no such subsection; the nearest is Run\n"
      "x.json: Wheelset/Velocity = 140: a bare number; a velocity with its unit is needed, such as 140 "
      "km/h\n"
      "x.json: Wheelset/Velocity: set a second time; keep one of them\n"
      "x.json: Wheelset/Velocity = 1 m/s: too small; a velocity from 5 km/h to 500 km/h is accepted\n"
      "x.json: Title = a # b: a value is one line without #",
      "faults in JSON"));
    BOOST_TEST(same_text(message("{\n\"Title\": a}", "x.json"),
                         "x.json:2: expected value; \"./wheelrail parameters --json\" prints a complete file",
                         "no JSON"));
    std::string json, xml;
    for (int i = 0; i < 100000; ++i)
      {
        json += "[";
        xml += "<a>";
      }
    const std::string deep = ": subsections in each other; \"./wheelrail parameters --";
    BOOST_TEST(
      same_text(message(json, "x.json"), "x.json" + deep + "json\" prints a complete file", "JSON too deep"));
    BOOST_TEST(
      same_text(message(xml, "x.xml"), "x.xml" + deep + "xml\" prints a complete file", "XML too deep"));
    BOOST_TEST(same_text(
      message("<Title>a</Title>", "x.xml"),
      "x.xml: no <ParameterHandler> with the entries in it; \"./wheelrail parameters --xml\" prints a "
      "complete file",
      "no XML of ParameterHandler"));
    BOOST_TEST(same_text(
      message("<ParameterHandler><Mesh><Fine_20depth>1</Fine_20depth></Mesh></ParameterHandler>", "x.xml"),
      "x.xml: Mesh/Fine depth = 1: a bare number; a length with its unit is needed, such as 1.5 mm",
      "a fault in XML"));
  }

  /// All entries of a scene but the folder that is named after its file.
  std::string
  entries_of(const SceneInput &input)
  {
    Scene scene = input.scene;
    if (input.text.find("set Folder") == std::string::npos)
      scene.folder = Scene().folder;
    return print_parameters(scene);
  }

  /// deal.II counts the paths of includes from where it is called. The studies include what includes a file
  /// beside itself: their text with all of it, as it is kept in input.prm, it reads as it reads the others'.
  BOOST_AUTO_TEST_CASE(test_ready_files)
  {
    namespace fs          = std::filesystem;
    const fs::path source = WHEELRAIL_SOURCE_DIR, here = fs::current_path();
    unsigned int   files = 0, unread = 0;
    for (const char *const folder : {"prm", "prm/studies"})
      for (const auto &file : fs::directory_iterator(source / folder))
        if (const std::string name = file.path().filename(); file.path().extension() == ".prm")
          {
            ++files;
            fs::current_path(source / folder); // tables beside the scene keep their names
            const SceneInput  input    = read_scene(name, {});
            const std::string expected = entries_of(input);
            BOOST_TEST(
              same_text(by_handler([&](auto &handler) { handler.parse_input_from_string(input.text); }),
                        expected,
                        name + " with its includes by ParameterHandler"));
            try
              {
                BOOST_TEST(same_text(by_handler([&](auto &handler) { handler.parse_input(name); }),
                                     expected,
                                     name + " by ParameterHandler"));
              }
            catch (const dealii::ParameterHandler::ExcCannotOpenIncludeStatementFile &)
              {
                ++unread;
              }
            fs::current_path(here);
          }
    BOOST_TEST((files > 20 && unread == 13), "the ready files are read");
    for (const auto &file : fs::directory_iterator(source / "prm/steels"))
      {
        const std::string text = "include " + file.path().string() + "\n";
        BOOST_TEST(same_text(by_handler([&](auto &handler) { handler.parse_input_from_string(text); }),
                             entries_of(scene_from_text(text, "x.prm", {})),
                             file.path().filename().string() + " by ParameterHandler"));
      }
  }

  BOOST_AUTO_TEST_CASE(test_commands)
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
        BOOST_TEST(scene.rolling_distance == 0.03, "parameters " + style + ": value of --set");
      }
    BOOST_TEST((printed("--xml").find("a length above 0 mm, at most 10 m") != std::string::npos),
               "XML tells what is accepted");
    BOOST_TEST((printed("--xml").find("[Selection torque|rate ]") != std::string::npos),
               "a choice is a list in deal.II's parameter GUI");
  }

  /// What doc/manual/parameters.md lists is what is declared to ParameterHandler.
  BOOST_AUTO_TEST_CASE(test_declarations)
  {
    boost::property_tree::ptree tree;
    std::istringstream          in(print_parameters(Scene(), ParameterStyle::json));
    boost::property_tree::read_json(in, tree);
    for (const Entry &entry : entries())
      {
        const auto declared = [&](const std::string &what) {
          return tree.get<std::string>({entry.path() + "/" + what, '/'});
        };
        BOOST_TEST(same_text(declared("value"), entry.default_text, entry.path() + ": value"));
        BOOST_TEST(same_text(declared("default_value"), entry.default_text, entry.path() + ": default"));
        BOOST_TEST(same_text(declared("documentation"), entry.meaning, entry.path() + ": meaning"));
        if (entry.choices.empty())
          BOOST_TEST(same_text(
            declared("pattern_description"), "[" + entry.accepted + "]", entry.path() + ": accepted"));
      }
  }

  /// The patterns are those of the entries, also when ParameterHandler reads by itself.
  BOOST_AUTO_TEST_CASE(test_patterns)
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
    BOOST_TEST(refuses("Wheelset", "Velocity", "140"), "a bare number");
    BOOST_TEST(refuses("Wheelset", "Velocity", "140 kN"), "a unit of another kind");
    BOOST_TEST(refuses("Wheelset", "Velocity", "900 km/h"), "a number beyond the range");
    BOOST_TEST(refuses("Wheelset", "Drive", "torqe"), "a misspelt choice");
    BOOST_TEST(refuses("Mesh", "Fine depth", "automatic"), "a word in place of a number");
    BOOST_TEST(refuses("Profiles", "Rail", "UIC 60"), "neither a standard profile nor a file");
    BOOST_TEST(refuses("Output", "Ticks", "2.5"), "a fraction for a whole number");
    BOOST_TEST(refuses("Output", "Folder", ""), "no text");
    BOOST_TEST((!refuses("Mesh", "Fine depth", "auto") && !refuses("Wheelset", "Velocity", "40 m/s")),
               "a word beside numbers, another unit");
    BOOST_TEST(scene.velocity == 40, "the value is in the scene");
    for (const Entry &entry : entries())
      set_entry(handler, entry.section, entry.name, entry.default_text);
    BOOST_TEST(
      same_text(print_parameters(scene), print_parameters(Scene()), "the defaults match their patterns"));
  }
} // namespace
