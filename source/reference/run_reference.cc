#include <wheelrail/reference/trust.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace wheelrail
{
  namespace
  {
    std::string
    text(const char *format, const double value)
    {
      char buffer[64];
      std::snprintf(buffer, sizeof(buffer), format, value);
      return buffer;
    }

    double
    bulk_modulus(const MaterialData &material)
    {
      return material.youngs_modulus / (3 * (1 - 2 * material.poissons_ratio));
    }

    double
    degrees(const double angle)
    {
      return angle * 180 / std::acos(-1.);
    }

    /// The rules of doc/manual/compare.md.
    struct Rules
    {
      bool steady, stiff, fine, flat, elastic, one_patch;

      explicit Rules(const Trust &trust)
        : steady(!(trust.unsteadiness >= 0.01))
        , stiff(trust.penetration < 0.02)
        , fine(trust.cells >= 12)
        , flat(trust.turn < 0.2)
        , elastic(!(trust.plastic_strain > 1e-4))
        , one_patch(!(trust.patches > 1))
      {
      }
    };

    std::string
    cells_text(const Scene &scene, const Trust &trust, const bool fine)
    {
      const bool one = std::round(trust.cells) == 1;
      return text("%.0f", trust.cells) + (one ? " cell of " : " cells of ") +
             text("%g", 1e3 * scene.cell_size) + " mm over the shorter extent of the patch " +
             (one ? "is " : "are ") + (fine ? "enough" : "too few (take at least 12)");
    }

    std::string
    penalty_text(const Trust &trust, const bool stiff)
    {
      return "the penalty contact sinks in by " + text("%.1f", 100 * trust.penetration) +
             " % of the approach (" + (stiff ? "small" : "too soft: raise Contact/Penalty scale") + ")";
    }

    std::string
    forces_text(const Trust &trust, const bool steady)
    {
      return "the forces vary by " + text("%.2f", 100 * trust.unsteadiness) + " % of the load (" +
             (steady ? "steady" : "not steady: roll farther") + ")";
    }

    /// Why half-spaces are no full reference; empty when they are.
    std::string
    limits_of_reference(const Trust &trust, const Rules &rules)
    {
      std::string limits;
      const auto  add = [&](const std::string &limit) { limits += (limits.empty() ? "" : " and ") + limit; };
      if (!rules.elastic)
        add("steel has flowed (plastic strain up to " + text("%.2g", 1e3 * trust.plastic_strain) + "e-3)");
      if (!rules.flat)
        add("the surfaces turn by " + text("%.0f", degrees(trust.turn)) + " degrees across the patch");
      if (!rules.one_patch)
        add("the run has " + text("%.0f", trust.patches) + " patches");
      return limits;
    }

    /// How far the peak agrees, or why half-spaces are no reference for it.
    std::string
    verdict(const Trust &trust, const Rules &rules)
    {
      const double      difference = std::abs(trust.peak_difference);
      const std::string by = text("%.0f", 100 * difference), fine_by = text("%.1f", 100 * difference);
      const std::string result = "The finite element result ", limits = limits_of_reference(trust, rules);
      if (!std::isfinite(difference))
        return result + "has no peak pressure that could be compared";
      if (!limits.empty())
        return "The half-spaces are no full reference here, since " + limits +
               "; the peak pressures differ by " + fine_by + " %";
      if (difference > 0.05)
        return result + "is off by " + by + " % in peak pressure and shows tendencies only";
      // what is not resolved may agree by chance
      if (!(rules.fine && rules.stiff && rules.steady))
        return result + "differs from the half-spaces by " + fine_by +
               " % in peak pressure, which may be chance";
      if (difference <= 0.02)
        return result + "agrees with the half-spaces within " +
               text("%.1f", std::max(0.1, 100 * difference)) +
               " % in peak pressure and can be trusted as far";
      return result + "can be trusted to about " + by + " % in peak pressure";
    }

    /// What the difference of the peaks is made of; empty where a part is not known.
    std::string
    parts_sentence(const Trust &trust, const Rules &rules)
    {
      const auto   percent = [](const double part) { return text("%+.1f", 100 * part) + " %"; };
      const double rest    = trust.peak_difference - trust.penalty_part() - trust.mesh_part();
      if (!std::isfinite(rest))
        return "";
      std::string rest_is = "the rest";
      if (!rules.elastic)
        rest_is = "yielding, which half-spaces know nothing of";
      else if (!rules.flat)
        rest_is = "the curved contact";
      else if (!rules.one_patch)
        rest_is = "the other patch";
      else if (!rules.steady)
        rest_is = "forces that are not steady";
      return " Of the difference of " + percent(trust.peak_difference) +
             " in peak pressure the penalty contact makes about " + percent(trust.penalty_part()) +
             ", the cells " + percent(trust.mesh_part()) + ", " + rest_is + " " + percent(rest) + ".";
    }
  } // namespace


  Trust
  trust_of(const Scene &scene, const Summary &run, const HalfspacePressure &halfspace)
  {
    Trust trust;
    trust.peak_difference = run.max_pressure / halfspace.peak - 1;
    trust.cells           = std::min(halfspace.width, halfspace.length) / scene.cell_size;
    trust.penetration     = run.max_pressure * scene.cell_size /
                        (scene.penalty_scale *
                         std::min(bulk_modulus(scene.rail_material), bulk_modulus(scene.wheel_material))) /
                        halfspace.approach;
    trust.unsteadiness =
      std::max(get_figure(run, "vertical_force_std_N"), get_figure(run, "longitudinal_force_std_N")) /
      run.vertical_force;
    trust.turn = halfspace.turn;
    if (run.max_plastic_strain > 0)
      trust.plastic_strain = run.max_plastic_strain;
    if (const double patches = get_figure(run, "patches"); patches > 1 && patches != halfspace.patches)
      trust.patches = patches;
    return trust;
  }


  std::string
  trust_sentence(const Scene &scene, const Trust &trust, const bool finished)
  {
    const Rules rules(trust);
    std::string sentence = finished ? "" : "The run did not finish, so take its figures with care. ";
    sentence += verdict(trust, rules) + ": " + cells_text(scene, trust, rules.fine);
    if (std::isfinite(trust.penetration))
      sentence += ", " + penalty_text(trust, rules.stiff);
    if (std::isfinite(trust.unsteadiness))
      sentence += ", " + forces_text(trust, rules.steady);
    if (rules.flat)
      sentence +=
        ", and the surfaces turn by only " + text("%.0f", degrees(trust.turn)) + " degrees across the patch" +
        (limits_of_reference(trust, rules).empty() ? ", so that half-spaces are a fair reference" : "");
    return sentence + "." + parts_sentence(trust, rules);
  }


  PeakMiss
  peak_miss(const Scene &scene, const Trust &trust)
  {
    constexpr double usual = 0.1;
    if (std::abs(trust.peak_difference) <= usual)
      return {};
    const Rules              rules(trust);
    const std::string        limits = limits_of_reference(trust, rules);
    std::vector<std::string> causes;
    if (!limits.empty())
      causes.push_back("half-spaces are no full reference here, since " + limits);
    if (!rules.fine)
      causes.push_back(cells_text(scene, trust, false));
    if (!rules.stiff)
      causes.push_back(penalty_text(trust, false));
    if (!rules.steady)
      causes.push_back(forces_text(trust, false));
    PeakMiss miss;
    miss.sentence = "the peak pressure is " + text("%.0f", 100 * std::abs(trust.peak_difference)) + " % " +
                    (trust.peak_difference < 0 ? "below" : "above") +
                    " that of half-spaces under the same force and in the same pose";
    for (std::size_t k = 0; k < causes.size(); ++k)
      miss.sentence += (k == 0 ? ": " : "; ") + causes[k];
    if (causes.empty())
      miss.sentence += ", and the usual causes (cells, penalty, unsteady forces) do not explain it";
    miss.is_fault = limits.empty();
    return miss;
  }


  WheelRailLoad
  load_of_run(const Summary &run)
  {
    WheelRailLoad load;
    load.force        = run.vertical_force;
    load.vertical     = true;
    load.longitudinal = run.longitudinal_force;
    load.along_track  = true;
    // a force at its bound says no more of the creepage; one that slides sideways, by its direction
    load.slides = run.stick_fraction < 1e-3 && std::abs(run.longitudinal_force) > 1e-3 * run.vertical_force &&
                  !std::isfinite(get_figure(run, "yaw_rad"));
    return load;
  }


  SectionOffsets
  offsets_of_run(const Summary &run)
  {
    const auto value = [&](const char *key) {
      const double figure = get_figure(run, key);
      return std::isfinite(figure) ? figure : 0;
    };
    return {value("relative_lateral_m"), value("rail_head_roll_rad"), value("wheel_rim_roll_rad")};
  }
} // namespace wheelrail
