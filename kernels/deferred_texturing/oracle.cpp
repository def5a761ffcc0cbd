#include "kernels/deferred_texturing/oracle.h"

#include <cmath>

#include "harness/formats/features.h"
#include "harness/formats/pixel_commands.h"
#include "harness/formats/visibility.h"
#include "harness/judged.h"
#include "kernels/deferred_texturing/fields.h"
#include "kernels/deferred_texturing/material.h"

namespace assay::deferred_texturing {

namespace {

struct Inputs {
  TexturingParams params;
  std::span<const uvec2> visibility;
  std::span<const SurfaceRecord> surfaces;
  std::span<const MaterialRecord> materials;
  std::span<const uint> indices;
  std::span<const vec3> positions;
  std::span<const VertexAttributes> vertices;
  std::span<const uint> barycentrics;
  std::span<const uvec2> derivatives, tangent_frame;
  Filter filter;
};
Inputs inputs_of(const Case& c) {
  std::span<const Texture> textures;
  if (const auto it = c.textures.find("textures"); it != c.textures.end()) textures = it->second;
  return {c.params<TexturingParams>(),           c.input<uvec2>("visibility"),  c.input<SurfaceRecord>("surfaces"),
          c.input<MaterialRecord>("materials"),  c.input<uint>("indices"),      c.input<vec3>("positions"),
          c.input<VertexAttributes>("vertices"), c.input<uint>("barycentrics"), c.input<uvec2>("derivatives"),
          c.input<uvec2>("tangent_frame"),       Filter(textures, c.device)};
}

// The material that textures a surface; kNoMaterial where nothing does.
uint32_t material_of(const Inputs& in, uint32_t surface) {
  if (surface >= in.params.surfaces) return kNoMaterial;
  const uint32_t material = in.surfaces[surface].material;
  if (material >= in.params.materials) return kNoMaterial;
  const uint32_t shader = in.materials[material].shader;
  return shader < kShaderClasses && in.params.slot_of_class[shader] != kUnregistered ? material : kNoMaterial;
}

using Corners = interpolation::Few<uint32_t, 3>;  // vertices
Corners corners(const Inputs& in, const SurfaceRecord& s, uint32_t triangle) {
  Corners c;
  for (uint32_t k = 0; k < 3; ++k) {
    const uint32_t index = in.indices[std::min(s.first_index + 3 * triangle + k, in.params.indices - 1)];
    c[static_cast<int>(k)] = std::min(index + s.vertex_offset, in.params.vertices - 1);
  }
  return c;
}

// Where a pixel's attributes come from.
enum class Source { stored, mesh };

PixelAttributes attributes_of(const Inputs& in, uint64_t pixel, Source source, const SurfaceRecord& s,
                              const Corners& c) {
  if (source == Source::stored) return decoded(in.barycentrics[pixel], in.derivatives[pixel], in.tangent_frame[pixel]);
  interpolation::Triangle t;
  interpolation::Few<const VertexAttributes*, 3> vertices;
  for (int k = 0; k < 3; ++k) {
    interpolation::set_corner(t, k, s, in.positions[c[k]]);
    vertices[k] = &in.vertices[c[k]];
  }
  interpolation::place(t, uvec2(pixel % in.params.width, pixel / in.params.width),
                       uvec2(in.params.width, in.params.height));
  return interpolated(t, s, (in.visibility[pixel].y & kVisibilityFlipped) != 0, vertices);
}

// A direction somewhere in a box: its middle, and how far the unit vector may be from the middle's.
struct Direction {
  glm::dvec3 middle = {};
  double error = 2;  // anything
};
Direction direction_of(const Range3& n) {
  glm::dvec3 middle, radius;
  for (int i = 0; i < 3; ++i) {
    const Range& axis = n[static_cast<size_t>(i)];
    middle[i] = axis.middle(), radius[i] = axis.radius();
  }
  const double length = std::sqrt(middle.x * middle.x + middle.y * middle.y + middle.z * middle.z),
               reach = std::sqrt(radius.x * radius.x + radius.y * radius.y + radius.z * radius.z);
  if (!(reach < length)) return {};
  return {middle / length, 2 * std::sin(std::asin(reach / length) / 2)};
}

Range squared_length(const Range3& n) { return square(n[0]) + square(n[1]) + square(n[2]); }

// Tangent space to world; where the direction is lost, the surface's own normal.
Direction shading_normal(const Range3& n, const PixelAttributes& a, bool turned) {
  Range3 bitangent;
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
    bitangent[i] = a.normal[j] * a.tangent[k] - a.normal[k] * a.tangent[j];
  }
  if (a.left_handed) bitangent = -bitangent;
  const Range3 world = n[0] * a.tangent + n[1] * bitangent + n[2] * a.normal;
  const Range squared = squared_length(world);
  Direction d;
  if (squared.is_nan() || squared.high < kLeastNormal || squared.low >= kLargestNormal)
    d = direction_of(a.normal);
  else if (squared.low >= kLeastNormal && squared.high < kLargestNormal)
    d = direction_of(world);
  if (turned) d.middle = -d.middle;
  return d;
}

// ---- Storage

float at_most(double v) {
  const auto f = static_cast<float>(v);
  return double{f} > v ? std::nextafter(f, -INFINITY) : f;
}
float at_least(double v) {
  const auto f = static_cast<float>(v);
  return double{f} < v ? std::nextafter(f, INFINITY) : f;
}

// Either code next to the number (Vulkan, Conversion From Floating-Point to Normalized Fixed-Point).
struct Codes {
  float low, high;
};
Codes unorm8(Range v) {
  const Range codes = rounded(Range(255.0) * clamped(v, 0, 1));
  const double low = std::max(std::floor(codes.low), 0.0), high = std::min(std::ceil(codes.high), 255.0);
  return {static_cast<float>(low / 255), static_cast<float>(high / 255)};
}

// A step of the encoding in x and in y moves (x, y, 1 - |x| - |y|), which is at least 1 / sqrt(3) long, by sqrt(6)
// steps; the encoder's own rounding is below a hundredth of that.
const double kOctahedral = 1.01 * std::sqrt(18.0) / 32767;

// The shared exponent follows the largest channel, and half its step is lost.
std::array<Codes, 3> shared_exponent(const Range3& radiance) {
  Range3 c;
  double largest = 0;
  for (size_t i = 0; i < 3; ++i) c[i] = clamped(radiance[i], 0, 65408), largest = std::max(largest, c[i].high);
  int exponent = std::max(largest > 0 ? std::ilogb(largest) : -16, -16) + 16;
  if (std::ldexp(largest, 24 - exponent) >= 511.5) ++exponent;
  const double half_step = std::ldexp(0.5, exponent - 24);
  std::array<Codes, 3> codes;
  for (size_t i = 0; i < 3; ++i)
    codes[i] = {at_most(std::max(c[i].low - half_step, 0.0)), at_least(c[i].high + half_step)};
  return codes;
}

// ---- Answers

// What a pixel of each output may hold.
struct TexelRange {
  vec4 base_low = vec4(0), base_high = vec4(0);
  vec3 normal_low = vec3(0, 0, 1), normal_high = vec3(0, 0, 1);
  vec2 metallic_low = vec2(0), metallic_high = vec2(0);
  vec3 emissive_low = vec3(0), emissive_high = vec3(0);
  bool determined = true;
};

TexelRange texel_of(const RangeLayer& l, const Direction& normal) {
  TexelRange t;
  for (int i = 0; i < 4; ++i) {
    const Codes c = unorm8(i < 3 ? root(clamped(l.base[static_cast<size_t>(i)], 0, 1)) : l.roughness);
    t.base_low[i] = c.low, t.base_high[i] = c.high;
  }
  const auto emissive = shared_exponent(l.emissive);
  for (int i = 0; i < 3; ++i) {
    const double reach = normal.error + kOctahedral;
    t.normal_low[i] = at_most(reach < 2 ? normal.middle[i] - reach : -1.001);
    t.normal_high[i] = at_least(reach < 2 ? normal.middle[i] + reach : 1.001);
    t.emissive_low[i] = emissive[static_cast<size_t>(i)].low,
    t.emissive_high[i] = emissive[static_cast<size_t>(i)].high;
  }
  const Codes metallic = unorm8(l.metallic), occlusion = unorm8(l.occlusion);
  t.metallic_low = {metallic.low, occlusion.low}, t.metallic_high = {metallic.high, occlusion.high};
  return t;
}

TexelRange texel_at(const Inputs& in, uint64_t pixel, Source source) {
  const uvec2 visible = in.visibility[pixel];
  const uint32_t surface = visible.y & kVisibilitySurfaceMask, material = material_of(in, surface);
  if (material == kNoMaterial) return {};
  const SurfaceRecord& s = in.surfaces[surface];
  const Corners c = corners(in, s, visible.x);
  const PixelAttributes a = attributes_of(in, pixel, source, s, c);
  const RangeFootprint f = footprint_of({in.vertices[c[0]].uv, in.vertices[c[1]].uv, in.vertices[c[2]].uv}, a);
  const RangeLayer l = shaded(in.materials, material, surface, in.filter, f);
  const MaterialRecord& m = in.materials[material];
  const bool both_sides =
      (m.flags & kMaterialDoubleSided) != 0 || m.shader == kShaderMasked || m.shader == kShaderFoliage;
  TexelRange t = texel_of(l, shading_normal(l.normal, a, both_sides && !a.front_facing));
  t.determined = a.determined;
  return t;
}

template <class T>
void append(Bytes& to, const T& value) {
  const auto* p = reinterpret_cast<const std::byte*>(&value);
  to.insert(to.end(), p, p + sizeof value);
}

struct Answers {
  Expected base, normal, metallic, emissive;
  uint32_t count = 0;  // alternatives
  std::vector<uint32_t> first = {0};

  // What is undetermined counts as two alternatives, so that it is told from what was judged.
  void add(const TexelRange& t) {
    for (int i = 0; i < (t.determined ? 1 : 2); ++i, ++count) {
      append(base.low, t.base_low), append(base.high, t.base_high);
      append(normal.low, t.normal_low), append(normal.high, t.normal_high);
      append(metallic.low, t.metallic_low), append(metallic.high, t.metallic_high);
      append(emissive.low, t.emissive_low), append(emissive.high, t.emissive_high);
    }
  }
  void end_pixel() { first.push_back(count); }
  void close(const std::vector<uint64_t>& judged) {
    for (Expected* e : {&base, &normal, &metallic, &emissive}) e->first = first, e->judged = judged;
  }
};

constexpr uint64_t kSampledAbove = 1u << 17;  // pixels

// Entries copy a pixel's result to its neighbours in the quad: for each pixel, those that others copy to it.
std::map<uint64_t, std::vector<uint64_t>> copies(const Case& c) {
  std::map<uint64_t, std::vector<uint64_t>> from;
  const uint32_t mask = (1u << kEntryCoordinateBits) - 1;
  for (const uint entry : c.input<uint>("entries")) {
    const uint32_t bits = entry >> kEntryCopyShift & kCopyBits;
    if ((entry & kEntryInvalid) != 0 || bits == 0) continue;
    const uint32_t x = entry & mask, y = entry >> kEntryCoordinateBits & mask;
    const auto add = [&](uint32_t bit, uint32_t to_x, uint32_t to_y) {
      if ((bits & bit) == 0 || to_x >= c.extent.width || to_y >= c.extent.height) return;
      from[uint64_t{to_y} * c.extent.width + to_x].push_back(uint64_t{y} * c.extent.width + x);
    };
    add(kCopyHorizontal, x ^ 1, y), add(kCopyVertical, x, y ^ 1), add(kCopyDiagonal, x ^ 1, y ^ 1);
  }
  return from;
}

Answers answers_of(const Inputs& in, const Case& c, const std::vector<uint64_t>& judged, Source source) {
  const auto copied = copies(c);
  Answers answers;
  for_each_judged(c, judged, [&](uint64_t pixel) {
    answers.add(texel_at(in, pixel, source));
    // A variant without lists shades such a pixel itself.
    if (const auto it = copied.find(pixel); it != copied.end())
      for (const uint64_t from : it->second) answers.add(texel_at(in, from, source));
    answers.end_pixel();
  });
  answers.close(judged);
  return answers;
}

}  // namespace

Answer textured(const Case& c) {
  const Inputs in = inputs_of(c);
  const std::vector<uint64_t> judged = judged_pixels(c, kSampledAbove);
  Answer answer;
  for (const Source source : {Source::stored, Source::mesh}) {
    Answers a = answers_of(in, c, judged, source);
    const std::string prefix = source == Source::mesh ? kInline : "";
    answer[prefix + "base_roughness"] = std::move(a.base), answer[prefix + "normal"] = std::move(a.normal);
    answer[prefix + "metallic_occlusion"] = std::move(a.metallic), answer[prefix + "emissive"] = std::move(a.emissive);
  }
  std::vector<uint> bits(pixel_count(c.extent));
  for (uint64_t i = 0; i < bits.size(); ++i) {
    const uint32_t material = material_of(in, in.visibility[i].y & kVisibilitySurfaceMask);
    bits[i] = material == kNoMaterial ? 0 : in.materials[material].features;
  }
  answer["features"] = expect_all(bits);
  return answer;
}

}  // namespace assay::deferred_texturing
