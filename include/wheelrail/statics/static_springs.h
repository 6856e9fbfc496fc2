#pragma once

#include <wheelrail/base/simd.h>
#include <wheelrail/base/vector3.h>
#include <wheelrail/contact/contact.h>
#include <wheelrail/mesh/coarse_levels.h>
#include <wheelrail/solid/node_vector.h>
#include <wheelrail/solid/part.h>

#include <cstdint>
#include <vector>

namespace wheelrail
{
  /// Springs between nodes of one mesh, those of the contact or what parts join: stretch = B x with the
  /// displacements x of the nodes, energy sum stiffness stretch^2 / 2. All ranks know all springs.
  class StaticSprings
  {
  public:
    /// Share of a node in the stretch of a spring.
    struct Part
    {
      unsigned int  spring;
      std::uint32_t node; ///< over all ranks
      Vector3       weight;
    };

    StaticSprings() = default;

    /// The springs of the contact on the finest mesh; nodes that hang hand their parts to their parents.
    /// `held`: 1 for nodes that do not move. Collective.
    StaticSprings(const std::vector<Contact::Spring> &springs,
                  const LocalMesh                    &mesh,
                  const std::vector<unsigned char>   &held,
                  MPI_Comm                            communicator);

    /// What parts join, on the finest mesh. Collective.
    StaticSprings(const std::vector<JoinedNodes>   &joined,
                  const LocalMesh                  &mesh,
                  const std::vector<unsigned char> &held,
                  MPI_Comm                          communicator);

    /// The same springs as the trial functions of the next coarser level stretch them. Collective.
    StaticSprings
    coarsened(const CoarseLevel &coarse, const std::vector<unsigned char> &held) const;

    /// B x. Collective.
    std::vector<double>
    stretch(const double *x) const;

    /// y += B^T forces on the nodes that the rank owns.
    void
    add(const std::vector<double> &forces, double *y) const;

    /// y += factor x B^T stiffness B x, from and on owned nodes. Collective.
    void
    add_product(double factor, const double *x, double *y) const;

    std::size_t
    size() const
    {
      return stiffness_.size();
    }
    /// [N/m]
    const std::vector<double> &
    stiffness() const
    {
      return stiffness_;
    }
    /// Parts of all springs, in the order of the springs, each node once a spring.
    const std::vector<Part> &
    parts() const
    {
      return parts_;
    }
    /// Local node of each part, or none, which no rank owns.
    const std::vector<unsigned int> &
    local_nodes() const
    {
      return local_;
    }
    static constexpr unsigned int none = ~0u;

    /// Largest distance of two springs in the list that share a node.
    std::size_t
    band() const;

  private:
    void
    take(std::vector<Part> own, const LocalMesh &mesh, const std::vector<unsigned char> &held);

    MPI_Comm                  communicator_{};
    const LocalMesh          *mesh_ = nullptr;
    std::vector<double>       stiffness_;
    std::vector<Part>         parts_;
    std::vector<unsigned int> local_;
  };

  /// What holds the bodies of a static solution to the ground, on one mesh.
  struct StaticGround
  {
    AlignedVector<double> springs; ///< along the axes of the nodes, 4 numbers each [N/m], or empty
    StaticSprings         joined;  ///< what unknowns of parts take off them
  };
} // namespace wheelrail
