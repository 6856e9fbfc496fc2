#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/irregularity_checks.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/model/scene_irregularities.h>
#include <wheelrail/run/staggered_starts.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Throws InputError where a wheel that starts farther along would stand on an irregularity.
    void
    require_smooth_start(Scene scene, SceneGeometry geometry, const double place)
    {
      if (!scene.irregular())
        return;
      scene.start_offset = place;
      add_irregularities(scene, geometry);
      Findings found;
      check_irregular_run(scene, geometry, expected_patch(scene, geometry), found);
      if (!found.errors.empty())
        throw InputError(entry_text(scene, "Run", "Staggered starts") + ": a start " + rounded_mm(place) +
                         " farther along: " + found.errors.front());
    }
  } // namespace


  StaggeredStarts::StaggeredStarts(const Scene &scene, const SceneGeometry &geometry)
    : places_{scene.start_offset}
  {
    if (scene.staggered_starts == 1 || scene.window == MeshWindow::fixed)
      return;
    const double length = 0.9 * expected_patch(scene, geometry).length; // that is some 10 % too long
    const double block  = sweep_plan(scene, geometry).block_length();
    const double step   = std::ceil(length / block) * block;
    // to the place where passages are compared, one patch behind the end of the first wheel's path
    const double path = scene.path() - length - scene.start_offset;
    const double rail = 0.5 * (scene.rail_length - scene.mesh_distance()) - free_rail(scene, length);
    const auto   fits = [&](const unsigned int n, const double settle) {
      return (n - 1) * step <= path - settle && scene.start_offset + (n - 1) * step <= rail;
    };
    unsigned int n = scene.staggered_starts;
    if (n == 0)
      n = !scene.irregular() && fits(2, 2 * length) ? 2 : 1; // irregularities are met at one distance
    else if (!fits(n, length))
      throw InputError(
        entry_text(scene, "Run", "Staggered starts") + ": each start lies " + rounded_mm(step) +
        " farther along than the one before, and the last one leaves no stretch that all wheels "
        "have rolled over; take fewer, or a longer " +
        path_entry(scene) + " and Track/Rail length");
    for (unsigned int k = 1; k < n; ++k)
      {
        places_.push_back(scene.start_offset + k * step);
        require_smooth_start(scene, geometry, places_.back());
      }
  }


  double
  StaggeredStarts::offset(const unsigned int k) const
  {
    return k == 1 ? places_.front() : places_[places_.size() == 1 ? 0 : 1 + (k - 2) % period()];
  }


  unsigned int
  StaggeredStarts::period() const
  {
    return std::max<unsigned int>(1, static_cast<unsigned int>(places_.size()) - 1);
  }
} // namespace wheelrail
