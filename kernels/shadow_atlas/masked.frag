#version 460
#include "harness/glsl/ports.glsl"
#include "kernels/shadow_atlas/layout.h"
#include "harness/glsl/cut.glsl"
#include "kernels/shadow_atlas/bounds.glsl"

layout(location = 1) flat in uint material;
layout(location = 2) in vec2 uv;

void main() {
  if (is_beside_tile() || is_hole(material, uv)) discard;
}
