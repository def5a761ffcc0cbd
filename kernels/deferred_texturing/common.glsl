// What every texturing shader reads: from a pixel to the material that it shows.
#ifndef DEFERRED_TEXTURING_COMMON
#define DEFERRED_TEXTURING_COMMON
#include "harness/glsl/ports.glsl"
#include "harness/formats/visibility.h"
#include "kernels/deferred_texturing/layout.h"

layout(binding = 0) uniform utexture2D visibility;
READS(1, SurfaceRecord, surfaces);
READS(2, MaterialRecord, materials);
PARAMS(TexturingParams);

#ifdef MUTANT_1  // the last column is left out
bool on_screen(uvec2 pixel) { return pixel.x + 1u < params.width && pixel.y < params.height; }
#else
bool on_screen(uvec2 pixel) { return pixel.x < params.width && pixel.y < params.height; }
#endif
uint pixel_number(uvec2 pixel) { return pixel.y * params.width + pixel.x; }

// A surface at or above the count is none.
struct Visible {
  uint triangle;
  uint surface;
  bool flipped;  // the surface's transform mirrors
};
Visible visible_at(uvec2 pixel) {
  const uvec2 shown = texelFetch(visibility, ivec2(pixel), 0).xy;
#ifdef MUTANT_2  // the instanced flag counts as part of the surface
  const uint surface = shown.y & ~kVisibilityFlipped;
#else
  const uint surface = shown.y & kVisibilitySurfaceMask;
#endif
  return Visible(shown.x, surface, (shown.y & kVisibilityFlipped) != 0u);
}

// What textures a surface; shader is kUnregistered where nothing does: a surface, material or class that there is not.
struct Look {
  uint material;
  uint shader;
};
Look look_of(uint surface) {
#ifdef MUTANT_3  // one surface too many, the last again
  if (surface > params.surfaces) return Look(kNoMaterial, kUnregistered);
  const uint material = surfaces[min(surface, params.surfaces - 1u)].material;
#else
  if (surface >= params.surfaces) return Look(kNoMaterial, kUnregistered);
  const uint material = surfaces[surface].material;
#endif
  if (material >= params.materials) return Look(kNoMaterial, kUnregistered);
  const uint shader = materials[material].shader;
  const bool is_visible = shader < kShaderClasses && params.slot_of_class[shader] != kUnregistered;
  return Look(material, is_visible ? shader : kUnregistered);
}
#endif
