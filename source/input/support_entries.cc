#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <limits>

namespace wheelrail
{
  namespace
  {
    using S = Scene;

    void
    add_stiffness(EntryList &list, const char *name, double SupportData::*place, const char *meaning)
    {
      list.number({name, "MN/m", "0.1 MN/m", "1000000 MN/m"}, field(&S::support, place), meaning);
    }

    void
    add_frequency(EntryList &list, const char *name, double SupportData::*place, const char *meaning)
    {
      list.number({name, "Hz", "1 Hz", "10 kHz"}, field(&S::support, place), meaning);
    }

    void
    add_pad_entries(EntryList &list)
    {
      list.number({"Pad length", "mm", "10 mm", "1 m"},
                  field(&S::support, &SupportData::pad_length),
                  "Of a pad along the rail; pads are as wide as the foot.");
      add_stiffness(list,
                    "Pad stiffness",
                    &SupportData::pad_stiffness,
                    "Of one pad, normal to the rail's foot, at Pad damping frequency.");
      add_stiffness(list, "Pad lateral stiffness", &SupportData::pad_lateral, "Of one pad, across the rail.");
      add_stiffness(
        list, "Pad longitudinal stiffness", &SupportData::pad_longitudinal, "Of one pad, along the rail.");
      list.number({"Pad loss factor", "", "0", "2"},
                  field(&S::support, &SupportData::pad_loss),
                  "Of the pads in all directions; 0: none.");
      list.choice<PadLoss>("Pad damping",
                           {{"damper", PadLoss::damper}, {"constant", PadLoss::constant}},
                           field(&S::support, &SupportData::pad_damping),
                           "How the loss factor depends on frequency; damper: in proportion, by one damper "
                           "that is matched at Pad damping frequency; constant: the same from 100 to 2000 "
                           "Hz, by three Maxwell branches, which make the pad stiffer with frequency.");
      add_frequency(list,
                    "Pad damping frequency",
                    &SupportData::pad_frequency,
                    "At which pads have their stiffness and loss factor.");
    }

    void
    add_ballast_entries(EntryList &list)
    {
      list.number({"Sleeper mass", "kg", "1 kg", "10 t"},
                  field(&S::support, &SupportData::sleeper_mass),
                  "Of the half of a sleeper below one rail, which moves without turning; rigid: sleepers do "
                  "not move, and there is no ballast.",
                  {{"rigid", std::numeric_limits<double>::infinity()}});
      add_stiffness(
        list, "Ballast stiffness", &SupportData::ballast_stiffness, "Below one end of a sleeper, vertical.");
      add_stiffness(
        list, "Ballast lateral stiffness", &SupportData::ballast_lateral, "Of one end of a sleeper.");
      add_stiffness(list,
                    "Ballast longitudinal stiffness",
                    &SupportData::ballast_longitudinal,
                    "Of one end of a sleeper.");
      list.number({"Ballast loss factor", "", "0", "10"},
                  field(&S::support, &SupportData::ballast_loss),
                  "By one damper in each direction; 0: none.");
      add_frequency(list,
                    "Ballast damping frequency",
                    &SupportData::ballast_frequency,
                    "At which ballast has its loss factor.");
    }
  } // namespace


  void
  add_support_entries(EntryList &list)
  {
    list.choice<RailSupport>(
      "Support",
      {{"clamped foot", RailSupport::clamped_foot},
       {"continuous pads", RailSupport::continuous_pads},
       {"sleepers", RailSupport::sleepers}},
      field(&S::support, &SupportData::kind),
      "What supports the rail; clamped foot: foot and ends of the rail do not move; continuous pads: the "
      "pads of all sleepers spread evenly along the rail, on rigid ground; sleepers: a pad on each sleeper. "
      "On pads the ends of the rail are free.");
    list.number({"Sleeper spacing", "mm", "100 mm", "5 m"},
                field(&S::support, &SupportData::spacing),
                "Also of continuous pads: their stiffness per length is that of one pad over it.");
    list.number({"First sleeper", "mm", "-5 m", "5 m"},
                field(&S::support, &SupportData::first_sleeper),
                "How far ahead of the start of the wheel one of the sleepers lies; the others follow before "
                "and behind it.");
    add_pad_entries(list);
    add_ballast_entries(list);
    list.number({"Damped ends", "m", "0 mm", "5 m"},
                field(&S::support, &SupportData::damped_ends),
                "Stretch at either end of the rail in which damping rises from zero, so that waves do not "
                "come back; 3 to 5 m, on a rail that is as much longer; 0 mm: none.");
  }
} // namespace wheelrail
