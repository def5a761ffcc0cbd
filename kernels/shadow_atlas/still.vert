#version 460
#include "harness/glsl/ports.glsl"
#include "kernels/shadow_atlas/layout.h"
#define TILES still_tiles
#define TILE_COUNT params.shadows.still_tiles
#include "kernels/shadow_atlas/caster.glsl"

void main() { place(caster(), vertex_index()); }
