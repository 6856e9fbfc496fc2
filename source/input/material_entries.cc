#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using D = Dimension;
    using B = Bounds;

    /// The place of a constant of Chaboche's law.
    template <typename T>
    Field<T>
    cyclic(MaterialData Scene::*part, T CyclicHardening::*member)
    {
      return [part, member](Scene &scene) -> T & { return (scene.*part).cyclic.*member; };
    }

    std::vector<Entry>
    cyclic_entries(const std::string &section, MaterialData Scene::*part)
    {
      using C = CyclicHardening;
      std::vector<Entry> list;
      list.push_back(number_entry({section,
                                   "Isotropic hardening",
                                   "Q of the law of Chaboche: by how much the yield stress grows in the end; "
                                   "negative: it falls."},
                                  D::stress,
                                  "MPa",
                                  B::between("-10 GPa", "10 GPa"),
                                  cyclic(part, &C::isotropic)));
      list.push_back(
        pure_entry({section,
                    "Isotropic rate",
                    "b of the law of Chaboche: dR = b (Q - R) dp, p the accumulated plastic strain."},
                   B::between("0", "100000"),
                   cyclic(part, &C::isotropic_rate)));
      list.push_back(
        list_entry({section,
                    "Kinematic moduli",
                    "C of each back stress X of the law of Chaboche: dX = 2/3 C dE_p - gamma X dp."},
                   D::stress,
                   "MPa",
                   B::above("0 MPa", "10000 GPa"),
                   most_back_stresses,
                   cyclic(part, &C::moduli)));
      list.push_back(
        list_entry({section,
                    "Kinematic rates",
                    "gamma of each back stress, as many as moduli; a back stress grows to C / gamma at "
                    "most, without bound with gamma 0."},
                   D::none,
                   "",
                   B::between("0", "1000000"),
                   most_back_stresses,
                   cyclic(part, &C::rates)));
      list.push_back(
        pure_entry({section,
                    "Recovery below threshold",
                    "Share of the recovery gamma X dp that acts on back stresses below their threshold "
                    "C / gamma, too. 1: Armstrong and Frederick, who ratchet most; 0: Ohno and Wang, who "
                    "do not below the threshold; between them Abdel-Karim and Ohno."},
                   B::between("0", "1"),
                   cyclic(part, &C::recovery)));
      return list;
    }
  } // namespace


  std::vector<Entry>
  material_entries(const std::string &section, MaterialData Scene::*part)
  {
    std::vector<Entry> list;
    using M = MaterialData;
    list.push_back(number_entry({section, "Young's modulus", "Slope of the elastic line."},
                                D::stress,
                                "GPa",
                                B::between("1 GPa", "1000 GPa"),
                                field(part, &M::youngs_modulus)));
    list.push_back(pure_entry({section, "Poisson's ratio", "Lateral over axial strain, elastic."},
                              B::between("0", "0.49"),
                              field(part, &M::poissons_ratio)));
    list.push_back(number_entry({section, "Density", "Mass per volume."},
                                D::density,
                                "kg/m3",
                                B::between("100 kg/m3", "30000 kg/m3"),
                                field(part, &M::density)));
    list.push_back(choice_entry<SteelLaw>(
      {section,
       "Law",
       "How the steel answers beyond yield. bilinear: linear hardening (Tangent modulus, Kinematic hardening "
       "fraction); Chaboche: cyclic hardening (the entries Isotropic and Kinematic ...); elastic: not at "
       "all."},
      {{"elastic", SteelLaw::elastic}, {"bilinear", SteelLaw::bilinear}, {"Chaboche", SteelLaw::chaboche}},
      field(part, &M::law)));
    const auto yield_stress = field(part, &M::yield_stress);
    list.push_back(
      with_word(number_entry({section, "Yield stress", "Initial yield stress; none: the body stays elastic."},
                             D::stress,
                             "MPa",
                             B::between("1 MPa", "10 GPa"),
                             yield_stress),
                "none",
                std::numeric_limits<double>::infinity(),
                yield_stress));
    list.push_back(number_entry(
      {section,
       "Tangent modulus",
       "Slope of the total stress-strain curve of the bilinear law beyond yield; without effect while "
       "the yield stress is none."},
      D::stress,
      "GPa",
      B::between("0 GPa", "1000 GPa"),
      field(part, &M::tangent_modulus)));
    list.push_back(pure_entry(
      {section,
       "Kinematic hardening fraction",
       "Of the bilinear law. 0: isotropic, 1: kinematic hardening; without effect while the yield stress "
       "is none."},
      B::between("0", "1"),
      field(part, &M::kinematic_hardening)));
    for (Entry &entry : cyclic_entries(section, part))
      list.push_back(std::move(entry));
    return list;
  }
} // namespace wheelrail
