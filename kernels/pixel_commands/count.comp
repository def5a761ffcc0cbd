#version 460
// A group a tile: the pixels and waves of each shader in it. Scans and offsets come later.
#include "kernels/pixel_commands/common.glsl"
#include "kernels/pixel_commands/pixels.glsl"
#include "kernels/pixel_commands/table.glsl"
#include "kernels/pixel_commands/groups.glsl"
#include "kernels/pixel_commands/count.glsl"

void main() { count_tile(this_tile()); }
