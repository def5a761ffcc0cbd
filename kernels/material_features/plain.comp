#version 460
// Each pixel follows its own indices: visibility -> surface -> material.
#include "kernels/material_features/common.glsl"

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel)) return;
  store(pixel, features_of(surface_at(pixel)));
}
