#include <wheelrail/wheel/reference_figures.h>

namespace wheelrail
{
  void
  set_reference_figures(const ContactReference &at, const bool determined, Summary &summary)
  {
    const double of_motion = determined ? 1 : Summary::none;
    set_figure(summary, "reference_ahead_of_axle_m", at.ahead);
    set_figure(summary, "reference_angle_rad", at.angle);
    set_figure(summary, "reference_creepage", of_motion * at.creepage);
    set_figure(summary, "reference_lateral_creepage", of_motion * at.lateral_creepage);
    set_figure(summary, "reference_spin_per_m", of_motion * at.spin);
  }
} // namespace wheelrail
