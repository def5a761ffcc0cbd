// What a frame can show, and what of it the kernels that are built can draw.
#pragma once
#include <cstdint>
#include <string>

namespace assay::frame {

// Of the shadow atlas, for a next frame.
inline constexpr const char* kShadowStill = "shadow_atlas.still";
inline constexpr const char* kShadowDepth = "shadow_atlas.depth";

struct View {
  const char* name;
  const char* image;      // the resource that is the picture
  uint32_t debug;         // kView... of formats/debug_view.h; of no meaning for the lit picture
  const char* needs;      // a resource that it cannot do without
  bool of_rates = false;  // that must vary
};

bool in_registry(const std::string& resource);    // whether its kernel is built
const View& view_named(const std::string& name);  // throws std::invalid_argument, naming those that there are

}  // namespace assay::frame
