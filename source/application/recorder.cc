#include <wheelrail/application/recorder.h>
#include <wheelrail/output/patch_measures.h>

#include <cmath>

namespace wheelrail
{
  Recorder::Recorder(const Model &model)
    : model_(model)
  {}



  void
  Recorder::put(const std::string &name, const std::string &unit, const double value)
  {
    if (column_ == history_.columns.size())
      {
        history_.names.push_back(name);
        history_.units.push_back(unit);
        history_.columns.emplace_back();
      }
    history_.columns[column_++].push_back(value);
  }



  void
  Recorder::add(const Rolling &rolling, const Axle &axle)
  {
    const ContactSums   &c = rolling.contact_sums();
    const EnergyBalance &e = rolling.energy();
    const Point2         t = model_.geometry.frame.tangent(), n = model_.geometry.frame.normal();
    column_ = 0;
    put("time", "s", rolling.time());
    put("rolled_distance", "m", axle.travelled());
    put("normal_force", "N", c.force[0] * n.x + c.force[1] * n.y);
    put("vertical_force", "N", c.force[1]);
    put("longitudinal_force", "N", c.force[2]);
    put("lateral_force", "N", c.force[0]);
    put("tangential_lateral_force", "N", c.force[0] * t.x + c.force[1] * t.y);
    put("axle_lateral_force", "N", axle.reaction()[0]);
    put("axle_vertical_force", "N", axle.reaction()[1]);
    put("max_pressure", "Pa", c.largest_pressure);
    const double radius = model_.geometry.rolling_radius, V = axle.data().velocity;
    put("creepage", "1", (axle.pitch_rate() * radius - V) / V);
    put("pitch_rate", "rad/s", axle.pitch_rate());
    put("drive_torque", "N m", axle.applied_torque());
    put("axle_height", "m", axle.height());
    put("kinetic_energy", "J", e.kinetic);
    put("strain_energy", "J", e.strain);
    put("stabilisation_energy", "J", e.stabilisation);
    put("contact_energy", "J", e.contact);
    put("friction_dissipation", "J", e.friction);
    put("viscous_dissipation", "J", e.viscous);
    put("contact_damping_dissipation", "J", e.contact_damping);
    put("suspension_dissipation", "J", e.suspension);
    put("torque_work", "J", e.torque_work);
    put("speed_hold_work", "J", e.hold_work);
    put("energy_residual", "J", e.residual);
    put("energy_error", "1", e.error);
  }



  void
  Recorder::add_patch(const PatchFields &patch)
  {
    const PatchMeasures m = measure_patch(patch);
    patch_distance_.push_back(patch.rolled_distance);
    patch_area_.push_back(m.area);
    patch_width_.push_back(m.width);
    patch_length_.push_back(m.length);
    patch_shear_.push_back(m.max_shear);
    patch_stick_.push_back(m.stick_fraction);
    patch_pressure_.push_back(m.peak_pressure);
    patch_fitted_.push_back(m.peak_pressure_fitted);
    patch_along_.push_back(m.centre_along);
    patch_lateral_.push_back(m.centre_lateral);
  }



  Mean
  mean_from(const std::vector<double> &distance, const std::vector<double> &values, const double from)
  {
    double n = 0, sum = 0, squares = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (distance[k] >= from)
        {
          n += 1;
          sum += values[k];
        }
    const double mean = n > 0 ? sum / n : std::nan("");
    for (std::size_t k = 0; k < values.size(); ++k)
      if (distance[k] >= from)
        squares += (values[k] - mean) * (values[k] - mean);
    return {mean, n > 1 ? std::sqrt(squares / (n - 1)) : 0.};
  }



  void
  Recorder::fill(Summary &summary, const double distance) const
  {
    if (history_.columns.empty())
      return;
    const auto &rolled = history_.columns[1];
    const double from  = rolled.back() - distance;
    const auto column  = [&](const std::string &name) -> const std::vector<double> & {
      for (std::size_t c = 0; c < history_.names.size(); ++c)
        if (history_.names[c] == name)
          return history_.columns[c];
      throw std::logic_error("no history column " + name);
    };
    const auto put_mean = [&](const std::string &key, const std::string &unit, const Mean &mean) {
      set_figure(summary, key + unit, mean.mean);
      set_figure(summary, key + "_std" + unit, mean.deviation);
    };
    for (const char *name : {"normal_force", "vertical_force", "longitudinal_force", "lateral_force"})
      put_mean(name, "_N", mean_from(rolled, column(name), from));
    put_mean("creepage", "", mean_from(rolled, column("creepage"), from));
    set_figure(summary, "energy_error", column("energy_error").back());
    const auto patch = [&](const std::string &key, const std::string &unit, const std::vector<double> &values) {
      put_mean(key, unit, mean_from(patch_distance_, values, from));
    };
    patch("max_pressure", "_Pa", patch_pressure_);
    patch("max_pressure_fitted", "_Pa", patch_fitted_);
    patch("contact_area", "_m2", patch_area_);
    patch("patch_lateral", "_m", patch_width_);
    patch("patch_longitudinal", "_m", patch_length_);
    patch("patch_centre_lateral", "_m", patch_lateral_);
    patch("patch_centre_longitudinal", "_m", patch_along_);
    patch("max_shear_traction", "_Pa", patch_shear_);
    patch("stick_fraction", "", patch_stick_);
  }
} // namespace wheelrail
