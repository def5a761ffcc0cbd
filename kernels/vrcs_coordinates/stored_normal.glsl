// Pixels share whose triangles' normals are close, as a pass has stored them: octahedral, RG16_SNORM.
#include "kernels/vrcs_coordinates/normals.glsl"

layout(binding = 8) uniform texture2D face_normals;

// Codes are whole numbers once scaled back, whichever way the device rounds c / 32767. |x| + |y| + |z| is 32767.
ivec3 stored_normal(uvec2 pixel) {
  const ivec2 p = ivec2(round(texelFetch(face_normals, ivec2(pixel), 0).xy * 32767.0));
  const int z = 32767 - abs(p.x) - abs(p.y);
#ifdef MUTANT_17  // the lower half stays folded
  return ivec3(p, z);
#else
  if (z >= 0) return ivec3(p, z);
  const ivec2 folded = 32767 - abs(p.yx);
  return ivec3(p.x < 0 ? -folded.x : folded.x, p.y < 0 ? -folded.y : folded.y, z);
#endif
}

void prepare_sharing(uint tile) {}

bool shares_across(Cell cell, uint a, uint b) {
  if (!close_depths(cell.depth[a], cell.depth[b])) return false;
  return close_normals(stored_normal(cell.first + offset_of(a)), stored_normal(cell.first + offset_of(b)));
}
