#include <wheelrail/dynamics/wheel_axes.h>

namespace wheelrail
{
  WheelAxes::WheelAxes(const Axle &axle)
    : centre_(axle.data().centre)
    , now_(axle.centre())
    , forth_(axle.data().axis, axle.pitch_angle())
    , back_(axle.data().axis, -axle.pitch_angle())
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
    change(solid, [&](const Vector3 &x) { return centre_ + back_(x - now_); });
  }


  void
  WheelAxes::to_track(Solid &solid) const
  {
    change(solid, [&](const Vector3 &x) { return now_ + forth_(x - centre_); });
  }
} // namespace wheelrail
