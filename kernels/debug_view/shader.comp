#version 460
// The shader view: which of the visible shader classes textures a pixel. A thread a pixel.
#include "kernels/debug_view/common.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
READS(4, SurfaceSlot, surface_slots);
READS(5, uint, shader_colours);

uint shader_colour(uvec2 visible) {
  if (is_nothing(visible)) return kBackgroundColour;
  const uint surface = visible.y & kVisibilitySurfaceMask;
  if (surface >= params.surfaces) return kBrokenColour;
#ifdef MUTANT_15  // the material's slot taken for the shader's
  const uint slot = surface_slots[surface].material;
#else
  const uint slot = surface_slots[surface].shader;
#endif
#ifdef MUTANT_16  // > for >= : the slot behind the last one is no slot
  if (slot > params.shaders) return kBrokenColour;
  return shader_colours[min(slot, params.shaders - 1u)] | 0xff000000u;
#else
  if (slot >= params.shaders) return kBrokenColour;
  return shader_colours[slot] | 0xff000000u;
#endif
}

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel, uvec2(params.width, params.height))) return;
  image[pixel.y * params.width + pixel.x] = shader_colour(visible_at(pixel));
}
