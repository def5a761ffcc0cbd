// Clip coordinates from rows, for every shader that places vertices.
#ifndef HARNESS_GLSL_CLIP
#define HARNESS_GLSL_CLIP
// Indices past the end read the last record, so that a broken index buffer draws a wrong triangle but reads nothing that
// is not the scene's.
uint clamped(uint i, uint count) { return min(i, max(count, 1u) - 1u); }

// `precise` forbids the compiler to fuse or reorder, so that every vertex shader of every variant puts a vertex in the
// same place; `invariant gl_Position` promises no more, and Mesa 22.3 warns of its decoration.
float along(vec4 row, vec3 p) {
  precise float sum = row.x * p.x + row.y * p.y + row.z * p.z + row.w;
  return sum;
}
#endif
