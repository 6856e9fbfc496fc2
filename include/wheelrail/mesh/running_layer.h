#pragma once

#include <wheelrail/mesh/fine_strip.h>
#include <wheelrail/mesh/section_builder.h>

#include <functional>
#include <vector>

namespace wheelrail
{
  /// Depth of the layer in block sizes. A little more than 1: where the profile slopes, cells are skewed
  /// and the height makes up for the stable time step that costs.
  constexpr double running_layer_depth = 1.06;

  /// One end of the layer of blocks below a running surface.
  struct LayerEnd
  {
    double parameter = 0;                ///< of the curve where the layer ends if the strip leaves room
    bool   movable   = false;            ///< the end may move away from the strip
    std::function<Point2(double)> inner; ///< the corner below an end at this parameter, frame of the builder
  };

  /// The layer of blocks below the running surface of a rail head or a wheel tread, in the frame of
  /// the builder (surface from left to right, material below).
  struct RunningLayer
  {
    Side                outer;                          ///< corners on the profile, edges marked `running`
    std::vector<Point2> inner;                          ///< where the corners below are to be
    double              start = 0, end = 0;             ///< curve parameters of the two ends
    unsigned int        strip_begin = 0, strip_end = 0; ///< first and last corner of the strip
  };

  /// What make_running_layer() is given.
  struct RunningLayerInput
  {
    MirroredCurve curve;
    Placement     placement; ///< of the profile in the track plane
    FineStrip     strip;
    LayerEnd      start, end;
    double        block_size    = 0; ///< [m]
    double        depth         = 0; ///< of the layer [m]
    unsigned int  minimum_count = 1; ///< of blocks
  };

  /// Divides the running surface into the blocks of the strip (exact boundaries, s linear along the
  /// edges) and blocks of about block_size beside it, adds their outer corners and edges to the
  /// builder, and tells where the inner corners should be. The block sides of the strip are parallel to
  /// the normal of the contact frame, as are the sides of the box of finest cells: these keep their
  /// width in depth, and no cell beside the strip gets into the box. The corners below the strip are to
  /// stay where they are; those beside it are first guesses along the profile's normals.
  /// An end of the layer that is movable leaves room for a block beside the strip: it goes one
  /// block_size beyond the end of the strip when it would be nearer.
  /// Throws InputError when the strip does not fit on the profile.
  RunningLayer
  make_running_layer(SectionBuilder &builder, const RunningLayerInput &input);

  /// Number of blocks of about block_size on a length, at least one.
  unsigned int
  block_count(double length, double block_size);
} // namespace wheelrail
