#include <wheelrail/base/errors.h>
#include <wheelrail/receptance/hammer.h>

#include <array>
#include <cmath>
#include <map>

namespace wheelrail
{
  double
  face_share(const double distance, const double radius)
  {
    return std::abs(distance) < radius ? 0.5 + 0.5 * std::cos(M_PI * distance / radius) : 0;
  }


  FaceNodes
  face_nodes(const LocalMesh &mesh, const HammerFace &of, MPI_Comm communicator)
  {
    constexpr int                  points = 8; // in each direction, of the midpoint rule: faces are coarse
    std::map<unsigned int, double> share;
    double                         sum = 0;
    for (const BoundaryFace &face : mesh.faces)
      if (face.body == of.body && face.mark == Boundary::running)
        {
          const std::array<Vector3, 4> X    = mesh.places(face.nodes);
          const double                 area = norm(cross(X[3] - X[0], X[2] - X[1])) / (2 * points * points);
          for (int p = 0; p < points; ++p)
            for (int q = 0; q < points; ++q)
              {
                const double xi = (p + 0.5) / points, eta = (q + 0.5) / points;
                const double N[4] = {(1 - xi) * (1 - eta), xi * (1 - eta), (1 - xi) * eta, xi * eta};
                Vector3      at{};
                for (int a = 0; a < 4; ++a)
                  add(at, N[a], X[a]);
                const Vector3 away = at - of.middle;
                const double  weight =
                  area * face_share(std::hypot(away[0], away[1]), of.radius) * face_share(away[2], of.radius);
                sum += weight;
                for (int a = 0; a < 4 && weight > 0; ++a)
                  share[face.nodes[a]] += weight * N[a];
              }
        }
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator);
    if (!(sum > 0))
      throw RunError("There is no running surface below the face of the hammer.");
    FaceNodes nodes{of.direction, {}};
    for (const auto &[node, weight] : share)
      nodes.share.emplace_back(node, weight / sum);
    return nodes;
  }


  Hammer::Hammer(const HammerFace &face, const double force, const double duration, MPI_Comm communicator)
    : face_(face)
    , force_(force)
    , duration_(duration)
    , communicator_(communicator)
  {
  }


  void
  Hammer::prepare(const Solid &solid, std::vector<NodeInertia> &)
  {
    nodes_ = face_nodes(solid.mesh, face_, communicator_);
  }


  void
  Hammer::enter(EnergyBalance &energies)
  {
    work_ = &energies.term("hammer_work", EnergyKind::supplied);
  }


  double
  Hammer::force(const double time) const
  {
    return time > 0 && time < duration_ ? force_ * std::pow(std::sin(M_PI * time / duration_), 2) : 0;
  }


  void
  Hammer::add_shares(const Instant &now, Solid &solid)
  {
    if (const double force = this->force(now.time); force > 0)
      for (const auto &[node, share] : nodes_.share)
        for (int i = 0; i < 3; ++i)
          solid.force[4 * node + i] += share * force * nodes_.direction[i];
  }


  void
  Hammer::account(const Instant &now, const Solid &solid, const std::vector<NodeInertia> &inertia)
  {
    const double force = this->force(now.time);
    double       power = 0;
    for (const auto &[node, share] : nodes_.share)
      if (force > 0)
        power +=
          share * force * dot(nodes_.direction, mean_velocity(solid, inertia, node, now.velocity_update));
    work_->add_work(now.velocity_update.duration * power);
  }
} // namespace wheelrail
