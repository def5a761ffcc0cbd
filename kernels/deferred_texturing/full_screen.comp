#version 460
// What the lists replace: every pixel takes its class's branch, and a wave with several classes takes them all.
#define HAS_EVERY_CLASS
#include "kernels/deferred_texturing/shade.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel)) return;
  const uvec2 visible = visible_at(pixel);
  const Look look = look_of(visible.y);
  if (look.shader == kUnregistered) {
    store_nothing(pixel);
    return;
  }
  const MaterialRecord m = materials[look.material];
  const SurfaceAttributes a = attributes_at(pixel);
  const Footprint f = footprint_of(surfaces[visible.y], visible.x, a);
  store(pixel, texel_of(layer_of_class(look.shader, m, f, visible.y), a, is_seen_from_both_sides(m)), m.features);
}
