#include <wheelrail/base/errors.h>
#include <wheelrail/model/model.h>
#include <wheelrail/reference/wheel_load.h>

#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// The section of the centred wheelset: the weight does not depend on where it stands.
    Section
    centred_section(const Scene &scene, const SceneGeometry &geometry)
    {
      Scene centred         = scene;
      centred.lateral_shift = 0;
      centred.yaw           = 0;
      return sweep_plan(centred, make_geometry(centred, {geometry.rail, geometry.wheel, {}})).wheel;
    }

    /// The section that a run would mesh, or that of the centred wheelset.
    Section
    wheel_section(const Scene &scene, const SceneGeometry &geometry)
    {
      try
        {
          return sweep_plan(scene, geometry).wheel;
        }
      catch (const InputError &)
        {
          return centred_section(scene, geometry);
        }
    }
  } // namespace


  double
  static_wheel_load(const Scene &scene, const SceneGeometry &geometry)
  {
    if (scene.wheel_load > 0)
      return scene.wheel_load;
    const Section wheel = wheel_section(scene, geometry);
    // first moment of the section about the axle, from small quadrilaterals (Guldin)
    constexpr int n      = 8;
    double        moment = 0;
    for (unsigned int block = 0; block < wheel.blocks.size(); ++block)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          {
            const auto at = [&](const int k, const int l) {
              return wheel.position(block, double(i + k) / n, double(j + l) / n);
            };
            const Point2 a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
            const auto   triangle = [](const Point2 &p, const Point2 &q, const Point2 &r) {
              const Point2 u = q - p, v = r - p;
              return 0.5 * (u.x * v.y - u.y * v.x) * (p.y + q.y + r.y) / 3;
            };
            moment += triangle(a, b, c) + triangle(a, c, d);
          }
    const double mass = 2 * M_PI * moment * scene.wheel_material.density;
    return (scene.sprung_mass + scene.axle_mass + mass) * scene.gravity;
  }
} // namespace wheelrail
