#include <wheelrail/geometry/profiles.h>
#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using S = Scene;
    using W = WearData;
    using P = WearPlan;

    /// Of the command wear.
    void
    add_plan(EntryList &list)
    {
      list.name_or_file("Mix",
                        {"none"},
                        "a table (with its ending, such as mix.csv)",
                        field(&S::wear_plan, &P::mix),
                        "For the command wear: table of the traffic, a row for each kind with its weight; "
                        "none: the scene alone.");
      list.choice<WornBody>("Worn",
                            {{"rail", WornBody::rail}, {"wheel", WornBody::wheel}, {"both", WornBody::both}},
                            field(&S::wear_plan, &P::worn),
                            "Which profile wears; the other one stays as it is.");
      list.number({"Gross load", "Mt", "> 0 Mt", "10000 Mt"},
                  field(&S::wear_plan, &P::gross_load),
                  "That passes the rail, where rail or both wear.");
      list.number({"Distance", "km", "> 0 km", "1e7 km"},
                  field(&S::wear_plan, &P::distance),
                  "That the wheel rolls, where it wears alone.");
      list.number({"Smoothing length", "mm", "2 mm", "50 mm"},
                  field(&S::wear_plan, &P::smoothing),
                  "Wavelength of the worn depth that is halved; shorter waves vanish, longer ones stay, and "
                  "no material is lost.");
      list.number({"Step depth", "um", "0.01 um", "1000 um"},
                  field(&S::wear_plan, &P::step_depth),
                  "Most that one step takes off; auto, and at most: what changes the pressure by a tenth "
                  "over the smoothing length.",
                  {{"auto", P::automatic}});
      list.number({"Line length", "km", "> 0 km", "100000 km"},
                  field(&S::wear_plan, &P::line_length),
                  "Of the rail that the wheels share, where both wear.");
      list.count(
        {"Wheels", 1, 100000000}, field(&S::wear_plan, &P::wheels), "That share this rail, where both wear.");
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
    add_machining(EntryList &list)
    {
      list.name_or_file("Grind to",
                        none_and(standard_rails()),
                        "a profile file (with its ending, such as rail.txt)",
                        field(&S::wear_plan, &P::grind_to),
                        "Profile that the rail is ground to, where it wears; a file is read as that of Rail. "
                        "none: it is not ground.");
      list.number({"Grind every", "Mt", "> 0 Mt", "10000 Mt"},
                  field(&S::wear_plan, &P::grind_every),
                  "Gross load between two grindings.");
      list.name_or_file("Turn to",
                        none_and(standard_wheels()),
                        "a profile file (with its ending, such as wheel.txt)",
                        field(&S::wear_plan, &P::turn_to),
                        "Profile that the wheel is turned to, where it wears; a file is read as that of "
                        "Wheel. none: it is not turned.");
      list.number({"Turn every", "km", "> 0 km", "1e7 km"},
                  field(&S::wear_plan, &P::turn_every),
                  "Distance of the wheel between two turnings.");
    }
  } // namespace


  std::vector<Entry>
  wear_entries()
  {
    EntryList list("Wear");
    list.number({"Archard coefficient", "", "0", "1"},
                field(&S::wear, &W::archard),
                "k of the depth k p s / H that sliding over s under the pressure p takes away. map: over "
                "slip velocity and pressure (KTH, Jendel 2002).",
                {{"map", W::automatic}});
    list.number({"Hardness", "GPa", "0.1 GPa", "20 GPa"},
                field(&S::wear, &W::hardness),
                "H of the softer steel; 260 HB are 2.55 GPa.");
    list.number({"Shear yield stress", "MPa", "10 MPa", "2000 MPa"},
                field(&S::wear, &W::shear_yield),
                "k of the rail's surface, for fatigue index and shakedown load. auto: from Rail "
                "material/Yield stress; without one both results are left out.",
                {{"auto", W::automatic}});
    const auto t_gamma = [&](const char *name, const char *meaning, double W::*place) {
      list.number({name, "N", "0 N", "10000 N"}, field(&S::wear, place), meaning);
    };
    t_gamma("Damage begins at",
            "T-gamma below which a passage starts no cracks (damage function of Burstow 2004).",
            &W::damage_begins);
    t_gamma("Damage peak at", "T-gamma with the largest damage.", &W::damage_peak);
    t_gamma("Damage ends at", "T-gamma from which on wear takes cracks away.", &W::damage_ends);
    list.number({"Largest damage", "", "0", "1"},
                field(&S::wear, &W::damage_most),
                "Share of a life that one passage takes there.");
    list.number({"Crack depth", "mm", "0.01 mm", "20 mm"},
                field(&S::wear, &W::crack_depth),
                "That wear, grinding or turning has to take off where the damage is 1, for the net of cracks "
                "and wear.");
    add_plan(list);
    add_machining(list);
    return list.entries;
  }
} // namespace wheelrail
