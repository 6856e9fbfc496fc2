#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <limits>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using S = Scene;

    void
    add_friction(EntryList &list)
    {
      list.number({"Friction coefficient", "", "0", "1.5"},
                  field(&S::friction, &FrictionLaw::at_rest),
                  "Coulomb friction, at rest; 0: no friction.");
      list.number(
        {"Friction coefficient left", "", "0", "1.5"},
        field(&S::left_friction),
        "On the left-hand rail, with Wheelset/Wheels = both; the dynamic coefficient changes in proportion.",
        {{"as right", std::numeric_limits<double>::infinity()}});
      list.choice<FrictionKind>("Friction law",
                                {{"constant", FrictionKind::constant},
                                 {"exponential", FrictionKind::exponential},
                                 {"rational", FrictionKind::rational}},
                                field(&S::friction, &FrictionLaw::kind),
                                "How friction changes with the sliding speed v; with s and d the "
                                "coefficients at rest and at high speed: constant: s; exponential: d + (s - "
                                "d) exp(-decay v); rational: d + (s - d)/(1 + v/half velocity).");
      list.number({"Dynamic friction coefficient", "", "0", "1.5"},
                  field(&S::friction, &FrictionLaw::at_speed),
                  "Coefficient at high sliding speed, used unless the friction law is constant.");
      list.number({"Friction decay", "s/m", "0 s/m", "100 s/m"},
                  field(&S::friction, &FrictionLaw::decay),
                  "Decay of the exponential friction law with sliding speed.");
      list.number({"Friction half velocity", "m/s", "> 0 m/s", "1000 m/s"},
                  field(&S::friction, &FrictionLaw::half_velocity),
                  "Sliding speed at which half of the difference of the coefficients is gone, of the "
                  "rational friction law.");
    }
  } // namespace


  std::vector<Entry>
  contact_entries()
  {
    EntryList list("Contact");
    add_friction(list);
    list.number({"Penalty scale", "", "0.05", "50"},
                field(&S::penalty_scale),
                "f of the contact stiffness f K / h (K bulk modulus, h solution cell size); 10 keeps the "
                "loss of peak pressure below 1 %, the default of many codes, 0.1, costs a third of it.");
    list.choice<bool>("Surface filter",
                      {{"consistent", true}, {"none", false}},
                      field(&S::surface_filter),
                      "consistent: gaps and forces pass a filter that removes most of the mesh error of the "
                      "pressure; none: bare nodes.");
    list.number(
      {"Damping", "", "0.05", "1"},
      field(&S::contact_damping),
      "Contact damping as a fraction of critical; without any, nodes that open and close gain energy.");
    return list.entries;
  }
} // namespace wheelrail
