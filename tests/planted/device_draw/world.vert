#version 460
#include "harness/glsl/ports.glsl"
READS(0, vec3, positions);
layout(location = 0) flat out uint instance;

// The rows of a 90 degree camera: Vulkan's clip space has y down, the world y up.
void main() {
  const vec4 p = vec4(positions[gl_VertexIndex], 1);
  const float near = 0.25;
  gl_Position = vec4(p.x, -p.y, near, -p.z);
  instance = gl_InstanceIndex;
}
