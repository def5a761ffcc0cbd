// Materials: glTF's metallic-roughness model, and what the shader classes of deferred texturing add to it.
#ifndef FORMATS_MATERIAL_H
#define FORMATS_MATERIAL_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

// Textures are named array << 16 | layer, kNoTexture where there is none.
SHARED_CONST uint kNoTexture = 0xffffffffu;
SHARED_CONST uint kNoMaterial = 0xffffffffu;

// Shader classes: each is a texturing shader of its own. All read base colour, normal, metallic-roughness, occlusion
// and emission; beyond that
SHARED_CONST uint kShaderOpaque = 0u;          // nothing
SHARED_CONST uint kShaderMasked = 1u;          // both sides are seen: normals of back faces are turned
SHARED_CONST uint kShaderTwoLayer = 2u;        // a second material on top, where mask and heights say so
SHARED_CONST uint kShaderEmissiveDetail = 3u;  // emission and base colour times a detail texture of its own scale
SHARED_CONST uint kShaderCloth = 4u;    // height of threads in `detail_texture` R, rough between; sheen by lighting
SHARED_CONST uint kShaderSkin = 5u;     // thickness in `mask_texture`, kept in place of metallic
SHARED_CONST uint kShaderWet = 6u;      // wetness in `mask_texture` darkens and smooths (Lagarde 2013)
SHARED_CONST uint kShaderFoliage = 7u;  // as masked; its tint varies by surface
SHARED_CONST uint kShaderClasses = 8u;

struct MaterialRecord {
  vec4 base_colour;   // linear factor; alpha too
  uint base_texture;  // sRGB; alpha linear
  float alpha_cutoff;
  uint flags;                       // kMaterial... of formats/scene.h
  uint features;                    // bits of formats/features.h
  vec3 emissive;                    // linear factor, radiance
  uint emissive_texture;            // sRGB
  float metallic;                   // factor, 0..1
  float roughness;                  // factor, 0..1, perceptual
  uint metallic_roughness_texture;  // linear; roughness in G, metallic in B, height in A (two-layer)
  uint normal_texture;              // linear, xy in RG as unorm of [-1, 1]; z is derived
  float normal_scale;
  uint occlusion_texture;  // linear, R
  float occlusion_strength;
  uint shader;          // kShader...
  uint layer;           // two-layer: the record on top, whose own layer is ignored; kNoMaterial
  uint mask_texture;    // linear, R; white where there is none
  float blend_depth;    // two-layer: the difference of heights over which the layers mix, above 0
  uint detail_texture;  // linear, RGB; sampled at uv * detail_scale
  float detail_scale;
};

#ifdef __cplusplus
SHARED_LAYOUT(MaterialRecord, base_colour, base_texture, alpha_cutoff, flags, features, emissive, emissive_texture,
              metallic, roughness, metallic_roughness_texture, normal_texture, normal_scale, occlusion_texture,
              occlusion_strength, shader, layer, mask_texture, blend_depth, detail_texture, detail_scale);
#endif
SHARED_END
#endif
