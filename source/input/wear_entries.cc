#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <vector>

namespace wheelrail
{
  namespace
  {
    using D = Dimension;
    using B = Bounds;
    using S = Scene;
    using W = WearData;
  } // namespace


  std::vector<Entry>
  wear_entries()
  {
    std::vector<Entry> list;
    const auto         archard = field(&S::wear, &W::archard);
    list.push_back(with_word(
      pure_entry(
        {"Wear",
         "Archard coefficient",
         "k of the depth k p s / H that sliding over s under the pressure p takes away. map: over slip "
         "velocity and pressure (KTH, Jendel 2002)."},
        B::between("0", "1"),
        archard),
      "map",
      W::automatic,
      archard));
    list.push_back(number_entry({"Wear", "Hardness", "H of the softer steel; 260 HB are 2.55 GPa."},
                                D::stress,
                                "GPa",
                                B::between("0.1 GPa", "20 GPa"),
                                field(&S::wear, &W::hardness)));
    const auto shear = field(&S::wear, &W::shear_yield);
    list.push_back(with_word(
      number_entry({"Wear",
                    "Shear yield stress",
                    "k of the rail's surface, for fatigue index and shakedown load. auto: from Rail "
                    "material/Yield stress; without one both figures are left out."},
                   D::stress,
                   "MPa",
                   B::between("10 MPa", "2000 MPa"),
                   shear),
      "auto",
      W::automatic,
      shear));
    const auto t_gamma = [&](const char *name, const char *meaning, double W::*place) {
      list.push_back(number_entry(
        {"Wear", name, meaning}, D::force, "N", B::between("0 N", "10000 N"), field(&S::wear, place)));
    };
    t_gamma("Damage begins at",
            "T-gamma below which a passage starts no cracks (damage function of Burstow 2004).",
            &W::damage_begins);
    t_gamma("Damage peak at", "T-gamma with the largest damage.", &W::damage_peak);
    t_gamma("Damage ends at", "T-gamma from which on wear takes cracks away.", &W::damage_ends);
    list.push_back(pure_entry({"Wear", "Largest damage", "Share of a life that one passage takes there."},
                              B::between("0", "1"),
                              field(&S::wear, &W::damage_most)));
    return list;
  }
} // namespace wheelrail
