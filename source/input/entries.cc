#include <wheelrail/base/choices.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/profile_entries.h>
#include <wheelrail/input/run_entries.h>
#include <wheelrail/input/special_entries.h>

#include <algorithm>

namespace wheelrail
{
  namespace
  {
    using D = Dimension;
    using B = Bounds;
    using S = Scene;

    void
    add_track(std::vector<Entry> &list)
    {
      list.push_back(text_entry({"", "Title", "", "Name of the scene in the output."}, field(&S::title)));
      for (const Entry &entry : profile_entries())
        list.push_back(entry);
      list.push_back(
        length_entry({"Track", "Gauge", "1435 mm", "Distance between the two rails, at the gauge height."},
                     "mm",
                     B::between("500 mm", "2000 mm"),
                     field(&S::track, &TrackDimensions::gauge)));
      list.push_back(length_entry(
        {"Track", "Gauge height", "14 mm", "Depth below the top of the rail at which the gauge is measured."},
        "mm",
        B::between("5 mm", "30 mm"),
        field(&S::track, &TrackDimensions::gauge_height)));
      list.push_back(inclination_entry());
      list.push_back(length_entry(
        {"Track", "Rail length", "1.8 m", "Length of the modelled piece of rail; its ends are clamped."},
        "m",
        B::between("200 mm", "10 m"),
        field(&S::rail_length)));
    }

    void
    add_wheel_section(std::vector<Entry> &list)
    {
      struct Row
      {
        const char *name, *default_text, *low, *high, *meaning;
        double WheelDimensions::*member;
      };
      using W                     = WheelDimensions;
      const std::vector<Row> rows = {
        {"Rim width", "135 mm", "100 mm", "200 mm", "Width of the rim from the flange back.", &W::rim_width},
        {"Rim inner radius", "395 mm", "50 mm", "750 mm", "Inner radius of the rim.", &W::rim_inner_radius},
        {"Disc thickness", "28 mm", "5 mm", "100 mm", "Thickness of the straight disc.", &W::disc_thickness},
        {"Disc position",
         "67.5 mm",
         "0 mm",
         "200 mm",
         "Middle of the disc, from the flange back towards the field side.",
         &W::disc_position},
        {"Hub length", "175 mm", "20 mm", "400 mm", "Length of the hub along the axle.", &W::hub_length},
        {"Hub position",
         "67.5 mm",
         "0 mm",
         "200 mm",
         "Middle of the hub, from the flange back towards the field side.",
         &W::hub_position},
        {"Hub outer radius", "130 mm", "30 mm", "500 mm", "Outer radius of the hub.", &W::hub_outer_radius},
        {"Bore radius",
         "92.5 mm",
         "10 mm",
         "400 mm",
         "Radius of the hub bore, tied to the rigid axle.",
         &W::bore_radius},
        {"Fillet radius",
         "20 mm",
         "1 mm",
         "100 mm",
         "Fillets of the disc at rim and hub.",
         &W::fillet_radius},
      };
      for (const Row &row : rows)
        list.push_back(length_entry({"Wheelset", row.name, row.default_text, row.meaning},
                                    "mm",
                                    B::between(row.low, row.high),
                                    field(&S::wheel, row.member)));
    }

    void
    add_wheelset(std::vector<Entry> &list)
    {
      list.push_back(nominal_radius_entry());
      list.push_back(length_entry({"Wheelset",
                                   "Flange back distance",
                                   "1360 mm",
                                   "Distance between the backs of the flanges of the two wheels."},
                                  "mm",
                                  B::between("400 mm", "1950 mm"),
                                  field(&S::track, &TrackDimensions::flange_back_distance)));
      list.push_back(
        length_entry({"Wheelset",
                      "Lateral shift",
                      "0 mm",
                      "Lateral position of the wheelset; negative moves the flange root of the modelled "
                      "(right-hand) wheel towards the gauge corner."},
                     "mm",
                     B::between("-12 mm", "12 mm"),
                     field(&S::lateral_shift)));
      list.push_back(
        choice_entry<RollMode>({"Wheelset",
                                "Roll",
                                "none",
                                "Roll of the wheelset; from contact: the one at which both wheels touch."},
                               {{"none", RollMode::none}, {"from contact", RollMode::from_contact}},
                               field(&S::roll)));
      add_wheel_section(list);
      list.push_back(
        number_entry({"Wheelset", "Sprung mass", "10 t", "Mass that the suspension carries, per wheel."},
                     D::mass,
                     "t",
                     B::between("0 t", "50 t"),
                     field(&S::sprung_mass)));
      list.push_back(number_entry({"Wheelset", "Axle mass", "180 kg", "Mass of half the axle, rigid."},
                                  D::mass,
                                  "kg",
                                  B::between("0 kg", "5 t"),
                                  field(&S::axle_mass)));
      list.push_back(number_entry({"Wheelset",
                                   "Axle pitch inertia",
                                   "1.5 kg m2",
                                   "Moment of inertia of half the axle about its own axis."},
                                  D::mass_moment,
                                  "kg m2",
                                  B::between("0 kg m2", "1000 kg m2"),
                                  field(&S::axle_pitch_inertia)));
      list.push_back(
        number_entry({"Wheelset", "Suspension stiffness", "1.15 MN/m", "Primary suspension, per wheel."},
                     D::stiffness,
                     "MN/m",
                     B::between("0 MN/m", "1000 MN/m"),
                     field(&S::suspension_stiffness)));
      list.push_back(
        number_entry({"Wheelset", "Suspension damping", "2500 N s/m", "Primary suspension, per wheel."},
                     D::damping,
                     "N s/m",
                     B::between("0 N s/m", "1000 kN s/m"),
                     field(&S::suspension_damping)));
    }

    void
    add_drive(std::vector<Entry> &list)
    {
      list.push_back(
        number_entry({"Wheelset", "Velocity", "140 km/h", "Speed of the wheelset along the track."},
                     D::velocity,
                     "km/h",
                     B::between("5 km/h", "500 km/h"),
                     field(&S::velocity)));
      list.push_back(choice_entry<Drive>({"Wheelset",
                                          "Drive",
                                          "torque",
                                          "What turns the wheel; torque: a constant torque from the traction "
                                          "coefficient; rate: the pitch rate is "
                                          "held at the creepage."},
                                         {{"torque", Drive::torque}, {"rate", Drive::rate}},
                                         field(&S::drive)));
      list.push_back(
        pure_entry({"Wheelset",
                    "Traction coefficient",
                    "0.25",
                    "Longitudinal force over static wheel load, used with Drive = torque; positive drives, "
                    "negative brakes."},
                   B::between("-1", "1"),
                   field(&S::traction_coefficient)));
      list.push_back(
        pure_entry({"Wheelset",
                    "Creepage",
                    "0",
                    "(rolling speed of the tread - velocity) / velocity, used with Drive = rate; positive "
                    "drives."},
                   B::between("-0.1", "0.1"),
                   field(&S::creepage)));
    }

    void
    add_friction(std::vector<Entry> &list)
    {
      list.push_back(
        pure_entry({"Contact", "Friction coefficient", "0.5", "Coulomb friction, at rest; 0: no friction."},
                   B::between("0", "1.5"),
                   field(&S::friction_coefficient)));
      list.push_back(choice_entry<FrictionKind>(
        {"Contact",
         "Friction law",
         "constant",
         "How friction changes with the sliding speed v; with s and d the coefficients at rest and at "
         "high speed: constant: s; exponential: d + (s - d) exp(-decay v); rational: d + (s - d)/(1 + v/half "
         "velocity)."},
        {{"constant", FrictionKind::constant},
         {"exponential", FrictionKind::exponential},
         {"rational", FrictionKind::rational}},
        field(&S::friction_law)));
      list.push_back(
        pure_entry({"Contact",
                    "Dynamic friction coefficient",
                    "0.4",
                    "Coefficient at high sliding speed, used unless the friction law is constant."},
                   B::between("0", "1.5"),
                   field(&S::dynamic_friction_coefficient)));
      list.push_back(number_entry({"Contact",
                                   "Friction decay",
                                   "0.05 s/m",
                                   "Decay of the exponential friction law with sliding speed."},
                                  D::slowness,
                                  "s/m",
                                  B::between("0 s/m", "100 s/m"),
                                  field(&S::friction_decay)));
      list.push_back(
        number_entry({"Contact",
                      "Friction half velocity",
                      "15 m/s",
                      "Sliding speed at which half of the difference of the coefficients is gone, "
                      "of the rational friction law."},
                     D::velocity,
                     "m/s",
                     B::above("0 m/s", "1000 m/s"),
                     field(&S::friction_half_velocity)));
    }

    void
    add_contact(std::vector<Entry> &list)
    {
      add_friction(list);
      list.push_back(
        pure_entry({"Contact",
                    "Penalty scale",
                    "10",
                    "f of the contact stiffness f K / h (K bulk modulus, h solution cell size); 10 keeps the "
                    "loss of peak pressure below 1 %, the default of many codes, 0.1, costs a third of it."},
                   B::between("0.05", "50"),
                   field(&S::penalty_scale)));
      list.push_back(
        choice_entry<bool>({"Contact",
                            "Surface filter",
                            "consistent",
                            "consistent: gaps and forces pass a filter that takes the error of second order "
                            "in the cell size out of the surface response of the mesh; none: bare nodes."},
                           {{"consistent", true}, {"none", false}},
                           field(&S::surface_filter)));
      list.push_back(pure_entry({"Contact", "Damping", "0.3", "Contact damping as a fraction of critical."},
                                B::between("0", "1"),
                                field(&S::contact_damping)));
    }

    void
    add_material(std::vector<Entry> &list, const std::string &section, MaterialData Scene::*part)
    {
      using M = MaterialData;
      list.push_back(number_entry({section, "Young's modulus", "210 GPa", "Slope of the elastic line."},
                                  D::stress,
                                  "GPa",
                                  B::between("1 GPa", "1000 GPa"),
                                  field(part, &M::youngs_modulus)));
      list.push_back(pure_entry({section, "Poisson's ratio", "0.3", "Lateral over axial strain, elastic."},
                                B::between("0", "0.49"),
                                field(part, &M::poissons_ratio)));
      list.push_back(number_entry({section, "Density", "7900 kg/m3", "Mass per volume."},
                                  D::density,
                                  "kg/m3",
                                  B::between("100 kg/m3", "30000 kg/m3"),
                                  field(part, &M::density)));
      list.push_back(yield_stress_entry(section, part));
      list.push_back(
        number_entry({section,
                      "Tangent modulus",
                      "21 GPa",
                      "Slope of the total stress-strain curve beyond yield; without effect while the "
                      "yield stress is none."},
                     D::stress,
                     "GPa",
                     B::between("0 GPa", "1000 GPa"),
                     field(part, &M::tangent_modulus)));
      list.push_back(
        pure_entry({section,
                    "Kinematic hardening fraction",
                    "0",
                    "0: isotropic, 1: kinematic hardening; without effect while the yield stress is none."},
                   B::between("0", "1"),
                   field(part, &M::kinematic_hardening)));
    }
  } // namespace

  const std::vector<Entry> &
  entries()
  {
    static const std::vector<Entry> table = [] {
      std::vector<Entry> list;
      add_track(list);
      add_wheelset(list);
      add_drive(list);
      add_contact(list);
      add_material(list, "Rail material", &Scene::rail_material);
      add_material(list, "Wheel material", &Scene::wheel_material);
      for (const Entry &entry : run_entries())
        list.push_back(entry);
      return list;
    }();
    return table;
  }

  const Entry *
  find_entry(const std::string &section, const std::string &name)
  {
    for (const Entry &entry : entries())
      if (entry.section == section && entry.name == name)
        return &entry;
    return nullptr;
  }

  std::vector<std::string>
  section_names()
  {
    std::vector<std::string> names;
    for (const Entry &entry : entries())
      if (!entry.section.empty() && std::find(names.begin(), names.end(), entry.section) == names.end())
        names.push_back(entry.section);
    return names;
  }

  std::vector<std::string>
  nearest_entries(const std::string &section, const std::string &name)
  {
    struct Candidate
    {
      unsigned int distance;
      bool         elsewhere;
      std::string  path;
    };
    std::vector<Candidate> candidates;
    if (name.size() > 200) // resembles nothing
      return {};
    for (const Entry &entry : entries())
      {
        const unsigned int distance = edit_distance(entry.name, name);
        if (distance <= std::max<std::size_t>(2, name.size() / 3))
          candidates.push_back({distance, entry.section != section, entry.path()});
      }
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate &a, const Candidate &b) {
      return a.distance != b.distance ? a.distance < b.distance : a.elsewhere < b.elsewhere;
    });
    std::vector<std::string> paths;
    // names much farther away than the best one would only distract
    for (const Candidate &candidate : candidates)
      if (paths.size() < 3 && candidate.distance <= candidates.front().distance + 1)
        paths.push_back(candidate.path);
    return paths;
  }

  std::string
  entry_text(const Scene &scene, const std::string &section, const std::string &name)
  {
    return section + "/" + name + " = " + find_entry(section, name)->get(scene);
  }
} // namespace wheelrail
