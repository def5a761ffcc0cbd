#include "kernels/particle_rects/oracle.h"

#include <algorithm>
#include <cmath>

#include "harness/groups.h"
#include "harness/oracle.h"
#include "harness/particles.h"

namespace assay::particle_rects {

namespace {

// Of floats, rounded once: a product of two is exact in double, and rounding a double's sum again changes nothing
// (53 >= 2 * 24 + 2; Figueroa 1995).
float product(float a, float b) { return static_cast<float>(double{a} * double{b}); }
float sum(float a, float b) { return static_cast<float>(double{a} + double{b}); }

float dot(const vec3& a, const vec3& b) { return sum(sum(product(a.x, b.x), product(a.y, b.y)), product(a.z, b.z)); }
vec3 cross(const vec3& a, const vec3& b) {
  const auto minor = [&](int i, int j) { return sum(product(a[i], b[j]), -product(a[j], b[i])); };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

bool is_number(const vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
float held(float v, float most) { return std::fabs(v) >= kLeastLength ? std::clamp(v, -most, most) : 0; }
vec3 held(const vec3& v, float most) { return {held(v.x, most), held(v.y, most), held(v.z, most)}; }

struct Quad {
  vec3 centre, right, up;

  float farthest_along(const vec3& direction) const {
    const vec3 d = held(direction, 1);
    return sum(sum(dot(d, centre), std::fabs(dot(d, right))), std::fabs(dot(d, up)));
  }
};

}  // namespace

uint32_t wanted_size(const RectParams& p, const ParticleRecord& r) {
  const bool is_sound = is_number(r.centre) && is_number(r.right) && is_number(r.up);
  if (!is_sound || !std::isfinite(r.opacity) || !std::isfinite(r.quality)) return 0;
  if (r.opacity < kLeastShown || r.quality < kLeastShown) return 0;
  const Quad q = {held(r.centre, kMostDistance), held(r.right, kMostAxis), held(r.up, kMostAxis)};
  const float near = std::max(held(p.near_plane, kMostDistance), kLeastDistance);
  for (const vec3& side : {p.left, p.right, p.top, p.bottom})
    if (q.farthest_along(side) < 0) return 0;
  if (!(q.farthest_along(p.forward) > near)) return 0;
  const float z = std::max(dot(held(p.forward, 1), q.centre), near);
  const float scale = held(product(held(p.pixels, kMostPixels), held(r.quality, kMostPixels)), kMostPixels);
  const auto scaled = [scale](const vec3& v) {
    return vec3(product(v.x, scale), product(v.y, scale), product(v.z, scale));
  };
  const vec3 across = cross(scaled(q.right), scaled(q.up));
  const float area = product(16, dot(across, across));
  const auto reaches = [&](float side) {
    const float square = product(product(side, z), product(side, z));
    return area >= product(square, square);
  };
  return reaches(kSideOf32) ? 3 : reaches(kSideOf16) ? 2 : reaches(kLeastSide) ? 1 : 0;
}

uint32_t particle_count(const Case& c) { return std::min(c.params<RectParams>().particles, kMostParticles); }

namespace {

struct Allocation {
  std::vector<uint32_t> rects, owners;
  ParticleRectCounts counts = {};
};

uint32_t word_of(const ParticleRegion& r, uint32_t size, uint32_t slot) {
  const uint32_t x = slot % r.across * r.side, y = r.row + slot / r.across * r.side;
  return x / 8 | y / 8 << kRectYShift | size << kRectSizeShift;
}

// Those that want this size, ascending: who had one of its slots keeps it, the first of several; the others take the
// free ones. Left over are those that found none.
std::vector<uint32_t> give(Allocation& a, const ParticleRegion& r, uint32_t size, std::span<const uint32_t> previous,
                           const std::vector<uint32_t>& waiting) {
  std::map<uint32_t, uint32_t> slot_of_word;
  for (uint32_t s = 0; s < r.slots; ++s) slot_of_word[word_of(r, size, s)] = s;
  const auto take = [&](uint32_t particle, uint32_t slot) {
    a.rects[particle] = word_of(r, size, slot);
    a.owners[r.first + slot] = particle;
    ++a.counts.lit;
    a.counts.blocks += 1u << 2 * (size - 1);
  };
  std::vector<uint32_t> others, left;
  for (const uint32_t i : waiting) {
    const auto had = slot_of_word.find(previous[i]);
    if (had != slot_of_word.end() && a.owners[r.first + had->second] == kNobody)
      take(i, had->second);
    else
      others.push_back(i);
  }
  uint32_t slot = 0;
  for (const uint32_t i : others) {
    while (slot < r.slots && a.owners[r.first + slot] != kNobody) ++slot;
    if (slot < r.slots)
      take(i, slot);
    else
      left.push_back(i);
  }
  return left;
}

Allocation allocate(const Case& c) {
  const auto params = c.params<RectParams>();
  const auto particles = c.input<ParticleRecord>("particles").first(particle_count(c));
  const auto previous = c.input<uint32_t>("previous");
  Allocation a = {std::vector<uint32_t>(particles.size(), kNoRect),
                  std::vector<uint32_t>(all_particle_slots(params.atlas), kNobody)};
  std::vector<uint32_t> wanted;
  for (const ParticleRecord& p : particles) wanted.push_back(wanted_size(params, p));
  std::vector<uint32_t> waiting;
  for (uint32_t size = kRectSizes; size > 0; --size) {
    const size_t stepped = waiting.size();
    for (uint32_t i = 0; i < wanted.size(); ++i)
      if (wanted[i] == size) waiting.push_back(i);
    std::ranges::inplace_merge(waiting, waiting.begin() + static_cast<ptrdiff_t>(stepped));
    waiting = give(a, particle_region(params.atlas, size), size, previous, waiting);
  }
  a.counts.dropped = static_cast<uint32_t>(waiting.size());
  for (uint32_t i = 0; i < wanted.size(); ++i)
    if (a.rects[i] != kNoRect && a.rects[i] >> kRectSizeShift != wanted[i]) ++a.counts.smaller;
  return a;
}

std::vector<uint32_t> blocks_of(const Allocation& a) {
  std::vector<uint32_t> blocks;
  for (uint32_t i = 0; i < a.rects.size(); ++i)
    for (uint32_t k = 0; k < (a.rects[i] == kNoRect ? 0u : 1u << 2 * ((a.rects[i] >> kRectSizeShift) - 1)); ++k)
      blocks.push_back(i << kLightBlockBits | k);
  return blocks;
}

}  // namespace

Answer allocation(const Case& c) {
  if (particle_count(c) == 0) {  // nothing runs, nothing is written
    Answer none;
    for (const char* port : {"rects", "owners", "blocks", "counts", "args"})
      none[port] = {.live = std::vector<Expected::Run>{}};
    return none;
  }
  const Allocation a = allocate(c);
  const std::vector<uint32_t> blocks = blocks_of(a);
  const Groups groups = spread_groups((blocks.size() + kLightGroupBlocks - 1) / kLightGroupBlocks);
  const DispatchArgs args = {groups.x, groups.y, 1};
  Answer answer = {{"rects", expect_all(a.rects)},
                   {"owners", expect_all(a.owners)},
                   {"blocks", expect_all(blocks)},
                   {"counts", expect_all(std::vector{a.counts})},
                   {"args", expect_all(std::vector{blocks.empty() ? DispatchArgs{0, 0, 1} : args})}};
  answer["blocks"].live = std::vector<Expected::Run>{{0, blocks.size()}};
  return answer;
}

}  // namespace assay::particle_rects
