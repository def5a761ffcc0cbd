// Which block of the list each part of the atlas has its light from.
#pragma once
#include <map>
#include <set>

#include "harness/kernel.h"
#include "kernels/particle_light_atlas/layout.h"

namespace assay::particle_light_atlas {

constexpr uint32_t kNobody = 0xffffffffu;  // left as it was

struct Texel {
  uint32_t particle, x, y, side;  // of the rectangle
  uint32_t at_x, at_y;            // in the atlas
};

// By texels of `direction`, each four of the atlas. Rectangles that overlap, which no allocation makes, leave the light
// of any of theirs.
struct Sources {
  explicit Sources(const Case&);

  uint32_t across;              // texels of `direction` a side
  std::vector<uint32_t> first;  // a word of the list of blocks
  std::map<uint64_t, std::set<uint32_t>> others = {};
  std::vector<uint32_t> rects;

  uint64_t quads() const { return first.size(); }
  std::vector<uint32_t> blocks_at(uint64_t quad) const;
  Texel texel(uint32_t block, uint64_t quad, uint32_t k) const;  // the k-th of the quad's, row by row
  std::vector<Expected::Run> live_quads() const;
  std::vector<Expected::Run> live_texels() const;
};

}  // namespace assay::particle_light_atlas
