#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <limits>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using B = Bounds;
    using S = Scene;

    Entry
    stiffness_entry(const std::string &name, const std::string &meaning, double SupportData::*place)
    {
      return number_entry({"Track", name, meaning},
                          Dimension::stiffness,
                          "MN/m",
                          B::between("0.1 MN/m", "1000000 MN/m"),
                          field(&S::support, place));
    }

    Entry
    frequency_entry(const std::string &name, const std::string &meaning, double SupportData::*place)
    {
      return number_entry({"Track", name, meaning},
                          Dimension::frequency,
                          "Hz",
                          B::between("1 Hz", "10 kHz"),
                          field(&S::support, place));
    }

    void
    add_pad_entries(std::vector<Entry> &list)
    {
      list.push_back(
        length_entry({"Track", "Pad length", "Of a pad along the rail; pads are as wide as the foot."},
                     "mm",
                     B::between("10 mm", "1 m"),
                     field(&S::support, &SupportData::pad_length)));
      list.push_back(stiffness_entry("Pad stiffness",
                                     "Of one pad, normal to the rail's foot, at Pad damping frequency.",
                                     &SupportData::pad_stiffness));
      list.push_back(
        stiffness_entry("Pad lateral stiffness", "Of one pad, across the rail.", &SupportData::pad_lateral));
      list.push_back(stiffness_entry(
        "Pad longitudinal stiffness", "Of one pad, along the rail.", &SupportData::pad_longitudinal));
      list.push_back(pure_entry({"Track", "Pad loss factor", "Of the pads in all directions; 0: none."},
                                B::between("0", "2"),
                                field(&S::support, &SupportData::pad_loss)));
      list.push_back(choice_entry<PadLoss>({"Track",
                                            "Pad damping",
                                            "How the loss factor goes with frequency; damper: in proportion, "
                                            "by one damper that is matched at Pad "
                                            "damping frequency; constant: the same from 100 to 2000 Hz, by "
                                            "three Maxwell branches, which make the "
                                            "pad stiffer with frequency."},
                                           {{"damper", PadLoss::damper}, {"constant", PadLoss::constant}},
                                           field(&S::support, &SupportData::pad_damping)));
      list.push_back(frequency_entry("Pad damping frequency",
                                     "At which pads have their stiffness and loss factor.",
                                     &SupportData::pad_frequency));
    }

    void
    add_ballast_entries(std::vector<Entry> &list)
    {
      const auto mass = field(&S::support, &SupportData::sleeper_mass);
      list.push_back(
        with_word(number_entry({"Track",
                                "Sleeper mass",
                                "Of the half of a sleeper below one rail, which moves without turning; "
                                "rigid: sleepers do not move, and there is no ballast."},
                               Dimension::mass,
                               "kg",
                               B::between("1 kg", "10 t"),
                               mass),
                  "rigid",
                  std::numeric_limits<double>::infinity(),
                  mass));
      list.push_back(stiffness_entry(
        "Ballast stiffness", "Below one end of a sleeper, vertical.", &SupportData::ballast_stiffness));
      list.push_back(stiffness_entry(
        "Ballast lateral stiffness", "Of one end of a sleeper.", &SupportData::ballast_lateral));
      list.push_back(stiffness_entry(
        "Ballast longitudinal stiffness", "Of one end of a sleeper.", &SupportData::ballast_longitudinal));
      list.push_back(pure_entry({"Track", "Ballast loss factor", "By one damper in each direction; 0: none."},
                                B::between("0", "10"),
                                field(&S::support, &SupportData::ballast_loss)));
      list.push_back(frequency_entry("Ballast damping frequency",
                                     "At which ballast has its loss factor.",
                                     &SupportData::ballast_frequency));
    }
  } // namespace


  void
  add_support_entries(std::vector<Entry> &list)
  {
    list.push_back(choice_entry<RailSupport>({"Track",
                                              "Support",
                                              "What the rail stands on; clamped foot: foot and ends of the "
                                              "rail do not move; continuous pads: the pads of "
                                              "all sleepers spread evenly along the rail, on rigid ground; "
                                              "sleepers: a pad on each sleeper. On pads the "
                                              "ends of the rail are free."},
                                             {{"clamped foot", RailSupport::clamped_foot},
                                              {"continuous pads", RailSupport::continuous_pads},
                                              {"sleepers", RailSupport::sleepers}},
                                             field(&S::support, &SupportData::kind)));
    list.push_back(
      length_entry({"Track",
                    "Sleeper spacing",
                    "Also of continuous pads: their stiffness per length is that of one pad over it."},
                   "mm",
                   B::between("100 mm", "5 m"),
                   field(&S::support, &SupportData::spacing)));
    list.push_back(
      length_entry({"Track",
                    "First sleeper",
                    "How far ahead of the start of the wheel one of the sleepers lies; the others "
                    "follow before and behind it."},
                   "mm",
                   B::between("-5 m", "5 m"),
                   field(&S::support, &SupportData::first_sleeper)));
    add_pad_entries(list);
    add_ballast_entries(list);
    list.push_back(
      length_entry({"Track",
                    "Damped ends",
                    "Stretch at either end of the rail in which damping rises from zero, so that waves "
                    "do not come back; 3 to 5 m, on a rail that is as much longer; 0 mm: none."},
                   "m",
                   B::between("0 mm", "5 m"),
                   field(&S::support, &SupportData::damped_ends)));
  }
} // namespace wheelrail
