#version 460
#include "harness/glsl/ports.glsl"
layout(local_size_x = 1) in;
UPDATES(0, uint, rows);
ROW();

void main() { atomicAdd(rows[row], 1); }
