#include "kernels/edge_classification/inputs.h"

#include <algorithm>

#include "harness/crop.h"
#include "kernels/edge_classification/oracle.h"

namespace assay::edge_classification {

Samples::Samples(const EdgeParams& p) : params(p) {
  const size_t count = size_t{p.width} * p.height * std::clamp(p.samples, 1u, kMaxSamples);
  materials.assign(count, 7);
  gradients.assign(count, 0);
}

size_t Samples::place(uint32_t x, uint32_t y, uint32_t sample) const {
  return (size_t{y} * params.width + x) * std::clamp(params.samples, 1u, kMaxSamples) + sample;
}

Case Samples::to_case() const {
  Case c{.extent = {params.width, params.height}};
  c.set_params(params);
  c.set_input("materials", materials);
  c.set_input("gradients", params.gradients ? gradients : std::vector<uint>());
  return c;
}

namespace {

uint pack(int32_t x, int32_t y) { return static_cast<uint16_t>(x) | uint{static_cast<uint16_t>(y)} << 16; }

// ---- The typical frame
// -----------------------------------------------------------------------------------------------

constexpr double kStandardX[] = {0.375, 0.875, 0.125, 0.625}, kStandardY[] = {0.125, 0.375, 0.625, 0.875};

struct Shape {  // a box or the ellipse in it; in screens
  double x, y, half_width, half_height;
  bool ellipse;
  uint material, gradient;
};

void draw(Samples& to, const Shape& shape) {
  const double w = to.params.width, h = to.params.height;
  const auto pixel = [](double at, double size) { return static_cast<uint32_t>(std::clamp(at * size, 0.0, size)); };
  const uint32_t right = pixel(shape.x + shape.half_width, w), bottom = pixel(shape.y + shape.half_height, h);
  for (uint32_t y = pixel(shape.y - shape.half_height, h); y < to.params.height && y <= bottom; ++y)
    for (uint32_t x = pixel(shape.x - shape.half_width, w); x < to.params.width && x <= right; ++x)
      for (uint32_t s = 0; s < 4; ++s) {
        const double u = ((x + kStandardX[s]) / w - shape.x) / shape.half_width;
        const double v = ((y + kStandardY[s]) / h - shape.y) / shape.half_height;
        if (shape.ellipse ? u * u + v * v > 1 : u * u > 1 || v * v > 1) continue;
        to.materials[to.place(x, y, s)] = shape.material;
        to.gradients[to.place(x, y, s)] = shape.gradient;
      }
}

}  // namespace

Case typical(Extent e) {
  Samples scene({e.width, e.height, 4, 1, 64, 0});
  Pcg32 rng(0xed6e);
  for (uint32_t i = 0; i < 160; ++i) {  // large shapes first, smaller ones before them
    const double size = 0.5 / (1 + i / 4.0) + 0.005;
    const auto slope = [&] { return static_cast<int32_t>(rng.range(-6000, 6000)); };
    draw(scene, {rng.unit(), rng.unit(), size * rng.range(0.3, 1), size * rng.range(0.3, 1), rng.below(2) == 0,
                 rng.below(60), pack(slope(), slope())});
  }
  return scene.to_case();
}

namespace {

// ---- Random cases
// ----------------------------------------------------------------------------------------------------

EdgeParams random_params(Random& r, Extent e) {
  EdgeParams p{e.width, e.height, 1, 0, 0, 0};
  switch (r.branch({{"samples_1", 0.25},
                    {"samples_2", 0.15},
                    {"samples_4", 0.25},
                    {"samples_8", 0.15},
                    {"samples_odd", 0.1},
                    {"samples_out_of_range", 0.1}})) {
    case 0:
      p.samples = 1;
      break;
    case 1:
      p.samples = 2;
      break;
    case 2:
      p.samples = 4;
      break;
    case 3:
      p.samples = 8;
      break;
    case 4:
      p.samples = 3 + 2 * r.rng.below(3);
      break;
    default:
      p.samples = r.rng.below(3) == 0 ? 0 : kMaxSamples + 1 + (r.rng.next() >> r.rng.below(32)) % 0xfffffff0u;
  }
  p.gradients = static_cast<uint>(r.branch({{"material_only", 0.3}, {"with_gradients", 0.7}}));
  if (p.gradients) p.gradients += r.rng.below(3);
  p.neighbours = static_cast<uint>(r.branch({{"samples_only", 0.5}, {"with_neighbours", 0.5}}));
  switch (r.branch({{"threshold_usual", 0.7}, {"threshold_zero", 0.15}, {"threshold_huge", 0.15}})) {
    case 0:
      p.threshold = 1 + r.rng.below(2000);
      break;
    case 1:
      break;
    default:
      p.threshold = 65530 + (r.rng.below(2) ? r.rng.below(8) : r.rng.next() >> 1);
  }
  return p;
}

// Boxes of one material and gradient each, all samples of a pixel alike.
void add_regions(Random& r, Samples& to) {
  const Extent e{to.params.width, to.params.height};
  const uint32_t samples = std::clamp(to.params.samples, 1u, kMaxSamples);
  for (uint32_t n = r.rng.below(6); n > 0; --n) {
    const uint32_t left = r.rng.below(e.width), top = r.rng.below(e.height), material = r.rng.below(4);
    const uint32_t right = left + 1 + r.rng.below(e.width - left), bottom = top + 1 + r.rng.below(e.height - top);
    const uint gradient = r.rng.next();
    for (uint32_t y = top; y < bottom; ++y)
      for (size_t i = to.place(left, y), end = to.place(right - 1, y) + samples; i < end; ++i)
        to.materials[i] = material, to.gradients[i] = gradient;
  }
}

void add_detail(Random& r, Samples& to, uint64_t count) {
  const uint32_t samples = std::clamp(to.params.samples, 1u, kMaxSamples);
  for (; count > 0; --count) {
    const size_t first = to.place(r.rng.below(to.params.width), r.rng.below(to.params.height));
    to.materials[first + r.rng.below(samples)] = r.rng.next() >> r.rng.below(32);
  }
}

// Samples off their pixel's first by the threshold, or one more; by ±1; or anything.
void add_gradients(Random& r, Samples& to, uint64_t count) {
  const size_t kind =
      r.branch({{"gradients_near_threshold", 0.5}, {"gradients_extreme", 0.25}, {"gradients_any", 0.25}});
  const uint32_t samples = std::clamp(to.params.samples, 1u, kMaxSamples);
  constexpr int32_t kExtremes[] = {-32768, -32767, 32767, 0};
  for (; count > 0; --count) {
    const size_t first = to.place(r.rng.below(to.params.width), r.rng.below(to.params.height));
    uint& gradient = to.gradients[first + r.rng.below(samples)];
    const auto step = static_cast<int32_t>(std::min(to.params.threshold, 32766u) + r.rng.below(2));
    if (kind == 0) to.gradients[first] = 0, gradient = r.rng.below(2) ? pack(step, 0) : pack(0, -step);
    if (kind == 1) gradient = pack(kExtremes[r.rng.below(4)], kExtremes[r.rng.below(4)]);
    if (kind == 2) gradient = r.rng.next();
  }
}

Case random_case(Random& r) {
  Samples to(random_params(r, random_extent(r, 32)));
  const uint64_t area = uint64_t{to.params.width} * to.params.height;
  switch (r.branch({{"content_flat", 0.1},
                    {"content_regions", 0.3},
                    {"content_one_sample", 0.2},
                    {"content_sparse", 0.25},
                    {"content_dense", 0.15}})) {
    case 0:
      break;
    case 1:
      add_regions(r, to);
      break;
    case 2:
      add_detail(r, to, 1);
      break;
    case 3:
      add_regions(r, to), add_detail(r, to, area / 200 + 1), add_gradients(r, to, area / 200 + 1);
      break;
    default:
      add_detail(r, to, area / 4), add_gradients(r, to, area / 4 + 1);
  }
  return to.to_case();
}

// ---- Smaller cases
// ---------------------------------------------------------------------------------------------------

Case cropped_case(const Case& c, const Crop& crop) {
  EdgeParams params = c.params<EdgeParams>();
  params.width = crop.size.width, params.height = crop.size.height;
  Case smaller = c;
  smaller.extent = crop.size;
  smaller.set_params(params);
  for (const char* port : {"materials", "gradients"})
    smaller.set_input(port, cropped(c.input<uint>(port), c.extent, crop, live_samples(c)));
  return smaller;
}

std::vector<Case> smaller_cases(const Case& c) {
  std::vector<Case> cases;
  for (const Crop& crop : smaller_crops(c.extent)) cases.push_back(cropped_case(c, crop));
  return cases;
}

}  // namespace

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  for (const char* b : {"samples_1",          "samples_2",
                        "samples_4",          "samples_8",
                        "samples_odd",        "samples_out_of_range",
                        "material_only",      "with_gradients",
                        "samples_only",       "with_neighbours",
                        "threshold_usual",    "threshold_zero",
                        "threshold_huge",     "gradients_near_threshold",
                        "gradients_extreme",  "gradients_any",
                        "content_flat",       "content_regions",
                        "content_one_sample", "content_sparse",
                        "content_dense"})
    branches.push_back(b);
  return {.random = random_case, .branches = branches, .hard = hard_cases(), .smaller = smaller_cases};
}

}  // namespace assay::edge_classification
