#include "kernels/particle_light_atlas/sources.h"

#include <algorithm>

namespace assay::particle_light_atlas {

namespace {

struct Rect {
  uint32_t x, y, side;
};
Rect rect_of(uint32_t word) {
  const uint32_t size = word >> kRectSizeShift & 3;
  return {word % 512 * 8, (word >> kRectYShift) % 512 * 8, size == 0 ? 0 : 4u << size};
}

}  // namespace

Sources::Sources(const Case& c) : across(c.params<ParticleLightParams>().side / 2) {
  const auto params = c.params<ParticleLightParams>();
  const auto words = c.input<uint32_t>("rects"), blocks = c.input<uint32_t>("blocks");
  const auto args = c.input<DispatchArgs>("args")[0];
  rects.assign(words.begin(), words.end());
  first.assign(size_t{across} * across, kNobody);
  const uint64_t groups = args.z == 0 ? 0 : uint64_t{args.x} * args.y;
  const uint64_t listed = std::min<uint64_t>(c.input<ParticleRectCounts>("counts")[0].blocks, blocks.size());
  for (uint64_t i = 0; i < std::min(listed, groups * kLightGroupBlocks); ++i) {
    const uint32_t particle = blocks[i] >> kLightBlockBits, block = blocks[i] % 16;
    if (particle >= params.particles) continue;
    const Rect r = rect_of(rects[particle]);
    if (block >= r.side / 8 * (r.side / 8) || r.x + r.side > params.side || r.y + r.side > params.side) continue;
    const uint32_t x = (r.x + block % (r.side / 8) * 8) / 2, y = (r.y + block / (r.side / 8) * 8) / 2;
    for (uint32_t k = 0; k < 16; ++k) {
      const uint64_t quad = uint64_t{y + k / 4} * across + x + k % 4;
      if (first[quad] == kNobody)
        first[quad] = blocks[i];
      else if (first[quad] != blocks[i])
        others[quad].insert(blocks[i]);
    }
  }
}

std::vector<uint32_t> Sources::blocks_at(uint64_t quad) const {
  std::vector<uint32_t> all = {first[quad]};
  if (const auto more = others.find(quad); more != others.end())
    all.insert(all.end(), more->second.begin(), more->second.end());
  return all;
}

Texel Sources::texel(uint32_t block, uint64_t quad, uint32_t k) const {
  const uint32_t particle = block >> kLightBlockBits;
  const Rect r = rect_of(rects[particle]);
  const auto x = static_cast<uint32_t>(quad % across) * 2 + k % 2, y = static_cast<uint32_t>(quad / across) * 2 + k / 2;
  return {particle, x - r.x, y - r.y, r.side, x, y};
}

std::vector<Expected::Run> Sources::live_quads() const {
  std::vector<Expected::Run> runs;
  for (uint64_t i = 0; i < first.size(); ++i) {
    if (first[i] == kNobody) continue;
    if (runs.empty() || runs.back().first + runs.back().count != i) runs.push_back({i, 0});
    ++runs.back().count;
  }
  return runs;
}

std::vector<Expected::Run> Sources::live_texels() const {
  std::vector<Expected::Run> runs;
  const uint64_t side = uint64_t{across} * 2;
  for (uint64_t y = 0; y < side; ++y)
    for (uint64_t x = 0; x < across; ++x) {
      if (first[y / 2 * across + x] == kNobody) continue;
      const uint64_t at = y * side + 2 * x;
      if (runs.empty() || runs.back().first + runs.back().count != at) runs.push_back({at, 0});
      runs.back().count += 2;
    }
  return runs;
}

}  // namespace assay::particle_light_atlas
