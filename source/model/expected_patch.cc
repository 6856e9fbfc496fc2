#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/scene_material.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace wheelrail
{
  namespace
  {
    /// (1 - nu^2) / E of a body [1/Pa].
    double
    plane_compliance(const MaterialData &material)
    {
      return (1 - material.poissons_ratio * material.poissons_ratio) / material.youngs_modulus;
    }
  } // namespace


  double
  contact_modulus(const SteelSettings &scene)
  {
    return 1 / (plane_compliance(scene.rail_material) + plane_compliance(scene.wheel_material));
  }


  double
  expected_unsprung_weight(const WheelsetSettings &scene)
  {
    // the default section, turned around the axle, has 344 kg: that changes the approach by 0.15 %
    constexpr double usual_wheel = 320;
    return (scene.axle_mass + usual_wheel) * scene.gravity;
  }


  std::string
  load_too_small(const Scene &scene, const double unsprung)
  {
    return entry_text(scene, "Wheelset", "Wheel load") + ": less than the weight of wheel and half axle, " +
           text("%.2f kN", 1e-3 * unsprung) + "; give more, or a lighter Wheelset/Axle mass";
  }


  double
  expected_load(const WheelsetSettings &scene)
  {
    if (scene.wheel_load > 0)
      return scene.wheel_load;
    return scene.sprung_mass * scene.gravity + expected_unsprung_weight(scene);
  }


  double
  expected_approach(const Scene &scene, const double rolling_radius)
  {
    return 1e-4 * std::pow(expected_load(scene) / 1e5 * 115.4e9 / contact_modulus(scene), 2. / 3) *
           std::pow(0.46 / rolling_radius, 1. / 3);
  }


  ExpectedPatch
  expected_patch(const Scene &scene, const SceneGeometry &geometry)
  {
    const double  radius = geometry.contact.rolling_radius;
    ExpectedPatch patch;
    patch.approach                = expected_approach(scene, radius);
    const double virtual_approach = kik_piotrowski * patch.approach;
    const Range  along            = smooth_overlap_along(geometry, virtual_approach, 0);
    patch.length                  = along.s1 - along.s0;
    for (const Range &range :
         interpenetration(geometry.wheel_heights(), geometry.rail_heights(), virtual_approach))
      patch.width += range.s1 - range.s0;
    return patch;
  }


  Measures
  expected_measures(const Scene &scene, const ExpectedPatch &patch)
  {
    constexpr double too_long = 1.1;
    Measures         expected;
    expected.cells             = std::min(patch.length, patch.width) / (too_long * scene.cell_size);
    expected.cells_across_peak = expected.cells;
    expected.penetration =
      4 / M_PI * contact_modulus(scene) / (scene.penalty_scale * mean_bulk_modulus(scene) * expected.cells);
    return expected;
  }


  double
  expected_loss(const Scene &scene, const ExpectedPatch &patch)
  {
    const bool     held     = !scene.irregular() && scene.motion == "none";
    const Measures expected = expected_measures(scene, patch);
    if (!std::isnan(expected.lost()))
      return expected.lost(held);
    Measures three = expected; // of fewer cells no law is known: theirs, with the second power
    three.cells = three.cells_across_peak = 3;
    return std::pow(three.cells / expected.cells, 2) * three.lost(held);
  }


  std::string
  expected_accuracy(const Scene &scene, const ExpectedPatch &patch)
  {
    const Measures expected = expected_measures(scene, patch);
    if (std::isnan(expected.lost()))
      return "";
    return text("peak pressure: expected to be uncertain by %.1f %% with %.1f cells of ",
                100 * expected_loss(scene, patch),
                expected.cells) +
           in_mm(scene.cell_size) +
           text(" over the patch; Run/Wanted accuracy is %.3g %%", 100 * scene.wanted_accuracy);
  }


  double
  expected_elements(const Scene &scene, const ExpectedPatch &patch)
  {
    // cross-section of a rail of 54 to 60 kg/m, steel of a usual wheel
    constexpr double rail_area = 7e-3, wheel_volume = 0.04;
    const double     h = scene.cell_size, coarse = std::max(scene.coarse_cell_size, h);
    // the strip covers the interpenetration at the full approach, which is about 1.3 times as wide as at 0.55
    // of it on the flattening tread; along the track this counts around irregularities: 1/sqrt(0.55) = 1.35
    const double wanted = scene.planned_strip.size() == 2 ? scene.planned_strip[1] - scene.planned_strip[0]
                                                          : 1.3 * patch.width + 2 * scene.fine_margin;
    const double width  = std::ceil(wanted / coarse) * coarse;
    const double bound =
                   (scene.irregular() ? 1.35 : 1) * patch.length + 2 * std::max(scene.fine_margin, 3 * h),
                 whole  = scene.mesh_distance() + bound,
                 length = scene.window == MeshWindow::moving ? std::min(coarse + bound, whole) : whole;
    const double layers = std::ceil(scene.depth_of_fine_cells() / h);
    const double fine   = coarse > h ? 2 * (length / h) * (width / h) * layers : 0;
    // halving from size to size takes about 0.4 of the finest cells more; blocks of the web and of thin
    // places are smaller than asked for
    constexpr double smaller = 1.3;
    return 1.4 * fine + smaller * (scene.rail_length * rail_area + wheel_volume) / (coarse * coarse * coarse);
  }


  unsigned int
  useful_ranks(const double elements, const unsigned int cores)
  {
    // the forces of 4000 cells take 0.18 ms, the contact of the main scene 0.17 ms on every rank (measured)
    constexpr double per_rank = 4e3;
    return static_cast<unsigned int>(std::max(1., std::min<double>(cores, std::floor(elements / per_rank))));
  }


  double
  expected_memory(const double elements, const unsigned int ranks)
  {
    // measured on scenes of 25 000 to 160 000 cells on one and two ranks, to 5 %
    constexpr double per_element = 3.3e3, per_rank = 240e6, once = 250e6;
    return once + elements * per_element + std::max(1u, ranks) * per_rank;
  }
} // namespace wheelrail
