#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <limits>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using D = Dimension;
    using B = Bounds;
    using S = Scene;

    void
    add_friction(std::vector<Entry> &list)
    {
      list.push_back(
        pure_entry({"Contact", "Friction coefficient", "Coulomb friction, at rest; 0: no friction."},
                   B::between("0", "1.5"),
                   field(&S::friction, &FrictionLaw::at_rest)));
      const auto left = field(&S::left_friction);
      list.push_back(with_word(
        pure_entry({"Contact",
                    "Friction coefficient left",
                    "On the left-hand rail, with Wheelset/Wheels = both; the dynamic coefficient changes in "
                    "proportion."},
                   B::between("0", "1.5"),
                   left),
        "as right",
        std::numeric_limits<double>::infinity(),
        left));
      list.push_back(choice_entry<FrictionKind>(
        {"Contact",
         "Friction law",
         "How friction changes with the sliding speed v; with s and d the coefficients at rest and at "
         "high speed: constant: s; exponential: d + (s - d) exp(-decay v); rational: d + (s - d)/(1 + v/half "
         "velocity)."},
        {{"constant", FrictionKind::constant},
         {"exponential", FrictionKind::exponential},
         {"rational", FrictionKind::rational}},
        field(&S::friction, &FrictionLaw::kind)));
      list.push_back(
        pure_entry({"Contact",
                    "Dynamic friction coefficient",
                    "Coefficient at high sliding speed, used unless the friction law is constant."},
                   B::between("0", "1.5"),
                   field(&S::friction, &FrictionLaw::at_speed)));
      list.push_back(number_entry(
        {"Contact", "Friction decay", "Decay of the exponential friction law with sliding speed."},
        D::slowness,
        "s/m",
        B::between("0 s/m", "100 s/m"),
        field(&S::friction, &FrictionLaw::decay)));
      list.push_back(
        number_entry({"Contact",
                      "Friction half velocity",
                      "Sliding speed at which half of the difference of the coefficients is gone, "
                      "of the rational friction law."},
                     D::velocity,
                     "m/s",
                     B::above("0 m/s", "1000 m/s"),
                     field(&S::friction, &FrictionLaw::half_velocity)));
    }
  } // namespace


  std::vector<Entry>
  contact_entries()
  {
    std::vector<Entry> list;
    add_friction(list);
    list.push_back(
      pure_entry({"Contact",
                  "Penalty scale",
                  "f of the contact stiffness f K / h (K bulk modulus, h solution cell size); 10 keeps the "
                  "loss of peak pressure below 1 %, the default of many codes, 0.1, costs a third of it."},
                 B::between("0.05", "50"),
                 field(&S::penalty_scale)));
    list.push_back(choice_entry<bool>(
      {"Contact",
       "Surface filter",
       "consistent: gaps and forces pass a filter that removes most of the mesh error of the pressure; "
       "none: bare nodes."},
      {{"consistent", true}, {"none", false}},
      field(&S::surface_filter)));
    list.push_back(pure_entry({"Contact",
                               "Damping",
                               "Contact damping as a fraction of critical; without any, nodes that open "
                               "and close gain energy."},
                              B::between("0.05", "1"),
                              field(&S::contact_damping)));
    return list;
  }
} // namespace wheelrail
