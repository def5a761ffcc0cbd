// One pixel an invocation, packed.
#include "kernels/attribute_interpolation/pack.glsl"
WRITES(6, uint, barycentrics);
WRITES(7, uvec2, derivatives);
WRITES(8, uvec2, tangent_frame);

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= params.width || pixel.y >= params.height) return;
  const uint at = pixel.y * params.width + pixel.x;
  Shown t;
  if (!triangle_at(pixel, t)) {
    barycentrics[at] = 0u;
    derivatives[at] = uvec2(0u);
    tangent_frame[at] = uvec2(0u);
    return;
  }
  const Interpolated i = interpolate(t.triangle);
  const TangentFrame f = frame_at(t, i.weights);
  barycentrics[at] = pack_barycentrics(i.weights);
  derivatives[at] = pack_derivatives(i.derivatives, flags_of(i, t.flipped, f));
  tangent_frame[at] = uvec2(pack_direction(f.normal), pack_direction(f.tangent));
}
