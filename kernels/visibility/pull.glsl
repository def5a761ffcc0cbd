// What the vertex shaders share: which vertex of which surface, and where it is.
#ifndef VISIBILITY_PULL
#define VISIBILITY_PULL
#include "harness/glsl/clip.glsl"
READS(0, vec3, positions);
READS(1, SurfaceRecord, surfaces);
PARAMS(VisibilityParams);

uint vertex_index() { return clamped(uint(gl_VertexIndex), params.scene.vertices); }

// gl_InstanceIndex begins at the command's first_instance, so it is the surface itself.
uint surface_index() {
#ifdef MUTANT_1
  return clamped(uint(gl_BaseInstance), params.scene.surfaces);
#else
  return clamped(uint(gl_InstanceIndex), params.scene.surfaces);
#endif
}

// Clip z is the near distance for every vertex: depth is near / w, reversed, and the far plane is at infinity.
vec4 clip_position(uint surface, uint vertex) {
  vec3 p = positions[vertex];
#ifdef MUTANT_2
  float y = along(surfaces[surface].clip_x, p);
#else
  float y = along(surfaces[surface].clip_y, p);
#endif
#ifdef MUTANT_3
  float z = 0.999 * params.near_plane;
#else
  float z = params.near_plane;
#endif
  return vec4(along(surfaces[surface].clip_x, p), y, z, along(surfaces[surface].clip_w, p));
}

// The second word of the visibility buffer.
uint surface_word(uint surface) {
  uint flags = surfaces[surface].flags;
#ifdef MUTANT_4
  uint instanced = (flags & kSurfaceFlipped) != 0u ? kVisibilityInstanced : 0u;
#else
  uint instanced = (flags & kSurfaceInstanced) != 0u ? kVisibilityInstanced : 0u;
#endif
#ifdef MUTANT_5
  uint flipped = 0u;
#else
  uint flipped = (flags & kSurfaceFlipped) != 0u ? kVisibilityFlipped : 0u;
#endif
  return (surface & kVisibilitySurfaceMask) | instanced | flipped;
}
#endif
