#version 460
// The formula that the boundaries come from, as shaders usually have it: two roundings and a logarithm move them.
#include "kernels/cluster_slices/common.glsl"

uint slice_at(float d) {
  const float z = params.near_plane / max(d, 0.0);
  const float slices = float(params.grid.slices);
  const float at = log2(z / params.first_slice) * (slices / log2(params.last_slice / params.first_slice));
  return uint(clamp(at, 0.0, max(slices - 1.0, 0.0)));
}
