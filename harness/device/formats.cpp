#include "harness/device/formats.h"

#include <algorithm>
#include <iterator>

namespace assay::device {

namespace {

constexpr FormatInfo kFormats[] = {
    {Format::r8_unorm, VK_FORMAT_R8_UNORM, "r8", Scalar::f32},
    {Format::r8_uint, VK_FORMAT_R8_UINT, "r8ui", Scalar::u32},
    {Format::rg8_unorm, VK_FORMAT_R8G8_UNORM, "rg8", Scalar::f32},
    {Format::rgba8_unorm, VK_FORMAT_R8G8B8A8_UNORM, "rgba8", Scalar::f32},
    {Format::rgba8_srgb, VK_FORMAT_R8G8B8A8_SRGB, nullptr, Scalar::f32},
    {Format::rgba8_uint, VK_FORMAT_R8G8B8A8_UINT, "rgba8ui", Scalar::u32},
    {Format::r16_unorm, VK_FORMAT_R16_UNORM, "r16", Scalar::f32},
    {Format::r16_float, VK_FORMAT_R16_SFLOAT, "r16f", Scalar::f32},
    {Format::rg16_snorm, VK_FORMAT_R16G16_SNORM, "rg16_snorm", Scalar::f32},
    {Format::rg16_unorm, VK_FORMAT_R16G16_UNORM, "rg16", Scalar::f32},
    {Format::rg16_float, VK_FORMAT_R16G16_SFLOAT, "rg16f", Scalar::f32},
    {Format::rgba16_float, VK_FORMAT_R16G16B16A16_SFLOAT, "rgba16f", Scalar::f32},
    {Format::rgba16_uint, VK_FORMAT_R16G16B16A16_UINT, "rgba16ui", Scalar::u32},
    {Format::r32_uint, VK_FORMAT_R32_UINT, "r32ui", Scalar::u32},
    {Format::r32_float, VK_FORMAT_R32_SFLOAT, "r32f", Scalar::f32},
    {Format::rg32_uint, VK_FORMAT_R32G32_UINT, "rg32ui", Scalar::u32},
    {Format::rg32_float, VK_FORMAT_R32G32_SFLOAT, "rg32f", Scalar::f32},
    {Format::rgba32_uint, VK_FORMAT_R32G32B32A32_UINT, "rgba32ui", Scalar::u32},
    {Format::rgba32_float, VK_FORMAT_R32G32B32A32_SFLOAT, "rgba32f", Scalar::f32},
    {Format::r11g11b10_float, VK_FORMAT_B10G11R11_UFLOAT_PACK32, "r11f_g11f_b10f", Scalar::f32},
    {Format::rgb9e5_float, VK_FORMAT_E5B9G9R9_UFLOAT_PACK32, nullptr, Scalar::f32},
    {Format::bc4_unorm, VK_FORMAT_BC4_UNORM_BLOCK, nullptr, Scalar::f32},
    {Format::bc5_unorm, VK_FORMAT_BC5_UNORM_BLOCK, nullptr, Scalar::f32},
    {Format::bc7_unorm, VK_FORMAT_BC7_UNORM_BLOCK, nullptr, Scalar::f32},
    {Format::bc7_srgb, VK_FORMAT_BC7_SRGB_BLOCK, nullptr, Scalar::f32},
    {Format::d32_float, VK_FORMAT_D32_SFLOAT, nullptr, Scalar::f32},
};

}  // namespace

const FormatInfo& info_of(Format f) {
  const auto* row = std::ranges::find(kFormats, f, &FormatInfo::format);
  if (row == std::end(kFormats)) throw std::logic_error("a format without a Vulkan name");
  return *row;
}

VkImageAspectFlags aspect_of(Format f) {
  return f == Format::d32_float ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

}  // namespace assay::device
