#include "kernels/vrcs_deblock/inputs.h"

#include <algorithm>
#include <cmath>

#include "harness/crop.h"
#include "harness/half.h"
#include "harness/tone_curve.h"

namespace assay::vrcs_deblock {

Texel grey(double value) {
  const uint16_t h = nearest_half(value);
  return {h, h, h, 0x3c00};
}

Picture blank(Extent e) {
  const size_t n = pixel_count(e);
  return {.extent = e,
          .texels = std::vector<Texel>(n, grey(0)),
          .visibility = std::vector<uvec2>(n, uvec2(7, 3)),
          .depth = std::vector<float>(n, 0.01f),
          .rates = std::vector<uint8_t>(pixel_count(tiles_of(e, kCellSide)), kRate1x1)};
}

Lists lists_of(const Picture& p) {
  return vrcs::lists_of(vrcs::coordinates_of({p.extent, p.visibility, p.rates, {}, p.frame}));
}

namespace {

// As the shading pass leaves the screen: a duplicate is the texel of the pixel that an entry copies.
void copy_primaries(const Picture& p, const Lists& lists, std::vector<Texel>& texels) {
  const Extent tiles = tiles_of(p.extent, kVrcsTileSide);
  const auto copy = [&](uint x, uint y, uint to_x, uint to_y) {
    if (std::max(x, to_x) < p.extent.width && std::max(y, to_y) < p.extent.height)
      texels[p.place(to_x, to_y)] = p.texels[p.place(x, y)];
  };
  for (size_t t = 0; t < lists.tiles.size(); ++t) {
    const uint word = lists.tiles[t], count = word & kVrcsTileCount;
    const bool derived = word & kVrcsTile2x2;
    if (!derived && count > kVrcsTileEntries) continue;
    for (uint i = 0; i < (derived ? 64u : count); ++i) {
      const uint corner = (2 * (i % 8) + p.frame % 2) | (2 * (i / 8) + p.frame % 2) << 4;
      const uint entry = derived ? corner | kCopyBits << 8 : lists.entries[t * kVrcsTileEntries + i];
      const uint x = static_cast<uint>(t % tiles.width) * 16 + entry % 16;
      const uint y = static_cast<uint>(t / tiles.width) * 16 + entry / 16 % 16, copies = entry >> kVrcsEntryCopyShift;
      if (copies & kCopyHorizontal) copy(x, y, x ^ 1, y);
      if (copies & kCopyVertical) copy(x, y, x, y ^ 1);
      if (copies & kCopyDiagonal) copy(x, y, x ^ 1, y ^ 1);
    }
  }
}

}  // namespace

namespace {

void set_display(Case& c, float exposure) {
  static const std::vector<float> thresholds = code_thresholds();
  c.set_input("exposure", std::vector{ExposureRecord{0, 0, 0, exposure}});
  c.set_input("thresholds", thresholds);
  c.set_input("first_codes", bucket_codes(thresholds));
}

}  // namespace

// With full rates everywhere there are no tiles. Without an exposure luma is 0.
Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.vrcs ? f.extent : Extent{0, 0}};
  c.set_params(DeblockParams{f.extent.width, f.extent.height, f.frame});
  set_display(c, f.history.exposure);
  return c;
}

Case case_of(const Picture& p, const Lists& lists) {
  Case c = {.extent = p.extent};
  c.set_params(DeblockParams{p.extent.width, p.extent.height, p.frame});
  std::vector<Texel> texels = p.texels;
  copy_primaries(p, lists, texels);
  c.set_input("radiance", texels);
  c.set_input("radiance_in_place", texels);
  c.set_input("visibility", p.visibility);
  c.set_input("depth", p.depth);
  c.set_input("tiles", lists.tiles);
  c.set_input("entries", lists.entries);
  set_display(c, p.exposure);
  return c;
}
Case case_of(const Picture& p) { return case_of(p, lists_of(p)); }

namespace {

constexpr uint8_t kRates[] = {kRate1x1, kRate1x2, kRate2x1, kRate2x2};

// Waves of several lengths, a channel each its own.
Texel wavy(double x, double y) {
  const auto wave = [](double at) { return nearest_half(0.5 + 0.45 * std::sin(at)); };
  return {wave(0.05 * x + 0.09 * y), wave(0.31 * x - 0.02 * y), wave(0.9 * x + 0.7 * y), 0x3c00};
}

// Rates by block of so many cells.
void set_rates(Picture& p, Pcg32& rng, uint block, const std::vector<uint8_t>& among) {
  const Extent cells = tiles_of(p.extent, kCellSide), blocks = tiles_of(cells, block);
  std::vector<uint8_t> of_block(pixel_count(blocks));
  for (uint8_t& r : of_block) r = among[rng.below(static_cast<uint32_t>(among.size()))];
  for (uint y = 0; y < cells.height; ++y)
    for (uint x = 0; x < cells.width; ++x)
      p.rates[size_t{y} * cells.width + x] = of_block[size_t{y / block} * blocks.width + x / block];
}

// Halves of squares of `side` pixels are triangles; one surface a row of eight squares.
void set_triangles(Picture& p, uint side) {
  for (uint y = 0; y < p.extent.height; ++y)
    for (uint x = 0; x < p.extent.width; ++x) {
      const uint column = x / side, row = y / side, half = x % side + y % side >= side;
      p.visibility[p.place(x, y)] = uvec2(2 * (column + 4096 * row) + half, column / 8 + 512 * row);
      p.depth[p.place(x, y)] = 0.01f + 1e-6f * static_cast<float>(x + 2 * y);
    }
}

void set_sky(Picture& p, uint x0, uint y0, uint x1, uint y1) {
  for (uint y = y0; y < std::min(y1, p.extent.height); ++y)
    for (uint x = x0; x < std::min(x1, p.extent.width); ++x) {
      p.visibility[p.place(x, y)] = uvec2(kVisibilityNone, kVisibilityNone);
      p.depth[p.place(x, y)] = 0;
      p.texels[p.place(x, y)][3] = 0;
    }
}

// A nearer surface of another colour.
void add_disc(Picture& p, Pcg32& rng, uint surface) {
  const double x0 = rng.range(0, p.extent.width), y0 = rng.range(0, p.extent.height), r = rng.range(2, 40);
  const Texel colour = {nearest_half(rng.unit()), nearest_half(rng.unit()), nearest_half(4 * rng.unit()), 0x3c00};
  const auto depth = static_cast<float>(rng.range(0.01, 0.1));
  for (uint y = 0; y < p.extent.height; ++y)
    for (uint x = 0; x < p.extent.width; ++x)
      if (std::hypot(x - x0, y - y0) < r) {
        p.visibility[p.place(x, y)] = uvec2(rng.below(2), surface);
        p.texels[p.place(x, y)] = colour, p.depth[p.place(x, y)] = depth;
      }
}

}  // namespace

Case typical(Extent e) {
  Pcg32 rng(0xdeb);
  Picture p = painted(e, [](uint x, uint y) { return wavy(x, y); });
  set_triangles(p, 24);
  // Blocks of 16x16 pixels, 2x2 and half rates as often as 1x1: triangles' edges make primaries of their own.
  set_rates(p, rng, 8, {kRate1x1, kRate1x2, kRate2x1, kRate2x2, kRate2x2});
  set_sky(p, 0, 0, e.width, e.height / 5);
  return case_of(p);
}

namespace {

void set_content(Random& r, Picture& p) {
  switch (r.branch({{"content_wavy", 0.35}, {"content_bits", 0.2}, {"content_bright", 0.2}, {"content_discs", 0.25}})) {
    case 0:
      for (uint y = 0; y < p.extent.height; ++y)
        for (uint x = 0; x < p.extent.width; ++x) p.texels[p.place(x, y)] = wavy(x, y);
      break;
    case 1:  // any bits, NaN and infinities among them
      for (Texel& t : p.texels)
        for (uint16_t& h : t) h = static_cast<uint16_t>(r.rng.next());
      break;
    case 2:
      for (Texel& t : p.texels) t = grey(std::exp2(r.rng.range(-24, 16)));
      break;
    default:
      for (uint i = 0; i < 12; ++i) add_disc(p, r.rng, 100 + i);
  }
}

// What hangs together by no rule.
void spoil(Pcg32& rng, Lists& lists) {
  for (uint& word : lists.tiles)
    if (rng.below(3) != 0) word = rng.below(2) ? rng.next() : rng.below(257);
  for (uint& entry : lists.entries)
    if (rng.below(2) != 0) entry = rng.next();
}

Case random_case(Random& r) {
  Picture p = blank(random_extent(r, 2 * kVrcsTileSide));
  p.frame = r.rng.next();
  p.exposure = static_cast<float>(std::exp2(r.rng.range(-6, 6)));
  if (r.branch({{"one_triangle", 0.5}, {"triangles", 0.5}}) == 1) set_triangles(p, 3 + r.rng.below(30));
  set_content(r, p);
  switch (r.branch({{"rates_uniform", 0.3}, {"rates_blocks", 0.4}, {"rates_cells", 0.3}})) {
    case 0:
      p.rates.assign(p.rates.size(), kRates[r.rng.below(4)]);
      break;
    case 1:
      set_rates(p, r.rng, 2 + r.rng.below(9), {std::begin(kRates), std::end(kRates)});
      break;
    default:
      set_rates(p, r.rng, 1, {std::begin(kRates), std::end(kRates)});
  }
  if (r.branch({{"no_sky", 0.6}, {"sky", 0.4}}) == 1)
    set_sky(p, 0, 0, 1 + r.rng.below(p.extent.width), 1 + r.rng.below(p.extent.height));
  Lists lists = lists_of(p);
  const bool fogged = r.branch({{"clear", 0.7}, {"fogged", 0.3}}) == 1;
  for (uint& word : lists.tiles) word |= fogged && r.rng.below(2) ? kVrcsTileFog : 0;
  if (r.branch({{"lists_sound", 0.8}, {"lists_spoilt", 0.2}}) == 1) spoil(r.rng, lists);
  return case_of(p, lists);
}

// The upper left of a case: tiles stay where they are.
Case cut(const Case& c, Extent e) {
  const Extent across = tiles_of(c.extent, kVrcsTileSide);
  const Crop pixels{{0, 0}, e}, in_tiles{{0, 0}, tiles_of(e, kVrcsTileSide)};
  Case part = c;
  part.extent = e;
  part.set_params(DeblockParams{e.width, e.height, c.params<DeblockParams>().frame});
  for (const char* port : {"radiance", "radiance_in_place"})
    part.set_input(port, cropped(c.input<Texel>(port), c.extent, pixels));
  part.set_input("visibility", cropped(c.input<uvec2>("visibility"), c.extent, pixels));
  part.set_input("depth", cropped(c.input<float>("depth"), c.extent, pixels));
  part.set_input("tiles", cropped(c.input<uint>("tiles"), across, in_tiles));
  part.set_input("entries", cropped(c.input<uint>("entries"), across, in_tiles, kVrcsTileEntries));
  return part;
}

std::vector<Case> smaller_cases(const Case& c) {
  std::vector<Case> cases;
  for (const Crop& crop : smaller_crops(c.extent))
    if (crop.at.width == 0 && crop.at.height == 0) cases.push_back(cut(c, crop.size));
  return cases;
}

}  // namespace

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  for (const char* b :
       {"one_triangle", "triangles", "content_wavy", "content_bits", "content_bright", "content_discs", "rates_uniform",
        "rates_blocks", "rates_cells", "no_sky", "sky", "clear", "fogged", "lists_sound", "lists_spoilt"})
    branches.push_back(b);
  return {.random = random_case, .branches = branches, .hard = hard_cases(), .smaller = smaller_cases};
}

}  // namespace assay::vrcs_deblock
