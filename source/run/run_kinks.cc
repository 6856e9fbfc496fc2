#include <wheelrail/geometry/surface_kinks.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/run/run_kinks.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Those in the patch of a wheel that has rolled to a place [m] and `around` it, half before and half
    /// behind.
    SurfaceKinks
    kinks_at(const SceneGeometry &geometry, const Summary &run, const double place, const double around)
    {
      constexpr int   strips = 8;
      RunningSurfaces there  = geometry.surfaces;
      there.rail.take_irregularities(there.rail, place);
      there.wheel.take_irregularities(there.wheel, place);
      const double strip = run.patch_lateral / strips, half = 0.5 * (run.patch_longitudinal + around);
      std::vector<PatchRow> rows;
      for (int k = 0; k <= strips; ++k)
        rows.push_back({run.patch_centre_lateral + (k - 0.5 * strips) * strip, -half, half});
      return surface_kinks(there, rows, 0.5 * strip);
    }
  } // namespace


  double
  middle_of_means(const Scene &scene, const Summary &run, const Measures &measures)
  {
    const double half = 0.5 * scene.averaging_distance;
    return scene.evaluate_at == Scene::at_largest_force ? std::max(measures.force_at, half)
           : scene.evaluate_at > 0                      ? scene.evaluate_at
                                                        : run.rolled_distance - half;
  }


  void
  measure_kinks(const Scene &scene, const SceneGeometry &geometry, const Summary &run, Measures &measures)
  {
    measures.contact_modulus  = contact_modulus(scene);
    const double       length = scene.averaging_distance;
    const double       middle = scene.irregular() ? middle_of_means(scene, run, measures) : 0;
    const SurfaceKinks kinks  = kinks_at(geometry, run, middle, scene.irregular() ? length : 0);
    measures.edge             = kinks.edge;
    measures.notch            = kinks.notch;
    if (const double at = get_figure(run, "largest_pressure_at_m"); std::isfinite(at))
      measures.edge_on_path = kinks_at(geometry, run, at, 0).edge;
  }
} // namespace wheelrail
