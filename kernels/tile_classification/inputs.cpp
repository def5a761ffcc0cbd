#include "kernels/tile_classification/inputs.h"

#include <algorithm>

#include "harness/crop.h"
#include "kernels/tile_classification/oracle.h"

namespace assay::tile_classification {

namespace {

constexpr uint32_t kGroupsPerTile =
    32;  // waves of 32 over 1024 pixels: Lazarek and Hammer print 65,280 groups for 2,040 tiles

struct Canvas {
  Extent extent;
  std::vector<uint> features;

  void add(uint32_t x, uint32_t y, uint bits) { features[size_t{y} * extent.width + x] |= bits; }
};

struct Box {  // in screens: 0..1 over width and height
  double left, top, right, bottom;
};

// ORs the bits into the pixels of the box, or of the ellipse within it; `cover` below 1 leaves holes at random.
void paint(Canvas& canvas, Pcg32& rng, Box box, bool ellipse, uint bits, double cover = 1) {
  const auto pixel = [](double at, uint32_t size) { return static_cast<uint32_t>(std::clamp(at, 0.0, 1.0) * size); };
  const double middle_x = (box.left + box.right) / 2, middle_y = (box.top + box.bottom) / 2;
  for (uint32_t y = pixel(box.top, canvas.extent.height); y < pixel(box.bottom, canvas.extent.height); ++y)
    for (uint32_t x = pixel(box.left, canvas.extent.width); x < pixel(box.right, canvas.extent.width); ++x) {
      const double u = ((x + 0.5) / canvas.extent.width - middle_x) / (box.right - middle_x);
      const double v = ((y + 0.5) / canvas.extent.height - middle_y) / (box.bottom - middle_y);
      if (ellipse && u * u + v * v > 1) continue;
      if (cover < 1 && rng.unit() >= cover) continue;
      canvas.add(x, y, bits);
    }
}

// `count` boxes with centres in `within` and sides up to `largest` screens.
void scatter(Canvas& canvas, Pcg32& rng, uint32_t count, Box within, double largest, bool ellipse, uint bits,
             double cover = 1) {
  for (uint32_t i = 0; i < count; ++i) {
    const double x = rng.range(within.left, within.right), y = rng.range(within.top, within.bottom);
    const double w = rng.range(largest / 4, largest) / 2, h = rng.range(largest / 4, largest) / 2;
    paint(canvas, rng, {x - w, y - h, x + w, y + h}, ellipse, bits, cover);
  }
}

// A street after rain under an open sky.
Canvas street(Extent e) {
  Canvas canvas{e, std::vector<uint>(pixel_count(e))};
  Pcg32 rng(0x7117);
  const uint surface = kFeatureOpaque | kFeatureTextured;
  for (double x = 0; x < 1;) {  // house fronts of differing height, then the ground
    const double width = rng.range(0.03, 0.12);
    paint(canvas, rng, {x, rng.range(0.02, 0.45), x + width, 0.6}, false, surface);
    x += width;
  }
  paint(canvas, rng, {0, 0.55, 1, 1}, false, surface);
  paint(canvas, rng, {0.3, 0.5, 1, 1}, false, kFeatureWetnessDrops);
  scatter(canvas, rng, 14, {0.3, 0.6, 1, 1}, 0.12, true, kFeaturePuddles | kFeatureReflective);
  scatter(canvas, rng, 2, {0.4, 0.6, 0.9, 0.9}, 0.3, true, kFeatureCaustics);
  scatter(canvas, rng, 120, {0, 0.3, 1, 1}, 0.05, false, kFeatureDecals);
  scatter(canvas, rng, 8, {0, 0.3, 1, 0.6}, 0.1, false, surface | kFeatureCloth);
  scatter(canvas, rng, 5, {0.1, 0.5, 0.9, 0.8}, 0.06, true, surface | kFeatureSkin | kFeatureSubsurface);
  scatter(canvas, rng, 6, {0, 0.2, 1, 0.7}, 0.2, true, surface | kFeatureMasked | kFeatureDoubleSided, 0.4);
  scatter(canvas, rng, 30, {0, 0.2, 1, 0.6}, 0.01, false, surface | kFeatureEmissive);
  return canvas;
}

std::vector<Workload> frame_table() {
  std::vector<Workload> table;
  for (const FrameWorkload& w : kFrameWorkloads) table.push_back(w.row);
  return table;
}

Case frame_of(Extent e) {
  ClassifyParams params{e.width, e.height, std::size(kFrameWorkloads), std::size(kFramePasses), kGroupsPerTile, {}};
  for (size_t pass = 0; pass < std::size(kFramePasses); ++pass) params.relevant[pass] = kFramePasses[pass].relevant;
  Case c{.extent = e};
  c.set_params(params);
  c.set_input("workloads", frame_table());
  return c;
}

// ---- Random cases
// ----------------------------------------------------------------------------------------------------

uint some_bits(Pcg32& rng) { return rng.next() & rng.next() & rng.next(); }

std::vector<uint> random_features(Random& r, Extent e) {
  Canvas canvas{e, std::vector<uint>(pixel_count(e))};
  const auto anywhere = [&] { canvas.add(r.rng.below(e.width), r.rng.below(e.height), 1u << r.rng.below(32)); };
  switch (r.branch({{"features_none", 0.05},
                    {"features_all", 0.05},
                    {"features_one_pixel", 0.15},
                    {"features_sparse", 0.25},
                    {"features_regions", 0.35},
                    {"features_noise", 0.15}})) {
    case 0:
      break;
    case 1:
      std::ranges::fill(canvas.features, kEveryFeature);
      break;
    case 2:
      anywhere();
      break;
    case 3:
      for (uint64_t n = pixel_count(e) / 512 + 1; n > 0; --n) anywhere();
      break;
    case 4:
      for (uint32_t n = 1 + r.rng.below(8); n > 0; --n) {
        const Box whole{0, 0, 1, 1};
        scatter(canvas, r.rng, 1, whole, 1, r.rng.below(2) == 0, some_bits(r.rng), r.rng.below(4) == 0 ? 0.3 : 1);
      }
      break;
    default:
      for (uint& bits : canvas.features) bits = some_bits(r.rng) & r.rng.next();
  }
  return std::move(canvas.features);
}

std::vector<Workload> random_table(Random& r, uint rows) {
  std::vector<Workload> table;
  for (uint i = 0; i < rows; ++i)  // few passes, so that most have several rows, in no order
    table.push_back({r.rng.below(4), some_bits(r.rng) & r.rng.next(), some_bits(r.rng), r.rng.next()});
  return table;
}

void random_classification(Random& r, Case& c, ClassifyParams& params) {
  std::vector<Workload> table;
  switch (r.branch({{"table_frame", 0.2},
                    {"table_random", 0.3},
                    {"table_overlapping", 0.15},
                    {"table_contradictory", 0.1},
                    {"table_empty", 0.05},
                    {"table_full", 0.1},
                    {"table_over", 0.1}})) {
    case 0:
      table = frame_table();
      break;
    case 1:
      table = random_table(r, 1 + r.rng.below(12));
      break;
    case 2:  // every tile meets several rows
      table = random_table(r, 2 + r.rng.below(6));
      for (Workload& w : table) w = {0, 1u << r.rng.below(8), 0, w.permutation};
      table.insert(table.end(), table.begin(), table.end());
      break;
    case 3:
      table = random_table(r, 1 + r.rng.below(6));
      for (Workload& w : table) w.excluded |= w.required |= 1u << r.rng.below(32);
      break;
    case 4:
      break;
    default:
      table = random_table(r, kMaxWorkloads);
  }
  params.workloads = static_cast<uint>(table.size());
  if (r.taken.contains("table_over")) params.workloads += 1 + (r.rng.next() >> r.rng.below(32)) % 0xffff0000u;
  c.set_input("workloads", table);
}

Case random_case(Random& r) {
  const Extent e = random_extent(r, kTileSide);
  Case c{.extent = e};
  ClassifyParams params{e.width, e.height, 0, 0, 0, {}};
  random_classification(r, c, params);
  constexpr uint kUsualGroups[] = {1, 4, 16, 32, 64};
  switch (r.branch({{"groups_usual", 0.8}, {"groups_zero", 0.1}, {"groups_over", 0.1}})) {
    case 0:
      params.groups_per_tile = kUsualGroups[r.rng.below(5)];
      break;
    case 1:
      break;
    default:
      params.groups_per_tile = r.rng.next() | 0x10000u;
  }
  switch (r.branch({{"passes_usual", 0.7}, {"passes_few", 0.2}, {"passes_over", 0.1}})) {
    case 0:
      params.passes = 4;
      break;
    case 1:
      params.passes = r.rng.below(3);
      break;
    default:
      params.passes = kMaxPasses + 1 + (r.rng.next() >> 1);
  }
  const bool every = r.branch({{"relevant_every", 0.5}, {"relevant_some", 0.5}}) == 0;
  for (uint& relevant : params.relevant) relevant = every ? kEveryFeature : r.rng.next() & r.rng.next();
  c.set_params(params);
  c.set_input("features", random_features(r, e));
  return c;
}

// ---- Smaller cases
// ---------------------------------------------------------------------------------------------------

Case cropped_case(const Case& c, const Crop& crop) {
  Case smaller = c;
  auto params = c.params<ClassifyParams>();
  params.width = crop.size.width, params.height = crop.size.height;
  smaller.extent = crop.size;
  smaller.set_params(params);
  smaller.set_input("features", cropped(c.input<uint>("features"), c.extent, crop));
  return smaller;
}

Case without_row(const Case& c, size_t row) {
  auto table = std::vector(c.input<Workload>("workloads").begin(), c.input<Workload>("workloads").end());
  table.erase(table.begin() + static_cast<std::ptrdiff_t>(row));
  Case smaller = c;
  auto params = c.params<ClassifyParams>();
  params.workloads = static_cast<uint>(table.size());
  smaller.set_params(params);
  smaller.set_input("workloads", table);
  return smaller;
}

std::vector<Case> smaller_cases(const Case& c) {
  std::vector<Case> cases;
  for (const Crop& crop : smaller_crops(c.extent)) cases.push_back(cropped_case(c, crop));
  for (size_t row = live_workloads(c); row-- > 0;) cases.push_back(without_row(c, row));
  return cases;
}

}  // namespace

Case case_of(Extent e, const std::vector<uint>& features) {
  Case c = frame_of(e);
  c.set_input("features", features);
  return c;
}

Case with_table(Case c, const std::vector<Workload>& table, uint passes) {
  auto params = c.params<ClassifyParams>();
  params.workloads = static_cast<uint>(table.size());
  params.passes = passes;
  std::ranges::fill(params.relevant, kEveryFeature);
  c.set_params(params);
  c.set_input("workloads", table);
  return c;
}

Case typical(Extent e) { return case_of(e, street(e).features); }

Case frame(const FrameInputs& view) { return frame_of(view.extent); }

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  for (const char* b :
       {"features_none",  "features_all", "features_one_pixel", "features_sparse",   "features_regions",
        "features_noise", "table_frame",  "table_random",       "table_overlapping", "table_contradictory",
        "table_empty",    "table_full",   "table_over",         "groups_usual",      "groups_zero",
        "groups_over",    "passes_usual", "passes_few",         "passes_over",       "relevant_every",
        "relevant_some"})
    branches.push_back(b);
  return {.random = random_case, .branches = branches, .hard = hard_cases(), .smaller = smaller_cases};
}

}  // namespace assay::tile_classification
