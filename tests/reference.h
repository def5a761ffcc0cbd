// A frame's G-buffer and radiance against the ray caster, at random pixels: each agrees, or disagrees for a cause that
// is said, or cannot be judged for a cause that is counted.
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "tests/shading.h"
#include "tests/surface.h"

namespace assay::tests {

struct View {
  const scene::Scene& scene;
  const scene::Camera& camera;
  Extent extent;
};

struct Verdict {
  uint32_t judged = 0, background = 0;  // background: of the judged
  // Not judged: at a face of a decal's box; of classes whose texturing is not repeated here.
  uint32_t edges = 0, alpha = 0, ties = 0, faces = 0, classes = 0;
  uint32_t decaled = 0;            // of the judged, that a decal touches
  std::vector<std::string> wrong;  // a pixel each
};
std::string to_text(const Verdict&);

// What deferred texturing wrote against the materials.
Verdict judge_gbuffer(const View&, std::span<const GBufferPixel>, uint32_t pixels, uint64_t seed);

// What decals made of the frame's own G-buffer and depth, against the scene's decals.
Verdict judge_decals(const View&, std::span<const GBufferPixel> before, std::span<const GBufferPixel> after,
                     std::span<const float> depth, uint32_t pixels, uint64_t seed);

// What deferred lighting made of the frame's own G-buffer and depth (near / w, 0 is nothing), against the scene's
// lights. `features` are the pixels' bits; `ambient` is radiance from everywhere. The depth itself is judged too.
struct LitFrame {
  std::span<const GBufferPixel> gbuffer;
  std::span<const uint32_t> features;
  std::span<const float> depth;
  std::span<const glm::dvec3> radiance;
  glm::dvec3 ambient = {};
};
Verdict judge_radiance(const View&, const LitFrame&, std::span<const scene::Light>, uint32_t pixels, uint64_t seed);

}  // namespace assay::tests
