#include "kernels/vrcs_deblock/oracle.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "harness/half.h"
#include "harness/oracle.h"
#include "harness/tone_curve.h"

namespace assay::vrcs_deblock {

uint64_t tiles(const Case& c) { return tile_count(c.extent, kVrcsTileSide); }
uint64_t entries(const Case& c) { return tiles(c) * kVrcsTileEntries; }

namespace {

struct Place {
  int64_t x, y;
};

bool on_screen(Extent e, Place p) { return p.x >= 0 && p.y >= 0 && p.x < e.width && p.y < e.height; }
size_t at(Extent e, Place p) { return static_cast<size_t>(p.y * e.width + p.x); }

bool is_finite(const Texel& t) {
  return std::isfinite(half_value(t[0])) && std::isfinite(half_value(t[1])) && std::isfinite(half_value(t[2]));
}

// What the lists say of a tile's 256 pixels.
struct Named {
  bool primary = false, horizontal = false, vertical = false, diagonal = false;
};
using Tile = std::array<Named, kVrcsTilePixels>;

void name(Tile& tile, uint x, uint y, uint copies) {
  const auto pixel = [&](uint px, uint py) -> Named& { return tile[size_t{py} * 16 + px]; };
  const uint other_x = x % 2 == 0 ? x + 1 : x - 1, other_y = y % 2 == 0 ? y + 1 : y - 1;
  pixel(x, y).primary = true;
  if (copies & kCopyHorizontal) pixel(other_x, y).horizontal = true;
  if (copies & kCopyVertical) pixel(x, other_y).vertical = true;
  if (copies & kCopyDiagonal) pixel(other_x, other_y).diagonal = true;
}

Tile named(uint word, std::span<const uint> list, uint frame) {
  Tile tile;
  const uint count = word % 512;
  if (word & (kVrcsTileSky | kVrcsTile1x1) || count > kVrcsTileEntries) return tile;
  if (word & kVrcsTile2x2) {
    for (uint y = frame % 2; y < 16; y += 2)
      for (uint x = frame % 2; x < 16; x += 2) name(tile, x, y, kCopyHorizontal | kCopyVertical | kCopyDiagonal);
    return tile;
  }
  for (const uint entry : list.first(count)) name(tile, entry % 16, entry / 16 % 16, entry / 256 % 8);
  return tile;
}

Kind kind_of(const Named& n) {
  if (n.primary) return Kind::none;
  return n.horizontal ? Kind::horizontal : n.vertical ? Kind::vertical : n.diagonal ? Kind::diagonal : Kind::none;
}

std::vector<Place> sides_of(Kind k) {
  switch (k) {
    case Kind::horizontal:
      return {{1, 0}};
    case Kind::vertical:
      return {{0, 1}};
    case Kind::diagonal:
      return {{1, 1}, {1, -1}};
    default:
      return {};
  }
}

// In float, pair by pair, each sum rounded once; then to the nearest half.
uint16_t mean(const std::vector<Texel>& texels, const Pairs& pairs, size_t channel) {
  float sum = 0;
  for (const auto& [a, b] : pairs) {
    const auto pair = static_cast<float>(half_value(texels[a][channel]) + half_value(texels[b][channel]));
    sum = static_cast<float>(double{sum} + double{pair});
  }
  const double exact = double{sum} / static_cast<double>(2 * pairs.size());
  return nearest_half(exact == 0 ? 0.0 : exact);
}

std::vector<Texel> radiance(const Case& c) {
  const auto given = c.input<Texel>("radiance");
  return {given.begin(), given.end()};
}

using Rg8 = std::array<uint8_t, 2>;
std::vector<Rg8> lumas(const Luma& luma, const std::vector<Texel>& texels) {
  std::vector<Rg8> all;
  all.reserve(texels.size());
  for (const Texel& t : texels) all.push_back({luma.of(t), luma.of(t)});
  return all;
}

}  // namespace

std::vector<Kind> kinds_of(const Case& c) {
  const auto words = c.input<uint>("tiles"), list = c.input<uint>("entries");
  const Extent across = tiles_of(c.extent, kVrcsTileSide);
  std::vector<Kind> kinds(pixel_count(c.extent));
  for (size_t t = 0; t < words.size(); ++t) {
    const Tile tile = named(words[t], list.subspan(t * kVrcsTileEntries), c.params<DeblockParams>().frame);
    const Place first{static_cast<int64_t>(t % across.width) * 16, static_cast<int64_t>(t / across.width) * 16};
    for (int64_t i = 0; i < 256; ++i) {
      const Place p{first.x + i % 16, first.y + i / 16};
      if (on_screen(c.extent, p)) kinds[at(c.extent, p)] = kind_of(tile[static_cast<size_t>(i)]);
    }
  }
  return kinds;
}

Belongs belongs_by_depth(const Case& c) {
  const auto seen = c.input<uvec2>("visibility");
  const auto depth = c.input<float>("depth");
  return [=](size_t a, size_t b) {
    const int64_t apart = int64_t{std::bit_cast<uint32_t>(depth[a])} - int64_t{std::bit_cast<uint32_t>(depth[b])};
    return seen[a].y % (1u << 30) == seen[b].y % (1u << 30) && std::abs(apart) <= kCloseDepths;
  };
}
Belongs belongs_by_triangle(const Case& c) {
  const auto seen = c.input<uvec2>("visibility");
  return [=](size_t a, size_t b) { return seen[a] == seen[b]; };
}

Pairs pairs_of(const Case& c, Kind kind, size_t pixel, const Belongs& belongs) {
  const auto texels = c.input<Texel>("radiance");
  const Place p{static_cast<int64_t>(pixel % c.extent.width), static_cast<int64_t>(pixel / c.extent.width)};
  Pairs pairs;
  if (!is_finite(texels[pixel])) return pairs;
  for (const Place& side : sides_of(kind)) {
    const Place before{p.x - side.x, p.y - side.y}, after{p.x + side.x, p.y + side.y};
    if (!on_screen(c.extent, before) || !on_screen(c.extent, after)) continue;
    const size_t a = at(c.extent, before), b = at(c.extent, after);
    if (belongs && (!belongs(pixel, a) || !belongs(pixel, b))) continue;
    if (is_finite(texels[a]) && is_finite(texels[b])) pairs.push_back({a, b});
  }
  return pairs;
}

std::vector<Texel> deblocked(const Case& c, const std::vector<Kind>& kinds, const Belongs& belongs) {
  const std::vector<Texel> before = radiance(c);
  std::vector<Texel> after = before;
  for (size_t i = 0; i < after.size(); ++i) {
    if (kinds[i] == Kind::none) continue;
    const Pairs pairs = pairs_of(c, kinds[i], i, belongs);
    for (size_t channel = 0; channel < 3 && !pairs.empty(); ++channel) after[i][channel] = mean(before, pairs, channel);
  }
  return after;
}

Luma::Luma(float exposure) : codes_(65536) {
  for (uint32_t h = 0; h < codes_.size(); ++h)
    codes_[h] = static_cast<uint8_t>(code_of(half_value(static_cast<uint16_t>(h)), exposure));
}
uint8_t Luma::of(const Texel& t) const {
  const uint sum = kLumaRed * codes_[t[0]] + kLumaGreen * codes_[t[1]] + kLumaBlue * codes_[t[2]];
  return static_cast<uint8_t>((sum + 32768) / 65536);
}

Answer answers(const Case& c) {
  const std::vector<Kind> kinds = kinds_of(c);
  const Luma luma(c.input<ExposureRecord>("exposure")[0].exposure);
  Answer answer;
  answer["half_codes"] = expect_all(luma.codes());
  const auto add = [&](const std::string& of, const Belongs& belongs) {
    const auto texels = deblocked(c, kinds, belongs);
    answer["deblocked_radiance" + of] = expect_all(texels);
    answer["luma" + of] = expect_all(lumas(luma, texels));
  };
  add("", {});
  answer["luma of luma_alone"] = expect_all(lumas(luma, radiance(c)));
  add(" of guarded", belongs_by_depth(c));
  add(" of guarded_by_triangle", belongs_by_triangle(c));
  add_in_place(answer, c, kinds, luma);
  return answer;
}

}  // namespace assay::vrcs_deblock
