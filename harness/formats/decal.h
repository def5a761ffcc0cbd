// Decals: boxes in space that project a rectangle of an atlas onto the surfaces within.
#ifndef FORMATS_DECAL_H
#define FORMATS_DECAL_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

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
  vec3 tangent;         // unit, in the space of p: where red of the normals points
  uint normal_mode;
  vec3 bitangent;  // where green does
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
SHARED_CONST uint kAtlasTextures = 3u;

// What a view has of them.
struct DecalCounts {
  uint decals;
  uint receivers;
  uint atlas_border;  // texels of the first level around each picture
};

#ifdef __cplusplus
SHARED_LAYOUT(DecalCounts, decals, receivers, atlas_border);
SHARED_LAYOUT(DecalRecord, row_x, row_y, row_z, scale_bias, weights, fade_distance, tangent, normal_mode, bitangent,
              receiver, outward, page);
SHARED_LAYOUT(ReceiverRecord, row_x, row_y, row_z);
#endif
SHARED_END
#endif
