// How far each variant is off, class by class, in what a texture lookup sees of it: texels and levels of detail.
#include <algorithm>
#include <cmath>

#include "harness/known.h"
#include "kernels/attribute_interpolation/classes.h"
#include "kernels/attribute_interpolation/codes.h"
#include "kernels/attribute_interpolation/inputs.h"
#include "kernels/attribute_interpolation/triangle.h"

namespace assay::attribute_interpolation {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr uint32_t kSamples = 16384;  // of a class
constexpr double kTexels = 4096;      // across the texture; coordinates of a triangle span all of it
constexpr double kWrong = 1e30;       // a figure of NaN or infinity
// Half a step of unorm16 in two weights, and what the arithmetic adds: 0.06 texels. Any size of triangle: 1/40 of a
// level.
constexpr double kStoredWeight = 1.6e-5, kStoredTexels = 0.06, kStoredLevel = 0.025;

// Weights and derivatives, exact or as a variant has them.
struct Answered {
  dvec3 weights;
  dvec2 d_dx, d_dy;  // of lambda_1, lambda_2
};

Answered exact_answer(const Hit& h) {
  return {{h.weights[0].value, h.weights[1].value, h.weights[2].value},
          {h.derivatives[0].value, h.derivatives[1].value},
          {h.derivatives[2].value, h.derivatives[3].value}};
}

template <class T>
T element(const Bytes& bytes, uint64_t i) {
  T t;
  std::memcpy(&t, bytes.data() + i * sizeof t, sizeof t);
  return t;
}

Answered stored_answer(const std::map<std::string, Bytes>& written, uint64_t i, uint encoding) {
  if (const auto floats = written.find("unpacked"); floats != written.end()) {
    const auto a = element<UnpackedAttributes>(floats->second, i);
    return {dvec3(a.barycentrics), {a.derivatives.x, a.derivatives.y}, {a.derivatives.z, a.derivatives.w}};
  }
  const BarycentricFields b = barycentric_fields(element<uint>(written.at("barycentrics"), i), encoding);
  const DerivativeFields d = derivative_fields(element<uvec2>(written.at("derivatives"), i), encoding);
  const dvec2 w(b.weights);
  return {{1 - w.x - w.y, w.x, w.y}, {d.derivatives.x, d.derivatives.y}, {d.derivatives.z, d.derivatives.w}};
}

// Texture coordinates of the vertices relative to the first's.
struct Mapping {
  dvec2 a, b;
  dvec2 at(const dvec3& weights) const { return weights.y * a + weights.z * b; }
  // The longer of the gradients along x and y.
  double footprint(const Answered& s) const {
    return std::max(length(s.d_dx.x * a + s.d_dx.y * b), length(s.d_dy.x * a + s.d_dy.y * b));
  }
};

double figure(double v) { return v >= 0 && v < kWrong ? v : kWrong; }

struct Errors {
  std::vector<double> weights, texels, levels;

  void add(const Answered& got, const Answered& want, const Mapping& m) {
    const dvec3 off = abs(got.weights - want.weights);
    weights.push_back(figure(std::max({off.x, off.y, off.z}) + 0 * (off.x + off.y + off.z)));
    const dvec2 moved = abs(m.at(got.weights) - m.at(want.weights));  // along each axis of the texture
    texels.push_back(figure(kTexels * std::max(moved.x, moved.y) + 0 * (moved.x + moved.y)));
    levels.push_back(figure(std::fabs(std::log2(m.footprint(got) / m.footprint(want)))));
  }
};

double quantile(std::vector<double>& v, double share) {
  if (v.empty()) return 0;
  const auto at = static_cast<size_t>(share * static_cast<double>(v.size() - 1));
  std::ranges::nth_element(v, v.begin() + static_cast<ptrdiff_t>(at));
  return v[at];
}

uint encoding_of(const Variant& v) { return v.constants.empty() ? kAttributesPacked : v.constants[0].values[0]; }

double finite_or_none(double goal) { return std::isfinite(goal) ? goal : 0; }

// What numbers a variant must keep to over a class: the compensated formula's, before and after storage.
struct Limits {
  double weight_max = 0, weight_p999 = 0, texels_max = 0, level_max = 0;
};
Limits limits_of(const Variant& v, const Goal& g) {
  if (v.name.starts_with("recentred_compensated_floats"))
    return {finite_or_none(g.weight_max), finite_or_none(g.weight_p999), 0, finite_or_none(g.level_max)};
  const bool conditioned = std::isfinite(g.weight_p999);
  if (v.name.starts_with("recentred_compensated") && encoding_of(v) != kAttributesHalves && conditioned)
    return {kStoredWeight, 0, kStoredTexels, kStoredLevel};
  return {};
}

// Of a class: samples whose answer is determined, and how many are not, by the compensated formula.
struct Truth {
  struct Sample {
    uint64_t index;
    Answered exact;
    Mapping mapping;
  };
  std::vector<Sample> samples;
  uint64_t undetermined = 0;
};
Truth truth_of(const Scene& scene) {
  Pcg32 rng(2);
  Truth t;
  for (uint64_t i = 0; i < scene.params.clip_samples; ++i) {
    const auto triangle = triangle_at(scene, i);
    const dvec2 uv[] = {{rng.unit(), rng.unit()}, {rng.unit(), rng.unit()}, {rng.unit(), rng.unit()}};
    if (!hit(*triangle, Formula::compensated).determined) ++t.undetermined;
    const Hit exact = hit(*triangle, Formula::paired);
    if (exact.determined) t.samples.push_back({i, exact_answer(exact), {uv[1] - uv[0], uv[2] - uv[0]}});
  }
  return t;
}

std::vector<Figure> figures(const Variant& v, const Case& c, const std::map<std::string, Bytes>& written) {
  static Known<Truth> known;
  const Scene scene = scene_of(c);
  const Truth& truth = known.at(c.name, [&] { return truth_of(scene); });
  Errors e;
  for (const auto& [index, exact, mapping] : truth.samples)
    e.add(stored_answer(written, index, encoding_of(v)), exact, mapping);
  const Limits limit = limits_of(v, input_class(c.name).goal);
  return {{"weight p99.9", quantile(e.weights, 0.999), limit.weight_p999},
          {"weight max", quantile(e.weights, 1), limit.weight_max},
          {"texels p99.9", quantile(e.texels, 0.999), 0},
          {"texels max", quantile(e.texels, 1), limit.texels_max},
          {"levels p99.9", quantile(e.levels, 0.999), 0},
          {"levels max", quantile(e.levels, 1), limit.level_max},
          {"undetermined", static_cast<double>(truth.undetermined) / scene.params.clip_samples, 0}};
}

}  // namespace

ErrorTable error_table() {
  ErrorTable t = {.classes = {}, .figures = figures};
  for (const InputClass& k : input_classes())
    t.classes.push_back({k.name, k.why, [&k] { return class_case(k, kSamples); }});
  return t;
}

}  // namespace assay::attribute_interpolation
