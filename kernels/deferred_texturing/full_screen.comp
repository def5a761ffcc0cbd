#version 460
// What the lists replace: every pixel takes its class's branch, and a wave with several classes takes them all.
#define HAS_EVERY_CLASS
#include "kernels/deferred_texturing/shade.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel)) return;
  const Visible visible = visible_at(pixel);
  const Look look = look_of(visible.surface);
  if (look.shader == kUnregistered) {
    store_nothing(pixel);
    return;
  }
  const MaterialRecord m = materials[look.material];
  const SurfaceRecord s = surfaces[visible.surface];
  const SurfaceAttributes a = attributes_at(pixel, visible, s);
  const Footprint f = footprint_of(s, visible.triangle, a);
  const Layer l = layer_of_class(look.shader, m, f, visible.surface);
  store(pixel, texel_of(l, a, is_seen_from_both_sides(m)), m.features);
}
