#version 460
#include "tests/planted/check_targets/layout.h"

// One triangle over the whole screen.
void main() { gl_Position = vec4(4 * (gl_VertexIndex & 1) - 1, 4 * (gl_VertexIndex >> 1) - 1, kDepth, 1); }
