// Array textures of a gathered view.
#pragma once
#include <string>
#include <vector>

#include "harness/scene/scene.h"

namespace assay::scene {

// An image as sRGB (alpha linear) or as plain numbers: rgba8_srgb or rgba8_unorm.
struct ImageUse {
  uint32_t image = 0;
  Format format = Format::rgba8_srgb;
  auto operator<=>(const ImageUse&) const = default;
};
// The arrays that hold what is used, one a size and format, and each use's name, array << 16 | layer, in their order.
struct TextureArrays {
  std::vector<Texture> textures;
  std::vector<uint32_t> names;
};
// With every mip level: a box filter of the linear values, of sRGB in linear light. The xy of normals are averaged like
// any numbers: where the normals under a texel disagree, the mean is shorter, and the normal rebuilt from it is
// flatter. More than 16 arrays: std::runtime_error.
TextureArrays pack_textures(const Scene&, const std::vector<ImageUse>&);

}  // namespace assay::scene
