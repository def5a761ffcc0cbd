#include "kernels/debug_view/palette.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "kernels/debug_view/layout.h"

namespace assay::debug_view {
namespace {

uint32_t packed(double r, double g, double b) {  // each 0 to 1
  const auto byte = [](double v) { return static_cast<uint32_t>(std::lround(std::clamp(v, 0.0, 1.0) * 255)); };
  return 255u << 24 | byte(b) << 16 | byte(g) << 8 | byte(r);
}

uint32_t from_hue(double hue, double saturation, double value) {  // hue in turns
  const auto channel = [&](double offset) {
    const double at = std::fmod(hue * 6 + offset, 6);
    return value * (1 - saturation * std::clamp(std::min(at, 4 - at), 0.0, 1.0));
  };
  return packed(channel(5), channel(3), channel(1));
}

}  // namespace

std::vector<uint32_t> material_palette(uint32_t count) {
  const double golden = 0.6180339887498949;
  std::vector<uint32_t> colours;
  for (uint32_t i = 0; i < count; ++i) {
    // Three brightnesses and saturations in turn: two hues that come close again differ in these.
    const double value[] = {0.95, 0.65, 0.8}, saturation[] = {0.6, 0.75, 0.35};
    colours.push_back(from_hue(std::fmod(0.08 + i * golden, 1), saturation[i % 3], value[i % 3]));
  }
  return colours;
}

std::vector<uint32_t> heat_palette() {
  // Hand-picked steps: black body colours run together on small tiles.
  const uint32_t steps[] = {kBackgroundColour,        packed(0.15, 0.25, 0.75), packed(0.10, 0.55, 0.80),
                            packed(0.10, 0.65, 0.45), packed(0.45, 0.75, 0.20), packed(0.90, 0.85, 0.20),
                            packed(0.95, 0.55, 0.10), packed(0.90, 0.20, 0.10), packed(1, 1, 1)};
  std::vector<uint32_t> colours(kHeatColours, steps[std::size(steps) - 1]);
  std::copy(std::begin(steps), std::end(steps), colours.begin());
  return colours;
}

std::vector<uint32_t> shader_palette(uint32_t count) {
  std::vector<uint32_t> colours;
  for (uint32_t i = 0; i < count; ++i) colours.push_back(from_hue(i / 8.0, i % 2 ? 0.45 : 0.75, i % 2 ? 0.95 : 0.75));
  return colours;
}

// Rates from hot to cold by what they cost; yellow tiles are the source's (Fuller, Hammer 2025).
std::vector<uint32_t> vrcs_palette() {
  std::vector<uint32_t> colours(kVrcsColours);
  colours[kColour1x1] = packed(0.9, 0.2, 0.15);
  colours[kColour1x2] = packed(0.95, 0.65, 0.1);
  colours[kColour2x1] = packed(0.15, 0.5, 0.95);
  colours[kColour2x2] = packed(0.15, 0.75, 0.3);
  colours[kColourPrimary] = packed(1, 1, 1);
  colours[kColourDuplicate] = packed(0.2, 0.3, 0.6);
  colours[kColourTileWhole] = named_colour("YELLOW");
  colours[kColourTile2x2] = packed(0.15, 0.75, 0.3);
  return colours;
}

uint32_t named_colour(const std::string& name) {
  if (name == "RED") return packed(0.9, 0.1, 0.1);
  if (name == "GREEN") return packed(0.1, 0.85, 0.15);
  if (name == "BLUE") return packed(0.15, 0.3, 1);
  if (name == "YELLOW") return packed(0.95, 0.9, 0.1);
  if (name == "CYAN") return packed(0.1, 0.9, 0.9);
  return packed(0.6, 0.6, 0.6);
}

}  // namespace assay::debug_view
