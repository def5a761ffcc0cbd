#include "kernels/vrcs_remap/oracle.h"

#include <algorithm>

#include "harness/oracle.h"

namespace assay::vrcs_remap {

uint64_t tiles(const Case& c) { return vrcs::tiles_in(c.extent); }
uint64_t entries(const Case& c) { return tiles(c) * kVrcsTileEntries; }

namespace {

struct Stores {
  const Case& input;
  RemapParams params;
  std::span<const uvec2> visibility;
  std::vector<uint> values, visits, waves;

  explicit Stores(const Case& c)
      : input(c),
        params(c.params<RemapParams>()),
        visibility(c.input<uvec2>("visibility")),
        values(pixels(c)),
        visits(pixels(c)),
        waves(tiles(c)) {}
  bool on_screen(uint x, uint y) const { return x < params.width && y < params.height; }
  bool covered(uint x, uint y) const {
    return visibility[size_t{y} * params.width + x] != uvec2(kVisibilityNone, kVisibilityNone);
  }
  void store(uint x, uint y, uint value) {
    if (!on_screen(x, y)) return;
    const size_t at = size_t{y} * params.width + x;
    ++visits[at];
    values[at] = std::max(values[at], value);
  }
};

// A primary and its copies: the pixels whose coordinates differ from its own in the last bit.
void store_primary(Stores& s, uint x, uint y, uint copies, uint depth) {
  const uint value = y * s.params.width + x + 1 + depth * 2654435769u;
  s.store(x, y, value);
  if (copies & kCopyHorizontal) s.store(x ^ 1, y, value);
  if (copies & kCopyVertical) s.store(x, y ^ 1, value);
  if (copies & kCopyDiagonal) s.store(x ^ 1, y ^ 1, value);
}

// Lane's own pixel, where all are shaded; false off the screen.
bool shade_own(Stores& s, uint left, uint top, uint lane) {
  const uint x = left + lane / 4 % 8 * 2 + lane % 2, y = top + lane / 32 * 2 + lane / 2 % 2;
  if (!s.on_screen(x, y)) return false;
  if (s.covered(x, y)) store_primary(s, x, y, 0, 0);
  return true;
}

bool shade_derived(Stores& s, uint left, uint top, uint lane) {
  const uint x = left + lane % 8 * 2 + s.params.frame % 2, y = top + lane / 8 * 2 + s.params.frame % 2;
  if (lane >= 64 || !s.on_screen(x, y)) return false;
  store_primary(s, x, y, kCopyBits, 0);
  return true;
}

bool shade_entry(Stores& s, uint left, uint top, uint entry) {
  const uint x = left + entry % 16, y = top + entry / 16 % 16;
  if (!s.on_screen(x, y)) return false;
  store_primary(s, x, y, entry / 256 % 8, entry / 2048);
  return true;
}

// Whether the lane had work.
bool shade_lane(Stores& s, uint tile, uint lane, bool fog) {
  const uint across = tiles_of(s.input.extent, kVrcsTileSide).width;
  const uint left = tile % across * 16, top = tile / across * 16;
  const uint word = s.input.input<uint>("tiles")[tile], count = word % 512;
  if (count == 0) return false;
  if (count > kVrcsTileEntries || (fog && word & kVrcsTileFog)) return shade_own(s, left, top, lane);
  if (lane >= count) return false;
  if (word & kVrcsTile2x2) return shade_derived(s, left, top, lane);
  return shade_entry(s, left, top, s.input.input<uint>("entries")[size_t{tile} * kVrcsTileEntries + lane]);
}

// No more than the list holds, nor than threads are dispatched.
uint entries_of_list(const Case& c) {
  const DispatchArgs args = c.input<DispatchArgs>("list_args")[0];
  const uint64_t threads = uint64_t{args.x} * args.y * args.z * kVrcsListGroup;
  return static_cast<uint>(std::min({uint64_t{c.input<uint>("list_count")[0]}, pixels(c), threads}));
}

bool shade_listed(Stores& s, uint i) {
  const uint entry = s.input.input<uint>("list")[i];
  const uint x = entry % 16384, y = entry / 16384 % 16384;
  if (entry >> 31 || !s.on_screen(x, y)) return false;
  store_primary(s, x, y, entry >> 28, 0);
  return true;
}

// Runs of `wave` lanes of which one has work at least.
template <class Lane>
uint busy_waves(uint lanes, uint wave, const Lane& lane) {
  uint busy = 0;
  for (uint first = 0; first < lanes; first += wave) {
    bool work = false;
    for (uint i = first; i < std::min(first + wave, lanes); ++i) work |= lane(i);
    busy += work;
  }
  return busy;
}

// Lists that are the screen's: whatever they say, each covered pixel once.
void go_by_cover(Stores& s) {
  for (size_t i = 0; i < s.visits.size(); ++i) s.visits[i] = s.visibility[i] != uvec2(kVisibilityNone, kVisibilityNone);
}

// And as few waves as hold the primaries, where a list is taken.
void go_by_count(Stores& s, bool fog) {
  const auto words = s.input.input<uint>("tiles");
  const uint width = s.input.device.subgroup_width;
  for (size_t t = 0; t < s.waves.size(); ++t) {
    const uint count = words[t] & kVrcsTileCount;
    if (count <= kVrcsTileEntries && !(fog && words[t] & kVrcsTileFog)) s.waves[t] = ceil_div(count, width);
  }
}

void add_answers(Answer& to, const Stores& s, const std::string& variant) {
  to["values of " + variant] = expect_all(s.values);
  to["visits of " + variant] = expect_all(s.visits);
  to["waves of " + variant] = expect_all(s.waves);
}

void add_tiles(Answer& to, const Case& c, bool fog) {
  Stores s(c);
  for (uint t = 0; t < s.waves.size(); ++t)
    s.waves[t] = busy_waves(256, c.device.subgroup_width, [&](uint lane) { return shade_lane(s, t, lane, fog); });
  if (!s.params.hostile) go_by_cover(s), go_by_count(s, fog);
  add_answers(to, s, fog ? "tile_list_fog" : "tile_list");
}

void add_list(Answer& to, const Case& c) {
  Stores s(c);
  const uint count = entries_of_list(c), width = c.device.subgroup_width;
  // Groups of 64 threads: a subgroup of 128 lanes has 64.
  s.waves[0] = busy_waves(count, std::min(width, kVrcsListGroup), [&](uint i) { return shade_listed(s, i); });
  if (!s.params.hostile) {
    go_by_cover(s);
    s.waves[0] = ceil_div(count, std::min(width, kVrcsListGroup));
  }
  add_answers(to, s, "compact");
}

}  // namespace

Answer remap(const Case& c) {
  Answer answer;
  add_tiles(answer, c, false);
  add_tiles(answer, c, true);
  add_list(answer, c);
  return answer;
}

}  // namespace assay::vrcs_remap
