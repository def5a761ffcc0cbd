// How far a drawn particle is from one that is lit at every pixel.
#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "harness/half.h"
#include "kernels/particles/air.h"
#include "kernels/particles/inputs.h"
#include "kernels/particles/light.h"

namespace assay::particles {

using glm::dvec2;
using glm::dvec3;

namespace {

constexpr Extent kExtent = {256, 256};
constexpr double kHalfSide_m = 2, kDepth_m = 2;  // it fills the view
constexpr const char* kShadow = "shadow edge";
constexpr const char* kUsual = "32 r11g11b10f";  // what a particle of this size has in a frame

// Whether a place on the quad is in a shadow whose edge is aslant.
bool in_shadow(const std::string& input_class, const dvec2& at) {
  return input_class.starts_with(kShadow) && at.x + 0.3 * at.y < 0.1;
}

dvec3 exact_light(const Case& c, const dvec2& at) {
  if (in_shadow(c.name, at)) return {};
  const ParticleRecord p = c.input<ParticleRecord>("particles")[0];
  const Colour light = lit(p, {position(p, at), 0}, vec3(0), c.input<LightRecord>("lights"));
  dvec3 middle;
  for (size_t i = 0; i < 3; ++i) middle[static_cast<int>(i)] = (light[i].low + light[i].high) / 2;
  return middle;
}

// One particle, opaque in the middle, over black, under a light so many of its half sides before it.
Case lit_case(const std::string& name, double height, uint32_t side, uint32_t encoding) {
  Air a = air(kExtent);
  for (vec4& t : a.radiance) t = vec4(0, 0, 0, 1);
  for (float& d : a.depth) d = 0;
  a.params.ambient = vec3(0);
  a.params.encoding = encoding;
  ParticleRecord p = facing({0, 0, -kDepth_m}, kHalfSide_m);
  p.opacity = 1, p.softness = 0, p.albedo = vec3(1);
  a.add(p, rect(side, 0, 0));
  a.lights.push_back({.position = vec3(dvec3(0.3, 0.2, -kDepth_m + height * kHalfSide_m)),
                      .colour = vec3(dvec3(20, 14, 8) * height),
                      .kind = kLightPoint});
  Case c = to_case(name, a);
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x)
      a.atlas[y * a.side + x] = encoded(exact_light(c, (2.0 * dvec2(x, y) + 1.0) / double(side) - 1.0), encoding);
  set_atlas(c, encoding, a.atlas);
  return c;
}

std::vector<Figure> figures(const Variant& v, const Case& c, const std::map<std::string, Bytes>& written) {
  const bool samples = v.name != "per_vertex" && v.name != "per_pixel";
  // Those have no shadows, and neither side nor encoding: once is enough.
  if (!samples && (c.name.starts_with(kShadow) || !c.name.ends_with(kUsual))) return {};
  const Bytes& bytes = written.at("radiance");
  std::vector<std::array<uint16_t, 4>> texels(bytes.size() / 8);
  std::memcpy(texels.data(), bytes.data(), bytes.size());
  double squares = 0, most = 0, mean = 0, counted = 0;
  for (uint32_t y = 0; y < kExtent.height; ++y)
    for (uint32_t x = 0; x < kExtent.width; ++x) {
      // The quad faces the eye and fills the view, up to the top.
      const dvec2 at = {(x + 0.5) / kExtent.width * 2 - 1, 1 - (y + 0.5) / kExtent.height * 2};
      const double inside = std::max(1 - glm::dot(at, at), 0.0), alpha = inside * inside;
      if (alpha == 0) continue;
      const dvec3 light = exact_light(c, at) * alpha;
      for (int i = 0; i < 3; ++i) {
        const double off = half_value(texels[size_t{y} * kExtent.width + x][static_cast<size_t>(i)]) - light[i];
        squares += off * off, most = std::max(most, std::fabs(off)), mean += light[i], ++counted;
      }
    }
  mean /= counted;
  return {{"error of the mean, rms", std::sqrt(squares / counted) / mean}, {"max", most / mean}};
}

}  // namespace

// "smooth light, 32 r11g11b10f": the study of particles' light asks for all of them by name (harness/study).
ErrorTable error_table() {
  struct Light {
    const char* name;
    double height;
  };
  ErrorTable t = {.figures = figures};
  for (const Light& light : {Light{"smooth light", 1}, Light{"close light", 0.15}, Light{kShadow, 0.5}})
    for (const uint32_t side : {8u, 16u, 32u})
      for (const auto& [encoding, of] : {std::pair(kLightR11G11B10, "r11g11b10f"), std::pair(kLightRgb9e5, "rgb9e5"),
                                         std::pair(kLightRgba16, "rgba16f")}) {
        const std::string name = fmt::format("{}, {} {}", light.name, side, of);
        t.classes.push_back({.name = name,
                             .why = "",
                             .make = [=, code = encoding] { return lit_case(name, light.height, side, code); },
                             .nightly = !name.ends_with(kUsual)});
      }
  return t;
}

}  // namespace assay::particles
