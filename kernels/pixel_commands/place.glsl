// Where a tile's groups lie in the lists, and what of them is written group by group. The includer has filled the table.
#include "kernels/pixel_commands/groups.glsl"

WRITES(6, uint, entries);
READS(3, TileCommands, tiles);
READS(4, ShaderCommands, shaders);
WRITES(8, WaveMaterial, wave_materials);
UPDATES(9, CommandStatus, status);
#if defined(PER_TILE)
WRITES(7, DispatchArgs, tile_args);
#elif !defined(STABLE)
#include "kernels/pixel_commands/commands.glsl"
#endif

shared uint group_wave[kTilePixels];  // a used slot: first wave of its group; kNowhere unless it is padded

const uint kNowhere = 0xffffffffu;
shared uint place_at[kTilePixels];  // a slot: entry of its first pixel; kNowhere where there is no room

#ifdef STABLE  // pixels stand in scan order, whatever their surface
uint place_in_group(uint i) { return 0u; }
#else
#include "kernels/pixel_commands/within.glsl"
#endif

struct Before {  // of the groups of the same shader in the same tile
  uint waves, pixels;
};

// Uniform groups before divergent ones, each ascending by material.
bool comes_before(uint j, uint i) {
  const uint divergent_j = group_at[j] & kGroupDivergent, divergent_i = group_at[i] & kGroupDivergent;
#ifdef MUTANT_18  // by material alone: uniform and divergent waves mixed
  return key_at[j] < key_at[i];
#else
  return divergent_j != divergent_i ? divergent_j < divergent_i : key_at[j] < key_at[i];
#endif
}

Before groups_before(uint i) {
  Before before = Before(0u, 0u);
  for (uint j = 0u; j < used; ++j) {
    const uint group = group_at[j];
    if ((group & kGroupLeader) == 0u || key_at[j] == kUnlisted || shader_of(key_at[j]) != shader_of(key_at[i]))
      continue;
    if (!comes_before(j, i)) continue;
    before.waves += waves_of(group_pixels(group));
    before.pixels += group_pixels(group);
  }
  return before;
}

// The tile's share of the shader's overflow: pixels of it that come before.
uint overflow_before(uint shader, uint tile) {
  const uint all = tile_count(extent());
#ifdef MUTANT_19  // the pixels of the padded tiles leave a hole
  return tiles[shader * all + tile].pixels_before;
#else
  return tiles[shader * all + tile].pixels_before - tiles[shader * all + shaders[shader].padded_tiles].pixels_before;
#endif
}
// Entries from where the shader's overflow begins to the end of the lists.
uint overflow_room(uint shader) {
  return params.waves - min(shaders[shader].overflow_first, params.waves) << wave_log2();
}
// The share is written whole or not at all.
bool has_room(uint shader, uint tile) {
#ifdef MUTANT_24  // it is enough that its first pixel finds room
  return overflow_before(shader, tile) < overflow_room(shader);
#endif
  return overflow_before(shader, tile) + shader_pixels[shader] <= overflow_room(shader);
}
uint overflow_entry(uint shader, uint tile) {
  return (shaders[shader].overflow_first << wave_log2()) + overflow_before(shader, tile);
}

void place_group(uint i, uint tile) {
  const uint key = key_at[i], slot = used_slots[i];
  group_wave[i] = kNowhere;
  place_at[slot] = kNowhere;
  if (key == kUnlisted) {
    atomicAdd(status[0].unlisted, pixels_at[slot]);
    return;
  }
  const uint shader = shader_of(key);
  const Before before = groups_before(i);
  const uint within = place_in_group(i);
  if (tile < shaders[shader].padded_tiles) {
    const uint at = shader * tile_count(extent()) + tile;
    group_wave[i] = shaders[shader].first + tiles[at].waves_before + before.waves;
    place_at[slot] = (group_wave[i] << wave_log2()) + within;
  } else if (has_room(shader, tile)) {
    place_at[slot] = overflow_entry(shader, tile) + before.pixels + within;
  }
}

// Followed by a barrier.
void place_groups(uint tile) {
  group_surfaces();
  for (uint i = gl_LocalInvocationID.x; i < used; i += THREADS) place_group(i, tile);
}

// Fills the last wave of each group up, and says which material its waves have. A wave's lanes each, side by side.
void write_waves(uint tile) {
  for (uint work = gl_LocalInvocationID.x; work < used << wave_log2(); work += THREADS) {
    const uint i = work >> wave_log2(), lane = work & wave_size() - 1u;
    const uint group = group_at[i], first = group_wave[i];
    if (first == kNowhere || (group & kGroupLeader) == 0u) continue;
    const uint pixels = group_pixels(group), waves = waves_of(pixels);
#ifdef MUTANT_21  // a full last wave is followed by one of padding
    const uint end = (pixels >> wave_log2()) + 1u << wave_log2();
#else
    const uint end = waves << wave_log2();
#endif
    if (pixels + lane < end) entries[(first << wave_log2()) + pixels + lane] = kEntryInvalid;
    for (uint w = lane; w < waves; w += wave_size())
      wave_materials[first + w] = WaveMaterial(material_of(key_at[i]), first);
  }
}

// What remains of the room where a tile's overflow found too little: consumers read it.
void fill_rest(uint shader, uint tile) {
  atomicAdd(status[0].lost, shader_pixels[shader]);
  for (uint i = overflow_before(shader, tile); i < overflow_room(shader); ++i)
    entries[(shaders[shader].overflow_first << wave_log2()) + i] = kEntryInvalid;
}

#ifdef PER_TILE
void dispatch_tile(uint shader, uint tile) {
  const uint at = shader * tile_count(extent()) + tile;
  const bool padded = tile < shaders[shader].padded_tiles;
  for (uint kind = 0u; kind < 2u; ++kind) {
#ifdef MUTANT_32  // the overflow's waves are dispatched by tile too
    const uint waves = shader_waves[shader] >> 16u * kind & 0xffffu;
#else
    const uint waves = padded ? shader_waves[shader] >> 16u * kind & 0xffffu : 0u;
#endif
    tile_args[at * 2u + kind] = DispatchArgs(ceil_div(waves, 1u << waves_per_group_log2()), 1u, 1u);
  }
}
#endif

void write_commands(uint tile) {
  for (uint s = gl_LocalInvocationID.x; s < shader_slots(); s += THREADS) {
#ifdef PER_TILE
    dispatch_tile(s, tile);
#endif
    if (shader_pixels[s] == 0u) continue;
    if (tile < shaders[s].padded_tiles) {
#if !defined(STABLE) && !defined(PER_TILE)
      const uint first = shaders[s].first + tiles[s * tile_count(extent()) + tile].waves_before;
      command_waves(s, kUniformLists, first, shader_waves[s] & 0xffffu);
      command_waves(s, kDivergentLists, first + (shader_waves[s] & 0xffffu), shader_waves[s] >> 16u);
#endif
    } else if (!has_room(s, tile)) {
      fill_rest(s, tile);
    }
  }
}
