#version 460
// A thread a run of pixels: neighbours mostly show the same triangle of the same surface, so what was looked up for the
// pixel before is kept while the visibility stays the same (except in the tile view, where the pixel matters too).
#include "kernels/debug_view/paint.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

void main() {
  const uint first = gl_GlobalInvocationID.x * kRunPixels;
  const uint y = gl_GlobalInvocationID.y;
  if (!on_screen(uvec2(first, y), uvec2(params.width, params.height))) return;
  const uint end = min(first + kRunPixels, params.width);
  uvec2 before = visible_at(uvec2(first, y));
  uint colour = colour_of(before);
  for (uint x = first; x < end; ++x) {
    const uvec2 visible = visible_at(uvec2(x, y));
#if defined(MUTANT_8)
    if (visible.y != before.y) {
#elif defined(MUTANT_9)
    if (visible.x != before.x) {
#else
    if (visible != before) {
#endif
      colour = colour_of(visible);
      before = visible;
    }
    image[y * params.width + x] = colour;
  }
}
