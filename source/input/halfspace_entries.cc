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
    using S = Scene;

    /// Of problems whose distance is not that of the profiles.
    void
    add_given_distance(std::vector<Entry> &list)
    {
      list.push_back(name_or_file_entry({"Half-space",
                                         "Undeformed distance",
                                         "Distance of the surfaces before they deform, for the command "
                                         "halfspace. profiles: of wheel and rail; "
                                         "hertz: x^2/(2 Radius along) + y^2/(2 Radius across); "
                                         "rollers: of the two rollers below; a file: rows "
                                         "x, y, distance in mm on a regular "
                                         "grid."},
                                        {"profiles", "hertz", "rollers"},
                                        "a file (with its ending, such as distance.txt)",
                                        field(&S::halfspace_distance)));
      list.push_back(
        length_entry({"Half-space",
                      "Radius along",
                      "Relative radius in the rolling direction; also turns Contact angle into spin."},
                     "mm",
                     B::between("1 mm", "100 m"),
                     field(&S::halfspace_radius_along)));
      list.push_back(length_entry({"Half-space", "Radius across", "Relative radius across, for hertz."},
                                  "mm",
                                  B::between("1 mm", "100 m"),
                                  field(&S::halfspace_radius_across)));
      const auto force = field(&S::halfspace_normal_force);
      list.push_back(with_word(number_entry({"Half-space",
                                             "Normal force",
                                             "For hertz, rollers and files; auto: static wheel load (not for "
                                             "rollers), or as Approach gives it."},
                                            D::force,
                                            "kN",
                                            B::between("1 N", "10 MN"),
                                            force),
                               "auto",
                               0,
                               force));
      const auto approach = field(&S::halfspace_approach);
      list.push_back(with_word(
        length_entry({"Half-space", "Approach", "For hertz, rollers and files, instead of the normal force."},
                     "mm",
                     B::between("0.1 um", "5 mm"),
                     approach),
        "auto",
        0,
        approach));
      list.push_back(number_entry({"Half-space",
                                   "Contact angle",
                                   "For hertz and files: the spin is sin(Contact angle) / Radius along."},
                                  D::angle,
                                  "mrad",
                                  B::between("-1500 mrad", "1500 mrad"),
                                  field(&S::halfspace_contact_angle)));
    }
    /// The rollers of a test rig.
    void
    add_rollers(std::vector<Entry> &list)
    {
      for (const bool wheel : {true, false})
        {
          const std::string name   = wheel ? "Wheel" : "Rail";
          const auto        shape  = wheel ? &S::wheel_roller : &S::rail_roller;
          const auto        radius = [shape](Scene &scene) -> double        &{ return (scene.*shape).radius; };
          const auto        crown  = [shape](Scene &scene) -> double         &{ return (scene.*shape).crown; };
          list.push_back(
            with_word(length_entry({"Half-space",
                                    name + " roller radius",
                                    "For rollers: in the rolling direction; straight: a bar, as of a rail."},
                                   "mm",
                                   B::between("1 mm", "100 m"),
                                   radius),
                      "straight",
                      0,
                      radius));
          list.push_back(with_word(
            with_word(
              length_entry({"Half-space",
                            name + " roller crown",
                            "For rollers: radius across; flat: a cylinder; profile: the crown in the file of "
                            "Profiles/" +
                              name + "."},
                           "mm",
                           B::between("1 mm", "100 m"),
                           crown),
              "flat",
              0,
              crown),
            "profile",
            -1,
            crown));
        }
      list.push_back(length_entry(
        {"Half-space", "Roller width", "For rollers: of the narrower one; beyond it there is no contact."},
        "mm",
        B::between("0.5 mm", "1 m"),
        field(&S::roller_width)));
    }

    /// What lies between the bodies.
    void
    add_interface(std::vector<Entry> &list)
    {
      list.push_back(length_entry({"Half-space",
                                   "Friction memory",
                                   "Slip distance over which friction comes to what the law has at the slip "
                                   "velocity; 0 um: at once. Not in runs and compare."},
                                  "um",
                                  B::between("0 um", "1 mm"),
                                  field(&S::halfspace_memory_length)));
      list.push_back(number_entry(
        {"Half-space", "Friction memory speed", "Least slip velocity with which friction comes to its law."},
        D::velocity,
        "mm/s",
        B::between("0.001 mm/s", "1 m/s"),
        field(&S::halfspace_memory_speed)));
      list.push_back(length_entry({"Half-space",
                                   "Interface layer",
                                   "Thickness of an elastic layer between wheel and rail that yields to "
                                   "shear; 0 mm: none. Not in runs and compare."},
                                  "mm",
                                  B::between("0 mm", "10 mm"),
                                  field(&S::halfspace_layer_thickness)));
      list.push_back(number_entry({"Half-space", "Interface layer shear modulus", "Of that layer."},
                                  D::stress,
                                  "GPa",
                                  B::between("1 MPa", "1000 GPa"),
                                  field(&S::halfspace_layer_shear)));
    }
  } // namespace


  std::vector<Entry>
  halfspace_entries()
  {
    std::vector<Entry> list;
    list.push_back(length_entry(
      {"Half-space", "Element size", "Edge of the contact elements of the commands halfspace and compare."},
      "mm",
      B::between("0.05 mm", "5 mm"),
      field(&S::halfspace_element_size)));
    list.push_back(choice_entry<ContactBodies>(
      {"Half-space",
       "Bodies",
       "real: this wheel, held at its bore, on this rail, held at its foot, as elastic bodies; half-spaces: "
       "Kalker's theory, as the program CONTACT has it; auto: real, but half-spaces in wear and where real "
       "bodies do not take the scene, which is said. For halfspace, vehicle, wear, run --wheelset and "
       "studies."},
      {{"auto", ContactBodies::automatic},
       {"half-spaces", ContactBodies::half_spaces},
       {"real", ContactBodies::real}},
      field(&S::halfspace_bodies)));
    list.push_back(choice_entry<HalfspaceSpin>(
      {"Half-space",
       "Spin",
       "Rigid slip of the wheel: local radius: from rolling radius and inclination of every slice; "
       "contact: "
       "one creepage and one spin, as the program CONTACT has it."},
      {{"local radius", HalfspaceSpin::local_radius}, {"contact", HalfspaceSpin::contact}},
      field(&S::halfspace_spin)));
    const auto spin = field(&S::halfspace_given_spin);
    list.push_back(with_word(
      number_entry(
        {"Half-space",
         "Given spin",
         "One spin in place of the wheel's own, with one creepage for the whole patch: the rail's turning "
         "against the wheel about the normal out of the rail, for each metre rolled; auto: as Spin "
         "says."},
        D::spin,
        "1/m",
        B::between("-20 1/m", "20 1/m"),
        spin),
      "auto",
      std::numeric_limits<double>::infinity(),
      spin));
    list.push_back(length_entry(
      {"Half-space",
       "Lateral offset",
       "Wheel section moved against the rail to the track centre after 2D-Geo, by the command halfspace."},
      "mm",
      B::between("-5 mm", "5 mm"),
      field(&S::halfspace_lateral)));
    list.push_back(number_entry(
      {"Half-space",
       "Extra inclination",
       "Rail head turned to the track centre about the contact point, by the command halfspace."},
      D::angle,
      "mrad",
      B::between("-20 mrad", "20 mrad"),
      field(&S::halfspace_inclination)));
    add_interface(list);
    add_given_distance(list);
    add_rollers(list);
    return list;
  }
} // namespace wheelrail
