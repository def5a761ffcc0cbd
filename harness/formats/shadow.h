// The shadow atlas (Sousa, Geffroy 2016; Simon Coenen's study of DOOM Eternal): one depth image for all lights, cut
// into square tiles. A spot has one tile, a point light six (the faces of a cube), a directional one a tile a cascade.
#ifndef FORMATS_SHADOW_H
#define FORMATS_SHADOW_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

SHARED_CONST uint kCubeFaces = 6u;  // +x, -x, +y, -y, +z, -z of the world's axes
SHARED_CONST uint kMostCascades = 4u;

// Depth in the atlas is reversed, d32_float: 1 nearest to the light, 0 farthest and where nothing casts a shadow. Of
// spots and points near / distance along the axis, as in the picture; of directional lights linear.

// Texels of the atlas; a power of two a side.
struct ShadowTile {
  uint x;
  uint y;
  uint side;
};

// A part of an instance that is drawn into a tile. Rows from the mesh's positions to the tile's clip space (Vulkan, y
// down, x and y in [-w, w] within the tile), rounded once from the double product of instance and light: nothing in
// them moves with the viewer, so that what was drawn in an earlier frame is what would be drawn now.
struct ShadowCaster {
  vec4 clip_x;
  vec4 clip_y;
  vec4 clip_z;    // of perspective ones (0, 0, 0, near)
  vec4 clip_w;    // of directional lights (0, 0, 0, 1)
  uint tile;      // of the list that its draw is for; past its end: not drawn
  uint material;  // for the alpha of masked ones
};

// How a light's tile is looked up. Rows as a caster's, but from positions relative to the camera.
struct ShadowView {
  vec4 clip_x;
  vec4 clip_y;
  vec4 clip_z;
  vec4 clip_w;
  ShadowTile tile;
  float bias;  // what rounding may move a point by in clip space, of w (kernels/shadow_lookup/README.md, Bias)
};

// Of the lookup (kernels/shadow_lookup/README.md).
SHARED_CONST float kCascadeBand = 0.1f;        // of a cascade's half width, at its rim: there dither chooses the next
SHARED_CONST float kMostShadowOutside = 2.0f;  // x or y, of w: beyond, a view does not see a point
SHARED_CONST float kMostShadowNumber = 1e18f;  // w and depths up to here; beyond, it does not either
SHARED_CONST float kLeastShadowFacing = 0.03125f;  // sine of the angle between light and plane below which slopes fade
SHARED_CONST float kShadowSnap = 0.00390625f;      // texels that a stored depth may be of a point beside, a tap's side

// What a frame has of them. Draws (DrawCommand, first_instance a caster) come in four ranges.
SHARED_CONST uint kShadowStill = 0u;  // of what never moves, drawn into the still depths
SHARED_CONST uint kShadowStillMasked = 1u;
SHARED_CONST uint kShadowMoving = 2u;  // of what may move, drawn over a copy of them
SHARED_CONST uint kShadowMovingMasked = 3u;
SHARED_CONST uint kShadowDraws = 4u;
struct ShadowCounts {
  uint width;  // of the atlas, texels; 0: no light casts shadows
  uint height;
  uint views;
  uint still_tiles;  // whose still depths are cleared and drawn in this frame
  uint tiles;        // that are copied from the still depths, and moving things drawn over
  uint casters;
  uint draw_first[kShadowDraws + 1];
};

#ifdef __cplusplus
SHARED_LAYOUT(ShadowTile, x, y, side);
SHARED_LAYOUT(ShadowCaster, clip_x, clip_y, clip_z, clip_w, tile, material);
SHARED_LAYOUT(ShadowView, clip_x, clip_y, clip_z, clip_w, tile, bias);
SHARED_LAYOUT(ShadowCounts, width, height, views, still_tiles, tiles, casters, draw_first);
#endif
SHARED_END
#endif
