#include <wheelrail/mesh/lattice.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/sampling/body_figures.h>
#include <wheelrail/sampling/impact_figures.h>
#include <wheelrail/sampling/patch_measures.h>
#include <wheelrail/sampling/recorder.h>
#include <wheelrail/sampling/settling.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Adds one row to a table, value by value; the first row makes the columns.
    class Row
    {
    public:
      explicit Row(History &table)
        : table_(table)
      {
      }

      /// A quantity that is a figure of the summary too; pure numbers have the unit 1.
      void
      put(const std::string &figure, const double value)
      {
        const std::string si = figure_named(figure).si;
        put(figure, si.empty() ? "1" : si, value);
      }

      void
      put(const std::string &name, const std::string &unit, const double value)
      {
        if (column_ == table_.columns.size())
          {
            table_.names.push_back(name);
            table_.units.push_back(unit);
            table_.columns.emplace_back();
          }
        table_.columns[column_++].push_back(value);
      }

    private:
      History    &table_;
      std::size_t column_ = 0;
    };

    /// The rows of the whole strip, of which a mesh may have finest cells in a part.
    Lattice
    rows_of_strip(const Model &model)
    {
      const SweepPlan &plan = model.discretization->plan();
      return make_lattice(plan, Body::rail, {0, 0}, plan.whole_strip());
    }

    /// Moment of the contact's forces on the wheelset about the vertical through its middle [N m].
    double
    yaw_moment(const ContactSums &sums, const ContactGeometry &geometry, const Axle &axle)
    {
      const Vector3 middle = {
        geometry.axis.middle.x + axle.aside(), geometry.axis.middle.y, axle.travelled() - geometry.along};
      return sums.moment[1] - cross(middle, sums.force)[1];
    }

    /// Work of the wheel's rigid motion against the contact's forces, for each metre rolled [N]: minus
    /// (F v + M w) / V, with the force F on the wheel, its moment M about the axle's centre, the axle's
    /// velocity v along and across the track, and its turning w. Over a point of the contact it is force
    /// times creepages and moment times spin, with the moment of rolling resistance in it. The vertical
    /// motion of the axle is no creepage.
    double
    creepage_work(const ContactSums &sums, const Axle &axle)
    {
      const double  V      = axle.velocity();
      const Vector3 moment = sums.moment - cross(axle.centre(), sums.force), axis = axle.axis();
      double        turning = 0;
      for (int d = 0; d < 3; ++d)
        turning += moment[d] * axis[d];
      return -(sums.force[2] + axle.data().lateral_creepage * sums.force[0] +
               turning * axle.pitch_rate() / V);
    }
  } // namespace


  Recorder::Recorder(const Model &model)
    : model_(model)
  {
  }


  void
  Recorder::add(const Rolling &rolling, const Axle &axle, MPI_Comm communicator)
  {
    const ContactSums   &c = rolling.contact_sums();
    const EnergyBalance &e = rolling.energy();
    const Point2         t = model_.geometry.frame.tangent(), n = model_.geometry.frame.normal();
    Row                  row(state_.history);
    row.put("time", "s", rolling.time());
    row.put("rolled_distance", axle.travelled());
    row.put("normal_force", c.force[0] * n.x + c.force[1] * n.y);
    row.put("vertical_force", c.force[1]);
    row.put("longitudinal_force", c.force[2]);
    row.put("lateral_force", c.force[0]);
    row.put("tangential_lateral_force", "N", c.force[0] * t.x + c.force[1] * t.y);
    row.put("yaw_moment", "N m", yaw_moment(c, model_.geometry, axle));
    row.put("creepage_work", creepage_work(c, axle));
    row.put("axle_lateral_force", "N", axle.reaction()[0]);
    row.put("axle_vertical_force", "N", axle.reaction()[1]);
    row.put("max_pressure", c.largest_pressure);
    const GuidedPath *const path   = axle.data().path.get();
    const double            rolled = axle.travelled(), V = axle.velocity(),
                 radius = path ? path->forward_radius.at(rolled) : model_.geometry.forward_radius;
    row.put("creepage", (axle.pitch_rate() * radius - V) / V);
    row.put("pitch_rate", "rad/s", axle.pitch_rate());
    row.put("drive_torque", "N m", axle.applied_torque());
    row.put("axle_height", "m", axle.height());
    if (irregular())
      {
        const RunningSurfaces &surfaces = model_.contact->surfaces();
        const double           on_rail  = axle.contact_along(),
                     on_wheel           = axle.contact_on_wheel(surfaces.rolling_radius);
        row.put("axle_acceleration", "m/s2", axle.acceleration());
        row.put("max_von_mises", largest_von_mises(model_.solid, communicator));
        if (const double strain = largest_plastic_strain(model_.solid, communicator); std::isfinite(strain))
          row.put("max_plastic_strain", strain);
        row.put("rail_velocity", "m/s", model_.contact->mean_velocity(Body::rail)[1]);
        row.put("rail_irregularity", "m", surfaces.rail.at(0, on_rail).n - surfaces.rail.smooth(0).n);
        row.put("wheel_irregularity", "m", surfaces.wheel.smooth(0).n - surfaces.wheel.at(0, on_wheel).n);
        if (surfaces.rail.has_second_rail())
          {
            const double second = model_.contact->force_of_second_rail()[1];
            row.put("first_rail_force", "N", c.force[1] - second);
            row.put("second_rail_force", "N", second);
          }
      }
    if (path)
      {
        row.put("lateral_shift", "m", path->lateral_shift.at(rolled));
        row.put("wheelset_roll", "rad", path->roll.at(rolled));
        row.put("yaw", "rad", path->yaw.at(rolled));
        row.put("velocity", "m/s", V);
        row.put("wheel_load", "N", path->load.at(rolled));
      }
    for (const auto &part : model_.parts)
      for (const PartMeasure &measure : part->measures())
        row.put(measure.name, measure.unit, measure.value);
    for (const EnergyTerm &term : e.terms())
      row.put(term.name, "J", term.value);
    row.put("energy_residual", "J", e.residual());
    row.put("energy_error", e.error());
  }


  bool
  Recorder::irregular() const
  {
    return model_.contact->surfaces().irregular();
  }


  void
  Recorder::add_patch(const PatchFields &patch, const WearProfile &wear)
  {
    const PatchMeasures m = measure_patch(patch);
    Row                 row(state_.patches);
    row.put("rolled_distance", patch.rolled_distance);
    row.put("max_pressure", m.peak_pressure);
    row.put("max_pressure_fitted", m.peak_pressure_fitted);
    row.put("contact_area", m.area);
    row.put("patch_lateral", m.width);
    row.put("patch_longitudinal", m.length);
    row.put("patch_centre_lateral", m.centre_lateral);
    row.put("patch_centre_longitudinal", m.centre_along + model_.geometry.ahead);
    row.put("max_shear_traction", m.max_traction);
    row.put("stick_fraction", m.stick_fraction);
    row.put("t_gamma", m.t_gamma);
    row.put("patches", m.n_patches);
    row.put("cells_across_peak", m.cells_across);
    row.put("peak_between_nodes", m.between_nodes);
    Row across(state_.wear);
    across.put("rolled_distance", patch.rolled_distance);
    const Lattice strip  = rows_of_strip(model_);
    const long    before = std::lround((wear.lateral.front() - strip.s_begin) / strip.spacing_lateral);
    for (long j = 0; j < static_cast<long>(strip.n_lateral); ++j)
      {
        const bool on_mesh = j >= before && j < before + static_cast<long>(wear.lateral.size());
        across.put("archard_depth_" + std::to_string(j), "m", on_mesh ? wear.depth[j - before] : 0);
        across.put("friction_work_" + std::to_string(j), "N/m", on_mesh ? wear.work[j - before] : 0);
      }
  }


  WearProfile
  Recorder::wear(const Scene &scene) const
  {
    WearProfile   profile;
    const Lattice lattice = rows_of_strip(model_);
    if (state_.wear.columns.size() != 1 + 2 * std::size_t(lattice.n_lateral))
      return profile;
    const Range stretch = averaging_stretch(scene);
    const auto  mean    = [&](const std::size_t c) {
      return mean_over(state_.wear.columns[0], state_.wear.columns[c], stretch).mean;
    };
    for (unsigned int j = 0; j < lattice.n_lateral; ++j)
      {
        profile.lateral.push_back(lattice.s_begin + j * lattice.spacing_lateral);
        profile.depth.push_back(mean(1 + 2 * j));
        profile.work.push_back(mean(2 + 2 * j));
      }
    return profile;
  }


  SteadyBasis
  Recorder::basis(const Scene &scene) const
  {
    SteadyBasis basis;
    basis.cell           = model_.contact->lattice().spacing_along;
    basis.friction       = scene.friction.at(0);
    basis.shear_modulus  = elasticity(scene.rail_material).shear_modulus();
    basis.radius         = model_.geometry.rolling_radius;
    basis.slowest        = slow_length(scene.velocity);
    basis.standard_error = scene.standard_error;
    basis.earliest       = model_.axle.torque_ramp;
    if (scene.motion == "none")
      basis.load = model_.wheel_load;
    if (!model_.axle.rate_held && scene.motion == "none" && !state_.patches.columns.empty())
      basis.torque_force = model_.axle.torque / model_.contact->surfaces().local_radius(
                                                  column(state_.patches, "patch_centre_lateral").back());
    return basis;
  }


  Steadiness
  Recorder::steadiness(const Scene &scene) const
  {
    return judge_steadiness(state_.history, state_.patches, basis(scene));
  }


  Range
  Recorder::averaging_stretch(const Scene &scene) const
  {
    const double rolled =
                   state_.history.columns.empty() ? 0 : column(state_.history, "rolled_distance").back(),
                 length = scene.averaging_distance;
    if (scene.until_steady())
      if (const Steadiness known = steadiness(scene); known.steady())
        return known.stretch;
    double middle = scene.evaluate_at;
    if (middle == Scene::at_largest_force && rolled > 0)
      middle = std::max(place_of_largest_force(state_.history), 0.5 * length);
    if (const double end = middle + 0.5 * length; middle > 0 && rolled >= end * (1 - 1e-9))
      return {end - length, end};
    return {rolled - length, rolled};
  }


  void
  Recorder::fill(Summary &summary, const Scene &scene) const
  {
    if (state_.history.columns.empty())
      return;
    const Steadiness known =
      known_results(state_.history, state_.patches, basis(scene), averaging_stretch(scene));
    for (const KnownResult &result : known.results)
      {
        const Figure &figure = figure_named(result.figure);
        set_figure(summary, figure.key(), result.mean.mean);
        set_figure(summary, figure.key("_std"), result.mean.deviation);
        if (!irregular()) // else nothing is steady that a mean could belong to
          set_figure(summary, figure.key("_error"), result.error());
      }
    const auto mean = [&](const char *name) {
      return mean_over(column(state_.history, "rolled_distance"), column(state_.history, name), known.stretch)
        .mean;
    };
    set_figure(summary, "creepage_work_N", mean("creepage_work"));
    set_figure(summary, "energy_error", column(state_.history, "energy_error").back());
    set_figure(summary, "means_from_m", std::max(0., known.stretch.s0));
    set_figure(summary, "means_to_m", known.stretch.s1);
    fill_grid(summary, known.stretch);
    fill_settling(summary, known);
    if (irregular())
      {
        add_impact_figures(state_.history, model_.wheel_load, summary);
        summary.max_von_mises = mean("max_von_mises");
      }
    add_track_figures(state_.history, known.stretch, summary);
  }


  void
  Recorder::fill_grid(Summary &summary, const Range &stretch) const
  {
    if (state_.patches.columns.empty())
      return;
    const std::vector<double> &along = column(state_.patches, "rolled_distance");
    std::size_t                last  = along.size() - 1;
    while (last > 0 && along[last] > stretch.s1)
      --last;
    const double patches = column(state_.patches, "patches")[last];
    if (!(patches > 0))
      return;
    set_figure(summary, "patches", patches);
    for (const char *const key : {"cells_across_peak", "peak_between_nodes"})
      set_figure(summary, key, column(state_.patches, key)[last]);
  }


  void
  Recorder::fill_settling(Summary &summary, const Steadiness &known) const
  {
    // where a force, traction or creepage is hardly there, 5 % of what presses or a creepage of 1e-3 counts
    // in place of its mean
    const auto least = [&](const std::string &figure) {
      return figure == "longitudinal_force"   ? 0.05 * summary.normal_force
             : figure == "max_shear_traction" ? 0.05 * summary.max_pressure
             : figure == "creepage"           ? 1e-3
                                              : 1e-300;
    };
    // two cells take out what repeats from cell to cell
    const double window = std::max(2e-3, 2 * model_.contact->lattice().spacing_along);
    Settling     worst;
    for (const KnownResult &result : known.results)
      {
        if (!result.settles)
          continue;
        const History &table = result.of_patch ? state_.patches : state_.history;
        const double   scale = std::max(std::abs(result.mean.mean), least(result.figure));
        const Settling found = settling(
          column(table, "rolled_distance"), column(table, result.figure), known.stretch, scale, window);
        worst.after = std::max(worst.after, found.after);
        if (!(found.swing <= worst.swing))
          {
            worst.swing              = found.swing;
            summary.largest_swing_of = figure_named(result.figure).label;
          }
        if (found.drift > worst.drift)
          {
            worst.drift              = found.drift;
            summary.largest_drift_of = figure_named(result.figure).label;
          }
      }
    set_figure(summary, "settled_after_m", worst.after);
    set_figure(summary, "largest_swing", worst.swing);
    set_figure(summary, "largest_drift", worst.drift);
  }
} // namespace wheelrail
