#include <deal.II/base/mpi.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/bodies/start_bodies.h>
#include <wheelrail/dynamics/rolling_velocities.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/output/root.h>
#include <wheelrail/run/run_start.h>
#include <wheelrail/run/run_texts.h>
#include <wheelrail/state/rail_state.h>

#include <chrono>
#include <exception>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// Whether the scene starts without this part of steady rolling.
    bool
    without(const RunSettings &scene, const StartState part)
    {
      return scene.start == part || scene.start == StartState::normal_load;
    }

    bool
    same_cells(const Model &one, const Model &other)
    {
      const MeshQuality &a = one.solid.quality, &b = other.solid.quality;
      return a.elements == b.elements && a.finest_elements == b.finest_elements;
    }
  } // namespace


  std::vector<std::string>
  check_on_machine(const Scene &scene, const SceneGeometry &geometry, MPI_Comm communicator)
  {
    MPI_Comm node;
    int      ranks = 1;
    MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
    MPI_Comm_size(node, &ranks);
    MPI_Comm_free(&node);
    Findings found;
    on_root(communicator, [&]() {
      found = check_scene(scene, geometry, this_machine(ranks));
      if (!found.errors.empty())
        throw InputError(found.errors.front());
    });
    return found.warnings;
  }


  StaticLoads
  static_loads(const Scene &scene, const Model &model)
  {
    StaticLoads loads;
    loads.axle                 = model.axle;
    loads.forward_radius       = model.geometry.forward_radius;
    loads.yaw                  = model.geometry.yaw;
    loads.traction_coefficient = scene.traction_coefficient;
    loads.rate_held            = scene.drive == Drive::rate;
    loads.creepage             = scene.creepage;
    loads.tractions            = !without(scene, StartState::without_tractions);
    loads.first_approach       = model.expected_approach;
    return loads;
  }


  RunStart
  start_from_rest(const Scene &scene, Model &model, const BeyondHalfspaces &beyond, Log &log)
  {
    StaticLoads loads                  = static_loads(scene, model);
    loads.beyond                       = beyond;
    const AlignedVector<double> still  = model.solid.displacement; // dents of earlier passages
    const auto                  begin  = std::chrono::steady_clock::now();
    const StaticResult          result = static_start(
      *model.discretization, model.solid, *model.contact, model.parts, loads, [&](const std::string &line) {
        log.status(line);
      });
    const bool   at_radius = !loads.rate_held && without(scene, StartState::without_creepage);
    const double creepage  = at_radius ? 0 : result.creepage;
    const double rate      = scene.velocity / loads.forward_radius * (1 + creepage);
    rolling_velocities(
      model.solid, model.parts, model.axle, rate, still, !without(scene, StartState::without_velocities));
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    const std::string                   flow =
      result.flow_steps == 0 ? "" : text(", %d steps of plastic flow", result.flow_steps);
    log.value("static start",
              text("%d Newton steps, %d CG steps%s, %s; axle lowered by %.4f mm, predicted creepage %.5f",
                   result.newton_steps,
                   result.cg_steps,
                   flow.c_str(),
                   format_duration(taken.count()).c_str(),
                   -1e3 * result.hub_displacement,
                   result.creepage));
    if (!result.converged && !result.at_border)
      log.warning(
        text("the static start ended with %.2g %% of the wheel load out of balance at a node; the first "
             "millimetres of rolling take it up",
             100 * result.residual));
    return {result.hub_displacement, rate, result.at_border};
  }


  RunStart
  start_on_wide_mesh(Scene               &scene,
                     const SceneGeometry &geometry,
                     Model               &model,
                     const Checkpoint    *rail,
                     Log                 &log,
                     MPI_Comm             communicator)
  {
    constexpr double       widest = 24e-3;
    const bool             first  = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
    const BeyondHalfspaces beyond = // the first rank finds the tractions
      first && scene.friction.at(0) > 0 ? bodies_of_start(scene, geometry) : BeyondHalfspaces();
    if (rail != nullptr)
      {
        lay_rail(scene, *rail, model, communicator);
        return start_from_rest(scene, model, beyond, log);
      }
    RunStart           start = start_from_rest(scene, model, beyond, log);
    std::exception_ptr failure; // of the last start
    const auto         as_it_is = [&]() {
      if (failure)
        std::rethrow_exception(failure);
      return start;
    };
    while (start.at_border && 2 * scene.fine_margin <= widest)
      {
        Scene wider = scene;
        Model wide;
        try
          {
            // whole blocks of cells are added, so that a step may add none
            do
              {
                wider.fine_margin *= 2;
                wide = make_model(wider, geometry, communicator);
              }
            while (same_cells(wide, model) && 2 * wider.fine_margin <= widest);
          }
        catch (const InputError &) // no room; the run tells what is wrong with the mesh that there is
          {
            return as_it_is();
          }
        if (same_cells(wide, model))
          return as_it_is();
        model = std::move(wide);
        scene = wider;
        log.warning(
          text("the patch reaches the edge of the fine cells; the mesh is built again with "
               "Mesh/Fine margin = %g mm",
               1e3 * scene.fine_margin));
        log.value("mesh", mesh_text(model.solid.quality));
        try
          {
            failure = nullptr;
            start   = start_from_rest(scene, model, beyond, log);
          }
        catch (const RunError &)
          {
            // a patch that moves to a place beyond the mesh may be stuck before it
            failure         = std::current_exception();
            start.at_border = true;
          }
      }
    return as_it_is();
  }
} // namespace wheelrail
