#include <wheelrail/application/run_start.h>
#include <wheelrail/application/run_texts.h>
#include <wheelrail/dynamics/rolling_velocities.h>
#include <wheelrail/dynamics/static_start.h>

#include <chrono>

namespace wheelrail
{
  RunStart
  start_from_rest(const Scene &scene, Model &model, Log &log, MPI_Comm communicator)
  {
    StaticLoads loads;
    loads.axle                 = model.axle;
    loads.rolling_radius       = model.geometry.rolling_radius;
    loads.traction_coefficient = scene.traction_coefficient;
    loads.rate_held            = scene.drive == Drive::rate;
    loads.creepage             = scene.creepage;
    loads.first_approach       = model.expected_approach;
    const auto without         = [&](const StartState part) {
      return scene.start == part || scene.start == StartState::normal_load;
    };
    loads.tractions = !without(StartState::without_tractions);

    const auto         begin  = std::chrono::steady_clock::now();
    const StaticResult result = static_start(
      *model.forest, model.solid, *model.contact, loads, [&](const std::string &line) { log.status(line); });
    const bool   at_radius = !loads.rate_held && without(StartState::without_creepage);
    const double creepage  = at_radius ? 0 : result.creepage;
    const double rate      = scene.velocity / loads.rolling_radius * (1 + creepage);
    rolling_velocities(model.solid, model.axle, rate, communicator, !without(StartState::without_velocities));
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    log.value("static start",
              text("%d Newton steps, %d CG steps, %s; axle lowered by %.4f mm, predicted creepage %.5f",
                   result.newton_steps,
                   result.cg_steps,
                   format_duration(taken.count()).c_str(),
                   -1e3 * result.lift,
                   result.creepage));
    return {result.lift, rate};
  }
} // namespace wheelrail
