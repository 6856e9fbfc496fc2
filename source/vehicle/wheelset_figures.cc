#include <wheelrail/base/format_text.h>
#include <wheelrail/vehicle/wheelset_figures.h>
#include <wheelrail/verdict/interval.h>
#include <wheelrail/verdict/verdict.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  const std::vector<std::string> &
  axle_keys()
  {
    static const std::vector<std::string> keys = split_list(
      "axle_pitch_rate_rad_per_s, axle_torque_Nm, axle_lateral_force_N, axle_yaw_moment_Nm, "
      "axle_prudhomme_limit_N, axle_load_N, axle_lateral_shift_m, axle_yaw_rad, "
      "axle_unbalanced_acceleration_m_per_s2");
    return keys;
  }


  void
  set_axle_figures(const WheelsetSolution &wheelset, Summary &summary)
  {
    const Scene        &scene    = wheelset.right.scene;
    const double        load     = wheelset.right.load + wheelset.left.load;
    const AxleSolution &axle     = wheelset.axle;
    const double        values[] = {axle.rate * scene.velocity,
                                    axle.torque,
                                    axle.lateral,
                                    axle.yaw_moment,
                                    scene.prudhomme_factor * (10e3 + load / 3),
                                    load,
                                    scene.lateral_shift,
                                    scene.yaw,
                                    wheelset.loads.acceleration};
    for (std::size_t k = 0; k < axle_keys().size(); ++k)
      set_figure(summary, axle_keys()[k], values[k]);
  }


  void
  set_wheel_figures(const WheelsetSolution &wheelset, const bool left, Summary &summary)
  {
    set_figure(
      summary, "rolling_radius_m", (left ? wheelset.left : wheelset.right).geometry.contact.rolling_radius);
  }


  std::string
  lifted_by_curve(const bool left)
  {
    return std::string("The ") + (left ? "left" : "right") +
           "-hand wheel is lifted: the curve demands more than both wheels hold, and the vehicle begins to "
           "tip over.";
  }


  namespace
  {
    /// A figure and the ends of its interval under a longer name.
    void
    copy_figure(const Summary &from, const std::string &key, const std::string &before, Summary &to)
    {
      set_figure(to, before + key, get_figure(from, key));
      for (const std::string &end : interval_keys(key))
        if (const double value = get_figure(from, end); std::isfinite(value))
          set_figure(to, before + end, value);
    }
  } // namespace


  Summary
  wheelset_summary(const Scene            &scene,
                   const WheelsetSolution &wheelset,
                   const Summary          *right,
                   const Summary          *left)
  {
    Summary total;
    total.title           = scene.title;
    total.program_version = WHEELRAIL_VERSION;
    total.velocity        = scene.velocity;
    total.wall_time       = 0;
    total.finished        = true;
    set_axle_figures(wheelset, total);
    Grade grade = Grade::trusted;
    for (const bool is_left : {false, true})
      {
        const Summary *const wheel = is_left ? left : right;
        const std::string    side  = is_left ? "left" : "right";
        if (!wheel)
          {
            grade = std::min(grade, Grade::with_care);
            total.doubts += (total.doubts.empty() ? "" : " ") + lifted_by_curve(is_left);
            continue;
          }
        for (const std::string &key :
             split_list("vertical_force_N, lateral_force_N, lateral_over_vertical, longitudinal_force_N, "
                        "normal_force_N, reference_creepage, reference_lateral_creepage, "
                        "reference_spin_per_m, reference_lateral_m, patch_centre_from_axis_m, "
                        "patch_centre_from_gauge_face_m, reference_radius_m, rolling_radius_m, t_gamma_N, "
                        "max_pressure_Pa, halfspace_max_pressure_Pa, contact_area_m2, stick_fraction"))
          copy_figure(*wheel, key, side + "_", total);
        grade          = std::min(grade, grade_of(*wheel));
        total.finished = total.finished && wheel->finished;
        total.wall_time += wheel->wall_time;
        if (!wheel->stop_reason.empty() && total.stop_reason.find(wheel->stop_reason) == std::string::npos)
          total.stop_reason += wheel->stop_reason;
        if (!wheel->doubts.empty())
          total.doubts += (total.doubts.empty() ? "" : " ") + side + " wheel: " + wheel->doubts;
      }
    total.verdict      = grade_word(grade);
    const double limit = get_figure(total, "axle_prudhomme_limit_N");
    if (const double sum = std::abs(get_figure(total, "axle_lateral_force_N")); sum > limit)
      total.note = text(
        "The sum of the lateral forces, %.1f kN, is above the limit after Prud'homme, %.1f kN: "
        "the track may be shifted.",
        1e-3 * sum,
        1e-3 * limit);
    return total;
  }
} // namespace wheelrail
