#include <wheelrail/base/format_text.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/output/summary.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <stdexcept>

namespace wheelrail
{
  namespace
  {
    using S = Summary;

    // clang-format off
    // name, SI, label, remark, unit shown, factor, decimals, count, member
    const std::vector<Figure> figures = {
      {"normal_force", "N", "normal force", "", "kN", 1e-3, 2, false, &S::normal_force},
      {"vertical_force", "N", "vertical force", "", "kN", 1e-3, 2, false, &S::vertical_force},
      {"longitudinal_force", "N", "longitudinal force on the wheel", "positive forward", "kN", 1e-3, 2, false, &S::longitudinal_force},
      {"lateral_force", "N", "lateral force on the wheel", "positive to the track centre", "kN", 1e-3, 3, false, &S::lateral_force},
      {"max_pressure", "Pa", "peak pressure", "", "MPa", 1e-6, 1, false, &S::max_pressure},
      {"max_pressure_fitted", "Pa", "peak pressure, fitted", "top of a parabola through nine nodes", "MPa", 1e-6, 1, false, &S::max_pressure_fitted},
      {"contact_area", "m2", "contact area", "", "mm2", 1e6, 1, false, &S::contact_area},
      {"patch_lateral", "m", "patch across the rail", "", "mm", 1e3, 2, false, &S::patch_lateral},
      {"patch_longitudinal", "m", "patch along the rail", "", "mm", 1e3, 2, false, &S::patch_longitudinal},
      {"patch_centre_lateral", "m", "patch centre from rigid contact point", "positive to the track centre", "mm", 1e3, 2, false, &S::patch_centre_lateral},
      {"patch_centre_longitudinal", "m", "patch centre, along the rail", "positive ahead of the axle", "mm", 1e3, 2, false, &S::patch_centre_longitudinal},
      {"patch_centre_from_axis", "m", "patch centre from the rail's axis", "positive to the gauge side", "mm", 1e3, 2, false, nullptr},
      {"patch_centre_from_gauge_face", "m", "patch centre from the gauge face", "positive to the field side", "mm", 1e3, 2, false, nullptr},
      {"patch_centre_below_top", "m", "patch centre below the top of the rail", "", "mm", 1e3, 2, false, nullptr},
      {"max_shear_traction", "Pa", "peak shear traction", "", "MPa", 1e-6, 1, false, &S::max_shear_traction},
      {"stick_fraction", "", "sticking part of the patch", "", "%", 1e2, 1, false, &S::stick_fraction},
      {"creepage", "", "creepage", "positive when driving", "1e-3", 1e3, 3, false, &S::creepage},
      {"friction_coefficient", "", "friction coefficient", "", "", 1, 3, false, &S::friction_coefficient},
      {"max_von_mises", "Pa", "largest von Mises stress", "mean of an element", "MPa", 1e-6, 1, false, &S::max_von_mises},
      {"max_plastic_strain", "", "largest plastic strain", "equivalent, accumulated", "1e-3", 1e3, 3, false, &S::max_plastic_strain},
      {"max_residual_von_mises", "Pa", "largest residual von Mises stress", "", "MPa", 1e-6, 1, false, &S::max_residual_von_mises},
      {"rolled_distance", "m", "rolled distance", "", "mm", 1e3, 1, false, &S::rolled_distance},
      {"velocity", "m_per_s", "velocity", "", "km/h", 3.6, 1, false, &S::velocity},
      {"elements", "", "elements", "", "", 1, 0, true, &S::elements},
      {"time_steps", "", "time steps", "", "", 1, 0, true, &S::time_steps},
      {"time_step", "s", "time step", "", "ns", 1e9, 2, false, &S::time_step},
      {"mass_scaling", "", "mass scaling", "largest share added to a body", "%", 1e2, 4, false, nullptr},
      {"element_updates_per_second", "", "element updates per second", "", "million", 1e-6, 2, false, &S::element_updates_per_second},
      {"energy_error", "", "energy error", "relative to strain plus dissipated energy", "%", 1e2, 3, false, &S::energy_error},
      {"wall_time", "s", "wall time", "", "s", 1, 1, false, &S::wall_time},
      {"peak_memory", "bytes", "peak memory, all ranks", "", "MB", 1e-6, 0, true, &S::peak_memory},
      {"ranks", "", "ranks", "", "", 1, 0, true, &S::ranks},

      {"t_gamma", "N", "wear number T-gamma", "friction work for each metre rolled", "N", 1, 2, false, nullptr},
      {"creepage_work", "N", "work of the creepages", "forces times creepages and spin, for each metre rolled", "N", 1, 2, false, nullptr},
      {"friction_work", "N", "work of friction along the paths of particles", "traction times slip, for each metre rolled", "N", 1, 2, false, nullptr},
      {"frictional_power", "W", "frictional power", "", "kW", 1e-3, 3, false, nullptr},
      {"t_gamma_over_area", "N_per_m2", "wear number over contact area", "", "N/mm2", 1e-6, 4, false, nullptr},
      {"usfd_wear_rate", "kg_per_m3", "wear rate after the wear number over area", "for each metre rolled", "ug/m/mm2", 1e3, 3, false, nullptr},
      {"burstow_damage", "", "crack damage of one passage", "share of a life, after Burstow", "1e-6", 1e6, 3, false, nullptr},
      {"utilised_friction", "", "traction coefficient, T/N", "", "", 1, 4, false, nullptr},
      {"fatigue_index", "", "fatigue index of the surface", "positive: fatigue is predicted", "", 1, 4, false, nullptr},
      {"shakedown_load", "", "peak pressure over yield stress in shear", "", "", 1, 3, false, nullptr},
      {"archard_depth", "m", "largest wear depth of one passage", "after Archard", "nm", 1e9, 3, false, nullptr},
      {"archard_section", "m2", "section worn by one passage", "after Archard", "um2", 1e12, 3, false, nullptr},
      {"creepage_at_patch_centre", "", "creepage with the radius at the patch centre", "positive when driving", "1e-3", 1e3, 3, false, nullptr},
      {"max_von_mises_nodal", "Pa", "largest von Mises stress at a node", "as in the VTU files", "MPa", 1e-6, 1, false, nullptr},
      {"plastic_band_width", "m", "width of the plastic zone", "plastic strain above 1e-4", "mm", 1e3, 1, false, nullptr},
      {"plastic_band_depth", "m", "depth of the plastic zone", "plastic strain above 1e-4", "mm", 1e3, 1, false, nullptr},
      {"plastic_band_centre_lateral", "m", "middle of the plastic zone", "positive to the track centre", "mm", 1e3, 2, false, nullptr},
      {"residual_lateral_stress", "Pa", "largest residual stress across the rail", "behind the wheel, without loads", "MPa", 1e-6, 1, false, nullptr},
      {"residual_longitudinal_stress", "Pa", "largest residual stress along the rail", "behind the wheel, without loads", "MPa", 1e-6, 1, false, nullptr},
      {"residual_forward_flow", "m", "surface moved along the rail", "behind the wheel, without loads; positive forward", "um", 1e6, 3, false, nullptr},
      {"rail_plastic_strain", "", "largest plastic strain of the rail behind the wheel", "", "1e-3", 1e3, 3, false, nullptr},
      {"first_force_over_load", "", "vertical force of the first step over the load", "", "", 1, 4, false, nullptr},
      {"largest_vertical_force", "N", "largest vertical force", "over the whole distance", "kN", 1e-3, 2, false, nullptr},
      {"largest_vertical_force_at", "m", "where it acts", "", "mm", 1e3, 1, false, nullptr},
      {"least_vertical_force", "N", "least vertical force", "over the whole distance", "kN", 1e-3, 2, false, nullptr},
      {"least_vertical_force_at", "m", "where it acts", "", "mm", 1e3, 1, false, nullptr},
      {"impact_factor", "", "impact factor", "largest vertical force over the wheel load", "", 1, 3, false, nullptr},
      {"first_rail_force", "N", "largest vertical force, first rail", "over the whole distance", "kN", 1e-3, 2, false, nullptr},
      {"first_rail_force_at", "m", "where it acts", "", "mm", 1e3, 1, false, nullptr},
      {"second_rail_force", "N", "largest vertical force, second rail", "over the whole distance", "kN", 1e-3, 2, false, nullptr},
      {"second_rail_force_at", "m", "where it acts", "", "mm", 1e3, 1, false, nullptr},
      {"contact_loss", "m", "rolled without contact", "", "mm", 1e3, 2, false, nullptr},
      {"largest_pressure", "Pa", "largest pressure", "at a node, over the whole distance", "MPa", 1e-6, 1, false, nullptr},
      {"largest_pressure_at", "m", "where it acts", "", "mm", 1e3, 1, false, nullptr},
      {"von_mises_on_way", "Pa", "largest von Mises stress", "mean of an element, over the whole distance", "MPa", 1e-6, 1, false, nullptr},
      {"von_mises_on_way_at", "m", "where it acts", "", "mm", 1e3, 1, false, nullptr},
      {"plastic_strain_on_way", "", "largest plastic strain", "over the whole distance", "1e-3", 1e3, 3, false, nullptr},
      {"plastic_strain_on_way_at", "m", "where it is reached", "", "mm", 1e3, 1, false, nullptr},
      {"axle_acceleration_up", "m_per_s2", "axle box, largest acceleration upwards", "", "m/s2", 1, 1, false, nullptr},
      {"axle_acceleration_down", "m_per_s2", "axle box, largest acceleration downwards", "", "m/s2", 1, 1, false, nullptr},
      {"foot_deflection", "m", "rail's foot sinks", "where it sinks most; mean over its width", "mm", 1e3, 3, false, nullptr},
      {"largest_pad_force", "N", "largest force of a pad", "over the whole distance", "kN", 1e-3, 2, false, nullptr},
      {"largest_pad_pull", "N", "largest pull of a pad", "over the whole distance; a clip holds it", "kN", 1e-3, 3, false, nullptr},
      {"pinned_pinned", "Hz", "pinned-pinned frequency", "a wave of the unsupported rail is two bays long", "Hz", 1, 0, false, nullptr},
      {"contact_resonance", "Hz", "contact resonance", "a rigid wheel on the spring of the contact on the rail", "Hz", 1, 0, false, nullptr},
      {"patches", "", "separate patches", "", "", 1, 0, true, nullptr},
      {"largest_swing", "", "largest fluctuation of a result", "means over 2 mm, relative", "%", 1e2, 2, false, nullptr},
      {"largest_drift", "", "largest drift of a result", "over the averaging distance, beyond noise", "%", 1e2, 2, false, nullptr},
      {"means_from", "m", "averaging begins after", "", "mm", 1e3, 1, false, nullptr},
      {"cells_across_peak", "", "cells across the highest pressure", "", "", 1, 1, false, nullptr},
      {"peak_between_nodes", "", "rise of the pressure between nodes", "over the peak", "%", 100, 1, false, nullptr},
      {"torque_miss", "", "longitudinal force less what the torque demands", "relative", "%", 1e2, 2, false, nullptr},
      {"settled_after", "m", "steady after", "", "mm", 1e3, 1, false, nullptr},
      {"plastic_work_rail", "J", "plastic work in the rail", "", "J", 1, 3, false, nullptr},
      {"plastic_work_wheel", "J", "plastic work in the wheel", "", "J", 1, 3, false, nullptr},
      {"wheel_load", "N", "wheel load", "", "kN", 1e-3, 2, false, nullptr},
      {"rolling_radius", "m", "rolling radius", "of the rigid contact", "mm", 1e3, 2, false, nullptr},
      {"contact_angle", "rad", "contact angle", "positive when the tangent falls to the gauge side", "mrad", 1e3, 2, false, nullptr},
      {"rail_head_lateral", "m", "rail head moved", "positive to the track centre", "mm", 1e3, 3, false, nullptr},
      {"rail_head_roll", "rad", "rail head turned", "positive from X to Y", "mrad", 1e3, 3, false, nullptr},
      {"wheel_rim_lateral", "m", "wheel rim moved", "positive to the track centre", "mm", 1e3, 3, false, nullptr},
      {"wheel_rim_roll", "rad", "wheel rim turned", "positive from X to Y", "mrad", 1e3, 3, false, nullptr},
      {"relative_lateral", "m", "wheel moved against the rail", "positive to the track centre", "mm", 1e3, 3, false, nullptr},
      {"relative_roll", "rad", "rail turned against the wheel", "positive when its top leans to the track centre", "mrad", 1e3, 3, false, nullptr},
      {"approach", "m", "approach of the two bodies", "", "mm", 1e3, 4, false, nullptr},
      {"traction_over_friction", "", "utilised friction, T/(mu N)", "below 1: partial slip", "", 1, 3, false, nullptr},
      {"spin", "per_m", "spin", "", "1/m", 1, 4, false, nullptr},
      {"yaw", "rad", "yaw of the wheelset", "positive: nose to the track centre", "mrad", 1e3, 3, false, nullptr},
      {"lateral_shift", "m", "lateral shift of the wheelset", "positive to the track centre", "mm", 1e3, 3, false, nullptr},
      {"motion_distance", "m", "place of these means along the motion", "of a run that follows a motion", "mm", 1e3, 1, false, nullptr},
      {"wheelset_roll", "rad", "roll of the wheelset", "positive from X to Y", "mrad", 1e3, 3, false, nullptr},
      {"reference_lateral", "m", "reference point, from the running circle", "positive to the track centre", "mm", 1e3, 3, false, nullptr},
      {"reference_vertical", "m", "reference point, height", "above the top of the rail", "mm", 1e3, 3, false, nullptr},
      {"reference_along", "m", "reference point, along the track", "ahead of the middle of the wheelset", "mm", 1e3, 3, false, nullptr},
      {"reference_radius", "m", "rolling radius, reference point", "from the axle", "mm", 1e3, 2, false, nullptr},
      {"reference_ahead_of_axle", "m", "reference point, ahead of the axle", "", "mm", 1e3, 3, false, nullptr},
      {"reference_angle", "rad", "contact angle, reference point", "positive when the tangent falls to the gauge side", "mrad", 1e3, 2, false, nullptr},
      {"reference_creepage", "", "longitudinal creepage, reference point", "positive when driving; over the mean speed", "1e-3", 1e3, 3, false, nullptr},
      {"reference_lateral_creepage", "", "lateral creepage, reference point", "of the wheel to the track centre", "1e-3", 1e3, 3, false, nullptr},
      {"reference_spin", "per_m", "spin, reference point", "of the rail against the wheel", "1/m", 1, 4, false, nullptr},
      {"reference_spin_moment", "Nm", "spin moment, reference point", "on the rail", "N m", 1, 2, false, nullptr},
      {"tangential_lateral_force", "N", "lateral force in the contact plane", "on the wheel, to the track centre", "kN", 1e-3, 3, false, nullptr},
      {"wheelset_longitudinal_force", "N", "force along the wheelset", "on the wheel, forward", "kN", 1e-3, 3, false, nullptr},
      {"wheelset_lateral_force", "N", "force along the axle", "on the wheel, to the track centre", "kN", 1e-3, 3, false, nullptr},
      {"lateral_over_vertical", "", "lateral over vertical force, Y/Q", "positive to the track centre", "", 1, 4, false, nullptr},
      {"axle_pitch_rate", "rad_per_s", "turning rate of the axle", "", "rad/s", 1, 4, false, nullptr},
      {"axle_torque", "Nm", "torque on the axle", "positive drives", "kN m", 1e-3, 3, false, nullptr},
      {"axle_lateral_force", "N", "sum of the lateral forces on the wheels", "positive to the left", "kN", 1e-3, 3, false, nullptr},
      {"axle_yaw_moment", "Nm", "steering moment of the contacts", "positive turns the nose to the left", "kN m", 1e-3, 3, false, nullptr},
      {"axle_prudhomme_limit", "N", "limit of the lateral sum, after Prud'homme", "", "kN", 1e-3, 2, false, nullptr},
      {"axle_load", "N", "load of the axle", "", "kN", 1e-3, 2, false, nullptr},
      {"axle_lateral_shift", "m", "lateral shift of the axle", "positive to the left", "mm", 1e3, 3, false, nullptr},
      {"axle_yaw", "rad", "yaw of the axle", "positive: nose to the left", "mrad", 1e3, 3, false, nullptr},
      {"axle_unbalanced_acceleration", "m_per_s2", "lateral acceleration beyond the cant", "positive to the left", "m/s2", 1, 3, false, nullptr},
      {"drive_torque", "Nm", "torque that keeps the wheel rolling", "positive drives", "kN m", 1e-3, 4, false, nullptr},
      {"yaw_moment", "Nm", "yaw moment on the wheelset", "of this wheel, positive from Z to X", "kN m", 1e-3, 3, false, nullptr},
      {"area_of_whole_elements", "m2", "area of whole elements", "", "mm2", 1e6, 1, false, nullptr},
      {"surface_von_mises", "Pa", "largest von Mises at the surface", "", "MPa", 1e-6, 1, false, nullptr},
      {"subsurface_von_mises", "Pa", "largest von Mises below the surface", "", "MPa", 1e-6, 1, false, nullptr},
      {"subsurface_von_mises_depth", "m", "depth of the largest below the surface", "", "mm", 1e3, 2, false, nullptr},
      {"von_mises_below_cell", "Pa", "largest von Mises below one cell", "in the cuts through the contact", "MPa", 1e-6, 1, false, nullptr},
      {"von_mises_below_cell_depth", "m", "depth of the largest below one cell", "", "mm", 1e3, 2, false, nullptr},
      {"largest_von_mises", "Pa", "largest von Mises stress", "at or below the surface", "MPa", 1e-6, 1, false, nullptr},
      {"grid_spacing", "m", "grid spacing", "", "mm", 1e3, 3, false, nullptr},
      {"grid_elements_along", "", "grid elements along the rail", "", "", 1, 0, true, nullptr},
      {"grid_elements_lateral", "", "grid elements across the rail", "", "", 1, 0, true, nullptr}};
    // clang-format on
  } // namespace


  std::string
  Figure::key(const std::string &tail) const
  {
    return name + tail + (*si ? std::string("_") + si : "");
  }


  std::string
  Figure::si_unit() const
  {
    const std::string unit = si;
    const std::size_t per  = unit.find("per_");
    if (per == std::string::npos)
      return unit.empty() ? "1" : unit;
    return (per == 0 ? "1" : unit.substr(0, per - 1)) + "/" + unit.substr(per + 4);
  }


  std::string
  Figure::shown(const double given) const
  {
    if (!std::isfinite(given))
      return "-";
    return text("%.*f", decimals, given * factor);
  }


  const std::vector<Figure> &
  all_figures()
  {
    return figures;
  }


  const Figure &
  figure_named(const std::string &name)
  {
    for (const Figure &figure : figures)
      if (name == figure.name)
        return figure;
    throw std::logic_error("no figure " + name);
  }


  const Figure *
  figure_with_key(const std::string &key)
  {
    for (const Figure &figure : figures)
      if (key == figure.key())
        return &figure;
    return nullptr;
  }


  std::string
  figures_as_json()
  {
    auto table = nlohmann::ordered_json::array();
    for (const Figure &figure : figures)
      table.push_back({{"key", figure.key()},
                       {"std_key", figure.key("_std")},
                       {"error_key", figure.key("_error")},
                       {"low_key", figure.key("_low")},
                       {"high_key", figure.key("_high")},
                       {"label", figure.label},
                       {"remark", figure.remark},
                       {"unit", figure.unit},
                       {"factor", figure.factor},
                       {"decimals", figure.decimals}});
    return table.dump(1) + "\n";
  }
} // namespace wheelrail
