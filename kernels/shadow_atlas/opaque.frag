#version 460
#include "kernels/shadow_atlas/bounds.glsl"

void main() {
  if (is_beside_tile()) discard;
}
