// label: fast
// needs: contactfiles

// What the program answers to irregularities that cannot be: entries against each other, cells, places of a
// run, options of the command halfspace.
#include "messages.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/wheel/irregular_places.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

using namespace wheelrail;

namespace
{
  void
  holds(const std::string &message, const std::string &part)
  {
    BOOST_TEST((message.find(part) != std::string::npos),
               "\"" + part + "\" in \"" + message.substr(0, 300) + "\"");
  }

  void
  says(const std::function<void()> &work, const std::string &part)
  {
    holds(test::message_of(work), part);
  }

  Findings
  found_in(const std::vector<std::string> &sets)
  {
    return check_scene(scene_from_text("", "none", sets).scene).found;
  }

  std::string
  joined(const std::vector<std::string> &sentences)
  {
    std::string text;
    for (const std::string &sentence : sentences)
      text += sentence + "\n";
    return text;
  }

  void
  refused(const std::vector<std::string> &sets, const std::string &part)
  {
    holds(joined(found_in(sets).errors), part);
  }

  void
  warned(const std::vector<std::string> &sets, const std::string &part)
  {
    const Findings found = found_in(sets);
    BOOST_TEST(found.errors.empty(), "no error: " + joined(found.errors));
    holds(joined(found.warnings), part);
  }

  BOOST_AUTO_TEST_CASE(test_entries)
  {
    const std::string one = "Irregularity 1/", squat = one + "Kind = squat";
    refused({squat},
            "Irregularity 1/Depth = auto: Irregularity 1/Kind = squat has no depth of its own; give one, "
            "such as 0.1 mm");
    refused({one + "Kind = flat", one + "Body = rail"},
            "Irregularity 1/Kind = flat is a shape of wheels; write auto");
    refused({one + "Kind = flat", one + "Depth = 1 mm"},
            ": that of a fresh flat is length^2/(8 R); write auto and give its length");
    refused({one + "Kind = flat", one + "Length = 300 mm"},
            ": longer than half the radius of the wheel, 230 mm");
    refused({one + "Kind = dipped joint", one + "Depth = 1 mm", one + "Angle = 5 mrad"},
            " it says the same twice; write none or auto for one of them");
    refused({one + "Kind = corrugation", one + "Depth = 0.01 mm", one + "Length = 20 mm"},
            "Irregularity 1/Length = 20 mm: shorter than one wave, Irregularity 1/Wavelength = 50 mm; give "
            "the length of all waves");
    refused({one + "Kind = file"}, "Irregularity 1/File = none: Irregularity 1/Kind = file needs one");
    warned({one + "Length = 30 mm"},
           "Irregularity 1/Length = 30 mm: without effect, since Irregularity 1/Kind = none");
    // a scene of the second one alone is listed and read again
    const Scene scene =
      scene_from_text(
        "",
        "none",
        {"Irregularity 2/Kind = weld", "Irregularity 2/Depth = -0.1 mm", "Irregularity 2/Place = 40 mm"})
        .scene;
    const std::string text = print_parameters(scene);
    BOOST_TEST((text.find("subsection Irregularity 2") != std::string::npos &&
                text.find("subsection Irregularity 3") == std::string::npos),
               "an irregularity is listed, those that are none are not");
    BOOST_TEST((print_parameters(scene_from_text(text, "none", {}).scene) == text), "and read again");
  }

  BOOST_AUTO_TEST_CASE(test_runs)
  {
    const std::string one = "Irregularity 1/", depth = one + "Depth = 0.02 mm", place = one + "Place = 45 mm";
    refused({one + "Kind = dent", depth, place, one + "Length = 3 mm"},
            "rises and falls within 3 mm, which cells of 1 mm cannot follow; take Mesh/Solution cell size = "
            "0.37 mm");
    warned({one + "Kind = dent", depth, place, one + "Length = 6 mm"},
           ", fewer than eight cells of 1 mm; take Mesh/Solution cell size = 0.75 mm for results");
    warned({one + "Kind = dent", depth, place, one + "Length = 9 mm"},
           " long: it lies over several waves, and the force follows only a part of their height");
    warned(
      {one + "Kind = dent", depth, one + "Place = 500 mm", one + "Length = 30 mm"},
      "Irregularity 1/Place = 500 mm: the wheel does not come there within Run/Rolling distance = 60 mm");
    warned({one + "Kind = dent", depth, one + "Place = 55 mm", one + "Length = 20 mm"},
           "Irregularity 1/Place = 55 mm: it ends at 65 mm, where the patch is still on it after Run/Rolling "
           "distance = 60 mm; the largest force may come later");
    const std::string until_steady = "Run/Rolling distance = until steady";
    warned({one + "Kind = dent", depth, one + "Place = 0.5 m", one + "Length = 30 mm", until_steady},
           ": the wheel does not come there within Run/Longest distance = ");
    BOOST_TEST(
      !scene_from_text("", "none", {one + "Kind = dent", depth, place, until_steady}).scene.until_steady(),
      "a run over an irregularity does not end before it as steady");
    for (const char *body : {"rail", "wheel"})
      warned(
        {one + "Kind = dent",
         depth,
         place,
         one + "Length = 30 mm",
         one + "Width = 20 mm",
         one + "Lateral place = -40 mm",
         one + "Body = " + body},
        "Irregularity 1/Lateral place = -40 mm: the wheel rolls beside the irregularity; its patch, about ");
    BOOST_TEST(found_in({one + "Kind = dent",
                         depth,
                         one + "Place = 35 mm",
                         one + "Length = 30 mm",
                         one + "Width = 20 mm",
                         one + "Lateral place = -5 mm"})
                 .warnings.empty(),
               "a dent half across the patch is felt");
    for (const std::string &warning :
         found_in({one + "Kind = polygon", depth, one + "Order = 64", one + "Body = wheel"}).warnings)
      BOOST_TEST(
        (warning.find("beside") == std::string::npos && warning.find("ends at") == std::string::npos),
        "waves all around are felt, and have no end: " + warning);
    refused({one + "Kind = polygon", one + "Depth = 1 mm", one + "Order = 64"},
            "on the smooth profile: put a crest there, or take less height or longer waves");
    refused({one + "Kind = dent", depth, one + "Length = 30 mm"},
            " at the patch); a run starts in steady rolling on the smooth profile: move it at least ");
    refused({one + "Kind = dent", depth, place, "Irregularity 2/Kind = dent", "Irregularity 2/Depth = 1 mm"},
            "Irregularity 2/Place = 0 mm: the wheel starts on the rail's irregularity (1 mm at the patch)");
    BOOST_TEST(found_in({one + "Kind = dent", depth, place, one + "Length = 30 mm"}).errors.empty(),
               "a dent on the way is computed");
  }

  void
  write(const char *name, const std::string &text)
  {
    std::ofstream(name) << text;
  }

  BOOST_AUTO_TEST_CASE(test_options)
  {
    const auto parsed = [](const char *text, const bool pitch) {
      return [text, pitch] { parse_irregular_places(text, pitch); };
    };
    says(parsed("0:100:5", false),
         "--places \"0:100:5\": the unit is missing; write first:last:step or values with commas, and mm or "
         "m, such as \"0:100:5 mm\"");
    says(parsed("1, 2 deg", false), "--places \"1, 2 deg\": the unit deg is unknown");
    says(parsed("1:2 deg", true), "--pitch \"1:2 deg\": ");
    const IrregularPlaces places = parse_irregular_places("-2:2:1 deg", true);
    BOOST_TEST(
      (places.pitch && places.values.size() == 5 && std::abs(places.values[0] + 2 * M_PI / 180) < 1e-15),
      "angles in degrees");
    BOOST_TEST((parse_irregular_places("1, 4 m", false).values == std::vector<double>({1., 4.})),
               "places in metres");
    write("scene.prm", "subsection Output\n  set Folder = out\nend\n");
    const auto command = [](const std::vector<std::string> &words) {
      std::ostringstream out;
      const RunFunction  run = [](const Scene &, const SceneGeometry &, const RunOptions &) { return 0; };
      try
        {
          execute(words, run, out);
        }
      catch (const InputError &error)
        {
          out << error.what();
        }
      return out.str();
    };
    write("dent.prm",
          "include scene.prm\nset Title = dent\nsubsection Irregularity 1\n  set Kind = dent\n  set Place = "
          "50 mm\n"
          "  set Length = 20 mm\n  set Width = 20 mm\n  set Depth = 0.1 mm\nend\nsubsection Track\n"
          "  set Support = sleepers\nend\nsubsection Half-space\n  set Element size = 1 mm\nend\n");
    const std::string at_start = command({"halfspace", "dent.prm", "--no-pictures"});
    holds(at_start,
          "note: at the start of the path alone, and the irregular surfaces as they are there; --places");
    holds(at_start, "note: without Track/Support: the contact of steady rolling does not depend on it");
    holds(command({"halfspace", "scene.prm", "--places", "0, 1 mm", "--pitch", "0, 1 deg"}),
          "--places, --pitch and --creep-curve are different tables: give one of them");
    holds(
      command(
        {"halfspace", "scene.prm", "--places", "0, 1 mm", "--set", "Half-space/Undeformed distance = hertz"}),
      "Half-space/Undeformed distance = hertz: --places needs wheel and rail; set it to profiles");
    holds(command({"halfspace", "dent.prm", "--places", "0, 1 mm", "--bodies", "real"}),
          "Half-space/Bodies = real: --places puts the wheel on irregular half-spaces; write half-spaces "
          "there");
    holds(
      command({"halfspace", "scene.prm", "--creep-curve", "spin 0, 1 1/m", "--bodies", "real"}),
      "Half-space/Bodies = real: --creep-curve \"spin ...\" gives the whole contact one spin, which bodies "
      "of their own shape do not have; write half-spaces there");
    holds(
      command({"halfspace", "scene.prm", "--contact-input", "c.inp", "--bodies", "real"}),
      "Half-space/Bodies = real: --contact-input writes the problem of two half-spaces; write half-spaces "
      "there");
    const std::string at_places = command({"halfspace",
                                           "dent.prm",
                                           "--places",
                                           "0, 50 mm",
                                           "--no-pictures",
                                           "--set",
                                           "Wheelset/Lateral shift = -6.5 mm"});
    holds(at_places, "verdict: 0 places trusted, 2 with care, 0 not trusted");
    holds(at_places, "place 50 mm: The surfaces turn by ");
  }
} // namespace
