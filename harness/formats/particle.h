// Particles, and where in the light atlas each has its light (Sousa, Geffroy 2016, Decoupled Particle Lighting).
#ifndef FORMATS_PARTICLE_H
#define FORMATS_PARTICLE_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

// A quad: centre +- right +- up. Its number is the same in every frame.
struct ParticleRecord {
  vec3 centre;     // relative to the camera, metres
  float opacity;   // in the middle, 0..1; falls to 0 towards the rim
  vec3 right;      // half axes, metres; what velocity stretches is in them
  float softness;  // metres before a surface over which it fades; 0: it does not
  vec3 up;
  float quality;  // times its size on the screen, for the resolution of its light; 0: not lit, not drawn
  vec3 albedo;    // linear
};

// Opacity and quality below this are none: devices may take denormal ones for 0.
SHARED_CONST float kLeastShown = 1e-30f;

// A particle's rectangle in the atlas, one word: where, in blocks of 8x8 texels, and how large.
SHARED_CONST uint kLightBlockSide = 8u;
SHARED_CONST uint kRectXBits = 0x1ffu;   // bits 0..8: x / 8
SHARED_CONST uint kRectYShift = 9u;      // bits 9..17: y / 8
SHARED_CONST uint kRectSizeShift = 18u;  // bits 18..19: 0 none, else side = 4 << size: 8, 16, 32
SHARED_CONST uint kRectSizes = 3u;
SHARED_CONST uint kNoRect = 0u;

// Texel (i, j) of a rectangle has the light of the quad at centre + ((2 i + 1) / side - 1) right
// + ((2 j + 1) / side - 1) up.

// The atlas is square, of regions one below the other: first rectangles of 32x32, then of 16x16, then of 8x8.
SHARED_CONST uint kMostAtlasSide = 4096u;
struct ParticleAtlas {
  uint side;              // texels, a multiple of 32, at most 4096
  uint rows[kRectSizes];  // texels that the regions are high: of 8x8, 16x16, 32x32; multiples of their rectangles' side
};

// What is to be lit, 8x8 texels a word: a particle, and which block of its rectangle, row by row.
SHARED_CONST uint kMostParticles = 131072u;
SHARED_CONST uint kLightBlockBits = 4u;    // the block's; the particle's are above
SHARED_CONST uint kLightGroupBlocks = 4u;  // blocks that a group lights, a thread a texel

struct ParticleRectCounts {
  uint blocks;   // to be lit
  uint lit;      // particles that have a rectangle
  uint smaller;  // of those, whose is smaller than wanted
  uint dropped;  // that want one and have none
};

// How the radiance is stored (variants of particle_light_atlas).
SHARED_CONST uint kLightR11G11B10 = 0u;
SHARED_CONST uint kLightRgb9e5 = 1u;
SHARED_CONST uint kLightRgba16 = 2u;

struct ParticleCounts {
  uint particles;  // records, those that are not seen included
  uint drawn;      // entries of their order, farthest first
};

#ifdef __cplusplus
SHARED_LAYOUT(ParticleRecord, centre, opacity, right, softness, up, quality, albedo);
SHARED_LAYOUT(ParticleAtlas, side, rows);
SHARED_LAYOUT(ParticleRectCounts, blocks, lit, smaller, dropped);
SHARED_LAYOUT(ParticleCounts, particles, drawn);
#endif
SHARED_END
#endif
