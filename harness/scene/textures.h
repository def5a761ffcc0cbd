// Array textures of a gathered view.
#pragma once
#include <string>
#include <vector>

#include "harness/scene/scene.h"

namespace assay::scene {

// The arrays that hold `images` (ascending scene indices), and each one's name, array << 16 | layer, in the same order.
struct TextureArrays {
  std::vector<Texture> textures;
  std::vector<uint32_t> names;
};
// sRGB with every mip level. More than 16 arrays: std::runtime_error.
TextureArrays pack_textures(const Scene&, const std::vector<uint32_t>& images);

}  // namespace assay::scene
