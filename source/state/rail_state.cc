#include <wheelrail/base/errors.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/root.h>
#include <wheelrail/solid/motion.h>
#include <wheelrail/solid/transfer.h>
#include <wheelrail/state/checkpoint_checks.h>
#include <wheelrail/state/rail_state.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    const char *const file_name = "/rail.h5";

    std::string
    in_words(const Scene &scene)
    {
      return "Run/Rail = " + scene.rail_from + ": ";
    }
  } // namespace


  void
  save_rail(const Checkpoint &part, const std::string &folder, MPI_Comm communicator)
  {
    const Checkpoint whole = gather_checkpoint(part, communicator);
    on_root(communicator, [&]() {
      const std::vector<char> bytes = checkpoint_bytes(whole);
      replace_file(folder + file_name, bytes.data(), bytes.size());
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
    Checkpoint        rail  = checkpoint_from_bytes(read_whole_file(path));
    const std::string other = other_steel(rail.parameters, parameters);
    if (!other.empty())
      throw InputError(in_words(scene) + "the steel of that rail is another one: " + other);
    return rail;
  }


  void
  lay_rail(const Scene &scene, const Checkpoint &rail, Model &model, MPI_Comm communicator)
  {
    FineWindow start = model.window;
    if (model.swept)
      {
        model.window = rail.window;
        prepare_window_forest(model, communicator);
      }
    if (!restore_bodies(rail, model.solid, communicator))
      throw InputError(
        in_words(scene) +
        "that rail has another mesh; profiles, track, lateral shift and the cells of Mesh must be "
        "those of its run, and Mesh/Planned load the same in both where loads differ");
    std::fill(model.solid.velocity.begin(), model.solid.velocity.end(), 0.);
    if (model.swept)
      {
        keep_flowed_rail(scene, model, communicator);
        start.kept.rail            = model.window.kept.rail;
        model.window               = start;
        const SolidChoice   choice = model.solid.choice;
        const SolidTransfer transfer(std::move(model.solid), 0, communicator);
        model.solid.choice = choice;
        prepare_window_forest(model, communicator);
        transfer.fill(model.solid, node_inertia(model.solid), 0);
        std::fill(model.solid.velocity.begin(), model.solid.velocity.end(), 0.);
      }
    for (std::size_t n = 0; n < model.solid.mesh.n_nodes(); ++n)
      if (model.solid.mesh.node_body[n] == Body::wheel)
        std::fill_n(&model.solid.displacement[4 * n], 4, 0.);
    forget_flow(model.solid.blocks.wheel);
    std::fill(model.solid.blocks.rail.plastic_work.begin(), model.solid.blocks.rail.plastic_work.end(), 0.);
    for (const Body body : both_bodies)
      std::fill(model.solid.blocks[body].viscous.begin(), model.solid.blocks[body].viscous.end(), 0.);
  }
} // namespace wheelrail
