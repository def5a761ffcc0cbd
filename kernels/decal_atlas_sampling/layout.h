// Decals projected from an atlas.
#ifndef DECAL_ATLAS_SAMPLING_LAYOUT_H
#define DECAL_ATLAS_SAMPLING_LAYOUT_H
#include "harness/formats/cluster_lists.h"
#include "harness/formats/clusters.h"
#include "harness/formats/light.h"
#include "harness/shared.h"
SHARED_BEGIN(decal_atlas_sampling)

struct DecalParams {
  uint width;  // pixels
  uint height;
  ClusterGrid grid;  // of a column, a row and a slice at least
  uint decals;
  uint entries;  // of the lists
  uint receivers;
  float near_plane;    // metres
  float atlas_border;  // texels of the first level around each rectangle that hold what it holds at its sides
  ViewRays rays;
};

// How a decal's normal and the surface's become one.
SHARED_CONST uint kNormalLinear = 0u;
SHARED_CONST uint kNormalWhiteout = 1u;    // slopes add up; any unknown mode too
SHARED_CONST uint kNormalReoriented = 2u;  // the decal's turned as the surface's is (Barre-Brisebois, Hill 2012)

SHARED_CONST uint kNoReceiver = 0xffffffffu;

// (row_x, row_y, row_z) (p, 1) is where a point is in the box, which is [0, 1]^3; p is relative to the camera, metres,
// or where there is a receiver, in its space. x and y in the box go to scale_bias.xy * (x, y) + scale_bias.zw in the
// page.
struct DecalRecord {
  vec4 row_x;
  vec4 row_y;
  vec4 row_z;
  vec4 scale_bias;      // UV of the page; a negative scale mirrors
  vec3 weights;         // of base colour, normal and roughness, 0..1; 0 leaves the channel as it is
  float fade_distance;  // view depth where it is gone, metres; it fades over the last quarter. 0 or less: never
  vec3 tangent;         // unit, in the space of p: where the page's u grows
  uint normal_mode;
  vec3 bitangent;  // where its v grows
  uint receiver;   // kNoReceiver: none
  vec3 outward;    // away from the surface that the decal is made for
  uint page;       // layer of the atlas; past the end the last
};

// From positions relative to the camera to the receiver's space: rigid, three rows.
struct ReceiverRecord {
  vec4 row_x;
  vec4 row_y;
  vec4 row_z;
};

// The atlas: three array textures of one size and as many levels; in blocks, the second format.
SHARED_CONST uint kAtlasAlbedo = 0u;     // rgba8_srgb or bc7_srgb, alpha is coverage
SHARED_CONST uint kAtlasNormal = 1u;     // rgba8_unorm or bc5_unorm, x and y in red and green
SHARED_CONST uint kAtlasRoughness = 2u;  // rgba8_unorm or bc4_unorm, red

SHARED_CONST float kLeastDepth = 1e-18f;         // of reversed depth: what is less, or no number, is no surface
SHARED_CONST float kLargestGradient = 65536.0f;  // of UV, a pixel: beyond it, or no number, this much
SHARED_CONST uint kAnisotropicTaps = 4u;
// A device's rho is at most sqrt(2) times the sum of both derivatives (Vulkan, Scale Factor Operation), and its level
// an eighth more at 4 bits of precision (2^(1/8)).
SHARED_CONST float kWidestRho = 1.5423f;
// And a tap may be off by a step of the filter's weights, a sixteenth of a texel at 4 bits: of half a texel, an eighth.
SHARED_CONST float kInset = 1.125f;
// A normal whose square is outside these has no direction that fp32 could tell: the surface's stays.
SHARED_CONST float kLeastNormal = 1e-6f;
SHARED_CONST float kLargestNormal = 1e12f;

#ifdef __cplusplus
SHARED_LAYOUT(DecalParams, width, height, grid, decals, entries, receivers, near_plane, atlas_border, rays);
SHARED_LAYOUT(DecalRecord, row_x, row_y, row_z, scale_bias, weights, fade_distance, tangent, normal_mode, bitangent,
              receiver, outward, page);
SHARED_LAYOUT(ReceiverRecord, row_x, row_y, row_z);
#endif
SHARED_END
#endif
