#include "harness/raster/winners.h"

#include <algorithm>

namespace assay::raster {

void Winners::add(uint64_t pixel, Candidate c) {
  if (c.high < front_[pixel]) return;
  if (c.cover == Cover::in) front_[pixel] = std::max(front_[pixel], c.low);
  c.next = head_[pixel];
  head_[pixel] = static_cast<uint32_t>(candidates_.size());
  candidates_.push_back(c);
}

// The same three vertices of the same surface in the same order, drawn by the same pipeline: Vulkan's invariance rules
// give the same depth, bit for bit.
bool Winners::same_place(uint32_t a, uint32_t b) const {
  const DrawnTriangle &p = triangles_[a].drawn, &q = triangles_[b].drawn;
  return p.surface == q.surface && p.masked == q.masked && p.facing == q.facing && p.vertices == q.vertices;
}

// Depth must be greater to replace what is there: of equal depths the first drawn stays.
bool Winners::beaten(const Candidate& c) const {
  if (c.high < nearest_pair_) return true;
  return std::ranges::any_of(here_, [&](const Candidate& other) {
    const bool earlier = other.triangle < c.triangle;
    if (earlier && same_place(other.triangle, c.triangle)) return true;  // wherever one is, the other is
    return other.cover == Cover::in && (other.low > c.high || (earlier && other.low >= c.high));
  });
}

// Two triangles on either side of an edge between the same two vertices, both in doubt for that edge alone: exactly one
// of them covers the pixel, wherever the edge was snapped to, so what is surely behind both is hidden.
void Winners::find_pairs() {
  nearest_pair_ = 0;
  for (const Candidate& a : here_) {
    if (a.edge_from == kNoVertex) continue;
    for (const Candidate& b : here_)
      if (a.edge_from == b.edge_to && a.edge_to == b.edge_from &&
          triangles_[a.triangle].drawn.surface == triangles_[b.triangle].drawn.surface)
        nearest_pair_ = std::max(nearest_pair_, std::min(a.low, b.low));
  }
}

const std::vector<Outcome>& Winners::outcomes(uint64_t pixel) {
  here_.clear(), outcomes_.clear();
  for (uint32_t i = head_[pixel]; i != kEnd; i = candidates_[i].next) here_.push_back(candidates_[i]);
  find_pairs();
  double floor = nearest_pair_;  // the depth that stays is no less
  bool covered = nearest_pair_ > 0;
  for (const Candidate& c : here_)
    if (c.cover == Cover::in) floor = std::max(floor, c.low), covered = true;
  for (const Candidate& c : here_)
    if (!beaten(c)) outcomes_.push_back({c.triangle, std::min(std::max(c.low, floor), c.high), c.high});
  if (!covered) outcomes_.push_back({});
  return outcomes_;
}

}  // namespace assay::raster
