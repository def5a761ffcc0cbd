// Which of the triangles at a pixel may be the one that stays.
#pragma once
#include <vector>

#include "kernels/visibility/drawn.h"

namespace assay::visibility {

constexpr uint32_t kNoTriangle = 0xffffffffu;
constexpr uint32_t kNoVertex = 0xffffffffu;

struct WinningTriangle {
  DrawnTriangle drawn;
  uint32_t word = 0;  // of the visibility buffer
  Shape shape;        // its edges are dropped once it is rasterised
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

}  // namespace assay::visibility
