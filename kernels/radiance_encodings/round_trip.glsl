// A thread a colour: its code, and what the code is read as. The includer says how: encoded() and decoded().
#include "harness/glsl/ports.glsl"
#include "kernels/radiance_encodings/layout.h"
#include "harness/glsl/tiles.glsl"

layout(local_size_x = 256) in;
READS(0, vec3, colours);
WRITES(1, uvec2, codes);
WRITES(2, vec3, decoded);
PARAMS(EncodingParams);

void main() {
  const uint i = spread_group() * 256u + gl_LocalInvocationID.x;
  if (i >= params.colours) return;
  const uvec2 code = encode(colours[i]);
  codes[i] = code;
  decoded[i] = decode(code);
}
