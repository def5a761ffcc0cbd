#include "tests/reference.h"

#include <fmt/format.h>

#include <cmath>

#include "harness/oracle.h"
#include "tests/decals.h"

namespace assay::tests {
namespace {

using glm::dvec3;

// Calls `judge` for every random pixel that can be judged, with its hit (none: background); it returns what is wrong,
// or nothing.
template <class Judge>
Verdict over_pixels(const View& view, uint32_t pixels, uint64_t seed, const Judge& judge) {
  Verdict v;
  Pcg32 rng(seed);
  for (uint32_t i = 0; i < pixels; ++i) {
    const uint32_t x = rng.below(view.extent.width), y = rng.below(view.extent.height);
    const std::optional<Hit> hit = cast(view.scene, view.camera, view.extent, x + 0.5, y + 0.5);
    const Doubt doubt = doubt_of(hit);
    if (doubt != Doubt::none) {
      ++(doubt == Doubt::edge ? v.edges : doubt == Doubt::alpha ? v.alpha : v.ties);
      continue;
    }
    ++v.judged;
    std::optional<SurfacePoint> point;
    if (hit && hit->instance != scene::kNone)
      point = surface_at(view.scene, view.camera, view.extent, x + 0.5, y + 0.5, *hit);
    v.background += !point;
    const std::string wrong = judge(size_t{y} * view.extent.width + x, point, hit, v);
    if (!wrong.empty()) v.wrong.push_back(fmt::format("pixel {},{}: {}", x, y, wrong));
  }
  return v;
}

dvec3 ambient_share(const Shaded& s, const dvec3& ambient, double occlusion) {
  const double metal = s.features & kFeatureSkin ? 0 : s.metallic;
  return ambient * (s.base * (1 - metal) + 0.04 * (1 - metal) + s.base * metal) * occlusion;
}

std::string outside(const dvec3& got, const dvec3& expected, const dvec3& error) {
  for (int c = 0; c < 3; ++c) {
    // Of a half: either next to it (2^-10 of it), flushed if denormal; beyond the largest there is none.
    const double wanted = std::min(expected[c], 65504.0);
    const double allowed = error[c] + (wanted + error[c]) * std::ldexp(1.0, -10) + std::ldexp(1.0, -14);
    if (!(std::abs(got[c] - wanted) <= allowed))
      return fmt::format("radiance {} is {:.6g}, expected {:.6g} within {:.2g}", "rgb"[c], got[c], wanted, allowed);
  }
  return "";
}

}  // namespace

std::string to_text(const Verdict& v) {
  std::string text = fmt::format(
      "{} judged ({} background, {} under decals), not judged: {} at an edge, {} at an alpha cut, {} ties, {} at a "
      "decal's "
      "face, {} of other classes; {} wrong",
      v.judged, v.background, v.decaled, v.edges, v.alpha, v.ties, v.faces, v.classes, v.wrong.size());
  for (size_t i = 0; i < v.wrong.size() && i < 10; ++i) text += "\n  " + v.wrong[i];
  return text;
}

Verdict judge_gbuffer(const View& view, std::span<const GBufferPixel> gbuffer, uint32_t pixels, uint64_t seed) {
  Filter filter(view.scene);
  return over_pixels(view, pixels, seed,
                     [&](size_t at, const std::optional<SurfacePoint>& point, const auto&, Verdict& v) -> std::string {
                       if (!point)
                         return gbuffer[at] == GBufferPixel() ? "" : "holds a surface where the ray meets none";
                       const std::optional<Appearance> expected = appearance_of(view.scene, *point, filter);
                       if (expected)
                         return disagreement(*expected, gbuffer[at], view.scene.materials[point->material].name);
                       --v.judged, ++v.classes;
                       return "";
                     });
}

Verdict judge_decals(const View& view, std::span<const GBufferPixel> before, std::span<const GBufferPixel> after,
                     std::span<const float> depth, uint32_t pixels, uint64_t seed) {
  return over_pixels(view, pixels, seed,
                     [&](size_t at, const std::optional<SurfacePoint>& point, const std::optional<Hit>& hit,
                         Verdict& v) -> std::string {
                       if (!point) return after[at] == before[at] ? "" : "a decal lies on the background";
                       const double moved = view.camera.near_plane / double{depth[at]} / hit->distance;
                       const Decaled expected = decaled(view.scene, view.camera, before[at], point->position * moved,
                                                        point->per_x * moved, point->per_y * moved);
                       if (expected.at_face) {
                         --v.judged, ++v.faces;
                         return "";
                       }
                       v.decaled += expected.touched[0] || expected.touched[1] || expected.touched[2];
                       return disagreement(expected, before[at], after[at]);
                     });
}

Verdict judge_radiance(const View& view, const LitFrame& frame, std::span<const scene::Light> lights, uint32_t pixels,
                       uint64_t seed) {
  return over_pixels(
      view, pixels, seed,
      [&](size_t at, const std::optional<SurfacePoint>& point, const std::optional<Hit>& hit, Verdict&) -> std::string {
        if (!point) return outside(frame.radiance[at], dvec3(0), dvec3(0));
        const double depth = double{frame.depth[at]}, expected_depth = view.camera.near_plane / hit->distance;
        if (!(std::abs(depth - expected_depth) <= expected_depth * point->depth_error))
          return fmt::format("depth is {:.7g}, expected {:.7g} within {:.1e} of it", depth, expected_depth,
                             point->depth_error);
        const Shaded s = shaded_of(frame.gbuffer[at], frame.features[at]);
        const dvec3 position = view.camera.eye + point->position * (expected_depth / depth);
        Lit lit = reflected(s, position, view.camera.eye, lights);
        const dvec3 rest = shared_exponent_radiance(frame.gbuffer[at].emissive) +
                           ambient_share(s, frame.ambient, frame.gbuffer[at].metallic_occlusion[1] / 255.0);
        lit.radiance += rest;
        lit.error += rest * std::ldexp(20.0, -24);
        return outside(frame.radiance[at], lit.radiance, lit.error);
      });
}

}  // namespace assay::tests
