// The default, which texturing may also have inline.
#include "harness/glsl/interpolation/compensated.glsl"

Interpolated interpolate(Triangle t) { return interpolate_compensated(t); }
