#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <wheelrail/solid/exchange.h>
#include <wheelrail/solid/solid.h>
#include <wheelrail/statics/band_cholesky.h>
#include <wheelrail/statics/static_springs.h>

#include <vector>

namespace wheelrail
{
  /// Stiffness of both bodies at rest on one mesh, with springs to the ground and the contact springs of the
  /// moment, as a product with vectors, and a smoother for it.
  ///
  /// The product is the element kernel's own force of a displacement so small that it is linear: no matrix is
  /// stored. The smoother is Chebyshev's polynomial of the fourth kind (Lottes 2023), which asks for the
  /// largest eigenvalue only, over the 3 x 3 diagonal blocks of the nodes; the springs enter these with all
  /// their couplings, by the formula of Sherman, Morrison and Woodbury, so that stiff springs do no harm.
  class StaticLevel
  {
  public:
    /// `blocks`: elements of rail and wheel on this mesh, taken as elastic. `held`: 1 for nodes that do not
    /// move. Both and the mesh must outlive the level. Collective.
    StaticLevel(const LocalMesh                  &mesh,
                PerBody<ElementBlocks>           &blocks,
                const std::vector<unsigned char> &held,
                StaticGround                      ground,
                MPI_Comm                          communicator);

    /// Takes these springs, none at first. Collective.
    void
    set_springs(StaticSprings springs);

    NodeVector
    zero() const
    {
      return node_vector(mesh_);
    }

    /// y = (stiffness + springs) x for x that vanishes at held nodes; zero at held and hanging nodes.
    /// Collective.
    void
    product(const NodeVector &x, NodeVector &y);

    /// The same for the bodies alone.
    void
    elastic_product(const NodeVector &x, NodeVector &y);

    /// residual -= (stiffness + springs) x. Collective.
    void
    subtract_product(const NodeVector &x, NodeVector &residual);

    /// Improves x and brings the residual up to date; the last update, which a caller may not need, is left
    /// out unless asked for. Collective.
    void
    smooth(NodeVector &x, NodeVector &residual, bool last_residual);

    const LocalMesh &
    mesh() const
    {
      return mesh_;
    }
    const std::vector<unsigned char> &
    held() const
    {
      return held_;
    }
    const StaticSprings &
    springs() const
    {
      return springs_;
    }
    unsigned long products = 0; ///< so far

  private:
    void
    make_diagonal();
    void
    make_coupling();
    void
    find_largest_eigenvalue();
    void
    find_elastic_force(const NodeVector &x);
    void
    add_ground(double factor, const NodeVector &x, double *y) const;
    std::vector<double>
    spring_forces(const NodeVector &residual) const;
    void
    smoothing_step(const NodeVector &residual, double keep, double take, NodeVector &step, NodeVector &x)
      const;

    const LocalMesh                           &mesh_;
    PerBody<ElementBlocks>                    &blocks_;
    const std::vector<unsigned char>           held_;
    const StaticGround                         ground_;
    MPI_Comm                                   communicator_;
    NodeVector                                 tiny_;    ///< the displacement that the kernel sees
    NodeVector                                 force_;   ///< the elements' forces in it, on free nodes
    NodeVector                                 step_;    ///< of the smoother
    std::vector<dealii::SymmetricTensor<2, 3>> inverse_; ///< of the diagonal blocks, zero of held nodes
    double                                     largest_ = 0;
    StaticSprings                              springs_;
    std::vector<Vector3> images_;   ///< of the springs' parts: diagonal^-1 times the weight
    BandCholesky<double> coupling_; ///< 1/stiffness + B diagonal^-1 B^T
  };
} // namespace wheelrail
