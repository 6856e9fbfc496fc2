#include <wheelrail/base/errors.h>
#include <wheelrail/base/gather_all.h>
#include <wheelrail/state/checkpoint.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace wheelrail
{
  namespace
  {
    // --- one rank's part ---

    /// Values of the rank's nodes that it owns, three each; the arrays of Solid have four numbers a node.
    NumberedValues
    owned_values(const LocalMesh &mesh, const AlignedVector<double> &values)
    {
      NumberedValues owned{3, {}};
      for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
        if (mesh.owns(n))
          owned.values.insert(owned.values.end(), &values[4 * n], &values[4 * n + 3]);
      return owned;
    }

    // --- all ranks ---

    /// Puts the rows of all ranks in the place of a rank's own, in the order of their keys; on rank 0.
    void
    gather_rows(std::vector<std::uint64_t>            &keys,
                std::map<std::string, NumberedValues> &rows,
                MPI_Comm                               communicator)
    {
      const auto               unordered = gather_on_root(keys, communicator);
      std::vector<std::size_t> order(unordered.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
        return unordered[a] < unordered[b];
      });
      keys.clear();
      for (const std::size_t k : order)
        keys.push_back(unordered[k]);
      for (auto &[name, part] : rows)
        {
          const auto all = gather_on_root(part.values, communicator);
          part.values.clear();
          for (const std::size_t k : order)
            part.values.insert(
              part.values.end(), all.begin() + part.components * k, all.begin() + part.components * (k + 1));
        }
    }

    /// What of a sum over ranks this rank goes on with.
    double
    share(const std::vector<double> &of_ranks, MPI_Comm communicator)
    {
      int rank, size;
      MPI_Comm_rank(communicator, &rank);
      MPI_Comm_size(communicator, &size);
      if (of_ranks.size() == std::size_t(size))
        return of_ranks[rank];
      return rank == 0 ? std::accumulate(of_ranks.begin(), of_ranks.end(), 0.) : 0.;
    }
  } // namespace


  Checkpoint
  take_checkpoint(const Model &model, const Rolling &rolling, const Recorder &recorder)
  {
    const LocalMesh &mesh = model.solid.mesh;
    Checkpoint       part;
    part.time_step = model.time_step;
    part.window    = model.window;
    if (model.discretization->plan().moving)
      part.start_block = model.discretization->plan().start_block;
    for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
      if (mesh.owns(n))
        part.node.push_back(mesh.node_key[n]);
    part.cell                        = mesh.cell_key;
    part.node_values["position"]     = owned_values(mesh, mesh.reference);
    part.node_values["displacement"] = owned_values(mesh, model.solid.displacement);
    part.node_values["velocity"]     = owned_values(mesh, model.solid.velocity);
    part.cell_values                 = cell_histories(model.solid);
    model.contact->gather_nodes();
    part.contact  = model.contact->state();
    part.rolling  = rolling.state();
    part.recorder = recorder.state();
    for (const auto &[name, work] : part.rolling.energy.works)
      part.works[name] = {work};
    return part;
  }


  bool
  is_finite(const Checkpoint &part, MPI_Comm communicator)
  {
    int        finite = 1;
    const auto see    = [&](const double value) { finite = finite && std::isfinite(value); };
    for (const auto *all : {&part.node_values, &part.cell_values})
      for (const auto &entry : *all)
        for (const double value : entry.second.values)
          see(value);
    for (const ContactNode &node : part.contact.nodes)
      for (const double value :
           {node.pressure, node.elastic[0], node.elastic[1], node.elastic[2], node.foot.xi, node.foot.eta})
        see(value);
    for (const auto &[name, state] : part.rolling.parts)
      {
        for (const auto &number : state.numbers)
          see(number.second);
        for (const double value : state.values)
          see(value);
      }
    see(part.rolling.energy.error);
    MPI_Allreduce(MPI_IN_PLACE, &finite, 1, MPI_INT, MPI_MIN, communicator);
    return finite == 1;
  }


  Checkpoint
  gather_checkpoint(Checkpoint part, MPI_Comm communicator)
  {
    gather_rows(part.node, part.node_values, communicator);
    gather_rows(part.cell, part.cell_values, communicator);
    for (auto &[name, work] : part.works)
      work = gather_on_root(work, communicator);
    for (auto &[name, state] : part.rolling.parts)
      {
        state.nodes  = gather_on_root(state.nodes, communicator);
        state.values = gather_on_root(state.values, communicator);
      }
    part.ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
    return dealii::Utilities::MPI::this_mpi_process(communicator) == 0 ? std::move(part) : Checkpoint();
  }


  Checkpoint
  share_checkpoint(Checkpoint whole, MPI_Comm communicator)
  {
    namespace mpi    = dealii::Utilities::MPI;
    const bool first = mpi::this_mpi_process(communicator) == 0;
    Checkpoint rows;
    const auto exchange_rows = [&]() {
      std::swap(rows.node, whole.node);
      std::swap(rows.cell, whole.cell);
      std::swap(rows.node_values, whole.node_values);
      std::swap(rows.cell_values, whole.cell_values);
    };
    exchange_rows();
    const auto bytes = mpi::broadcast(communicator, first ? checkpoint_bytes(whole) : std::vector<char>());
    if (!first)
      return checkpoint_from_bytes({bytes.begin(), bytes.end()});
    exchange_rows();
    return whole;
  }


  void
  restore_checkpoint(const Checkpoint &whole,
                     Model            &model,
                     Rolling          &rolling,
                     Recorder         &recorder,
                     MPI_Comm          communicator)
  {
    if (!restore_bodies(whole, model.solid, 0, communicator))
      throw InputError(
        "--resume: the mesh is not that of the saved state, since a profile file or the program has changed: "
        "start anew without --resume");
    model.contact->set_state(whole.contact);
    TimeLoop::State state = whole.rolling;
    for (const auto &[name, of_ranks] : whole.works)
      state.energy.works[name] = share(of_ranks, communicator);
    rolling.set_state(state);
    recorder.set_state(whole.recorder);
  }
} // namespace wheelrail
