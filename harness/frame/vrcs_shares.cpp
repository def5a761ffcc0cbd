#include "harness/frame/vrcs_shares.h"

#include "harness/formats/pixel_commands.h"
#include "harness/formats/visibility.h"
#include "harness/formats/vrcs.h"
#include "harness/frame/downloads.h"

namespace assay::frame {

namespace {

uint64_t& by_rate(VrcsShares& s, uint8_t rate) {
  switch (rate) {
    case kRate2x2:
      return s.pixels_2x2;
    case kRate2x1:
      return s.pixels_2x1;
    case kRate1x2:
      return s.pixels_1x2;
    default:
      return s.pixels_1x1;
  }
}

}  // namespace

VrcsShares vrcs_shares(const std::map<std::string, Bytes>& downloads, Extent extent) {
  VrcsShares s;
  const auto visibility = values_of<uvec2>(downloads, "visibility.visibility");
  const auto rates = values_of<uint8_t>(downloads, kRates), copies = values_of<uint8_t>(downloads, kCopyBits);
  const uint32_t cells_across = ceil_div(extent.width, kCellSide);
  for (size_t i = 0; i < copies.size(); ++i) {
    if (visibility[i] == uvec2(kVisibilityNone)) continue;
    ++s.covered;
    s.primaries += (copies[i] & kCopyDuplicate) == 0;
    const size_t x = i % extent.width, y = i / extent.width;
    ++by_rate(s, rates[y / kCellSide * cells_across + x / kCellSide]);
  }
  for (const uint32_t word : values_of<uint32_t>(downloads, kTiles)) {
    ++s.tiles;
    s.tiles_sky += (word & kVrcsTileSky) != 0;
    s.tiles_1x1 += (word & kVrcsTile1x1) != 0;
    s.tiles_2x2 += (word & kVrcsTile2x2) != 0;
    s.tiles_whole += (word & kVrcsTile1x1) == 0 && (word & kVrcsTileCount) > kVrcsTileEntries;
  }
  return s;
}

nlohmann::json to_json(const VrcsShares& s) {
  return {{"covered", s.covered},       {"primaries", s.primaries},    {"pixels_1x1", s.pixels_1x1},
          {"pixels_1x2", s.pixels_1x2}, {"pixels_2x1", s.pixels_2x1},  {"pixels_2x2", s.pixels_2x2},
          {"tiles", s.tiles},           {"tiles_sky", s.tiles_sky},    {"tiles_1x1", s.tiles_1x1},
          {"tiles_2x2", s.tiles_2x2},   {"tiles_whole", s.tiles_whole}};
}

}  // namespace assay::frame
