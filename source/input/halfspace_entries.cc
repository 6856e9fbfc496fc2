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

    /// Of problems whose distance is not that of the profiles.
    void
    add_given_distance(EntryList &list)
    {
      list.name_or_file(
        "Undeformed distance",
        {"profiles", "hertz", "rollers"},
        "a file (with its ending, such as distance.txt)",
        field(&S::halfspace_distance),
        "For halfspace. profiles: of wheel and rail; hertz: x^2/(2 Radius along) + y^2/(2 Radius "
        "across); rollers: of the two below; a file: rows x, y, distance in mm on a regular "
        "grid.");
      list.number({"Radius along", "mm", "1 mm", "100 m"},
                  field(&S::halfspace_radius_along),
                  "Relative radius in the rolling direction; also turns Contact angle into spin.");
      list.number({"Radius across", "mm", "1 mm", "100 m"},
                  field(&S::halfspace_radius_across),
                  "Relative radius across, for hertz.");
      list.number(
        {"Normal force", "kN", "1 N", "10 MN"},
        field(&S::halfspace_normal_force),
        "For hertz, rollers and files; auto: static wheel load (not for rollers), or as Approach gives it.",
        {{"auto", 0}});
      list.number({"Approach", "mm", "0.1 um", "5 mm"},
                  field(&S::halfspace_approach),
                  "For hertz, rollers and files, instead of the normal force.",
                  {{"auto", 0}});
      list.number({"Contact angle", "mrad", "-1500 mrad", "1500 mrad"},
                  field(&S::halfspace_contact_angle),
                  "For hertz and files: the spin is sin(Contact angle) / Radius along.");
    }
    /// The rollers of a test rig.
    void
    add_rollers(EntryList &list)
    {
      for (const bool wheel : {true, false})
        {
          const std::string name   = wheel ? "Wheel" : "Rail";
          const auto        shape  = wheel ? &S::wheel_roller : &S::rail_roller;
          const auto        radius = [shape](Scene &scene) -> double        &{ return (scene.*shape).radius; };
          const auto        crown  = [shape](Scene &scene) -> double         &{ return (scene.*shape).crown; };
          list.number({name + " roller radius", "mm", "1 mm", "100 m"},
                      radius,
                      "For rollers: in the rolling direction; straight: a bar, as of a rail.",
                      {{"straight", 0}});
          list.number(
            {name + " roller crown", "mm", "1 mm", "100 m"},
            crown,
            "For rollers: radius across; flat: a cylinder; profile: the crown in the file of Profiles/" +
              name + ".",
            {{"profile", -1}, {"flat", 0}});
        }
      list.number({"Roller width", "mm", "0.5 mm", "1 m"},
                  field(&S::roller_width),
                  "For rollers: of the narrower one; beyond it there is no contact.");
    }

    /// What lies between the bodies.
    void
    add_interface(EntryList &list)
    {
      list.number({"Friction memory", "um", "0 um", "1 mm"},
                  field(&S::halfspace_memory_length),
                  "Slip distance over which friction comes to what the law has at the slip velocity; 0 um: "
                  "at once. Not in runs and compare.");
      list.number({"Friction memory speed", "mm/s", "0.001 mm/s", "1 m/s"},
                  field(&S::halfspace_memory_speed),
                  "Least slip velocity with which friction comes to its law.");
      list.number({"Interface layer", "mm", "0 mm", "10 mm"},
                  field(&S::halfspace_layer_thickness),
                  "Thickness of an elastic layer that yields to shear; 0 mm: none. "
                  "Not in runs and compare.");
      list.number({"Interface layer shear modulus", "GPa", "1 MPa", "1000 GPa"},
                  field(&S::halfspace_layer_shear),
                  "Of that layer.");
    }
  } // namespace


  std::vector<Entry>
  halfspace_entries()
  {
    EntryList list("Half-space");
    list.number({"Element size", "mm", "0.05 mm", "5 mm"},
                field(&S::halfspace_element_size),
                "Edge of contact elements, for halfspace and compare.");
    list.choice<ContactBodies>(
      "Bodies",
      {{"auto", ContactBodies::automatic},
       {"half-spaces", ContactBodies::half_spaces},
       {"real", ContactBodies::real}},
      field(&S::halfspace_bodies),
      "real: wheel held at its bore, rail at its foot, as elastic bodies; half-spaces: Kalker's theory, as "
      "in CONTACT; auto: real, but half-spaces in wear and where real bodies do not take the scene. For "
      "halfspace, vehicle, wear, run --wheelset and studies.");
    list.choice<HalfspaceSpin>(
      "Spin",
      {{"local radius", HalfspaceSpin::local_radius}, {"contact", HalfspaceSpin::contact}},
      field(&S::halfspace_spin),
      "local radius: slip from rolling radius and inclination of every slice; contact: one creepage "
      "and one spin, as in CONTACT.");
    list.choice<bool>(
      "Normal",
      {{"surface", false}, {"section", true}},
      field(&S::halfspace_section_normal),
      "Of slices: surface: with their slope along the track; section: without, as in CONTACT.");
    list.number(
      {"Given spin", "1/m", "-20 1/m", "20 1/m"},
      field(&S::halfspace_given_spin),
      "One spin, with one creepage for the whole patch: turning of the rail against the wheel about the "
      "normal out of the rail per metre rolled; auto: as Spin says.",
      {{"auto", std::numeric_limits<double>::infinity()}});
    list.number({"Lateral offset", "mm", "-5 mm", "5 mm"},
                field(&S::halfspace_lateral),
                "Wheel section moved to the track centre after 2D-Geo, for halfspace.");
    list.number({"Extra inclination", "mrad", "-20 mrad", "20 mrad"},
                field(&S::halfspace_inclination),
                "Rail head turned to the track centre about the contact point, for halfspace.");
    add_interface(list);
    add_given_distance(list);
    add_rollers(list);
    return list.entries;
  }
} // namespace wheelrail
