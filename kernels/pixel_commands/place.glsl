// Where each shader's share of a tile's list goes: to whole waves, or to its overflow.
shared uint tile_pixels[kMaxShaders];     // of a shader
shared uint tile_waves[kMaxShaders];      // as TileCommands.waves
shared uint pixels_below[kMaxShaders];    // in the list before the shader's
shared uint waves_below[kMaxShaders];     // likewise, in whole waves
shared uint first_wave[kMaxShaders];      // in wave_materials; kNowhere where the tile is not padded
shared uint first_overflow[kMaxShaders];  // in entries; kNowhere where there is no room

// Pixels of the shader's overflow that are of tiles below.
uint overflow_before(uint shader, uint tile) {
  const uint all = tile_count(extent());
#ifdef MUTANT_19  // the pixels of the padded tiles leave a hole
  return tiles[shader * all + tile].pixels_before;
#else
  return tiles[shader * all + tile].pixels_before - tiles[shader * all + shaders[shader].padded_tiles].pixels_before;
#endif
}

// What remains of the room where a tile's overflow found too little: consumers read it.
void fill_rest(uint shader, uint before, uint room) {
  atomicAdd(status[0].lost, tile_pixels[shader]);
  for (uint i = before; i < room; ++i) entries[(shaders[shader].overflow_first << wave_log2()) + i] = kEntryInvalid;
}

// The share is written whole or not at all.
void place_overflow(uint shader, uint tile) {
  const uint first = shaders[shader].overflow_first;
  const uint room = params.waves - min(first, params.waves) << wave_log2();  // to the end of the entries
  const uint before = overflow_before(shader, tile);
#ifdef MUTANT_24  // it is enough that its first pixel finds room
  const bool fits = before < room;
#else
  const bool fits = before + tile_pixels[shader] <= room;
#endif
  if (fits)
    first_overflow[shader] = (first << wave_log2()) + before;
  else
    fill_rest(shader, before, room);
}

void load_sums(uint tile) {
  for (uint s = gl_LocalInvocationID.x; s < shader_slots(); s += THREADS) {
    const TileCommands sums = tiles[s * tile_count(extent()) + tile];
    tile_pixels[s] = sums.pixels;
    tile_waves[s] = sums.waves;
    first_wave[s] = tile < shaders[s].padded_tiles ? shaders[s].first + sums.waves_before : kNowhere;
    first_overflow[s] = kNowhere;
  }
}

// After load_sums() and a barrier.
void place_shaders(uint tile) {
  for (uint s = gl_LocalInvocationID.x; s < shader_slots(); s += THREADS) {
    uint pixels = 0u, waves = 0u;
    for (uint below = 0u; below < s; ++below) {
      pixels += tile_pixels[below];
      waves += (tile_waves[below] & 0xffffu) + (tile_waves[below] >> 16u);
    }
    pixels_below[s] = pixels;
    waves_below[s] = waves;
    if (tile_pixels[s] > 0u && first_wave[s] == kNowhere) place_overflow(s, tile);
  }
}
