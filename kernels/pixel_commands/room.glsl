// Which tiles' groups are padded: tiles are taken in order, shader by shader, while the padding so far leaves room for
// all pixels unpadded. So no pixel is lost where the capacity holds them all unpadded, and what is padded is a prefix.

#include "kernels/pixel_commands/sums.glsl"

shared uint pixels_of[kMaxShaders];
shared uint waves_wanted[kMaxShaders];  // were all of it padded
shared uint padded_tiles_of[kMaxShaders];
shared uint padded_pixels_of[kMaxShaders];
shared uint padded_waves_of[kMaxShaders];
shared uint listed, padded_waves, overflow_pixels, wanted;
shared uint cut;          // tiles of the one shader that is padded in part
shared uint cut_shader;

// Entries that all pixels take unpadded, with a wave of each shader's overflow filled up.
uint unpadded() {
  return saturating_sum(saturating_sum(params.reserved, listed), shader_slots() * (wave_size() - 1u));
}
bool fits(uint padding) { return saturating_sum(unpadded(), padding) <= capacity(); }

uint padding_before(uint shader) {
  uint padding = 0u;
  for (uint s = 0u; s < shader; ++s) padding = saturating_sum(padding, padding_of(waves_wanted[s], pixels_of[s]));
  return padding;
}

void read_sums(uint thread) {
  if (thread < shader_slots()) {
    pixels_of[thread] = shaders[thread].pixels;
    waves_wanted[thread] = shaders[thread].first;
  }
  clear_digits(thread);
  barrier();
  if (thread == 0u) {
    listed = 0u;
    for (uint s = 0u; s < shader_slots(); ++s) listed += pixels_of[s];
    wanted = saturating_sum(unpadded(), padding_before(shader_slots()));
    cut = 0u;
    cut_shader = shader_slots();
    uint padding = 0u;
    for (uint s = 0u; s < shader_slots(); ++s) {
      padding = saturating_sum(padding, padding_of(waves_wanted[s], pixels_of[s]));
      if (fits(padding)) continue;
      cut_shader = s;
      break;
    }
  }
  barrier();
}

// Of the one shader that fits in part: how many tiles do, and their commands.
void cut_tiles(uint thread) {
  const uint all = tile_count(extent());
  const uint before = padding_before(cut_shader);
  uint fitting = 0u;
  for (uint t = thread; cut_shader < shader_slots() && t < all; t += kThreads) {
    const TileCommands tile = tiles[cut_shader * all + t];
    const uint waves = tile.waves_before + (tile.waves & 0xffffu) + (tile.waves >> 16u);
#ifdef MUTANT_16  // the tile's own padding is not looked at
    const uint padding = padding_of(tile.waves_before, tile.pixels_before);
#else
    const uint padding = padding_of(waves, tile.pixels_before + tile.pixels);
#endif
    if (!fits(saturating_sum(before, padding))) break;  // and none after it
    ++fitting;
    add_digits(cut_shader, tile.waves);
  }
  if (fitting > 0u) atomicAdd(cut, fitting);
  barrier();
}

void find_room(uint thread) {
  read_sums(thread);
  cut_tiles(thread);
  const uint all = tile_count(extent());
  if (thread < shader_slots()) {
    const bool whole = thread < cut_shader || all == 0u;
    padded_tiles_of[thread] = whole ? all : thread == cut_shader ? cut : 0u;
    padded_pixels_of[thread] = whole ? pixels_of[thread] : 0u;
    padded_waves_of[thread] = whole ? waves_wanted[thread] : 0u;
    if (thread == cut_shader && !whole) {
      const TileCommands next = tiles[cut_shader * all + cut];  // the first that does not fit
      padded_pixels_of[thread] = next.pixels_before;
      padded_waves_of[thread] = next.waves_before;
    }
  }
  barrier();
  if (thread == 0u) {
    padded_waves = 0u;
    overflow_pixels = 0u;
    for (uint s = 0u; s < shader_slots(); ++s) {
      padded_waves += padded_waves_of[s];
      overflow_pixels += pixels_of[s] - padded_pixels_of[s];
    }
  }
  barrier();
}

// `count` commands of 2^k waves: x covers a command, or several commands share a group; y and z hold them.
DispatchArgs args_of(uint count, uint k) {
  const uint shift = waves_per_group_log2();
  const uint x = k > shift ? 1u << k - shift : 1u;
#ifdef MUTANT_15  // groups of small commands rounded down
  const uint groups = k > shift ? count : count >> shift - k;
#else
  const uint groups = k > shift ? count : ceil_div(count, 1u << shift - k);
#endif
  const uvec2 list = spread(groups);
  return DispatchArgs(x, list.x, list.y);
}

uint commands_of(uint shader, uint r) {
  if (shader < cut_shader) return command_rows[shader * kCommandRows + r].count;  // counted by the scan
  return shader == cut_shader ? sum_of_digits(r) : 0u;
}

// The shader's unpadded waves, after all padded ones; the last is filled up.
void place_overflow(uint shader) {
  uint first = 0u, overflow = padded_waves;
  for (uint s = 0u; s < shader; ++s) {
    first += padded_waves_of[s];
    overflow += waves_of(pixels_of[s] - padded_pixels_of[s]);
  }
  const uint pixels = pixels_of[shader] - padded_pixels_of[shader];
  shaders[shader] = ShaderCommands(first, pixels_of[shader], padded_tiles_of[shader], overflow, pixels);
  const uint room = params.waves - min(overflow, params.waves);
  const uint waves = min(waves_of(pixels), room);
  const uint row = shader * kCommandRows + kOverflowRow;
  command_rows[row] = CommandRow(overflow, waves);
  args[row] = args_of(waves, 0u);
#ifndef MUTANT_17  // the last wave of the overflow is not filled up
  const uint filled = pixels & wave_size() - 1u;
  const uint last = overflow + waves_of(pixels) - 1u;
  if (filled == 0u || last >= params.waves) return;
  for (uint i = filled; i < wave_size(); ++i) entries[(last << wave_log2()) + i] = kEntryInvalid;
#endif
}
