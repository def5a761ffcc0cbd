#version 460
#include "harness/glsl/ports.glsl"

layout(local_size_x = 64) in;
WRITES(0, uint, unused);
layout(constant_id = 0) const uint NEVER = 0;

// The store is never taken but keeps the port alive.
void main() {
  if (NEVER != 0u) unused[0] = 1u;
}
