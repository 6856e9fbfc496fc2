#include <wheelrail/base/errors.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/root.h>
#include <wheelrail/solid/motion.h>
#include <wheelrail/solid/transfer.h>
#include <wheelrail/state/checkpoint_checks.h>
#include <wheelrail/state/rail_state.h>
#include <wheelrail/wheelset/axle.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    const char *const file_name = "/rail.h5";

    std::string
    in_words(const RunSettings &scene)
    {
      return "Run/Rail = " + scene.rail_from + ": ";
    }

    /// Takes over where the fine cells of one body lie, which now is `farther` along, in blocks of the length
    /// `block` [m].
    void
    take_window(const FineWindow &from,
                const Body        body,
                const int         farther,
                const double      block,
                FineWindow       &window)
    {
      window.column[body] = from.column[body] + farther;
      window.start[body]  = from.start[body] + farther;
      window.kept[body]   = from.kept[body];
      for (int &column : window.kept[body])
        column += farther;
      window.path_end[body] = from.path_end[body] + farther * block;
    }

    /// Turns a wheel that was unloaded at the end of its way back to where it began.
    void
    turn_back(const Checkpoint &rail, Model &model, MPI_Comm communicator)
    {
      Axle axle(model.axle, 0, 0, communicator);
      axle.set_state(rail.rolling.parts.at("axle"));
      WheelAxes(axle).to_wheel(model.solid);
    }
  } // namespace


  void
  save_rail(const RunParts &run, const std::string &parameters)
  {
    Checkpoint part        = take_checkpoint(run.model, run.rolling, run.recorder);
    part.parameters        = parameters;
    part.fine_margin       = run.scene.fine_margin;
    const Checkpoint whole = gather_checkpoint(std::move(part), run.communicator);
    on_root(run.communicator, [&]() {
      const std::vector<char> bytes = checkpoint_bytes(whole);
      replace_file(run.scene.folder + file_name, bytes.data(), bytes.size());
    });
  }


  Checkpoint
  read_rail(const Scene &scene, const std::string &parameters, MPI_Comm communicator)
  {
    const std::string path = scene.rail_from + file_name;
    on_root(communicator, [&]() {
      if (!std::filesystem::is_regular_file(path))
        throw InputError(
          in_words(scene) +
          "there is no rail.h5, which runs with a rail that yields leave when they have finished");
    });
    Checkpoint rail;
    on_root(communicator, [&]() {
      try
        {
          rail = checkpoint_from_bytes(read_whole_file(path));
        }
      catch (const RunError &error)
        {
          throw InputError(in_words(scene) + path + " is no whole rail (" + error.what() +
                           "); compute that run again with --overwrite, or name another folder");
        }
    });
    rail                    = share_checkpoint(std::move(rail), communicator);
    const std::string other = other_steel(rail.parameters, parameters);
    if (!other.empty())
      throw InputError(in_words(scene) + "the steel of that rail is another one: " + other);
    return rail;
  }


  void
  lay_rail(const Scene &scene, const Checkpoint &rail, Model &model, MPI_Comm communicator)
  {
    const bool       same_wheel = scene.next_wheel == NextWheel::same;
    FineWindow       start      = model.window;
    double           farther = 0; // along the track than in the earlier run, which may have started elsewhere
    const SweepPlan &plan    = model.discretization->plan();
    if (plan.moving)
      {
        const int blocks = rail.start_block - plan.start_block;
        farther          = blocks * plan.block_length();
        take_window(rail.window, Body::rail, blocks, plan.block_length(), model.window);
        if (same_wheel)
          take_window(rail.window, Body::wheel, 0, plan.block_length(), model.window);
        prepare_mesh(model, communicator);
      }
    const std::optional<Body> rail_alone = same_wheel ? std::optional<Body>() : Body::rail;
    if (!restore_bodies(rail, model.solid, farther, communicator, rail_alone))
      throw InputError(in_words(scene) +
                       "that rail has another mesh; rail profile, track, rolling distance and the cells of "
                       "Mesh must be those of "
                       "its run, and Mesh/Planned load the same in both where loads differ, Mesh/Planned "
                       "strip where lateral "
                       "shifts or wheels differ" +
                       (same_wheel ? "; with Run/Next wheel = same the wheel and its place, too" : ""));
    std::fill(model.solid.velocity.begin(), model.solid.velocity.end(), 0.);
    if (same_wheel)
      turn_back(rail, model, communicator);
    if (plan.moving)
      {
        for (const Body body : both_bodies)
          {
            keep_flowed(scene, model, body, communicator);
            start.kept[body] = model.window.kept[body];
          }
        model.window             = start;
        const SolidChoice choice = model.solid.choice;
        SolidTransfer     transfer(std::move(model.solid), 0, communicator);
        model.solid.choice = choice;
        prepare_mesh(model, communicator);
        transfer.fill(model.solid, node_inertia(model.solid), 0);
        std::fill(model.solid.velocity.begin(), model.solid.velocity.end(), 0.);
      }
    for (const Body body : both_bodies)
      {
        ElementBlocks &blocks = model.solid.blocks[body];
        std::fill(blocks.plastic_work.begin(), blocks.plastic_work.end(), 0.);
        std::fill(blocks.viscous.begin(), blocks.viscous.end(), 0.);
      }
  }
} // namespace wheelrail
