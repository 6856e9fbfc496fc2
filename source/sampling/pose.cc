#include <wheelrail/sampling/pose.h>

#include <cmath>

namespace wheelrail
{
  void
  RigidFit::add(const double dx, const double dy, const double ux, const double uy, const double weight)
  {
    n += weight;
    x += weight * dx;
    y += weight * dy;
    xx_yy += weight * (dx * dx + dy * dy);
    u += weight * ux;
    v += weight * uy;
    moment += weight * (dx * uy - dy * ux);
  }


  RigidPart
  RigidFit::solve(const int nodes) const
  {
    RigidPart part;
    part.nodes = nodes;
    if (nodes < 3)
      return part;
    const double spread = xx_yy - (x * x + y * y) / n;
    part.roll           = (moment - (x * v - y * u) / n) / spread;
    part.lateral        = (u + part.roll * y) / n;
    part.vertical       = (v - part.roll * x) / n;
    return part;
  }


  bool
  fits_pose(const PoseQuery &query, const Body body, const double dx, const double dy, const double from_axle)
  {
    // the part of the rim around the contact: beyond it the wheel has turned away from it
    constexpr double highest = 0.1; // [m]
    if (std::hypot(dx, dy) < query.keep_away)
      return false;
    return body == Body::rail ? dy >= -query.head_depth
                              : from_axle >= query.rim_inner_radius && dy <= highest;
  }


  void
  set_pose_figures(const ContactPose &pose, Summary &summary)
  {
    set_figure(summary, "rail_head_lateral_m", pose.rail_head.lateral);
    set_figure(summary, "rail_head_roll_rad", pose.rail_head.roll);
    set_figure(summary, "wheel_rim_lateral_m", pose.wheel_rim.lateral);
    set_figure(summary, "wheel_rim_roll_rad", pose.wheel_rim.roll);
    set_figure(summary, "relative_lateral_m", pose.relative_lateral());
    set_figure(summary, "relative_roll_rad", pose.relative_roll());
  }


  ContactPose
  fit_pose(const Solid &solid, const PoseQuery &query, MPI_Comm communicator)
  {
    RigidFit sums[2];
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      {
        if (!solid.mesh.owns(n))
          continue;
        const Vector3 X    = solid.mesh.place(n);
        const Body    body = solid.mesh.node_body[n];
        const bool    rail = body == Body::rail;
        const Vector3 arm  = X - query.axle_reference;
        // where the node would be without deformation
        const Vector3 place = rail ? X : query.wheel_place(X);
        const Vector3 away  = place - query.contact;
        if (std::abs(away[2]) > query.slab ||
            !fits_pose(query, body, away[0], away[1], norm(arm - dot(arm, query.axis) * query.axis)))
          continue;
        const Vector3 u = solid.position(n) - place;
        sums[rail ? 0 : 1].add(away[0], away[1], u[0], u[1]);
      }
    MPI_Allreduce(MPI_IN_PLACE, sums, 14, MPI_DOUBLE, MPI_SUM, communicator);
    return {sums[0].solve(std::lround(sums[0].n)), sums[1].solve(std::lround(sums[1].n))};
  }
} // namespace wheelrail
