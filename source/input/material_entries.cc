#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>
#include <wheelrail/scene/steels.h>

#include <limits>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// The place of a constant of Chaboche's law.
    template <typename T>
    Field<T>
    cyclic(MaterialData Scene::*part, T CyclicHardening::*member)
    {
      return [part, member](Scene &scene) -> T & { return (scene.*part).cyclic.*member; };
    }

    void
    add_cyclic(EntryList &list, MaterialData Scene::*part)
    {
      using C = CyclicHardening;
      list.number(
        {"Isotropic hardening", "MPa", "-10 GPa", "10 GPa"},
        cyclic(part, &C::isotropic),
        "Q of the law of Chaboche: by how much the yield stress grows in the end; negative: it falls.");
      list.number({"Isotropic rate", "", "0", "100000"},
                  cyclic(part, &C::isotropic_rate),
                  "b of the law of Chaboche: dR = b (Q - R) dp, p the accumulated plastic strain.");
      list.numbers({"Kinematic moduli", "MPa", "> 0 MPa", "10000 GPa"},
                   most_back_stresses,
                   cyclic(part, &C::moduli),
                   "C of each back stress X of the law of Chaboche: dX = 2/3 C dE_p - gamma X dp.");
      list.numbers({"Kinematic rates", "", "0", "1000000"},
                   most_back_stresses,
                   cyclic(part, &C::rates),
                   "gamma of each back stress, as many as moduli; a back stress grows to C / gamma at most, "
                   "without bound with gamma 0.");
      list.number({"Recovery below threshold", "", "0", "1"},
                  cyclic(part, &C::recovery),
                  "Share of the recovery gamma X dp that acts on back stresses below their threshold C / "
                  "gamma, too. 1: Armstrong and Frederick, who ratchet most; 0: Ohno and Wang, who do not "
                  "below the threshold; between them Abdel-Karim and Ohno.");
    }
  } // namespace


  std::vector<Entry>
  material_entries(const std::string &section, MaterialData Scene::*part)
  {
    EntryList list(section);
    using M = MaterialData;
    list.number({"Young's modulus", "GPa", "1 GPa", "1000 GPa"},
                field(part, &M::youngs_modulus),
                "Slope of the elastic line.");
    list.number({"Poisson's ratio", "", "0", "0.49"},
                field(part, &M::poissons_ratio),
                "Lateral over axial strain, elastic.");
    list.number(
      {"Density", "kg/m3", "100 kg/m3", "30000 kg/m3"}, field(part, &M::density), "Mass per volume.");
    Words<std::string> steels{{"any", "any"}};
    for (const Steel &steel : part == &Scene::rail_material ? rail_steels() : wheel_steels())
      steels.push_back({steel.name, steel.name});
    list.choice<std::string>(
      "Steel",
      steels,
      field(part, &M::steel),
      "EN 13674-1; wheels: ER6 to ER9, EN 13262. Beyond its shakedown limit elastic results "
      "are with care; any: R350HT.");
    list.choice<SteelLaw>(
      "Law",
      {{"elastic", SteelLaw::elastic}, {"bilinear", SteelLaw::bilinear}, {"Chaboche", SteelLaw::chaboche}},
      field(part, &M::law),
      "How the steel answers beyond yield. bilinear: linear hardening (Tangent modulus, Kinematic hardening "
      "fraction); Chaboche: cyclic hardening (the entries Isotropic and Kinematic ...); elastic: not at "
      "all.");
    list.number({"Yield stress", "MPa", "1 MPa", "10 GPa"},
                field(part, &M::yield_stress),
                "Initial yield stress; none: the body stays elastic.",
                {{"none", std::numeric_limits<double>::infinity()}});
    list.number({"Tangent modulus", "GPa", "0 GPa", "1000 GPa"},
                field(part, &M::tangent_modulus),
                "Slope of the total stress-strain curve of the bilinear law beyond yield; without effect "
                "while the yield stress is none.");
    list.number({"Kinematic hardening fraction", "", "0", "1"},
                field(part, &M::kinematic_hardening),
                "Of the bilinear law. 0: isotropic, 1: kinematic hardening; without effect while the yield "
                "stress is none.");
    add_cyclic(list, part);
    return list.entries;
  }
} // namespace wheelrail
