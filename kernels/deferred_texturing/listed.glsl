// A shader class over its pixel commands. The includer says which, SHADER_CLASS, and what of classes.glsl it needs, and
// defines ONE_SURFACE where it is dispatched over waves of one surface only, INTERPOLATES where nobody stored attributes.
#include "kernels/deferred_texturing/shade.glsl"
#include "harness/formats/pixel_commands.h"
layout(constant_id = 0) const uint FIRST_ROW = 0u;  // of the slot's rows, the first that the pass is dispatched for
READS(14, uint, entries);
READS(15, uint, commands);
READS(16, CommandRow, command_rows);
layout(push_constant) uniform row_block { uint row_of_pass; };
#ifdef ONE_SURFACE
#define row row_of_pass
#else
#define row (FIRST_ROW + row_of_pass)
#endif
#define PIXEL_ENTRIES entries
#define PIXEL_COMMANDS commands
#define PIXEL_COMMAND_ROWS command_rows
#define PIXEL_SHADER_SLOT params.slot_of_class[SHADER_CLASS]
#include "harness/glsl/pixel_commands.glsl"

// Where a pixel's result also goes under variable-rate shading (Fuller, Hammer 2025): its neighbours in the 2x2 quad.
void store_copies(uvec2 pixel, uint copy_bits, GBufferTexel t, uint bits) {
#ifdef MUTANT_27  // copies go right and down, not to the quad
  const uvec2 other = pixel + 1u;
#else
  const uvec2 other = pixel ^ 1u;
#endif
#ifdef MUTANT_28  // a copy beyond the edge is the next row's
  if ((copy_bits & kCopyHorizontal) != 0u) store(uvec2(other.x, pixel.y), t, bits);
#else
  if ((copy_bits & kCopyHorizontal) != 0u && other.x < params.width) store(uvec2(other.x, pixel.y), t, bits);
#endif
  if ((copy_bits & kCopyVertical) != 0u && other.y < params.height) store(uvec2(pixel.x, other.y), t, bits);
  if ((copy_bits & kCopyDiagonal) != 0u && on_screen(other)) store(other, t, bits);
}

void main() {
  uvec2 pixel;
  uint copy_bits;
  if (!commanded_pixel(pixel, copy_bits) || !on_screen(pixel)) return;
  Visible visible = visible_at(pixel);
  if (visible.surface >= params.surfaces) return;
#if defined(ONE_SURFACE) || defined(MUTANT_25)  // all waves taken for uniform
  visible.surface = equal_in_wave(visible.surface);
#endif
  const Look look = look_of(visible.surface);
#ifdef MUTANT_26  // another class's pixels are textured as this one's
  if (look.shader == kUnregistered) return;
#else
  if (look.shader != SHADER_CLASS) return;  // a stale entry
#endif
  const MaterialRecord m = materials[look.material];
  const SurfaceRecord s = surfaces[visible.surface];
  const SurfaceAttributes a = attributes_at(pixel, visible, s);
  const Footprint f = footprint_of(s, visible.triangle, a);
  const Layer l = layer_of_class(SHADER_CLASS, m, f, visible.surface);
  const GBufferTexel t = texel_of(l, a, is_seen_from_both_sides(m));
  store(pixel, t, m.features);
  if (copy_bits != 0u) store_copies(pixel, copy_bits, t, m.features);
}
