#include <wheelrail/geometry/profiles.h>
#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using D = Dimension;
    using B = Bounds;
    using S = Scene;
    using W = WearData;
    using P = WearPlan;

    /// Of the command wear.
    void
    add_plan(std::vector<Entry> &list)
    {
      list.push_back(name_or_file_entry({"Wear",
                                         "Mix",
                                         "For the command wear: table of the traffic, a row for each kind "
                                         "with its weight; none: the scene alone."},
                                        {"none"},
                                        "a table (with its ending, such as mix.csv)",
                                        field(&S::wear_plan, &P::mix)));
      list.push_back(choice_entry<WornBody>(
        {"Wear", "Worn", "Which profile wears; the other one stays as it is."},
        {{"rail", WornBody::rail}, {"wheel", WornBody::wheel}, {"both", WornBody::both}},
        field(&S::wear_plan, &P::worn)));
      list.push_back(number_entry({"Wear", "Gross load", "That passes the rail, where rail or both wear."},
                                  D::mass,
                                  "Mt",
                                  B::above("0 Mt", "10000 Mt"),
                                  field(&S::wear_plan, &P::gross_load)));
      list.push_back(length_entry({"Wear", "Distance", "That the wheel rolls, where it wears alone."},
                                  "km",
                                  B::above("0 km", "1e7 km"),
                                  field(&S::wear_plan, &P::distance)));
      list.push_back(
        length_entry({"Wear",
                      "Smoothing length",
                      "Wavelength of the worn depth that is halved; shorter waves vanish, longer "
                      "ones stay, and no material is lost."},
                     "mm",
                     B::between("2 mm", "50 mm"),
                     field(&S::wear_plan, &P::smoothing)));
      const auto depth = field(&S::wear_plan, &P::step_depth);
      list.push_back(
        with_word(length_entry({"Wear",
                                "Step depth",
                                "Most that one step takes off; auto, and at most: what changes the "
                                "pressure by a tenth over the smoothing length."},
                               "um",
                               B::between("0.01 um", "1000 um"),
                               depth),
                  "auto",
                  P::automatic,
                  depth));
      list.push_back(
        length_entry({"Wear", "Line length", "Of the rail that the wheels share, where both wear."},
                     "km",
                     B::above("0 km", "100000 km"),
                     field(&S::wear_plan, &P::line_length)));
      list.push_back(count_entry({"Wear", "Wheels", "That share this rail, where both wear."},
                                 1,
                                 100000000,
                                 field(&S::wear_plan, &P::wheels)));
    }

    std::vector<std::string>
    none_and(const std::vector<std::string> &names)
    {
      std::vector<std::string> all{"none"};
      all.insert(all.end(), names.begin(), names.end());
      return all;
    }

    /// Grinding of the rail and turning of the wheel between steps.
    void
    add_machining(std::vector<Entry> &list)
    {
      list.push_back(name_or_file_entry({"Wear",
                                         "Grind to",
                                         "Profile that the rail is ground to, where it wears; a file is read "
                                         "as that of Rail. none: it is not ground."},
                                        none_and(standard_rails()),
                                        "a profile file (with its ending, such as rail.txt)",
                                        field(&S::wear_plan, &P::grind_to)));
      list.push_back(number_entry({"Wear", "Grind every", "Gross load between two grindings."},
                                  D::mass,
                                  "Mt",
                                  B::above("0 Mt", "10000 Mt"),
                                  field(&S::wear_plan, &P::grind_every)));
      list.push_back(name_or_file_entry({"Wear",
                                         "Turn to",
                                         "Profile that the wheel is turned to, where it wears; a file is "
                                         "read as that of Wheel. none: it is not turned."},
                                        none_and(standard_wheels()),
                                        "a profile file (with its ending, such as wheel.txt)",
                                        field(&S::wear_plan, &P::turn_to)));
      list.push_back(length_entry({"Wear", "Turn every", "Distance of the wheel between two turnings."},
                                  "km",
                                  B::above("0 km", "1e7 km"),
                                  field(&S::wear_plan, &P::turn_every)));
    }
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
                    "material/Yield stress; without one both results are left out."},
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
    list.push_back(length_entry({"Wear",
                                 "Crack depth",
                                 "That wear, grinding or turning has to take off where the damage is 1, for "
                                 "the net of cracks and wear."},
                                "mm",
                                B::between("0.01 mm", "20 mm"),
                                field(&S::wear, &W::crack_depth)));
    add_plan(list);
    add_machining(list);
    return list;
  }
} // namespace wheelrail
