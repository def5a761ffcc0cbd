// The G-buffer that deferred texturing writes, updates touch, and lighting reads. A pixel without a surface has all
// bits zero in every channel.
//
// base_roughness      rgba8_unorm   rgb: square root of linear base colour; a: perceptual roughness
// normal              rg16_snorm    world normal, octahedral (Cigolle et al. 2014)
// metallic_occlusion  rg8_unorm     r: metallic, or of skin (kFeatureSkin), which is no metal, thickness, 1 letting no
//                                   light through; g: occlusion, 1 is open
// emissive            r32_uint      radiance, E5B9G9R9 as Vulkan defines it, rounded to nearest
// features            buffer of uint, a pixel: bits of formats/features.h
#ifndef FORMATS_GBUFFER_H
#define FORMATS_GBUFFER_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

SHARED_CONST float kMinimumRoughness = 0.045f;  // perceptual; below, the highlight of a punctual light has no width

SHARED_END
#endif
