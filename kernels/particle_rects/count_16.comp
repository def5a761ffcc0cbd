#version 460
#include "kernels/particle_rects/count.glsl"

void main() { count(2u); }
