#include <wheelrail/base/choices.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <limits>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using S = Scene;

    void
    add_nominal_radius(EntryList &list)
    {
      Entry &entry = list.number({"Nominal rolling radius", "mm", "150 mm", "800 mm"},
                                 field(&S::track, &TrackDimensions::nominal_radius),
                                 "Radius of the wheel at the running circle, 70 mm from the flange back.");
      entry.set    = [set = entry.set](Scene &scene, const std::string &text) {
        set(scene, text);
        scene.wheel.nominal_radius = scene.track.nominal_radius;
      };
    }

    /// A word or an angle.
    void
    add_roll(EntryList &list)
    {
      Entry &entry =
        list.number({"Roll", "mrad", "-50 mrad", "50 mrad"},
                    field(&S::roll_angle),
                    "Roll of the wheelset; from contact: the one at which both wheels touch; an angle is "
                    "positive when the modelled wheel goes down.");
      const Words<RollMode> words = {{"none", RollMode::none}, {"from contact", RollMode::from_contact}};
      entry.accepted              = "none, from contact, or " + entry.accepted;
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
    }

    void
    add_wheel_section(EntryList &list)
    {
      using W = WheelDimensions;
      list.number({"Rim width", "mm", "100 mm", "200 mm"},
                  field(&S::wheel, &W::rim_width),
                  "Width of the rim from the flange back.");
      list.number({"Rim inner radius", "mm", "50 mm", "750 mm"},
                  field(&S::wheel, &W::rim_inner_radius),
                  "Inner radius of the rim.");
      list.number({"Disc thickness", "mm", "5 mm", "100 mm"},
                  field(&S::wheel, &W::disc_thickness),
                  "Thickness of the straight disc.");
      list.number({"Disc position", "mm", "0 mm", "200 mm"},
                  field(&S::wheel, &W::disc_position),
                  "Middle of the disc, from the flange back towards the field side.");
      list.number({"Hub length", "mm", "20 mm", "400 mm"},
                  field(&S::wheel, &W::hub_length),
                  "Length of the hub along the axle.");
      list.number({"Hub position", "mm", "0 mm", "200 mm"},
                  field(&S::wheel, &W::hub_position),
                  "Middle of the hub, from the flange back towards the field side.");
      list.number({"Hub outer radius", "mm", "30 mm", "500 mm"},
                  field(&S::wheel, &W::hub_outer_radius),
                  "Outer radius of the hub.");
      list.number({"Bore radius", "mm", "10 mm", "400 mm"},
                  field(&S::wheel, &W::bore_radius),
                  "Radius of the hub bore, tied to the rigid axle.");
      list.number({"Fillet radius", "mm", "1 mm", "100 mm"},
                  field(&S::wheel, &W::fillet_radius),
                  "Fillets of the disc at rim and hub.");
    }

    /// Of the wheelset with both wheels.
    void
    add_axle(EntryList &list)
    {
      list.choice<bool>("Wheels",
                        {{"one", false}, {"both", true}},
                        field(&S::both_wheels),
                        "Of halfspace and vehicle. one: the modelled wheel alone; both: the whole wheelset "
                        "on its two rails.");
      list.choice<bool>("Axle",
                        {{"rigid", true}, {"independent", false}},
                        field(&S::rigid_axle),
                        "With Wheels = both. rigid: both wheels turn at one rate, and share the torque; "
                        "independent: each turns by itself.");
      list.choice<bool>("Pose",
                        {{"given", false}, {"equilibrium", true}},
                        field(&S::pose_balances),
                        "With Wheels = both. given: Lateral shift and Yaw are those of the wheelset; "
                        "equilibrium: both are found such that the forces on the wheelset balance, with "
                        "springs that are at rest at Lateral shift and Yaw.");
      list.number({"Lateral stiffness", "MN/m", "0 MN/m", "1000 MN/m"},
                  field(&S::lateral_stiffness),
                  "Of the spring that guides the wheelset, with Pose = equilibrium.");
      list.number({"Yaw stiffness", "MN m/rad", "0 MN m/rad", "1000 MN m/rad"},
                  field(&S::yaw_stiffness),
                  "Of the spring that guides the wheelset about the vertical, with Pose = equilibrium.");
      list.number({"Centre of gravity height", "m", "0 m", "4 m"},
                  field(&S::centre_height),
                  "Of what rests on the axle, above the rails: how much of the load goes to the outer wheel "
                  "of a curve with Track/Cant.");
    }

    void
    add_wheelset(EntryList &list)
    {
      add_nominal_radius(list);
      list.number({"Flange back distance", "mm", "400 mm", "1950 mm"},
                  field(&S::track, &TrackDimensions::flange_back_distance),
                  "Distance between the backs of the flanges of the two wheels.");
      list.choice<bool>("Side",
                        {{"right", false}, {"left", true}},
                        field(&S::left_wheel),
                        "The modelled wheel, on the right-hand or the left-hand rail; lateral shift, roll, "
                        "yaw and lateral creepage are those of the wheelset, with the signs for its "
                        "right-hand wheel; results are positive to the track centre of the modelled wheel.");
      add_axle(list);
      list.number({"Lateral shift", "mm", "-12 mm", "12 mm"},
                  field(&S::lateral_shift),
                  "Lateral position of the wheelset; negative moves the flange root of the modelled "
                  "(right-hand) wheel towards the gauge corner.");
      add_roll(list);
      list.number({"Yaw", "mrad", "-50 mrad", "50 mrad"},
                  field(&S::yaw),
                  "Angle of attack: the wheelset turned about the vertical through its middle; positive when "
                  "its nose turns to the track centre, away from the flange of the modelled wheel.");
      add_wheel_section(list);
      list.number({"Sprung mass", "t", "0 t", "50 t"},
                  field(&S::sprung_mass),
                  "Mass that the suspension carries, per wheel.");
      list.number({"Wheel load", "kN", "1 kN", "500 kN"},
                  field(&S::wheel_load),
                  "Static load on the rail; the sprung mass is then what it needs besides wheel and half "
                  "axle. auto: from Sprung mass.",
                  {{"auto", 0}});
      list.number({"Axle mass", "kg", "0 kg", "5 t"}, field(&S::axle_mass), "Mass of half the axle, rigid.");
      list.number({"Axle pitch inertia", "kg m2", "0 kg m2", "1000 kg m2"},
                  field(&S::axle_pitch_inertia),
                  "Moment of inertia of half the axle about its own axis.");
      list.number({"Suspension stiffness", "MN/m", "0 MN/m", "1000 MN/m"},
                  field(&S::suspension_stiffness),
                  "Primary suspension, per wheel.");
      list.number({"Suspension damping", "N s/m", "0 N s/m", "1000 kN s/m"},
                  field(&S::suspension_damping),
                  "Primary suspension, per wheel.");
    }

    void
    add_drive(EntryList &list)
    {
      list.number({"Velocity", "km/h", "5 km/h", "500 km/h"},
                  field(&S::velocity),
                  "Speed of the wheelset along the track.");
      list.choice<Drive>("Drive",
                         {{"torque", Drive::torque}, {"rate", Drive::rate}},
                         field(&S::drive),
                         "What turns the wheel; torque: a constant torque from the traction coefficient; "
                         "rate: the pitch rate is held at the creepage.");
      list.number({"Traction coefficient", "", "-1", "1"},
                  field(&S::traction_coefficient),
                  "Longitudinal force over static wheel load, used with Drive = torque; positive drives, "
                  "negative brakes, 0 rolls freely.");
      list.number(
        {"Creepage", "", "-0.1", "0.1"},
        field(&S::creepage),
        "(rolling speed of the tread - velocity) / velocity, used with Drive = rate; positive drives.");
      list.number({"Lateral creepage", "", "-0.1", "0.1"},
                  field(&S::lateral_creepage),
                  "Lateral velocity of the wheelset over velocity, besides that of its yaw; positive to the "
                  "track centre.");
    }

    void
    add_motion(EntryList &list)
    {
      list.name_or_file("Motion",
                        {"none"},
                        "a table with commas",
                        field(&S::motion),
                        "none: the wheelset keeps its position; else a table over time or distance, of a "
                        "vehicle simulation, that the run follows: its columns take the place of lateral "
                        "shift, roll, yaw, load, velocity, torque, traction, creepage, lateral creepage.");
      list.number({"Motion start", "m", "-1e6 m", "1e6 m"},
                  field(&S::motion_start),
                  "Where the run begins in that table: its distance, or, where it has only time, the "
                  "distance since its first row.",
                  {{"first row", std::numeric_limits<double>::infinity()}});
    }
  } // namespace


  std::vector<Entry>
  wheelset_entries()
  {
    EntryList list("Wheelset");
    add_wheelset(list);
    add_drive(list);
    add_motion(list);
    return list.entries;
  }
} // namespace wheelrail
