#include "kernels/decal_atlas_sampling/oracle.h"

#include <cmath>
#include <unordered_map>

#include "harness/half.h"
#include "harness/judged.h"
#include "kernels/decal_atlas_sampling/material.h"
#include "kernels/decal_atlas_sampling/sources.h"

namespace assay::decal_atlas_sampling {

namespace {

constexpr uint64_t kSampledAbove = 1u << 17;  // pixels

// ---- The G-buffer's texels

glm::dvec3 direction_of(uint32_t texel) {
  const auto snorm = [](uint32_t code) { return std::max(static_cast<int16_t>(code & 0xffffu) / 32767.0, -1.0); };
  glm::dvec3 n = {snorm(texel), snorm(texel >> 16), 0};
  n.z = 1 - std::fabs(n.x) - std::fabs(n.y);
  if (n.z < 0) {
    const double x = n.x;
    n.x = std::copysign(1 - std::fabs(n.y), x), n.y = std::copysign(1 - std::fabs(x), n.y);
  }
  return n / glm::length(n);
}
vec3 normal_of(uint32_t texel) { return vec3(direction_of(texel)); }
vec4 base_roughness_of(uint32_t t) {
  const auto unorm8 = [](uint32_t code) { return static_cast<float>((code & 0xffu) / 255.0); };
  return {unorm8(t), unorm8(t >> 8), unorm8(t >> 16), unorm8(t >> 24)};
}

template <class F>
Unpack unpack(F of) {
  using Fields = decltype(of(0u));
  return {layout_of<Fields>(), [of](std::span<const std::byte> texels) {
            std::vector<uint32_t> codes(texels.size() / 4);
            std::memcpy(codes.data(), texels.data(), codes.size() * 4);
            std::vector<Fields> fields;
            fields.reserve(codes.size());
            for (const uint32_t c : codes) fields.push_back(of(c));
            const auto bytes = std::as_bytes(std::span(fields));
            return Bytes(bytes.begin(), bytes.end());
          }};
}

// ---- A pixel

struct Inputs {
  DecalParams params;
  std::span<const float> depth, edges;
  std::span<const std::array<uint16_t, 2>> gradients;
  std::span<const uint32_t> base_roughness, normal;
  std::span<const DecalRecord> decals;
  std::span<const ReceiverRecord> receivers;
  std::span<const uvec2> cells;
  std::span<const uint> entries, bits;
  Atlas atlas, blocks;
};
Atlas atlas_of(const Case& c, const std::string& port) {
  const std::vector<Texture>& t = c.textures.at(port);
  return {TextureFilter(t[kAtlasAlbedo], c.device),
          TextureFilter(t[kAtlasNormal], c.device),
          TextureFilter(t[kAtlasRoughness], c.device),
          t[0].width,
          t[0].height,
          t[0].levels,
          c.params<DecalParams>().atlas_border};
}
Inputs inputs_of(const Case& c) {
  return {c.params<DecalParams>(),
          c.input<float>("depth"),
          c.input<float>("slice_edges"),
          c.input<std::array<uint16_t, 2>>("depth_gradients"),
          c.input<uint32_t>("base_roughness"),
          c.input<uint32_t>("normal"),
          c.input<DecalRecord>("decals"),
          c.input<ReceiverRecord>("receivers"),
          c.input<uvec2>("cells"),
          c.input<uint>("entries"),
          c.input<uint>("decal_bits"),
          atlas_of(c, "atlas"),
          atlas_of(c, "atlas_blocks")};
}

Intervals3 intervals(const vec3& v) { return {exactly(v.x), exactly(v.y), exactly(v.z)}; }

SurfacePoint point_at(const Inputs& in, uint64_t pixel) {
  const ViewRays& r = in.params.rays;
  const uint64_t column = pixel % in.params.width, line = pixel / in.params.width;
  const Interval x = exactly(static_cast<double>(column) + 0.5), y = exactly(static_cast<double>(line) + 0.5);
  SurfacePoint p;
  p.distance = exactly(in.params.near_plane) / exactly(in.depth[pixel]);
  const double gx = half_value(in.gradients[pixel][0]), gy = half_value(in.gradients[pixel][1]);
  p.finite_dx = std::isfinite(gx), p.finite_dy = std::isfinite(gy);
  const Intervals3 corner = intervals(r.corner), across = intervals(r.across), down = intervals(r.down);
  for (size_t i = 0; i < 3; ++i) {
    const Interval ray = sum_of({corner[i], across[i] * x, down[i] * y});
    p.position[i] = p.distance * ray;
    p.d_dx[i] = p.distance * (across[i] - ray * exactly(p.finite_dx ? gx : 0));
    p.d_dy[i] = p.distance * (down[i] - ray * exactly(p.finite_dy ? gy : 0));
  }
  return p;
}

bool has_surface(float depth) { return depth >= kLeastDecalDepth && std::isfinite(depth); }

// Depths are compared with the boundaries of slices as they are.
uint32_t cell_of(const Inputs& in, uint64_t pixel) {
  const ClusterGrid& g = in.params.grid;
  uint32_t slice = 0;
  for (uint32_t k = 1; k < g.slices; ++k)
    if (in.depth[pixel] <= in.edges[k]) slice = k;
  const auto x = static_cast<uint32_t>(pixel % in.params.width), y = static_cast<uint32_t>(pixel / in.params.width);
  return (slice * g.rows + y / g.cell_height) * g.columns + x / g.cell_width;
}

std::vector<uint32_t> listed(const Inputs& in, uint32_t cell) {
  const uint32_t first = std::min(in.cells[cell].x, in.params.entries);
  const uint32_t count = std::min(
      {in.cells[cell].y >> kClusterDecalShift & kClusterItemMask, kMaxClusterEntries, in.params.entries - first});
  std::vector<uint32_t> all;
  for (uint32_t i = 0; i < count; ++i) all.push_back(in.entries[first + i] >> kClusterDecalShift & kClusterItemMask);
  return all;
}
std::vector<uint32_t> marked(const Inputs& in, uint32_t cell) {
  const uint32_t all_cells = in.params.grid.columns * in.params.grid.rows * in.params.grid.slices;
  std::vector<uint32_t> all;
  for (uint32_t w = 0; w < ceil_div(std::min(in.params.decals, kMaxClusterDecals), 32); ++w)
    for (uint32_t i = 0; i < 32; ++i)
      if ((in.bits[w * all_cells + cell] >> i & 1) != 0) all.push_back(w * 32 + i);
  return all;
}

BlendedMaterial material_of(const Inputs& in, uint64_t pixel) {
  BlendedMaterial m;
  const uint32_t code = in.base_roughness[pixel];
  for (uint32_t i = 0; i < 3; ++i) m.base[i] = square(bounded::rounded(exactly((code >> 8 * i & 255) / 255.0), 5));
  m.roughness = bounded::rounded(exactly((code >> 24) / 255.0), 5);
  m.normal = {direction_of(in.normal[pixel]), 8 * bounded::u};  // three terms, an inverse square root, a product
  return m;
}

BlendedMaterial blended(const Inputs& in, uint64_t pixel, const SurfacePoint& p, const std::vector<uint32_t>& decals,
                        const Atlas& atlas, Filtering filtering = Filtering::trilinear) {
  BlendedMaterial m = material_of(in, pixel);
  for (const uint32_t i : decals) {
    if (i >= in.params.decals) continue;
    const uint32_t receiver = in.decals[i].receiver;
    if (receiver != kNoReceiver && receiver >= in.params.receivers) continue;
    apply(m, in.decals[i], receiver == kNoReceiver ? nullptr : &in.receivers[receiver], p, atlas, filtering);
  }
  return m;
}

// ---- What is stored of it

// Rounded to nearest by hand: a product and a sum before the integer.
float code_of(double v, double direction) {
  const double scaled = std::clamp(v, 0.0, 1.0) * 255 + 0.5;
  return static_cast<float>(std::clamp(std::floor(scaled + direction * 3 * bounded::u * 256), 0.0, 255.0) / 255);
}
// A step of the encoding in x and in y moves (x, y, 1 - |x| - |y|), which is at least 1 / sqrt(3) long, by sqrt(6)
// steps. Rounded to nearest: half a step, a hundredth of it for the encoder's arithmetic.
const double kOctahedral = 1.01 * std::sqrt(18.0) / 2 / 32767;

struct Answers {
  Expected base_roughness, normal;
  uint32_t count = 0;  // alternatives
  std::vector<uint32_t> first = {0};

  template <class T>
  static void append(Bytes& to, const T& v) {
    const auto* p = reinterpret_cast<const std::byte*>(&v);
    to.insert(to.end(), p, p + sizeof v);
  }
  void add(const vec4& low, const vec4& high, const vec3& normal_low, const vec3& normal_high) {
    append(base_roughness.low, low), append(base_roughness.high, high);
    append(normal.low, normal_low), append(normal.high, normal_high);
    ++count;
  }
  void untouched(uint32_t base_bits, uint32_t normal_bits) {
    const vec4 b = base_roughness_of(base_bits);
    const vec3 n = normal_of(normal_bits);
    add(b, b, n, n);
  }
  // What is undecided counts as two alternatives, so that it is told from what was judged.
  void add(const BlendedMaterial& m, uint32_t normal_bits) {
    vec4 low, high;
    for (int i = 0; i < 4; ++i) {
      const Interval v = i < 3 ? square_root(m.base[static_cast<size_t>(i)]) : m.roughness;
      low[i] = code_of(v.low, -1), high[i] = code_of(v.high, 1);
    }
    vec3 normal_low = normal_of(normal_bits), normal_high = normal_low;
    if (m.normal_touched) {
      const auto reach = static_cast<float>(std::min(m.normal.error + kOctahedral, 4.0)) + 1e-7f;
      normal_low = vec3(m.normal.value) - reach, normal_high = vec3(m.normal.value) + reach;
    }
    for (int i = 0; i < (m.undecided ? 2 : 1); ++i) add(low, high, normal_low, normal_high);
  }
  void end_pixel() { first.push_back(count); }
  void put(Answer& to, const std::string& prefix, const std::vector<uint64_t>& judged) {
    for (Expected* e : {&base_roughness, &normal}) e->first = first, e->judged = judged;
    to[prefix + "base_roughness"] = std::move(base_roughness), to[prefix + "normal"] = std::move(normal);
  }
};

}  // namespace

Unpack unpack_base_roughness() { return unpack(base_roughness_of); }
Unpack unpack_normal() { return unpack(normal_of); }

namespace {

// By list, each pixel worked out once: copies ask for their primary's.
class ByList {
 public:
  explicit ByList(const Inputs& in) : in_(in) {}
  const BlendedMaterial& at(uint64_t pixel) {
    const auto [it, is_new] = known_.try_emplace(pixel);
    if (is_new) it->second = blended(in_, pixel, point_at(in_, pixel), listed(in_, cell_of(in_, pixel)), in_.atlas);
    return it->second;
  }

 private:
  const Inputs& in_;
  std::unordered_map<uint64_t, BlendedMaterial> known_;
};

void add_by_sources(Answer& to, const Case& c, const Inputs& in, ByList& by_list, const std::vector<uint64_t>& judged,
                    const std::vector<uint32_t>& sources, const std::string& prefix) {
  Answers a;
  for_each_judged(c, judged, [&](uint64_t pixel) {
    const uint32_t source = sources[pixel];
    if (source == kNobody || !has_surface(in.depth[source]))
      a.untouched(in.base_roughness[pixel], in.normal[pixel]);
    else
      a.add(by_list.at(source), in.normal[source]);
    a.end_pixel();
  });
  a.put(to, prefix, judged);
}

}  // namespace

Answer decaled(const Case& c) {
  const Inputs in = inputs_of(c);
  const std::vector<uint64_t> judged = judged_pixels(c, kSampledAbove);
  ByList by_list(in);
  Answers lists, taps, bits, blocks;
  for_each_judged(c, judged, [&](uint64_t pixel) {
    const uint32_t normal = in.normal[pixel];
    if (!has_surface(in.depth[pixel])) {
      for (Answers* a : {&lists, &taps, &bits, &blocks}) a->untouched(in.base_roughness[pixel], normal), a->end_pixel();
      return;
    }
    const SurfacePoint p = point_at(in, pixel);
    const uint32_t cell = cell_of(in, pixel);
    const std::vector<uint32_t> from_list = listed(in, cell), from_bits = marked(in, cell);
    const BlendedMaterial& m = by_list.at(pixel);
    lists.add(m, normal);
    taps.add(blended(in, pixel, p, from_list, in.atlas, Filtering::taps), normal);
    bits.add(from_bits == from_list ? m : blended(in, pixel, p, from_bits, in.atlas), normal);
    blocks.add(blended(in, pixel, p, from_list, in.blocks), normal);
    for (Answers* a : {&lists, &taps, &bits, &blocks}) a->end_pixel();
  });
  Answer answer;
  lists.put(answer, "", judged), taps.put(answer, kTaps, judged), bits.put(answer, kBits, judged);
  blocks.put(answer, kBlocks, judged);
  add_by_sources(answer, c, in, by_list, judged, sources_by_tiles(c), kTiles);
  add_by_sources(answer, c, in, by_list, judged, sources_by_primaries(c), kPrimaries);
  return answer;
}

}  // namespace assay::decal_atlas_sampling
