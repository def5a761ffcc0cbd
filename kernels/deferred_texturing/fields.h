// The G-buffer's texels unpacked, as the bounds judge them.
#pragma once
#include "harness/kernel.h"

namespace assay::deferred_texturing {

using glm::vec2;
using glm::vec3;
using glm::vec4;

vec4 base_roughness_of(uint32_t texel);  // square roots of the colour; roughness
vec3 normal_of(uint32_t texel);          // unit
vec2 metallic_occlusion_of(uint16_t texel);
vec3 emissive_of(uint32_t texel);  // radiance

Unpack unpack_base_roughness();
Unpack unpack_normal();
Unpack unpack_metallic_occlusion();
Unpack unpack_emissive();

}  // namespace assay::deferred_texturing
