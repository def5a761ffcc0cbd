#version 460
#include "kernels/particle_rects/place.glsl"

void main() { place_all(2u); }
