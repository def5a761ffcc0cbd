#include "kernels/debug_view/oracle.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "harness/oracle.h"
#include "kernels/debug_view/layout.h"

namespace assay::debug_view {
namespace {

using Colour = std::array<uint32_t, 3>;  // red, green, blue, 0 to 255

Colour unpacked(uint32_t c) { return {c % 256, c / 256 % 256, c / 65536 % 256}; }
uint32_t packed(const Colour& c) { return 255u << 24 | c[2] << 16 | c[1] << 8 | c[0]; }

// quarters/4 of a over b.
Colour over(const Colour& a, const Colour& b, uint32_t quarters) {
  Colour sum;
  for (size_t i = 0; i < 3; ++i) sum[i] = (a[i] * quarters + b[i] * (4 - quarters)) / 4;
  return sum;
}

// MurmurHash3's last step.
uint32_t murmur_last_step(uint32_t h) {
  h ^= h >> 16;
  h *= 0x85ebca6b;
  h ^= h >> 13;
  h *= 0xc2b2ae35;
  h ^= h >> 16;
  return h;
}

Colour random_colour(uint32_t key) {
  Colour c = unpacked(murmur_last_step(key));
  for (uint32_t& channel : c) channel = 64 + channel % 128;
  return c;
}

Colour grey_of(const Colour& c) {
  const uint32_t brightness = (c[0] * 77 + c[1] * 150 + c[2] * 29) / 256;
  return {brightness, brightness, brightness};
}

struct View {
  const Case& c;
  ViewParams params = c.params<ViewParams>();
  std::span<const uvec2> visibility = c.input<uvec2>("visibility");
  std::span<const SurfaceRecord> surfaces = c.input<SurfaceRecord>("surfaces");
  std::span<const uint32_t> material_colours = c.input<uint32_t>("material_colours");
  std::span<const uint32_t> heat_colours = of_tiles("heat_colours"), masks = of_tiles("masks");
  uint32_t across = ceil_div(params.width, kTileSide);

  // In the frame only the tile view has them, and the clusters view the colours.
  std::span<const uint32_t> of_tiles(const char* port) const {
    const bool has = params.view == kViewTile || (params.view == kViewClusters && port == std::string("heat_colours"));
    return has ? c.input<uint32_t>(port) : std::span<const uint32_t>();
  }

  static bool nothing(uvec2 v) { return v.x == kVisibilityNone && v.y == kVisibilityNone; }

  Colour material(uvec2 v) const {
    if (nothing(v)) return unpacked(kBackgroundColour);
    const uint32_t surface = v.y % (1u << 30);
    if (surface >= surfaces.size()) return unpacked(kBrokenColour);
    const uint32_t material_index = surfaces[surface].material;
    if (material_index >= material_colours.size()) return unpacked(kBrokenColour);
    return unpacked(material_colours[material_index]);
  }

  Colour grey(uvec2 v) const { return grey_of(material(v)); }

  Colour triangle(uvec2 v) const {
    if (nothing(v)) return unpacked(kBackgroundColour);
    return random_colour(v.x ^ murmur_last_step(v.y % (1u << 30) + 1));
  }

  Colour tile(uint32_t x, uint32_t y, uvec2 v) const {
    const uint32_t mask = masks[y / kTileSide * across + x / kTileSide];
    const uint32_t in_x = x % kTileSide, in_y = y % kTileSide;
    if (in_x == 0 || in_y == 0) return over(grey(v), {0, 0, 0}, 1);
    if (mask == 0) return over(grey(v), unpacked(kBackgroundColour), 1);
    if (std::min(in_x, in_y) >= kChipFirst && std::max(in_x, in_y) < kChipEnd) return random_colour(mask);
    return over(grey(v), unpacked(heat_colours[static_cast<size_t>(std::popcount(mask))]), 1);
  }

  Colour shader(uvec2 v) const {
    if (nothing(v)) return unpacked(kBackgroundColour);
    const auto slots = c.input<SurfaceSlot>("surface_slots");
    const auto colours = c.input<uint32_t>("shader_colours");
    const uint32_t surface = v.y % (1u << 30);
    if (surface >= slots.size() || slots[surface].shader >= colours.size()) return unpacked(kBrokenColour);
    return unpacked(colours[slots[surface].shader]);
  }

  Colour cluster(uint32_t x, uint32_t y, uvec2 v) const {
    const ClusterGrid& g = params.grid;
    if (nothing(v) || g.columns == 0 || g.rows == 0) return over(grey(v), unpacked(kBackgroundColour), 1);
    if (x % g.cell_width == 0 || y % g.cell_height == 0) return over(grey(v), {0, 0, 0}, 1);
    const auto edges = c.input<float>("slice_edges");
    const float d = c.input<float>("depth")[size_t{y} * params.width + x];
    uint32_t slice = 0;
    while (slice + 1 < g.slices && d <= edges[slice + 1]) ++slice;
    const uint64_t column = std::min(x / g.cell_width, g.columns - 1), row = std::min(y / g.cell_height, g.rows - 1);
    const uint32_t counts = c.input<uvec2>("cells")[(slice * uint64_t{g.rows} + row) * g.columns + column].y;
    const uint32_t items = counts % 4096 + counts / 4096 % 4096 + counts / (1u << 24);
    return over(grey(v), unpacked(heat_colours[static_cast<size_t>(std::bit_width(items))]), 1);
  }

  Colour vrcs(uint32_t place) const { return unpacked(c.input<uint32_t>("vrcs_colours")[place]); }

  // Log2 of width and height of what is shaded once.
  Colour rate(uint32_t x, uint32_t y, uvec2 v) const {
    if (nothing(v)) return unpacked(kBackgroundColour);
    const uint8_t code = c.input<uint8_t>("rates")[size_t{y} / 2 * ((params.width + 1) / 2) + x / 2];
    const bool wide = code == 4 || code == 5, high = code == 1 || code == 5;
    const bool known = wide || high || code == 0;
    return over(known ? vrcs(wide ? (high ? kColour2x2 : kColour2x1) : (high ? kColour1x2 : kColour1x1))
                      : unpacked(kBrokenColour),
                grey(v), 3);
  }

  Colour primary(uint32_t x, uint32_t y, uvec2 v) const {
    if (nothing(v)) return unpacked(kBackgroundColour);
    const uint32_t word = c.input<uint32_t>("vrcs_tiles")[size_t{y} / 16 * ((params.width + 15) / 16) + x / 16];
    const bool duplicate = c.input<uint8_t>("copy_bits")[size_t{y} * params.width + x] / 128 == 1;
    const bool whole = word / kVrcsTile1x1 % 2 == 1 || word % 512 > 224, once = word / kVrcsTile2x2 % 2 == 1;
    return over(vrcs(whole       ? kColourTileWhole
                     : once      ? kColourTile2x2
                     : duplicate ? kColourDuplicate
                                 : kColourPrimary),
                grey(v), 3);
  }

  // Three quarters by the depth's logarithm, a colour a tile.
  Colour shadow(uint32_t x, uint32_t y) const {
    const uint64_t wide = params.shadow_width, high = params.shadow_height;
    const bool fills_width = wide > 0 && params.width * high <= params.height * wide;
    const uint64_t shown_x = fills_width ? params.width : high ? params.height * wide / high : 0;
    const uint64_t shown_y = fills_width ? params.width * high / wide : params.height;
    if (x >= shown_x || y >= shown_y || high == 0) return unpacked(kBackgroundColour);
    const uint64_t at_x = x * wide / shown_x, at_y = y * high / shown_y;
    const auto views = c.input<ShadowView>("shadow_views");
    const auto found = std::ranges::find_if(views, [&](const ShadowView& v) {
      const auto holds = [&](uint64_t at, uint64_t first) { return at >= first && at < first + v.tile.side; };
      return holds(at_x, v.tile.x) && holds(at_y, v.tile.y);
    });
    if (found == views.end()) return unpacked(kBackgroundColour);
    int exponent = 0;
    const double fraction = std::frexp(c.input<float>("shadow_depth")[at_y * wide + at_x], &exponent);  // [0.5, 1)
    const double code = fraction > 0 ? 32 * (exponent + 7) + std::floor((2 * fraction - 1) * 32) : 0;
    Colour colour = random_colour(static_cast<uint32_t>(found - views.begin()) + 1);
    for (uint32_t& channel : colour) channel += 64;
    Colour dark = colour;
    for (uint32_t& channel : dark) channel = channel * static_cast<uint32_t>(std::clamp(code, 0.0, 255.0)) / 255;
    return over(dark, colour, 3);
  }

  Colour at(uint32_t x, uint32_t y) const {
    if (params.view == kViewShadows) return shadow(x, y);
    const uvec2 v = visibility[size_t{y} * params.width + x];
    if (params.view == kViewRate) return rate(x, y, v);
    if (params.view == kViewPrimary) return primary(x, y, v);
    if (params.view == kViewTriangle) return triangle(v);
    if (params.view == kViewTile) return tile(x, y, v);
    if (params.view == kViewShader) return shader(v);
    if (params.view == kViewClusters) return cluster(x, y, v);
    if (params.view == kViewWorkload || params.view == kViewWave) return over(grey(v), unpacked(kBackgroundColour), 1);
    return material(v);
  }
};

// The tiles that workload `row` really runs over: listed, counted and reached by its dispatch.
std::vector<uint32_t> run_over(const Case& c, size_t row) {
  const auto list = c.input<uint32_t>("workload_tiles").subspan(row * tiles(c), tiles(c));
  const DispatchArgs args = c.input<DispatchArgs>("workload_args")[row];
  const uint64_t groups = args.x == 0 ? 0 : uint64_t{args.y} * args.z;
  const uint64_t counted = c.input<WorkloadCount>("workload_counts")[row].tiles;
  std::vector<uint32_t> found;
  for (const uint32_t tile : list.first(std::min({groups, counted, tiles(c)})))
    if (tile < tiles(c)) found.push_back(tile);
  return found;
}

void paint_workload(const View& view, size_t row, std::vector<uint32_t>& image) {
  const uint32_t colour = view.c.input<uint32_t>("workload_colours")[row];
  if (colour == 0) return;
  for (const uint32_t tile : run_over(view.c, row)) {
    const uint32_t x0 = tile % view.across * kTileSide, y0 = tile / view.across * kTileSide;
    for (uint32_t y = y0; y < std::min(y0 + kTileSide, view.params.height); ++y)
      for (uint32_t x = x0; x < std::min(x0 + kTileSide, view.params.width); ++x) {
        const size_t i = size_t{y} * view.params.width + x;
        image[i] = packed(over(unpacked(colour), view.grey(view.visibility[i]), 2));
      }
  }
}

// Every wave of every row's list, in the colour of its row and number.
void paint_waves(const View& view, std::vector<uint32_t>& image) {
  const auto entries = view.c.input<uint32_t>("entries"), commands = view.c.input<uint32_t>("commands");
  const auto rows = view.c.input<CommandRow>("command_rows");
  for (uint32_t row = 0; row < rows.size(); ++row) {
    const bool overflow = row % kCommandRows == kOverflowRow;
    const uint32_t each = overflow ? 1 : 1u << row % kCommandRows % kCommandBuckets;
    for (uint32_t wave = 0; wave < rows[row].count * each; ++wave) {
      const uint32_t first = overflow ? rows[row].first + wave : commands[rows[row].first + wave / each] + wave % each;
      for (const uint32_t entry : entries.subspan(size_t{first} * kWaveSize, kWaveSize)) {
        const uint32_t x = entry % (1u << 14), y = entry / (1u << 14) % (1u << 14);
        if (entry >= kEntryInvalid || x >= view.params.width || y >= view.params.height) continue;
        image[size_t{y} * view.params.width + x] = packed(random_colour(murmur_last_step(row + 1) ^ wave));
      }
    }
  }
}

}  // namespace

uint64_t tiles(const Case& c) { return tile_count(c.extent, kTileSide); }
uint64_t workloads(const Case& c) { return c.params<ViewParams>().workloads; }

Answer expected_image(const Case& c) {
  const View view = {c};
  std::vector<uint32_t> image(pixels(c));
  for (uint32_t y = 0; y < c.extent.height; ++y)
    for (uint32_t x = 0; x < c.extent.width; ++x) image[size_t{y} * c.extent.width + x] = packed(view.at(x, y));
  if (view.params.view == kViewWorkload)
    for (size_t row = 0; row < workloads(c); ++row) paint_workload(view, row, image);
  if (view.params.view == kViewWave) paint_waves(view, image);
  return {{"image", expect_all(image)}};
}

}  // namespace assay::debug_view
