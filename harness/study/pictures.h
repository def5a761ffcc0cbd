// The pictures that variable rates are studied on: radiance as a full-rate frame leaves it.
#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "harness/device/device.h"

namespace assay::study {

using Texel = std::array<uint16_t, 4>;  // halves of red, green, blue, alpha

struct Picture {
  std::string input_class, name;
  Extent size = {};
  std::vector<Texel> radiance = {};  // rows top to bottom
  float exposure = 1;
};

// The middle of it, `side` pixels square at most.
Picture cut(const Picture&, uint32_t side);

Picture synthetic(uint32_t side);  // harness/vrcs_scene.h as displayed grey
// R, G and B of an EXR, or of its only layer, in halves. Exposed as the frame's metering does. std::runtime_error.
Picture photograph(const std::filesystem::path&);
// What the frame lights at full rate.
Picture frame(device::Device&, const std::string& scene, const std::filesystem::path& sidecar, Extent);

// Where images and scenes are looked for: $ASSAY_DATA, else beside the source folder.
std::filesystem::path data_folder();
// EXRs of data_folder()/hdr by name; none where it is missing.
std::vector<std::filesystem::path> photographs();

}  // namespace assay::study
