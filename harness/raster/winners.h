// Which of the triangles at a pixel may be the one that stays.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "harness/formats/scene.h"
#include "harness/judged.h"
#include "harness/raster/coverage.h"

namespace assay::raster {

constexpr uint32_t kNoTriangle = 0xffffffffu;
constexpr uint32_t kNoVertex = 0xffffffffu;

struct DrawnTriangle {
  uint32_t order = 0;      // position in drawing order
  uint32_t primitive = 0;  // within its command
  uint32_t surface = 0;    // or caster: what its command's instance is
  bool masked = false;
  Facing facing = Facing::both;
  std::array<uint32_t, 3> vertices = {};
};
// The triangles of a command, instance after instance; indices and instances past the end are the last. `order` goes
// on.
template <class F>
void for_each_triangle(const DrawCommand& d, std::span<const uint> indices, uint32_t vertices, uint32_t surfaces,
                       DrawnTriangle& t, F visit) {
  const uint32_t last_surface = std::max(surfaces, 1u) - 1, last_vertex = std::max(vertices, 1u) - 1;
  for (uint32_t instance = 0; instance < d.instance_count; ++instance) {
    t.surface = std::min(d.first_instance + instance, last_surface);
    for (t.primitive = 0; t.primitive < d.index_count / 3; ++t.primitive, ++t.order) {
      for (uint32_t k = 0; k < 3; ++k)
        t.vertices[k] = std::min(indices[d.first_index + 3 * t.primitive + k] + d.vertex_offset, last_vertex);
      visit(t);
    }
  }
}

struct WinningTriangle {
  DrawnTriangle drawn;
  Shape shape = {};  // its edges are dropped once it is rasterised
};

// A triangle at a pixel: covered surely or perhaps, with its depth somewhere in low..high.
struct Candidate {
  Cover cover = Cover::out;
  double low = 0, high = 0;
  uint32_t triangle = kNoTriangle;
  uint32_t edge_from = kNoVertex,
           edge_to = kNoVertex;  // covered unless it lies beyond this edge: nothing else is in doubt
  uint32_t next = 0xffffffffu;   // of the pixel's list
};

// What a pixel may end as; kNoTriangle: as it was cleared.
struct Outcome {
  uint32_t triangle = kNoTriangle;
  double low = 0, high = 0;
};

class Winners {
 public:
  explicit Winners(uint64_t pixels) : head_(pixels, kEnd), front_(pixels, 0) {}
  uint64_t pixels() const { return head_.size(); }

  // Triangles come in drawing order: ids ascend with it.
  uint32_t reserve() { return add({}); }
  uint32_t add(WinningTriangle t) {
    triangles_.push_back(std::move(t));
    return static_cast<uint32_t>(triangles_.size() - 1);
  }
  void set(uint32_t id, WinningTriangle t) { triangles_[id] = std::move(t); }
  const WinningTriangle& triangle(uint32_t id) const { return triangles_[id]; }

  void add(uint64_t pixel, Candidate c);
  // Valid until the next call.
  const std::vector<Outcome>& outcomes(uint64_t pixel);

 private:
  static constexpr uint32_t kEnd = 0xffffffffu;
  bool same_place(uint32_t a, uint32_t b) const;
  bool beaten(const Candidate&) const;
  void find_pairs();

  std::vector<WinningTriangle> triangles_;
  std::vector<Candidate> candidates_;
  std::vector<uint32_t> head_;
  std::vector<double> front_;  // no surely covered triangle is wholly nearer than this: later ones below it are hidden
  std::vector<Candidate> here_;
  std::vector<Outcome> outcomes_;
  double nearest_pair_ = 0;
};

// What is known of a triangle at a pixel's centre; `kept` tells of a masked one whether it is no hole there.
template <class Kept>
Candidate candidate_at(const Shape& shape, const DrawnTriangle& t, double x, double y, Kept kept) {
  Candidate c;
  const Coverage coverage = covers(shape, x, y);
  c.cover = coverage.cover;
  if (c.cover == Cover::out) return c;
  const Cover within = in_depth(shape, x, y);
  const Cover solid = t.masked && within != Cover::out ? kept(x, y) : Cover::in;
  c.cover = std::min({c.cover, within, solid});
  if (c.cover == Cover::out) return c;
  const Interval depth = depth_at(shape, x, y);
  c.low = depth.low, c.high = depth.high;
  if (c.low <= 0) c.cover = Cover::maybe;  // the cleared depth is not surely behind it
  if (coverage.only_doubt != kNoEdge && shape.whole && within == Cover::in && solid == Cover::in) {
    const Edge& e = shape.edges[coverage.only_doubt];
    c.edge_from = t.vertices[e.from], c.edge_to = t.vertices[e.to];
  }
  return c;
}

// Adds a triangle at each judged pixel that it may cover. The id that was reserved for it, or kNoTriangle.
template <class Kept>
uint32_t add_candidates(Winners& winners, const JudgedMap& judged, uint64_t width, const DrawnTriangle& t,
                        const Shape& shape, Kept kept) {
  uint32_t id = kNoTriangle;
  if (shape.edges.empty()) return id;
  for (uint32_t y = shape.y_first; y < shape.y_end; ++y)
    for (uint32_t x = shape.x_first; x < shape.x_end; ++x) {
      uint64_t pixel = y * width + x;
      if (!judged.list.empty()) {
        if (judged.position[pixel] == kNotJudged) continue;
        pixel = judged.position[pixel];
      }
      Candidate c = candidate_at(shape, t, x + 0.5, y + 0.5, kept);
      if (c.cover == Cover::out) continue;
      if (id == kNoTriangle) id = winners.reserve();
      c.triangle = id;
      winners.add(pixel, c);
    }
  return id;
}

}  // namespace assay::raster
