#include <wheelrail/sampling/pose.h>

#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Sums of a least-squares fit of (u_x, u_y) = (a - roll dy, b + roll dx).
    struct FitSums
    {
      double n = 0, x = 0, y = 0, xx_yy = 0, u = 0, v = 0, moment = 0;

      void
      add(const double dx, const double dy, const double ux, const double uy)
      {
        n += 1;
        x += dx;
        y += dy;
        xx_yy += dx * dx + dy * dy;
        u += ux;
        v += uy;
        moment += dx * uy - dy * ux;
      }

      RigidPart
      solve() const
      {
        RigidPart part;
        part.nodes = static_cast<int>(n);
        if (n < 3)
          return part;
        const double spread = xx_yy - (x * x + y * y) / n;
        part.roll           = (moment - (x * v - y * u) / n) / spread;
        part.lateral        = (u + part.roll * y) / n;
        part.vertical       = (v - part.roll * x) / n;
        return part;
      }
    };
  } // namespace


  ContactPose
  fit_pose(const Solid &solid, const PoseQuery &query, MPI_Comm communicator)
  {
    FitSums sums[2];
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      {
        if (!solid.mesh.owned[n])
          continue;
        const double *R    = &solid.mesh.reference[4 * n];
        const Vector3 X    = {R[0], R[1], R[2]};
        const bool    rail = solid.mesh.node_body[n] == Body::rail;
        const Vector3 arm  = X - query.axle_reference;
        // where the node would be without deformation
        const Vector3 place = rail ? X : query.wheel_place(X);
        const Vector3 away  = place - query.contact;
        if (std::abs(away[2]) > query.slab || std::hypot(away[0], away[1]) < query.keep_away)
          continue;
        if (rail ? away[1] < -query.head_depth
                 : norm(arm - dot(arm, query.axis) * query.axis) < query.rim_inner_radius)
          continue;
        // the part of the rim around the contact: beyond 0.1 m above it the wheel has turned away from it
        if (!rail && away[1] > 0.1)
          continue;
        const Vector3 u = solid.position(n) - place;
        sums[rail ? 0 : 1].add(away[0], away[1], u[0], u[1]);
      }
    MPI_Allreduce(MPI_IN_PLACE, sums, 14, MPI_DOUBLE, MPI_SUM, communicator);
    return {sums[0].solve(), sums[1].solve()};
  }
} // namespace wheelrail
