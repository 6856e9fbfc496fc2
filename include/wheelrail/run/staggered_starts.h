#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

#include <vector>

namespace wheelrail
{
  /// Where on the rail the wheels of a family of passages start. The patch of the first one, put down on new
  /// steel, flows as a whole and leaves a pit, in which another wheel would start with a percent less than
  /// its load: the others start farther along, where the first one has rolled, in turn where there are
  /// several places.
  class StaggeredStarts
  {
  public:
    /// Run/Staggered starts places, whole coarse blocks of cells, each at least the length of the patch
    /// farther along than the one before. With auto two, where that leaves twice the length of the patch to
    /// settle before the place where passages are compared, and the rail is long enough; else one, as where
    /// the fine cells do not move. Throws InputError where the path has no room for the places asked for.
    StaggeredStarts(const Scene &scene, const SceneGeometry &geometry);

    /// Run/Start offset of passage k, from 1 [m].
    double
    offset(unsigned int k) const;

    /// After how many passages a wheel starts at the same place again, the first wheel apart.
    unsigned int
    period() const;

  private:
    std::vector<double> places_;
  };
} // namespace wheelrail
