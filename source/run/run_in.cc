#include <wheelrail/model/scene_material.h>
#include <wheelrail/run/run_in.h>
#include <wheelrail/sampling/creep_scale.h>
#include <wheelrail/sampling/settling.h>

#include <algorithm>
#include <string>

namespace wheelrail
{
  namespace
  {
    /// Part of the patch's length over which forces are averaged.
    constexpr double averaged = 0.25;

    /// Mean of a column over the stretch before a place.
    double
    mean_before(const History &table, const std::string &name, const double place, const double length)
    {
      return mean_over(
               column(table, "rolled_distance"), column(table, name), {place - averaged * length, place})
        .mean;
    }

    /// Of the slope of the theory: patches of a wheel on a rail, which are no ellipses, deflect more
    /// (measured in the main scene).
    constexpr double of_theory = 0.75;

    /// What is still to come of the change of the force after a change of the creepage, when the patch has
    /// rolled on by a share of its length: tractions grow from the leading edge.
    double
    left_after(const double share)
    {
      return share < 1 ? (1 - share) * (1 - share) : 0;
    }

    /// The change of the creepage at a place that brings the force to what the torque asks for; `earlier`:
    /// the change that was made half a length before.
    double
    change_of_creepage(const RunState &run, const double length, const double place, const double earlier)
    {
      const History &history = run.recorder.state().history, &patches = run.recorder.state().patches;
      const auto     mean = [&](const History &table, const char *name) {
        return mean_before(table, name, place, length);
      };
      const double force  = mean(history, "longitudinal_force");
      const double wanted = run.axle.data().torque /
                            run.model.contact->surfaces().local_radius(mean(patches, "patch_centre_lateral"));
      const CreepScale creep = creep_scale(run.scene.friction.at(0) * mean(history, "normal_force"),
                                           elasticity(run.scene.rail_material).shear_modulus(),
                                           mean(patches, "patch_longitudinal"),
                                           mean(patches, "patch_lateral"));
      const double     slope = of_theory * creep.stiffness * std::max(0.1, creep.tangent(wanted));
      const double     still = slope * earlier * left_after(0.5 - 0.5 * averaged);
      const double     most  = 0.1 * creep.half_saturation() + 1e-4;
      return std::clamp((wanted - force - still) / slope, -most, most);
    }
  } // namespace


  void
  run_in(RunState &run, const double before)
  {
    const AxleData &axle   = run.axle.data();
    const double    length = axle.torque_ramp / 1.5, first = 0.5 * length;
    const auto passed = [&](const double place) { return before < place && run.axle.travelled() >= place; };
    if (axle.torque_ramp == 0 || !(passed(first) || passed(length)))
      return;
    double change = change_of_creepage(run, length, first, 0);
    if (passed(length))
      change = change_of_creepage(run, length, length, change);
    MPI_Bcast(&change, 1, MPI_DOUBLE, 0, run.communicator);
    run.rolling.turn_faster(change * axle.velocity / run.model.geometry.forward_radius);
  }
} // namespace wheelrail
