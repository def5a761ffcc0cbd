// What variable rates leave to be shaded.
#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/kernel.h"

namespace assay::frame {

inline constexpr const char* kRates = "vrcs_shading_rate.rates";
inline constexpr const char* kTiles = "vrcs_coordinates.tiles";
inline constexpr const char* kCopyBits = "vrcs_coordinates.copy_bits";

struct VrcsShares {
  uint64_t covered = 0, primaries = 0;                                      // pixels
  uint64_t pixels_1x1 = 0, pixels_1x2 = 0, pixels_2x1 = 0, pixels_2x2 = 0;  // covered, by the rate of their cell
  uint64_t tiles = 0, tiles_sky = 0, tiles_1x1 = 0, tiles_2x2 = 0;          // by flag
  uint64_t tiles_whole = 0;  // neither, but with so many primaries that all of it is shaded
};

// Of what a frame of the extent left; zeros where rates do not vary.
VrcsShares vrcs_shares(const std::map<std::string, Bytes>& downloads, Extent);
nlohmann::json to_json(const VrcsShares&);

}  // namespace assay::frame
