// One pixel an invocation, as it was worked out: for judging the arithmetic apart from the storage.
WRITES(6, UnpackedAttributes, unpacked);

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= params.width || pixel.y >= params.height) return;
  const uint at = pixel.y * params.width + pixel.x;
  Shown t;
  if (!triangle_at(pixel, t)) {
    unpacked[at] = UnpackedAttributes(vec3(0), vec4(0), vec3(0), vec3(0));
    return;
  }
  const Interpolated i = interpolate(t.triangle);
  const TangentFrame f = frame_at(t, i.weights);
  unpacked[at] = UnpackedAttributes(i.weights, i.derivatives, f.normal, f.tangent);
}
