// What a particle's vertices tell its fragments, all six the same. SIDE is in or out.
#ifndef PARTICLES_PASSED
#define PARTICLES_PASSED
// With the ray of a pixel: dot(row_x, ray) / dot(normal, ray) is its place along `right` where it meets the quad's
// plane, likewise row_y along `up`, and centre_normal / dot(normal, ray) its view depth.
layout(location = 0) flat SIDE vec3 row_x;
layout(location = 1) flat SIDE vec3 row_y;
layout(location = 2) flat SIDE vec3 normal;
layout(location = 3) flat SIDE float centre_normal;
layout(location = 4) flat SIDE vec3 albedo;
layout(location = 5) flat SIDE vec2 opacity_softness;
layout(location = 6) flat SIDE uvec2 entry_particle;  // its place in the order, its record
#endif
