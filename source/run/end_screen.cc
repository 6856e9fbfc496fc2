#include <wheelrail/base/format_text.h>
#include <wheelrail/base/hints.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/run/end_screen.h>
#include <wheelrail/verdict/interval.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    using Lines = std::vector<std::string>;

    /// Sentences of a text, one by one.
    Lines
    sentences_of(const std::string &text)
    {
      Lines sentences;
      for (std::size_t begin = 0; begin < text.size();)
        {
          std::size_t end = text.find(". ", begin);
          end             = end == std::string::npos ? text.size() : end + 1;
          sentences.push_back(text.substr(begin, end - begin));
          begin = end + 1;
        }
      return sentences;
    }

    std::string
    padded(const std::string &text, const std::size_t width)
    {
      return text + std::string(text.size() < width ? width - text.size() : 0, ' ');
    }

    /// Figures of one group: its name stands before the first.
    class Group
    {
    public:
      Group(const char *name, const Summary &summary, Lines &lines)
        : name_(name)
        , summary_(summary)
        , lines_(lines)
      {
      }

      /// A figure under its own label or another one; nothing where there is none.
      void
      figure(const char *name, const std::string &label = "")
      {
        const Figure &figure = figure_named(name);
        const double  value  = get_figure(summary_, figure.key());
        if (std::isfinite(value))
          line(label.empty() ? figure.label : label,
               figure.shown(value),
               figure.unit,
               shown_interval(summary_, name));
      }

      void
      line(const std::string &label,
           const std::string &value,
           const std::string &unit,
           const std::string &interval = "")
      {
        const std::string right = std::string(value.size() < 12 ? 12 - value.size() : 0, ' ') + value;
        lines_.push_back("  " + padded(name_, 10) + padded(label, 32) + right +
                         (unit.empty() ? "" : " " + unit) + (interval.empty() ? "" : " (" + interval + ")"));
        name_.clear();
      }

    private:
      std::string    name_; ///< until it has been said
      const Summary &summary_;
      Lines         &lines_;
    };

    void
    add_verdict(const Summary &summary, Lines &lines)
    {
      constexpr std::size_t most = 3;
      lines.push_back("  verdict: " + verdict_of(summary));
      if (!summary.finished)
        {
          const std::size_t end = summary.stop_reason.find_last_not_of(" ."); // of sentences
          lines.push_back(
            "    - It did not finish: " +
            (end == std::string::npos ? "no reason is known" : summary.stop_reason.substr(0, end + 1)) +
            "; this is what it has.");
          return;
        }
      const Lines reasons = sentences_of(summary.doubts);
      for (std::size_t k = 0; k < std::min(most, reasons.size()); ++k)
        lines.push_back("    - " + reasons[k]);
      if (reasons.size() > most)
        lines.push_back("    - " + std::to_string(reasons.size() - most) + " more in summary.json.");
    }

    void
    add_forces(const Summary &summary, Lines &lines)
    {
      Group forces("forces", summary, lines);
      forces.figure("wheel_load");
      forces.figure("vertical_force", "vertical force Q");
      forces.figure("lateral_force", "lateral force Y");
      if (summary.vertical_force > 0)
        forces.line("Y/Q", text("%.4f", summary.lateral_force / summary.vertical_force), "");
      forces.figure("longitudinal_force");
    }

    /// What a run over irregular surfaces is made for; nothing of others.
    void
    add_impact(const Summary &summary, Lines &lines)
    {
      Group      impact("impact", summary, lines);
      const auto with_place = [&](const std::string &name) {
        const Figure &figure = figure_named(name), &place = figure_named(name + "_at");
        const double  value = get_figure(summary, figure.key()), at = get_figure(summary, place.key());
        if (std::isfinite(value) && std::isfinite(at))
          impact.line(figure.label,
                      figure.shown(value),
                      figure.unit + (" at " + place.shown(at)) + " mm",
                      shown_interval(summary, name));
      };
      with_place("largest_vertical_force");
      with_place("least_vertical_force");
      with_place("first_rail_force");
      with_place("second_rail_force");
      impact.figure("impact_factor");
      impact.figure("contact_loss");
      for (const char *name : {"largest_pressure", "von_mises_on_way", "plastic_strain_on_way"})
        with_place(name);
      const Figure &up = figure_named("axle_acceleration_up"), &down = figure_named("axle_acceleration_down");
      if (const double most = get_figure(summary, up.key()); std::isfinite(most))
        impact.line("acceleration of the axle box",
                    down.shown(-get_figure(summary, down.key())) + " to " + up.shown(most),
                    up.unit);
      impact.figure("pinned_pinned");
      impact.figure("contact_resonance");
    }

    /// Where the patch lies, as an engineer on the track would measure it; empty where it is not known.
    std::string
    place_on_head(const Summary &summary)
    {
      const double axis = get_figure(summary, "patch_centre_from_axis_m"),
                   face = get_figure(summary, "patch_centre_from_gauge_face_m");
      if (!std::isfinite(axis) || !std::isfinite(face))
        return "";
      return text("%.1f", 1e3 * std::abs(axis)) + " mm to the " + (axis < 0 ? "field" : "gauge") +
             " side of its axis, " + text("%.1f", 1e3 * face) + " mm from the gauge face";
    }

    void
    add_contact(const Summary &summary, Lines &lines)
    {
      Group contact("contact", summary, lines);
      contact.figure("max_pressure");
      const double patches = get_figure(summary, figure_named("patches").key());
      contact.figure("contact_area",
                     patches > 1 ? "contact area, " + std::to_string(std::lround(patches)) + " patches" : "");
      if (std::isfinite(summary.patch_lateral))
        contact.line("patch, across x along the rail",
                     figure_named("patch_lateral").shown(summary.patch_lateral) + " x " +
                       figure_named("patch_longitudinal").shown(summary.patch_longitudinal),
                     "mm");
      if (const std::string place = place_on_head(summary); !place.empty())
        contact.line("patch centre on the rail head", place, "");
      contact.figure("creepage");
      contact.figure("stick_fraction");
      contact.figure("t_gamma");
    }

    void
    add_stresses(const Summary &summary, Lines &lines)
    {
      Group stresses("stresses", summary, lines);
      stresses.figure("max_shear_traction");
      stresses.figure("max_von_mises");
      stresses.figure("von_mises_below_cell");
      if (summary.max_plastic_strain > 0)
        {
          stresses.figure("max_plastic_strain");
          stresses.figure("max_residual_von_mises");
        }
    }

    /// What rests on pads or sleepers.
    void
    add_track(const Summary &summary, Lines &lines)
    {
      Group track("track", summary, lines);
      for (const char *name : {"foot_deflection", "largest_pad_force", "largest_pad_pull"})
        track.figure(name);
    }

    /// What half-spaces and true bodies know beyond a run's patch: in which plane it lies, how the bodies
    /// moved.
    void
    add_pose(const Summary &summary, Lines &lines)
    {
      Group pose("position", summary, lines);
      for (const char *name : {"contact_angle",
                               "spin",
                               "rail_head_lateral",
                               "rail_head_roll",
                               "wheel_rim_lateral",
                               "wheel_rim_roll",
                               "relative_lateral",
                               "relative_roll"})
        pose.figure(name);
    }

    void
    add_wear(const Summary &summary, Lines &lines)
    {
      Group wear("wear", summary, lines);
      wear.figure("archard_depth");
      wear.figure("burstow_damage");
    }

    void
    add_cost(const Summary &summary, Lines &lines)
    {
      const auto shown = [&](const char *name) {
        const Figure &figure = figure_named(name);
        return figure.shown(get_figure(summary, figure.key())) + (*figure.unit ? " " : "") + figure.unit;
      };
      lines.push_back("  cost      " + shown("rolled_distance") + " rolled in " + shown("wall_time") +
                      " on " + shown("ranks") + (summary.ranks == 1 ? " process" : " processes") +
                      ", energy error " + shown("energy_error") + ", " + shown("elements") + " elements, " +
                      shown("time_steps") + " steps, " + shown("peak_memory") + " of memory");
    }

    Lines
    title_of(const Summary &summary)
    {
      return summary.title.empty() ? Lines{} : Lines{summary.title};
    }
  } // namespace


  std::vector<std::string>
  end_screen(const Summary &summary, const std::string &folder)
  {
    Lines lines = title_of(summary);
    add_verdict(summary, lines);
    add_impact(summary, lines);
    add_forces(summary, lines);
    add_contact(summary, lines);
    add_stresses(summary, lines);
    add_track(summary, lines);
    add_cost(summary, lines);
    if (!summary.note.empty())
      lines.push_back("  " + summary.note);
    const std::string where = shell_word(folder);
    lines.push_back(
      "  next: " +
      (summary.finished ? own_call() + " compare " + where + " (against half-spaces), " : std::string()) +
      own_call() + " report " + where + " (pictures and a page)");
    return lines;
  }


  std::vector<std::string>
  halfspace_screen(const Summary &summary)
  {
    Lines lines = title_of(summary);
    add_verdict(summary, lines);
    add_forces(summary, lines);
    add_contact(summary, lines);
    add_pose(summary, lines);
    Group("stresses", summary, lines).figure("max_shear_traction");
    add_wear(summary, lines);
    const Figure &elements = figure_named("elements"), &time = figure_named("wall_time");
    lines.push_back("  cost      " + elements.shown(summary.elements) + " elements in contact, " +
                    time.shown(summary.wall_time) + " " + time.unit);
    if (!summary.note.empty())
      lines.push_back("  " + summary.note);
    return lines;
  }
} // namespace wheelrail
