#include <wheelrail/base/format_text.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/study_cases.h>
#include <wheelrail/input/without_effect.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace wheelrail
{
  namespace
  {
    using Names = std::vector<std::string>;

    /// Of what a command reads or leaves: "Mesh" is the whole subsection, "Track/Gauge" an entry, "Track/Pad
    /// *" all that begin so.
    bool
    is_among(const Entry &entry, const Names &names)
    {
      return std::any_of(names.begin(), names.end(), [&](const std::string &name) {
        return name.back() == '*' ? entry.path().compare(0, name.size() - 1, name, 0, name.size() - 1) == 0
                                  : entry.section == name || entry.path() == name;
      });
    }

    const Names profiles_in_track = split_list(
      "Profiles, Track/Gauge, Track/Gauge height, Track/Rail inclination, Wheelset/Nominal rolling radius, "
      "Wheelset/Flange back distance, Wheelset/Side, Wheelset/Wheels, Wheelset/Lateral shift, Wheelset/Roll, "
      "Wheelset/Yaw, Wheelset/Rim width, Wheelset/Motion, Wheelset/Motion start");
    const Names one_steel = {"Rail material", "Wheel material", "Material test", "Output/Folder"};
    const Names wear_plan = split_list(
      "Wear/Mix, Wear/Worn, Wear/Gross load, Wear/Distance, Wear/Smoothing length, Wear/Step depth, "
      "Wear/Line length, Wear/Wheels, Wear/Grind *, Wear/Turn *");
    const Names of_halfspaces = split_list(
      "Half-space/Friction memory*, Half-space/Interface layer*, Half-space/Given spin, Half-space/Lateral "
      "offset, Half-space/Extra inclination, Half-space/Undeformed distance");
    const Names of_runs = split_list(
      "Mesh/Fine *, Mesh/Planned *, Mesh/Prepared distance, Mesh/Window, Mesh/Behind the wheel, "
      "Mesh/Element, Mesh/Rail element, Mesh/Wheel element, Run/Rolling distance, Run/Longest distance, "
      "Run/Standard error, Run/Error estimate, Run/Pass*, Run/Most passages, Run/Settled *, Run/Next wheel, "
      "Run/Staggered starts, Run/Rail, Run/Averaging distance, Run/Evaluate at, Run/Start, Run/Time step "
      "factor, Run/Bulk viscosity, Run/Energy limit, Output/Ticks, Output/Volume fields, Output/Checkpoint "
      "interval, Contact/Penalty scale, Contact/Surface filter, Contact/Damping, Track/Support, "
      "Track/Sleeper *, Track/First sleeper, Track/Pad *, Track/Ballast *, Track/Damped ends, Track/Rail "
      "length, Wheelset/Suspension *, Wheelset/Axle pitch inertia");

    Names
    together(Names a, const Names &b)
    {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    }

    bool
    is_read(const Entry &entry, const std::string &command)
    {
      if (entry.section.empty() || entry.section == "Study") // Study has messages of its own
        return true;
      if (command == "geometry")
        return is_among(entry, profiles_in_track);
      if (command == "material")
        return is_among(entry, one_steel);
      if (entry.section == "Material test")
        return false;
      if (command == "parameters")
        return true;
      if (command == "compare" && is_among(entry, of_halfspaces))
        return false;
      if (command == "halfspace" || command == "vehicle" || command == "compare")
        return !is_among(entry, together(of_runs, wear_plan));
      if (command == "wear")
        return !is_among(entry, of_runs);
      if (command == "run")
        return !is_among(entry, together(of_halfspaces, wear_plan));
      return !is_among(
        entry,
        together(wear_plan,
                 split_list(
                   "Wear, Half-space, Irregularity *, Contact/Friction *, Wheelset/Velocity, Wheelset/Drive, "
                   "Wheelset/Traction coefficient, Wheelset/Creepage, Wheelset/Lateral creepage")));
    }

    /// Entries that another one leaves without effect.
    struct Rule
    {
      Names                              names;
      std::function<bool(const Scene &)> holds;
      const char                        *section, *since; ///< the entry that does so
    };

    const std::vector<Rule> &
    rules()
    {
      using S                              = const Scene &;
      static const std::vector<Rule> table = {
        {{"Profiles/Wheel left", "Profiles/Rail left", "Contact/Friction coefficient left", "Wheelset/Axle"},
         [](S s) { return !s.both_wheels; },
         "Wheelset",
         "Wheels"},
        {{"Profiles/Rail place", "Half-space/Normal"},
         [](S s) { return !s.rail_by_slices(); },
         "Profiles",
         "Rail"},
        {{"Wheelset/Lateral stiffness", "Wheelset/Yaw stiffness"},
         [](S s) { return !s.pose_balances; },
         "Wheelset",
         "Pose"},
        {{"Wheelset/Motion start"}, [](S s) { return s.motion == "none"; }, "Wheelset", "Motion"},
        {{"Contact/Dynamic friction coefficient", "Contact/Friction decay", "Contact/Friction half velocity"},
         [](S s) { return s.friction.kind == FrictionKind::constant; },
         "Contact",
         "Friction law"},
        {{"Contact/Friction half velocity"},
         [](S s) { return s.friction.kind == FrictionKind::exponential; },
         "Contact",
         "Friction law"},
        {{"Contact/Friction decay"},
         [](S s) { return s.friction.kind == FrictionKind::rational; },
         "Contact",
         "Friction law"},
        {{"Rail material/Tangent modulus", "Rail material/Kinematic hardening fraction"},
         [](S s) { return !s.rail_material.yields(); },
         "Rail material",
         "Yield stress"},
        {{"Wheel material/Tangent modulus", "Wheel material/Kinematic hardening fraction"},
         [](S s) { return !s.wheel_material.yields(); },
         "Wheel material",
         "Yield stress"},
        {{"Rail material/Steel"},
         [](S s) { return std::isfinite(s.rail_material.yield_stress); },
         "Rail material",
         "Yield stress"},
        {{"Wheel material/Steel"},
         [](S s) { return std::isfinite(s.wheel_material.yield_stress); },
         "Wheel material",
         "Yield stress"},
        {split_list("Half-space/Radius *, Half-space/Normal force, Half-space/Approach, Half-space/Contact "
                    "angle, Half-space/Wheel roller *, Half-space/Rail roller *, Half-space/Roller width"),
         [](S s) { return s.halfspace_distance == "profiles"; },
         "Half-space",
         "Undeformed distance"},
        {{"Wear/Gross load", "Wear/Grind *"},
         [](S s) { return s.wear_plan.worn == WornBody::wheel; },
         "Wear",
         "Worn"},
        {{"Wear/Turn *"}, [](S s) { return s.wear_plan.worn == WornBody::rail; }, "Wear", "Worn"},
        {{"Wear/Distance"}, [](S s) { return s.wear_plan.worn != WornBody::wheel; }, "Wear", "Worn"},
        {{"Wear/Line length", "Wear/Wheels"},
         [](S s) { return s.wear_plan.worn != WornBody::both; },
         "Wear",
         "Worn"},
        {{"Half-space/Interface layer shear modulus"},
         [](S s) { return s.halfspace_layer_thickness == 0; },
         "Half-space",
         "Interface layer"},
        {{"Half-space/Friction memory speed"},
         [](S s) { return s.halfspace_memory_length == 0; },
         "Half-space",
         "Friction memory"}};
      return table;
    }

    const Rule *
    rule_of(const Entry &entry, const Scene &scene)
    {
      for (const Rule &rule : rules())
        if (is_among(entry, rule.names) && rule.holds(scene))
          return &rule;
      return nullptr;
    }

    /// Those of all cases of a study, whose axes are asked for as --set does.
    std::vector<std::string>
    of_all_cases(SceneInput input)
    {
      const Study              study = input.scene.study;
      std::vector<std::string> result;
      for (const StudyAxis &axis : study.axes)
        input.origin[axis.path()] = {"Study/Axes"};
      bool first = true;
      for (const StudyCase &one : study_cases(Scene(input.scene), ""))
        {
          input.scene = one.scene;
          const auto here =
            entries_without_effect(input, study.compute == StudyComputation::halfspace ? "halfspace" : "run");
          const auto is_here = [&](const std::string &note) {
            const std::string entry = note.substr(0, note.find(" = "));
            return std::any_of(here.begin(), here.end(), [&](const std::string &other) {
              return other.substr(0, other.find(" = ")) == entry;
            });
          };
          if (first)
            result = here;
          result.erase(std::remove_if(result.begin(), result.end(), std::not_fn(is_here)), result.end());
          first = false;
        }
      return result;
    }
  } // namespace


  std::string
  entries_under_rows(const SceneInput &input, const MotionFile &rows, const std::string &file)
  {
    using Q             = MotionQuantity;
    Names      drive    = {"Wheelset/Drive", "Wheelset/Traction coefficient", "Wheelset/Creepage"};
    const auto replaced = [&](const Q column) -> Names {
      switch (column)
        {
          case Q::lateral_shift:
            return {"Wheelset/Lateral shift"};
          case Q::roll:
            return {"Wheelset/Roll"};
          case Q::yaw:
            return {"Wheelset/Yaw"};
          case Q::load:
          case Q::load_right:
            return {"Wheelset/Wheel load"};
          case Q::velocity:
            return {"Wheelset/Velocity"};
          case Q::torque:
          case Q::traction:
          case Q::creepage:
            return drive;
          case Q::lateral_creepage:
            return {"Wheelset/Lateral creepage"};
          case Q::radius:
            return {"Track/Radius"};
          case Q::cant:
            return {"Track/Cant"};
          default:
            return {};
        }
    };
    std::string told;
    for (const Q column : rows.quantities)
      for (const std::string &path : replaced(column))
        if (const auto origin = input.origin.find(path); origin != input.origin.end())
          told += (told.empty() ? "" : ", ") + path + " (" + origin->second.text + ")";
    return told.empty() ? "" : "without effect, since the rows of " + file + " have their own: " + told;
  }


  std::vector<std::string>
  entries_without_effect(const SceneInput &input, const std::string &command)
  {
    if (command == "study")
      return of_all_cases(input);
    std::vector<std::string> result;
    std::string              unread;
    for (const Entry &entry : entries())
      {
        const auto origin = input.origin.find(entry.path());
        if (origin == input.origin.end())
          continue;
        const bool asked = origin->second.order == Place::last_line; // a file serves all commands
        if (!asked && entry.get(input.scene) == entry.default_text)
          continue;
        if (!is_read(entry, command))
          unread += !asked ? "" : (unread.empty() ? "" : ", ") + entry.path();
        else if (const Rule *const rule = rule_of(entry, input.scene))
          result.push_back(entry_text(input.scene, entry.section, entry.name) + ": without effect, since " +
                           entry_text(input.scene, rule->section, rule->since));
      }
    if (!unread.empty())
      result.push_back("without effect in " + command + ": " + unread);
    return result;
  }
} // namespace wheelrail
