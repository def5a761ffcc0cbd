#version 460
// The end of the scale that errs least: lit at each fragment.
#include "kernels/particles/fragment.glsl"
#include "kernels/particles/lit.glsl"

vec3 light_at(Place p) { return lit(particles[entry_particle.y], p.position); }
