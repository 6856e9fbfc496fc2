#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <cctype>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Numbers, all strains or all stresses with their units.
    Stations
    parse_stations(const std::string &text)
    {
      Stations stations;
      if (text == "none")
        return stations;
      bool strain = false;
      for (const std::string &part : split_list(text, ','))
        {
          const bool has_unit = !part.empty() && std::isalpha(static_cast<unsigned char>(part.back()));
          (has_unit ? stations.of_stress : strain) = true;
          stations.values.push_back(parse_quantity(part, has_unit ? Dimension::stress : Dimension::none));
        }
      if (strain && stations.of_stress)
        throw InputError(
          "strains and stresses together; write all values as strains (0.01) or all as stresses "
          "(500 MPa)");
      return stations;
    }

    std::string
    stations_text(const Stations &stations)
    {
      std::string text;
      for (const double value : stations.values)
        text += (text.empty() ? "" : ", ") + format_quantity(value, stations.of_stress ? "MPa" : "");
      return text.empty() ? "none" : text;
    }

    void
    add_stations(EntryList &list, const char *name, Stations MaterialTest::*place, const char *meaning)
    {
      list.add(
        name,
        meaning,
        "none, or strains (0.01, -0.01) or stresses (700 MPa, -500 MPa) with commas between them",
        [place](Scene &scene, const std::string &text) { scene.material_test.*place = parse_stations(text); },
        [place](const Scene &scene) { return stations_text(scene.material_test.*place); });
    }

    template <typename T>
    Field<T>
    test_field(T MaterialTest::*member)
    {
      return field(&Scene::material_test, member);
    }
  } // namespace


  std::vector<Entry>
  material_test_entries()
  {
    EntryList list("Material test");
    list.choice<Body>("Body",
                      {{"rail", Body::rail}, {"wheel", Body::wheel}},
                      test_field(&MaterialTest::body),
                      "Whose steel the command material drives.");
    add_stations(list,
                 "Axial",
                 &MaterialTest::axial,
                 "Values that the strain or stress along x goes through in each cycle; a single one is held; "
                 "none: free of stress.");
    add_stations(list,
                 "Shear",
                 &MaterialTest::shear,
                 "The same for the shear in the plane xy, as of a thin tube in torsion; strains are changes "
                 "of the angle.");
    list
      .text("File",
            test_field(&MaterialTest::file),
            "Rows of strains and stresses to go through instead of Axial and Shear: CSV, first a line of "
            "names out of E_xx ... E_xy (tensor components) and S_xx_MPa ... S_xy_MPa; what has no column "
            "is free of stress.")
      .names_files = true;
    list.count(
      {"Cycles", 1, 100000}, test_field(&MaterialTest::cycles), "How often the path is gone through.");
    list.count({"Steps", 1, 100000},
               test_field(&MaterialTest::steps),
               "Steps of the law from one value to the next, whose errors fall with their number; auto: as "
               "many as answers within 0.1 % need.",
               {{"auto", 0u}});
    return list.entries;
  }
} // namespace wheelrail
