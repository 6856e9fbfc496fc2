#pragma once

#include <wheelrail/solid/part.h>

#include <mpi.h>

#include <utility>
#include <vector>

namespace wheelrail
{
  /// A soft round face on the running surface of a body: what a force or an observation is spread over, by
  /// (1 + cos(pi d/radius))/2 of the distance d in the section, times the same of the distance along the
  /// track.
  struct HammerFace
  {
    Body    body = Body::rail;
    Vector3 middle{};        ///< in the track frame [m]
    double  radius = 25e-3;  ///< where it ends [m]
    Vector3 direction{0, 1}; ///< of the force, or of the displacement that is observed; a unit vector
  };

  /// The share of the face at a distance from its middle, in the section or along the track [1].
  double
  face_share(double distance, double radius);

  /// What a face is to the nodes of a mesh.
  struct FaceNodes
  {
    Vector3                                      direction{};
    std::vector<std::pair<unsigned int, double>> share; ///< of this rank's faces; over all ranks one in sum
  };

  /// Throws RunError where no running surface lies below the face. Collective.
  FaceNodes
  face_nodes(const LocalMesh &mesh, const HammerFace &face, MPI_Comm communicator);

  /// A blow: a force F sin^2(pi t/duration) on a face, from t = 0 on. Energy: `hammer_work`.
  class Hammer : public Part
  {
  public:
    /// `force` F [N], `duration` [s].
    Hammer(const HammerFace &face, double force, double duration, MPI_Comm communicator);

    void
    prepare(const Solid &solid, std::vector<NodeInertia> &inertia) override;
    void
    enter(EnergyBalance &energies) override;
    void
    add_shares(const Instant &now, Solid &solid) override;
    void
    account(const Instant &now, const Solid &solid, const std::vector<NodeInertia> &inertia) override;

    /// At a time [N].
    double
    force(double time) const;

  private:
    HammerFace  face_;
    double      force_, duration_;
    MPI_Comm    communicator_;
    FaceNodes   nodes_;
    EnergyTerm *work_ = nullptr;
  };
} // namespace wheelrail
