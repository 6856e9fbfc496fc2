#include <wheelrail/wheelset/wheel_axes.h>

namespace wheelrail
{
  WheelAxes::WheelAxes(const Axle &axle)
    : motion_(axle)
  {
  }


  void
  WheelAxes::change(Solid &solid, const std::function<Vector3(const Vector3 &)> &move) const
  {
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::wheel)
        {
          const Vector3 x = move(solid.position(n));
          for (int i = 0; i < 3; ++i)
            solid.displacement[4 * n + i] = x[i] - solid.mesh.reference[4 * n + i];
        }
  }


  void
  WheelAxes::to_wheel(Solid &solid) const
  {
    change(solid, [&](const Vector3 &x) { return motion_.back(x); });
  }


  void
  WheelAxes::to_track(Solid &solid) const
  {
    change(solid, [&](const Vector3 &x) { return motion_(x); });
  }
} // namespace wheelrail
