#version 460
#include "kernels/particle_rects/list.glsl"

void main() { list(3u); }
