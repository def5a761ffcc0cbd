// One group a tile: each thread ORs every THREADS-th pixel of it, so that neighbouring lanes read neighbouring pixels.
layout(constant_id = 0) const uint THREADS = 64u;  // divides the tile's 1024 pixels
layout(local_size_x_id = 0) in;
READS(0, uint, features);
WRITES(1, uint, masks);
PARAMS(ClassifyParams);

uint bits_of_thread(uint tile, uvec2 extent) {
  uint bits = 0u;
  for (uint i = gl_LocalInvocationID.x; i < kTileSide * kTileSide; i += THREADS) {
    const uvec2 at = pixel_of_tile(tile, i, extent.x);
#ifdef MUTANT_3  // one column too many: the next row's first pixel
    if (at.x <= extent.x && at.y < extent.y) bits |= features[at.y * extent.x + at.x];
#else
    if (on_screen(at, extent)) bits |= features[at.y * extent.x + at.x];
#endif
  }
  return bits;
}
