// Every pixel is shaded. The includer says by which lights: add_lights().
layout(local_size_x = 16, local_size_y = 16) in;

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel)) return;
  const float d = depth_at(pixel);
  if (d == 0.0) {
    store_background(pixel);
    return;
  }
  Lit lit = start(pixel, d);
  add_lights(lit, pixel, d);
  store(pixel, texel_of(lit.radiance));
}
