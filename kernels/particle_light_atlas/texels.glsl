// After add_lights(): a thread a texel, an encoding's store_radiance().
void main() {
  const Texel t = texel_of_thread();
  Lit lit;
  lit.towards = vec3(0.0);
  if (t.is_one) lit = start(t);
  add_lights(lit, t);
  if (t.is_one) store_radiance(t.at, lit.radiance);
  store_direction(t, lit.towards);
}
