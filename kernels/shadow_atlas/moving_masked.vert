#version 460
#include "harness/glsl/ports.glsl"
#include "kernels/shadow_atlas/layout.h"
#define TILES tiles
#define TILE_COUNT params.shadows.tiles
#include "kernels/shadow_atlas/caster_masked.glsl"
