#include "kernels/vrcs_remap/oracle.h"

#include <algorithm>

#include "harness/vrcs_lists.h"

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
  bool covered(uint x, uint y) const {
    return visibility[size_t{y} * params.width + x] != uvec2(kVisibilityNone, kVisibilityNone);
  }
  void store(uint x, uint y, uint value) {
    const size_t at = size_t{y} * params.width + x;
    ++visits[at];
    values[at] = std::max(values[at], value);
  }
};

bool store_work(Stores& s, const std::optional<vrcs::Work>& w) {
  if (!w) return false;
  if (w->own && !s.covered(w->x, w->y)) return true;
  const uint value = w->y * s.params.width + w->x + 1 + w->depth * 2654435769u;
  vrcs::for_each_store(s.input.extent, *w, [&](uint x, uint y) { s.store(x, y, value); });
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
  const vrcs::TileLists lists = {c.extent, c.input<uint>("tiles"), c.input<uint>("entries"), s.params.frame};
  for (uint t = 0; t < s.waves.size(); ++t)
    s.waves[t] = busy_waves(256, c.device.subgroup_width,
                            [&](uint lane) { return store_work(s, vrcs::work_of(lists, t, lane, fog)); });
  if (!s.params.hostile) go_by_cover(s), go_by_count(s, fog);
  add_answers(to, s, fog ? "tile_list_fog" : "tile_list");
}

void add_list(Answer& to, const Case& c) {
  Stores s(c);
  const vrcs::ScreenList list = vrcs::screen_list(c);
  const uint count = vrcs::entries_taken(list), width = c.device.subgroup_width;
  // Groups of 64 threads: a subgroup of 128 lanes has 64.
  s.waves[0] =
      busy_waves(count, std::min(width, kVrcsListGroup), [&](uint i) { return store_work(s, vrcs::work_of(list, i)); });
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
