#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <wheelrail/base/gather_all.h>
#include <wheelrail/mesh/ancestor_vertices.h>
#include <wheelrail/mesh/forest.h>

#include <stdexcept>

namespace wheelrail
{
  namespace
  {
    constexpr std::uint32_t unknown = ~std::uint32_t(0);
  }

  /// A vertex of a cell, the same on all ranks: coarse cell, path of children with a leading one, vertex.
  struct AncestorVertices::Place
  {
    std::uint32_t coarse_cell, path, vertex;

    Place() = default;
    Place(Cell cell, const unsigned int v)
      : path(1)
      , vertex(v)
    {
      for (const auto child : cell->id().get_child_indices())
        path = path * 8 + child;
      while (cell->level() > 0)
        cell = cell->parent();
      coarse_cell = static_cast<std::uint32_t>(cell->index());
    }
  };


  AncestorVertices::AncestorVertices(const Forest &forest, const LocalMesh &finest)
    : triangulation_(forest.dofs().get_triangulation())
    , finest_(finest)
    , local_(triangulation_.n_vertices(), unknown)
    , number_(triangulation_.n_active_cells(), unknown)
    , hangs_(finest.n_nodes(), unknown)
  {
    for (const auto &cell : triangulation_.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const std::size_t c                = active.size();
          number_[cell->active_cell_index()] = c;
          for (unsigned int v = 0; v < 8; ++v)
            local_[cell->vertex_index(v)] = finest.cells[c][v];
          active.push_back(cell);
        }
    for (unsigned int k = 0; k < finest.hanging.size(); ++k)
      hangs_[finest.hanging[k]] = k;
    ask_others(forest.communicator());
  }


  bool
  AncestorVertices::knows(const unsigned int vertex) const
  {
    return local_[vertex] != unknown || told_.count(vertex) != 0;
  }


  AncestorVertices::Node
  AncestorVertices::at(const unsigned int vertex) const
  {
    return local_[vertex] != unknown ? node(local_[vertex]) : told_.at(vertex);
  }


  AncestorVertices::Node
  AncestorVertices::node(const unsigned int number) const
  {
    const auto place = [&](const unsigned int n) -> std::array<double, 3> {
      const double *X = &finest_.reference[4 * n];
      return {X[0], X[1], X[2]};
    };
    Node node;
    node.global    = finest_.global_node[number];
    node.key       = finest_.node_key[number];
    node.reference = place(number);
    node.body      = finest_.node_body[number];
    if (const unsigned int k = hangs_[number]; k != unknown)
      for (unsigned int p = finest_.hanging_begin[k]; p < finest_.hanging_begin[k + 1]; ++p)
        {
          const unsigned int parent         = finest_.parents[p];
          node.parents.at(node.n_parents++) = {
            finest_.global_node[parent], finest_.node_key[parent], finest_.weights[p], place(parent)};
        }
    return node;
  }


  /// Vertices of ancestors that belong to no cell of the rank: whoever has the active cell in that corner
  /// tells.
  void
  AncestorVertices::ask_others(MPI_Comm communicator)
  {
    std::vector<Place>        places;
    std::vector<unsigned int> vertices;
    for (Cell cell : active)
      while (cell->level() > 0)
        {
          cell = cell->parent();
          for (unsigned int v = 0; v < 8; ++v)
            if (local_[cell->vertex_index(v)] == unknown && told_.try_emplace(cell->vertex_index(v)).second)
              {
                vertices.push_back(cell->vertex_index(v));
                places.emplace_back(cell, v);
              }
        }
    const auto rank  = dealii::Utilities::MPI::this_mpi_process(communicator);
    const auto sizes = dealii::Utilities::MPI::all_gather(communicator, places.size());
    struct Answer
    {
      std::size_t question;
      Node        node;
    };
    const auto          questions = gather_all(places, communicator);
    std::vector<Answer> known;
    for (std::size_t q = 0; q < questions.size(); ++q)
      if (const unsigned int number = own_node(questions[q]); number != unknown)
        known.push_back({q, node(number)});
    std::size_t first = 0;
    for (unsigned int r = 0; r < rank; ++r)
      first += sizes[r];
    std::vector<bool> answered(places.size(), false);
    for (const Answer &answer : gather_all(known, communicator))
      if (answer.question >= first && answer.question < first + places.size())
        {
          told_[vertices[answer.question - first]] = answer.node;
          answered[answer.question - first]        = true;
        }
    for (const bool known_somewhere : answered)
      if (!known_somewhere)
        throw std::logic_error("a vertex of a coarse level is known to no rank");
  }


  /// The node at a place if the active cell in that corner is the rank's own.
  unsigned int
  AncestorVertices::own_node(const Place &place) const
  {
    Cell cell(&triangulation_, 0, place.coarse_cell);
    int  bits = 0;
    while (place.path >> (bits + 3) != 0)
      bits += 3;
    for (; bits > 0; bits -= 3)
      {
        if (!cell->has_children())
          return unknown;
        cell = cell->child(place.path >> (bits - 3) & 7);
      }
    while (cell->has_children())
      cell = cell->child(place.vertex);
    const unsigned int c = number_[cell->active_cell_index()];
    return c == unknown ? unknown : finest_.cells[c][place.vertex];
  }
} // namespace wheelrail
