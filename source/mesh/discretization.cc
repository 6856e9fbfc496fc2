#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include <wheelrail/mesh/discretization.h>

#include <p8est_extended.h>

#include <algorithm>
#include <set>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// A cell of p4est in the block that is its tree.
    CellPlace
    place_in(CellPlace block, const p8est_quadrant_t &q)
    {
      const int shift = P8EST_MAXLEVEL - q.level;
      block.level     = static_cast<unsigned char>(q.level);
      block.i         = static_cast<unsigned short>(q.x >> shift);
      block.j         = static_cast<unsigned short>(q.y >> shift);
      block.k         = (block.k << q.level) + (q.z >> shift);
      return block;
    }

    /// What p4est's recursion asks.
    struct Asked
    {
      const RefinementRule         &rule;
      const std::vector<CellPlace> &blocks; ///< of each of p4est's trees
      PerBody<int>                  work;   ///< of a cell
      std::unique_ptr<CellTree>     tree{};
    };

    int
    parts_of(p8est_t *forest, const p4est_topidx_t tree, p8est_quadrant_t *)
    {
      const auto *asked = static_cast<const Asked *>(forest->user_pointer);
      return asked->rule.n_parts(asked->blocks[tree]);
    }

    int
    is_divided(p8est_t *forest, const p4est_topidx_t tree, p8est_quadrant_t *q)
    {
      const auto *asked = static_cast<const Asked *>(forest->user_pointer);
      return asked->tree->divided(place_in(asked->blocks[tree], *q));
    }

    int
    work_of(p8est_t *forest, const p4est_topidx_t tree, p8est_quadrant_t *)
    {
      const auto *asked = static_cast<const Asked *>(forest->user_pointer);
      return asked->work[asked->blocks[tree].body];
    }
  } // namespace


  Discretization::Discretization(MPI_Comm communicator, SweepPlan plan, const std::vector<Body> &bodies)
    : plan_(std::move(plan))
    , grids_{SweptGrid(plan_, Body::rail), SweptGrid(plan_, Body::wheel)}
    , communicator_(communicator)
    , triangulation_(std::make_unique<Triangulation>(communicator))
    , dofs_(std::make_unique<Dofs>())
    , hanging_(std::make_unique<Constraints>())
    , bodies_(bodies)
  {
    create_blocks();
  }


  Discretization::~Discretization() = default;


  void
  Discretization::create_blocks()
  {
    std::vector<CellPlace>           blocks;
    std::vector<dealii::CellData<3>> cells;
    std::vector<dealii::Point<3>>    vertices;
    for (const Body body : bodies_)
      {
        const SweptGrid &grid  = grids_[body];
        const int        first = static_cast<int>(vertices.size());
        CellPlace        block;
        block.body = body;
        vertices.resize(first + grid.n_sections() * grid.n_corners());
        for (block.k = 0; block.k < grid.n_columns(); ++block.k)
          for (block.block = 0; block.block < grid.n_blocks(); ++block.block)
            {
              dealii::CellData<3> cell;
              const auto          X = grid.coarse_vertices(block.block, block.k);
              for (unsigned int v = 0; v < 8; ++v)
                {
                  const int section = (block.k + static_cast<int>(v / 4)) % grid.n_sections();
                  cell.vertices[v]  = first + section * grid.n_corners() + grid.corners(block.block)[v % 4];
                  vertices[cell.vertices[v]] = {X[v][0], X[v][1], X[v][2]};
                }
              cell.material_id = static_cast<dealii::types::material_id>(body);
              cells.push_back(cell);
              blocks.push_back(block);
            }
      }
    triangulation_->create_triangulation(vertices, cells, dealii::SubCellData());
    blocks_.clear();
    for (const auto cell : triangulation_->get_p4est_tree_to_coarse_cell_permutation())
      blocks_.push_back(blocks[cell]);
  }


  void
  Discretization::lay(const PerBody<FineZone> &zones, const PerBody<int> &work)
  {
#ifdef DEBUG
    // load() takes a triangulation that is divided, too, but deal.II 9.4 asserts that it is not; the mesh
    // that it makes is the same
    if (triangulation_->n_global_levels() > 1)
      {
        dofs_->clear();
        triangulation_->clear();
        create_blocks();
      }
#endif
    const RefinementRule rule(plan_, grids_, zones);
    Asked                asked{rule, blocks_, work};
    auto *const connectivity = const_cast<p8est_connectivity_t *>(triangulation_->get_p4est()->connectivity);
    std::unique_ptr<p8est_t, void (*)(p8est_t *)> forest(
      p8est_new_ext(triangulation_->get_communicator(), connectivity, 0, 0, 1, 0, nullptr, &asked),
      p8est_destroy);
    // each rank divides blocks that become about as many cells
    p8est_partition(forest.get(), 0, parts_of);
    PerBody<std::set<int>> columns;
    for (p4est_topidx_t tree = forest->first_local_tree; tree <= forest->last_local_tree; ++tree)
      columns[blocks_[tree].body].insert(blocks_[tree].k);
    asked.tree = std::make_unique<CellTree>(rule, grids_, columns);
    p8est_refine_ext(forest.get(), 1, static_cast<int>(plan_.levels), is_divided, nullptr, nullptr);
    p8est_partition(forest.get(), 0, work.rail == work.wheel ? nullptr : work_of);
    triangulation_->load(forest.get());
    find_own_cells();
    number_unknowns();
  }


  void
  Discretization::find_own_cells()
  {
    own_cells_.clear();
    const auto add =
      [&](const auto &self, const Triangulation::cell_iterator &cell, const CellPlace &place) -> void {
      if (cell->has_children())
        for (unsigned int c = 0; c < 8; ++c)
          self(self, cell->child(c), place.child(c));
      else if (cell->is_locally_owned())
        own_cells_.push_back({cell->level(), cell->index(), place});
    };
    const p8est_t *const forest = triangulation_->get_p4est();
    for (p4est_topidx_t tree = forest->first_local_tree; tree <= forest->last_local_tree; ++tree)
      add(add,
          Triangulation::cell_iterator(
            triangulation_.get(),
            0,
            static_cast<int>(triangulation_->get_p4est_tree_to_coarse_cell_permutation()[tree])),
          blocks_[tree]);
  }


  CellPlace
  Discretization::place(const dealii::CellAccessor<3> &cell) const
  {
    const dealii::CellId id    = cell.id();
    CellPlace            place = blocks_[id.get_coarse_cell_id()]; // which is the number of the tree
    for (const auto child : id.get_child_indices())
      place = place.child(child);
    return place;
  }


  /// In the order in which own cells use them: deal.II's own depends on what was laid before.
  void
  Discretization::number_unknowns()
  {
    dofs_->reinit(*triangulation_);
    dofs_->distribute_dofs(dealii::FE_Q<3>(1));
    const dealii::IndexSet                      &own = dofs_->locally_owned_dofs();
    std::vector<dealii::types::global_dof_index> numbers(own.n_elements(),
                                                         dealii::numbers::invalid_dof_index);
    auto                                         next = own.n_elements() > 0 ? own.nth_index_in_set(0) : 0;
    for (const Cell &cell : own_cells_)
      {
        const Dofs::cell_iterator here(triangulation_.get(), cell.level, cell.index, dofs_.get());
        for (unsigned int v = 0; v < 8; ++v)
          if (const auto dof = here->vertex_dof_index(v, 0); own.is_element(dof))
            if (auto &number = numbers[own.index_within_set(dof)];
                number == dealii::numbers::invalid_dof_index)
              number = next++;
      }
    dofs_->renumber_dofs(numbers);
    dealii::IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(*dofs_, relevant);
    hanging_->reinit(relevant);
    dealii::DoFTools::make_hanging_node_constraints(*dofs_, *hanging_);
    hanging_->close();
  }
} // namespace wheelrail
