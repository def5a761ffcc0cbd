// Colours that the host chooses, RGBA8 packed, red in the lowest byte.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace assay::debug_view {

std::vector<uint32_t> material_palette(uint32_t count);  // hues a golden section apart, so that any first n differ well
std::vector<uint32_t> heat_palette();                    // 33: from blue for one feature to white for eight and more
std::vector<uint32_t> shader_palette(uint32_t count);    // eight hues of two brightnesses, by shader class
std::vector<uint32_t> vrcs_palette();                    // kVrcsColours
uint32_t named_colour(const std::string& name);  // "RED", as Lazarek and Hammer print it; grey for a name unknown here

}  // namespace assay::debug_view
