#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/run/unloaded_rail.h>

#include <chrono>

namespace wheelrail
{
  std::optional<UnloadedBodies>
  take_loads_off(RunState &run, Log &log)
  {
    const PerBody<ElementBlocks> &blocks = run.model.solid.blocks;
    if (!blocks.rail.plastic() && !blocks.wheel.plastic())
      return {};
    const auto begin = std::chrono::steady_clock::now();
    try
      {
        UnloadedBodies bodies = unload(*run.model.discretization, run.model.solid, run.model.parts, run.axle);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        log.value("unloading",
                  text("%u Newton steps, %u CG steps, %s",
                       bodies.steps,
                       bodies.cg_steps,
                       format_duration(taken.count()).c_str()));
        return bodies;
      }
    catch (const RunError &error)
      {
        log.warning(error.what());
        return {};
      }
  }
} // namespace wheelrail
