// Parameters of the edge classification.
#ifndef EDGE_CLASSIFICATION_LAYOUT_H
#define EDGE_CLASSIFICATION_LAYOUT_H
#include "harness/formats/scene.h"
#include "harness/formats/workloads.h"
#include "harness/shared.h"
SHARED_BEGIN(edge_classification)

SHARED_CONST uint kEdgeTileSide = 8u;  // pixels
SHARED_CONST uint kMaxSamples = 8u;

// Entries of tile_counts and args.
SHARED_CONST uint kEdgeTiles = 0u;
SHARED_CONST uint kPlainTiles = 1u;

struct EdgeParams {
  uint width;  // pixels
  uint height;
  uint samples;     // a pixel; outside 1..kMaxSamples counts as the nearer end
  uint gradients;   // 0: materials alone make edges; otherwise depth gradients do too
  uint threshold;   // of a gradient component's difference, in snorm16 units of 1/32767: an edge is above it
  uint neighbours;  // not 0: a pixel's first sample is also compared with its right and lower neighbours'
};

#ifdef __cplusplus
SHARED_LAYOUT(EdgeParams, width, height, samples, gradients, threshold, neighbours);
#endif
SHARED_END
#endif
