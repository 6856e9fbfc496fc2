#pragma once

#include <wheelrail/mesh/fine_strip.h>
#include <wheelrail/mesh/section_builder.h>

namespace wheelrail
{
  /// One end of the layer of blocks below a running surface.
  struct LayerEnd
  {
    double parameter = 0;                ///< of the curve where the layer ends if the strip leaves room
    bool   movable   = false;            ///< the end may move to the end of the strip
    std::function<Point2(double)> inner; ///< the corner below an end at this parameter, frame of the builder
  };

  /// The layer of blocks below the running surface of a rail head or a wheel tread, in the frame of
  /// the builder (surface from left to right, material below).
  struct RunningLayer
  {
    Side                outer;              ///< corners on the profile, edges marked `running`
    std::vector<Point2> inner;              ///< where the corners below are to be
    double              start = 0, end = 0; ///< curve parameters of the two ends
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
  /// builder, and tells where the inner corners should be. The block sides leave the profile along
  /// its normals; below the strip they turn by no more than 18 degrees from the normal of the contact
  /// frame, or they would meet in the rail's gauge corner, whose radius is less than the depth.
  /// An end of the layer that is movable goes to the end of the strip when the strip reaches
  /// beyond it or leaves less than 0.4 block_size.
  /// Throws InputError when the strip does not fit on the profile.
  RunningLayer
  make_running_layer(SectionBuilder &builder, const RunningLayerInput &input);

  /// Number of blocks of about block_size on a length, at least one.
  unsigned int
  block_count(double length, double block_size);
} // namespace wheelrail
