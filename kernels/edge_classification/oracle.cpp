#include "kernels/edge_classification/oracle.h"

#include <algorithm>
#include <cstdlib>

#include "harness/groups.h"
#include "harness/oracle.h"

namespace assay::edge_classification {

uint32_t live_samples(const Case& c) { return std::clamp(c.params<EdgeParams>().samples, 1u, kMaxSamples); }
uint64_t samples(const Case& c) { return pixels(c) * live_samples(c); }
uint64_t gradients(const Case& c) { return c.params<EdgeParams>().gradients ? samples(c) : 0; }
uint64_t tiles(const Case& c) { return tile_count(c.extent, kEdgeTileSide); }

namespace {

struct View {
  EdgeParams params;
  size_t samples;
  std::span<const uint> materials, gradients;

  size_t first_sample(uint32_t x, uint32_t y) const { return (size_t{y} * params.width + x) * samples; }
};

// snorm16: the two lowest codes are both -1.
int64_t snorm(uint16_t bits) { return std::max<int64_t>(static_cast<int16_t>(bits), -32767); }

bool gradients_apart(uint a, uint b, uint threshold) {
  const int64_t x = snorm(static_cast<uint16_t>(a)) - snorm(static_cast<uint16_t>(b));
  const int64_t y = snorm(static_cast<uint16_t>(a >> 16)) - snorm(static_cast<uint16_t>(b >> 16));
  return std::max(std::llabs(x), std::llabs(y)) > threshold;
}

// Samples are shaded apart when their materials differ, or when they are not of one plane.
bool apart(const View& v, size_t a, size_t b) {
  return v.materials[a] != v.materials[b] ||
         (v.params.gradients && gradients_apart(v.gradients[a], v.gradients[b], v.params.threshold));
}

bool is_edge(const View& v, uint32_t x, uint32_t y) {
  const size_t first = v.first_sample(x, y);
  for (size_t s = 1; s < v.samples; ++s)
    if (apart(v, first, first + s)) return true;
  if (!v.params.neighbours) return false;
  const bool right = x + 1 < v.params.width && apart(v, first, v.first_sample(x + 1, y));
  const bool below = y + 1 < v.params.height && apart(v, first, v.first_sample(x, y + 1));
  return right || below;
}

std::vector<uvec2> masks_of(const Case& c) {
  const View view{c.params<EdgeParams>(), live_samples(c), c.input<uint>("materials"), c.input<uint>("gradients")};
  const uint32_t across = tiles_of(c.extent, kEdgeTileSide).width;
  std::vector<uvec2> masks(tiles(c), uvec2(0));
  for (uint32_t y = 0; y < c.extent.height; ++y)
    for (uint32_t x = 0; x < c.extent.width; ++x) {
      if (!is_edge(view, x, y)) continue;
      uvec2& mask = masks[size_t{y / 8} * across + x / 8];
      (y % 8 < 4 ? mask.x : mask.y) |= 1u << (y % 4 * 8 + x % 8);  // four rows a word
    }
  return masks;
}

// A group a tile, in rows of at most 65,535.
DispatchArgs args_for(uint64_t listed) {
  const Groups groups = spread_groups(listed);
  return {groups.x, listed ? groups.y : 0, 1};
}

Expected head(const std::vector<uint>& list) {
  Expected expected = expect_all(list);
  expected.live.emplace();
  if (!list.empty()) expected.live->push_back({0, list.size()});
  return expected;
}

}  // namespace

Answer classify(const Case& c) {
  const auto masks = masks_of(c);
  std::vector<uint> edges, plain;
  for (uint tile = 0; tile < masks.size(); ++tile) (masks[tile] == uvec2(0) ? plain : edges).push_back(tile);
  const std::vector<uint> counts = {static_cast<uint>(edges.size()), static_cast<uint>(plain.size())};
  const std::vector<DispatchArgs> args = {args_for(edges.size()), args_for(plain.size())};
  return {{"edge_mask", expect_all(masks)},
          {"edge_tiles", head(edges)},
          {"plain_tiles", head(plain)},
          {"tile_counts", expect_all(counts)},
          {"args", expect_all(args)}};
}

}  // namespace assay::edge_classification
