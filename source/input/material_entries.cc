#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <limits>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using D = Dimension;
    using B = Bounds;
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
    list.push_back(
      number_entry({section,
                    "Tangent modulus",
                    "Slope of the total stress-strain curve beyond yield; without effect while the "
                    "yield stress is none."},
                   D::stress,
                   "GPa",
                   B::between("0 GPa", "1000 GPa"),
                   field(part, &M::tangent_modulus)));
    list.push_back(
      pure_entry({section,
                  "Kinematic hardening fraction",
                  "0: isotropic, 1: kinematic hardening; without effect while the yield stress is none."},
                 B::between("0", "1"),
                 field(part, &M::kinematic_hardening)));
    return list;
  }
} // namespace wheelrail
