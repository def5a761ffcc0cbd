#version 460
#include "harness/glsl/ports.glsl"
#include "tests/planted/device_draw/layout.h"
// Slot 0 is another port's in the vertex shader: slots are a shader's own.
UPDATES(0, uint, fragments);
layout(location = 0) flat in uint instance;
layout(location = 0) out uint colour;

void main() {
  atomicAdd(fragments[0], 1);
  colour = instance | (gl_FrontFacing ? kFrontBit : 0);
}
