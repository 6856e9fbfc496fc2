#include <wheelrail/base/choices.h>
#include <wheelrail/base/errors.h>
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
    using S = Scene;

    Entry
    nominal_radius_entry()
    {
      Entry      entry = number_entry({"Wheelset",
                                       "Nominal rolling radius",
                                       "Radius of the wheel at the running circle, 70 mm from the flange back."},
                                 Dimension::length,
                                 "mm",
                                 Bounds::between("150 mm", "800 mm"),
                                 field(&Scene::track, &TrackDimensions::nominal_radius));
      const auto set   = entry.set;
      entry.set        = [set](Scene &scene, const std::string &text) {
        set(scene, text);
        scene.wheel.nominal_radius = scene.track.nominal_radius;
      };
      return entry;
    }

    /// A word or an angle.
    Entry
    roll_entry()
    {
      const EntryHead head{
        "Wheelset",
        "Roll",
        "Roll of the wheelset; from contact: the one at which both wheels touch; an angle is "
        "positive when the modelled wheel goes down."};
      Entry entry =
        number_entry(head, D::angle, "mrad", B::between("-50 mrad", "50 mrad"), field(&S::roll_angle));
      const std::vector<std::pair<std::string, RollMode>> words = {{"none", RollMode::none},
                                                                   {"from contact", RollMode::from_contact}};
      entry.accepted                                            = "none, from contact, or " + entry.accepted;
      entry.set = [words, set = entry.set, accepted = entry.accepted](Scene &scene, const std::string &text) {
        for (const auto &word : words)
          if (word.first == text)
            {
              scene.roll       = word.second;
              scene.roll_angle = 0;
              return;
            }
        if (text.find_first_of("0123456789") == std::string::npos)
          throw InputError((text.empty() ? "no value" : "not known here") +
                           perhaps(text, {"none", "from contact"}) + "; " + accepted + " is accepted");
        set(scene, text);
        scene.roll = RollMode::given;
      };
      entry.get = [words, get = entry.get](const Scene &scene) {
        for (const auto &word : words)
          if (scene.roll == word.second)
            return word.first;
        return get(scene);
      };
      return entry;
    }

    void
    add_wheel_section(std::vector<Entry> &list)
    {
      struct Row
      {
        const char *name, *low, *high, *meaning;
        double WheelDimensions::*member;
      };
      using W                     = WheelDimensions;
      const std::vector<Row> rows = {
        {"Rim width", "100 mm", "200 mm", "Width of the rim from the flange back.", &W::rim_width},
        {"Rim inner radius", "50 mm", "750 mm", "Inner radius of the rim.", &W::rim_inner_radius},
        {"Disc thickness", "5 mm", "100 mm", "Thickness of the straight disc.", &W::disc_thickness},
        {"Disc position",
         "0 mm",
         "200 mm",
         "Middle of the disc, from the flange back towards the field side.",
         &W::disc_position},
        {"Hub length", "20 mm", "400 mm", "Length of the hub along the axle.", &W::hub_length},
        {"Hub position",
         "0 mm",
         "200 mm",
         "Middle of the hub, from the flange back towards the field side.",
         &W::hub_position},
        {"Hub outer radius", "30 mm", "500 mm", "Outer radius of the hub.", &W::hub_outer_radius},
        {"Bore radius",
         "10 mm",
         "400 mm",
         "Radius of the hub bore, tied to the rigid axle.",
         &W::bore_radius},
        {"Fillet radius", "1 mm", "100 mm", "Fillets of the disc at rim and hub.", &W::fillet_radius},
      };
      for (const Row &row : rows)
        list.push_back(length_entry({"Wheelset", row.name, row.meaning},
                                    "mm",
                                    B::between(row.low, row.high),
                                    field(&S::wheel, row.member)));
    }

    /// Of the wheelset with both wheels.
    void
    add_axle(std::vector<Entry> &list)
    {
      list.push_back(choice_entry<bool>({"Wheelset",
                                         "Wheels",
                                         "Of halfspace and vehicle. one: the modelled wheel alone; both: the "
                                         "whole wheelset on its two rails."},
                                        {{"one", false}, {"both", true}},
                                        field(&S::both_wheels)));
      list.push_back(choice_entry<bool>({"Wheelset",
                                         "Axle",
                                         "With Wheels = both. rigid: both wheels turn at one rate, and share "
                                         "the torque; independent: each turns by itself."},
                                        {{"rigid", true}, {"independent", false}},
                                        field(&S::rigid_axle)));
      list.push_back(choice_entry<bool>({"Wheelset",
                                         "Pose",
                                         "With Wheels = both. given: Lateral shift and Yaw are those of the "
                                         "wheelset; equilibrium: both are found "
                                         "such that the forces on the wheelset balance, with springs that "
                                         "are at rest at Lateral shift and Yaw."},
                                        {{"given", false}, {"equilibrium", true}},
                                        field(&S::pose_balances)));
      list.push_back(number_entry(
        {"Wheelset", "Lateral stiffness", "Of the spring that guides the wheelset, with Pose = equilibrium."},
        D::stiffness,
        "MN/m",
        B::between("0 MN/m", "1000 MN/m"),
        field(&S::lateral_stiffness)));
      list.push_back(
        number_entry({"Wheelset",
                      "Yaw stiffness",
                      "Of the spring that guides the wheelset about the vertical, with Pose = equilibrium."},
                     D::turning_stiffness,
                     "MN m/rad",
                     B::between("0 MN m/rad", "1000 MN m/rad"),
                     field(&S::yaw_stiffness)));
      list.push_back(length_entry(
        {"Wheelset",
         "Centre of gravity height",
         "Of what rests on the axle, above the rails: how much of the load goes to the outer wheel "
         "of a curve with Track/Cant."},
        "m",
        B::between("0 m", "4 m"),
        field(&S::centre_height)));
    }

    void
    add_wheelset(std::vector<Entry> &list)
    {
      list.push_back(nominal_radius_entry());
      list.push_back(length_entry(
        {"Wheelset", "Flange back distance", "Distance between the backs of the flanges of the two wheels."},
        "mm",
        B::between("400 mm", "1950 mm"),
        field(&S::track, &TrackDimensions::flange_back_distance)));
      list.push_back(choice_entry<bool>({"Wheelset",
                                         "Side",
                                         "The modelled wheel, on the right-hand or the left-hand rail; "
                                         "lateral shift, roll, yaw and lateral creepage "
                                         "are those of the wheelset, with the signs for its right-hand "
                                         "wheel; results count to the track centre of "
                                         "the modelled wheel."},
                                        {{"right", false}, {"left", true}},
                                        field(&S::left_wheel)));
      add_axle(list);
      list.push_back(
        length_entry({"Wheelset",
                      "Lateral shift",
                      "Lateral position of the wheelset; negative moves the flange root of the modelled "
                      "(right-hand) wheel towards the gauge corner."},
                     "mm",
                     B::between("-12 mm", "12 mm"),
                     field(&S::lateral_shift)));
      list.push_back(roll_entry());
      list.push_back(number_entry(
        {"Wheelset",
         "Yaw",
         "Angle of attack: the wheelset turned about the vertical "
         "through its middle; positive when its nose turns to the track centre, away from the flange of the "
         "modelled wheel."},
        D::angle,
        "mrad",
        B::between("-50 mrad", "50 mrad"),
        field(&S::yaw)));
      add_wheel_section(list);
      list.push_back(number_entry({"Wheelset", "Sprung mass", "Mass that the suspension carries, per wheel."},
                                  D::mass,
                                  "t",
                                  B::between("0 t", "50 t"),
                                  field(&S::sprung_mass)));
      const auto load = field(&S::wheel_load);
      list.push_back(with_word(
        number_entry({"Wheelset",
                      "Wheel load",
                      "Static load on the rail; the sprung mass is then what it needs besides wheel and "
                      "half axle. auto: from Sprung mass."},
                     D::force,
                     "kN",
                     B::between("1 kN", "500 kN"),
                     load),
        "auto",
        0,
        load));
      list.push_back(number_entry({"Wheelset", "Axle mass", "Mass of half the axle, rigid."},
                                  D::mass,
                                  "kg",
                                  B::between("0 kg", "5 t"),
                                  field(&S::axle_mass)));
      list.push_back(number_entry(
        {"Wheelset", "Axle pitch inertia", "Moment of inertia of half the axle about its own axis."},
        D::mass_moment,
        "kg m2",
        B::between("0 kg m2", "1000 kg m2"),
        field(&S::axle_pitch_inertia)));
      list.push_back(number_entry({"Wheelset", "Suspension stiffness", "Primary suspension, per wheel."},
                                  D::stiffness,
                                  "MN/m",
                                  B::between("0 MN/m", "1000 MN/m"),
                                  field(&S::suspension_stiffness)));
      list.push_back(number_entry({"Wheelset", "Suspension damping", "Primary suspension, per wheel."},
                                  D::damping,
                                  "N s/m",
                                  B::between("0 N s/m", "1000 kN s/m"),
                                  field(&S::suspension_damping)));
    }

    void
    add_drive(std::vector<Entry> &list)
    {
      list.push_back(number_entry({"Wheelset", "Velocity", "Speed of the wheelset along the track."},
                                  D::velocity,
                                  "km/h",
                                  B::between("5 km/h", "500 km/h"),
                                  field(&S::velocity)));
      list.push_back(choice_entry<Drive>({"Wheelset",
                                          "Drive",
                                          "What turns the wheel; torque: a constant torque from the traction "
                                          "coefficient; rate: the pitch rate is "
                                          "held at the creepage."},
                                         {{"torque", Drive::torque}, {"rate", Drive::rate}},
                                         field(&S::drive)));
      list.push_back(
        pure_entry({"Wheelset",
                    "Traction coefficient",
                    "Longitudinal force over static wheel load, used with Drive = torque; positive drives, "
                    "negative brakes, 0 rolls freely."},
                   B::between("-1", "1"),
                   field(&S::traction_coefficient)));
      list.push_back(
        pure_entry({"Wheelset",
                    "Creepage",
                    "(rolling speed of the tread - velocity) / velocity, used with Drive = rate; positive "
                    "drives."},
                   B::between("-0.1", "0.1"),
                   field(&S::creepage)));
      list.push_back(
        pure_entry({"Wheelset",
                    "Lateral creepage",
                    "Lateral velocity of the wheelset over velocity, besides that of its yaw; positive to "
                    "the track centre."},
                   B::between("-0.1", "0.1"),
                   field(&S::lateral_creepage)));
    }

    void
    add_motion(std::vector<Entry> &list)
    {
      list.push_back(name_or_file_entry(
        {"Wheelset",
         "Motion",
         "none: the wheelset keeps its position; else a table over time or distance, of a vehicle "
         "simulation, "
         "that "
         "the run follows: its columns take the place of lateral shift, roll, yaw, load, velocity, torque, "
         "traction, creepage, lateral creepage."},
        {"none"},
        "a table with commas",
        field(&S::motion)));
      const auto start = field(&S::motion_start);
      list.push_back(with_word(number_entry({"Wheelset",
                                             "Motion start",
                                             "Where the run begins in that table: its distance, or, where it "
                                             "has only time, the distance since its first row."},
                                            D::length,
                                            "m",
                                            B::between("-1e6 m", "1e6 m"),
                                            start),
                               "first row",
                               std::numeric_limits<double>::infinity(),
                               start));
    }
  } // namespace


  std::vector<Entry>
  wheelset_entries()
  {
    std::vector<Entry> list;
    add_wheelset(list);
    add_drive(list);
    add_motion(list);
    return list;
  }
} // namespace wheelrail
