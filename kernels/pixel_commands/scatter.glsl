// A group a tile: its list in waves to where the scan has found room, a wave's lanes side by side, its last filled up.
// The tiles are walked backwards, so that what the count wrote last, and the cache may still hold, is read first.
#include "kernels/pixel_commands/common.glsl"

layout(constant_id = 0) const uint THREADS = 64u;  // at least kStartWords
layout(local_size_x_id = 0) in;
layout(constant_id = 2) const uint ABREAST = 8u;  // threads that write a wave side by side: 8 fill a sector of 32 bytes
READS(3, TileCommands, tiles);
READS(4, ShaderCommands, shaders);
WRITES(6, uint, entries);
WRITES(8, WaveMaterial, wave_materials);
UPDATES(9, CommandStatus, status);
READS(10, uint, tile_lists);
READS(11, uint, tile_groups);
#include "kernels/pixel_commands/tile_list.glsl"
#include "kernels/pixel_commands/group_starts.glsl"
#include "kernels/pixel_commands/place.glsl"
#include "kernels/pixel_commands/list_waves.glsl"
#if defined(PER_TILE)
#include "kernels/pixel_commands/tile_dispatch.glsl"
#elif defined(STABLE)
void write_commands(uint tile) {}  // commands_stable.comp has them
#else
#include "kernels/pixel_commands/commands.glsl"
#endif

void load_starts(uint tile) {
  for (uint w = gl_LocalInvocationID.x; w < kStartWords; w += THREADS)
    group_starts[w] = tile_groups[tile * kTileWords + w];
  if (gl_LocalInvocationID.x != 0u) return;
  const uint unlisted = tile_groups[tile * kTileWords + kUnlistedWord];
  if (unlisted > 0u) atomicAdd(status[0].unlisted, unlisted);
  words_with_starts = tile_groups[tile * kTileWords + kWordsWithStarts];
  listed = tile_groups[tile * kTileWords + kListedWord];
}

// The pixel of a word of the list; `corner`: the tile's first.
uint entry_of_word(uint word, uvec2 corner) {
  return entry_of(corner + uvec2(word % kTileSide, word / kTileSide % kTileSide), word >> kListCopyShift & kCopyBits);
}

// Of each wave: its first entry; what its lanes write.
shared uint entry_at[kTilePixels];
shared uint lanes_at[kTilePixels];  // position of the first in bits 0..10, lanes with a pixel in 11..18, those that write
const uint kFilledShift = 11u, kWrittenShift = 19u;

void place_wave(uint tile, uint wave) {
  const uint first = wave_position(wave), filled = wave_position(wave + 1u) - first;
  const uint key = tile_lists[tile * kTilePixels + first] >> kListKeyShift & (1u << kKeyBits) - 1u;
  const uint shader = shader_of(key);
  const bool padded = first_wave[shader] != kNowhere;
#ifdef MUTANT_40  // the waves of lower shaders leave a hole
  const uint to = first_wave[shader] + wave;
#else
  const uint to = first_wave[shader] + wave - waves_below[shader];
#endif
#ifdef MUTANT_41  // the pixels of lower shaders leave a hole
  const uint overflow = first_overflow[shader] + first;
#else
  const uint overflow = first_overflow[shader] + first - pixels_below[shader];
#endif
#ifdef MUTANT_21  // the last wave of a group is not filled up
  const uint written = first_overflow[shader] == kNowhere && !padded ? 0u : filled;
#else
  const uint written = padded ? wave_size() : first_overflow[shader] == kNowhere ? 0u : filled;
#endif
  entry_at[wave] = padded ? to << wave_log2() : overflow;
  lanes_at[wave] = first | filled << kFilledShift | written << kWrittenShift;
#ifdef MUTANT_39  // every wave begins a group
  const uint begun = to;
#else
  const uint begun = to - wave_number(wave);
#endif
  if (padded) wave_materials[to] = WaveMaterial(material_of(key), begun);
}

// Lanes past the end of a group write padding.
void write_entries(uint tile) {
  const uvec2 corner = pixel_of_tile(tile, 0u, params.width);
  const uint all = waves * ABREAST;
  for (uint i = gl_LocalInvocationID.x; i < all; i += THREADS) {
    const uint wave = i / ABREAST, lanes = lanes_at[wave], to = entry_at[wave];
    const uint written = lanes >> kWrittenShift, filled = lanes >> kFilledShift & 0xffu;
    const uint from = tile * kTilePixels + (lanes & bits_below(kFilledShift));
    for (uint lane = i % ABREAST; lane < written; lane += ABREAST) {
      const uint word = tile_lists[from + min(lane, filled - 1u)];
      entries[to + lane] = lane < filled ? entry_of_word(word, corner) : kEntryInvalid;
    }
  }
}

void main() {
  const uint tile = tile_count(extent()) - 1u - spread_group();
  if (tile >= tile_count(extent())) return;  // the whole group: past the end it wraps
  load_starts(tile);
  load_sums(tile);
  clear_waves();
  barrier();
  place_shaders(tile);
  list_waves();
  barrier();
  write_commands(tile);
  for (uint wave = gl_LocalInvocationID.x; wave < waves; wave += THREADS) place_wave(tile, wave);
#ifndef MUTANT_38  // the barrier dropped: waves that higher subgroups have yet to place
  barrier();
#endif
  write_entries(tile);
}
