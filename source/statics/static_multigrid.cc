#include <wheelrail/mesh/discretization.h>
#include <wheelrail/statics/static_multigrid.h>

#include <algorithm>
#include <array>

// Geometric multigrid on the levels of the octree, global coarsening (doc/theory/rolling.md, Static start,
// 3): coarse elements are computed anew on their own vertices.

namespace wheelrail
{
  namespace
  {
    /// A coarse node is held when the finer one at its place is.
    std::vector<unsigned char>
    coarse_held(const CoarseLevel &coarse, const std::vector<unsigned char> &held)
    {
      // only a node with one parent coincides with it: one in the middle of a line or face does not hold the
      // coarse nodes around it, which would stiffen what is free
      AlignedVector<double> mark(4 * coarse.mesh.n_nodes(), 0.);
      for (std::size_t n = 0; n < held.size(); ++n)
        if (held[n] && coarse.begin[n + 1] == coarse.begin[n] + 1)
          // a node of one parent lies on it
          mark[4 * coarse.nodes[coarse.begin[n]]] = 1;
      sum_over_ranks(coarse.mesh, mark.data());
      std::vector<unsigned char> result(coarse.mesh.n_nodes());
      for (std::size_t n = 0; n < result.size(); ++n)
        result[n] = mark[4 * n] > 0;
      return result;
    }

    PerBody<ElementBlocks>
    coarse_blocks(const LocalMesh &mesh, const PerBody<ElementBlocks> &finest)
    {
      PerBody<std::vector<ElementGeometry>> geometry;
      // Coarse elements are those of the octree one level up, on their own vertices, not P' K P: no matrix is
      // stored. Their sides are chords of curved surfaces, so that a coarse body differs a little from the
      // fine one.
      PerBody<std::vector<std::array<unsigned int, 8>>> cells;
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        {
          std::array<Vector3, 8> X;
          for (int a = 0; a < 8; ++a)
            for (int i = 0; i < 3; ++i)
              X[a][i] = mesh.reference[4 * mesh.cells[c][a] + i];
          const Body body = mesh.cell_body[c];
          // elastic elements of the coarse cells, of the same form
          geometry[body].push_back(element_geometry(X));
          cells[body].push_back(mesh.cells[c]);
        }
      PerBody<ElementBlocks> blocks;
      for (const Body body : both_bodies)
        blocks[body] = pack_elements(geometry[body],
                                     cells[body],
                                     ElasticLaw(finest[body].elasticity()),
                                     finest[body].width,
                                     finest[body].form);
      return blocks;
    }

    /// Forces of the finer nodes, handed to the coarse ones.
    void
    restrict_forces(const CoarseLevel &coarse, const LocalMesh &finer, const double *from, NodeVector &to)
    {
      to = 0;
      for (std::size_t n = 0; n < finer.n_owned; ++n)
        for (unsigned int p = coarse.begin[n]; p < coarse.begin[n + 1]; ++p)
          for (int i = 0; i < 3; ++i)
            // f_coarse = P' f, P trilinear interpolation
            to.begin()[4 * coarse.nodes[p] + i] += coarse.weights[p] * from[4 * n + i];
      // coarse nodes may hang too
      condense(coarse.mesh, to.begin());
      to.compress(dealii::VectorOperation::add);
    }

    /// The springs of nodes as a coarser level has them: handed on as forces are, which is the sum of the
    /// rows of what the trial functions there make of them.
    AlignedVector<double>
    coarse_springs(const CoarseLevel &coarse, const LocalMesh &finer, const AlignedVector<double> &springs)
    {
      // lumped: springs of a translation stay what they are in sum, P' k P would join nodes
      NodeVector to = node_vector(coarse.mesh);
      restrict_forces(coarse, finer, springs.data(), to);
      to.update_ghost_values();
      return {to.begin(), to.begin() + 4 * coarse.mesh.n_nodes()};
    }

    void
    interpolate(const CoarseLevel &coarse, const LocalMesh &finer, NodeVector &from, NodeVector &to)
    {
      from.update_ghost_values();
      distribute(coarse.mesh, from.begin());
      for (std::size_t n = 0; n < finer.n_owned; ++n)
        for (int i = 0; i < 3; ++i)
          {
            // P is trilinear within a coarse cell; nodes that hang on the fine level are interpolated
            // afterwards
            double value = 0;
            for (unsigned int p = coarse.begin[n]; p < coarse.begin[n + 1]; ++p)
              // u = P u_coarse
              value += coarse.weights[p] * from.begin()[4 * coarse.nodes[p] + i];
            to.begin()[4 * n + i] = value;
          }
    }
    void
    hold(const std::vector<unsigned char> &held, const LocalMesh &mesh, NodeVector &x)
    {
      for (std::size_t n = 0; n < mesh.n_owned; ++n)
        if (held[n])
          std::fill_n(x.begin() + 4 * n, 3, 0.);
    }
  } // namespace


  StaticMultigrid::StaticMultigrid(const Discretization             &discretization,
                                   Solid                            &solid,
                                   const std::vector<unsigned char> &held,
                                   const StaticGround               &ground)
    : communicator_(discretization.communicator())
    , coarse_(coarse_levels(discretization, solid.mesh))
  {
    // 1. The finest level has the solid's own elements; 2. each coarser one new elastic ones, with ground and
    // held nodes handed down; 3. the coarsest has the coarse solver in place of a smoother
    held_.push_back(held);
    blocks_.reserve(coarse_.size());
    PerBody<ElementBlocks> *blocks = &solid.blocks;
    const LocalMesh        *mesh   = &solid.mesh;
    StaticGround            here   = ground;
    levels_.push_back(std::make_unique<StaticLevel>(*mesh, *blocks, held_.back(), here, communicator_));
    for (const CoarseLevel &coarse : coarse_)
      {
        if (&coarse != &coarse_.front())
          levels_.push_back(std::make_unique<StaticLevel>(*mesh, *blocks, held_.back(), here, communicator_));
        held_.push_back(coarse_held(coarse, held_.back()));
        if (!here.springs.empty())
          here.springs = coarse_springs(coarse, *mesh, here.springs);
        if (here.joined.size() > 0)
          here.joined = here.joined.coarsened(coarse, held_.back());
        blocks_.push_back(coarse_blocks(coarse.mesh, solid.blocks));
        blocks = &blocks_.back();
        mesh   = &coarse.mesh;
      }
    coarse_solver_ = make_coarse_solver(discretization, *mesh, *blocks, held_.back(), here);
  }


  void
  StaticMultigrid::set_springs(const std::vector<Contact::Spring> &springs)
  {
    // contact springs go down as B P, exactly (Galerkin): without them coarse corrections would not know that
    // the bodies touch
    StaticSprings here(springs, levels_.front()->mesh(), held_.front(), communicator_);
    for (std::size_t k = 0; k < coarse_.size(); ++k)
      {
        StaticSprings next = here.coarsened(coarse_[k], held_[k + 1]);
        levels_[k]->set_springs(std::move(here));
        here = std::move(next);
      }
    coarse_solver_->set_springs(here);
  }


  void
  StaticMultigrid::cycle(const NodeVector &forces, NodeVector &z)
  {
    NodeVector residual = forces;
    z                   = 0;
    cycle(0, residual, z);
  }


  void
  StaticMultigrid::cycle(const std::size_t k, NodeVector &residual, NodeVector &x)
  {
    // exact, or by rough conjugate gradients (make_coarse_solver())
    if (k == coarse_.size())
      {
        coarse_solver_->solve(residual, x);
        return;
      }
    // K x = f on each level: x has been improved, `residual` = f - K x follows it
    StaticLevel &level = *levels_[k];
    // V cycle: 1. smooth; 2. residual to the coarser level and its correction; 3. back; 4. smooth. The
    // smoother is symmetric in D, and so is the cycle.
    level.smooth(x, residual, true);
    NodeVector coarse_residual = node_vector(coarse_[k].mesh), correction = coarse_residual;
    restrict_forces(coarse_[k], level.mesh(), residual.begin(), coarse_residual);
    hold(held_[k + 1], coarse_[k].mesh, coarse_residual);
    cycle(k + 1, coarse_residual, correction);
    NodeVector step = level.zero();
    interpolate(coarse_[k], level.mesh(), correction, step);
    // a node that is held here may interpolate from free ones
    hold(held_[k], level.mesh(), step);
    // the correction changes the residual by K step; the second smoothing needs it, its own last residual
    // does not
    x.add(1, step);
    level.subtract_product(step, residual);
    level.smooth(x, residual, false);
  }


  double
  StaticMultigrid::passes() const
  {
    double cells = 0, finest = 0;
    for (const auto &level : levels_)
      {
        // work in products with the finest stiffness
        cells += double(level->products) * level->mesh().cells.size();
        if (&level == &levels_.front())
          finest = level->mesh().cells.size();
      }
    return cells / finest;
  }
} // namespace wheelrail
