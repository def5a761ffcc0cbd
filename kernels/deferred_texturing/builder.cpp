#include "kernels/deferred_texturing/builder.h"

#include <algorithm>
#include <cmath>

#include "harness/formats/attributes.h"
#include "harness/formats/visibility.h"

namespace assay::deferred_texturing {

namespace {

uint unorm16(double v) { return static_cast<uint>(std::lround(std::clamp(v, 0.0, 1.0) * 65535)); }

// Lambert's azimuthal equal-area projection of the hemisphere that the vector is in.
uint lambert(const glm::dvec3& v) {
  const glm::dvec3 n = v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  const double scale = 1 / std::sqrt(1 + std::fabs(n.z));
  const auto code = [](double e) { return static_cast<uint>(std::lround(e * 32767)) & 0xffffu; };
  return code(n.x * scale) | code(n.y * scale) << 16;
}

uvec2 shared_exponent(const Interpolated& p, uint flags) {
  const double d[4] = {p.d_dx.x, p.d_dx.y, p.d_dy.x, p.d_dy.y};
  double largest = 0;
  for (const double v : d) largest = std::max(largest, std::fabs(v));
  if (largest < 0x1p-100) return {0, flags << 28};
  int exponent = std::ilogb(largest) - 11;  // the largest mantissa has 12 bits
  if (std::lround(std::ldexp(largest, -exponent)) > kAttributeMantissaLimit) ++exponent;
  const auto mantissa = [&](double v) { return static_cast<uint>(std::lround(std::ldexp(v, -exponent))) & 0x1fffu; };
  const auto code = static_cast<uint>(exponent + kAttributeExponentBias);
  return {mantissa(d[0]) | mantissa(d[1]) << 13 | (code & 63u) << 26,
          mantissa(d[2]) | mantissa(d[3]) << 13 | (code >> 6) << 26 | flags << 28};
}

uint flags_of(const Frame& f) {
  return (f.front_facing ? kAttributeFrontFacing : 0) | (f.normal.z < 0 ? kAttributeNormalNegative : 0) |
         (f.tangent.z < 0 ? kAttributeTangentNegative : 0) | (f.left_handed ? kAttributeLeftHanded : 0);
}

// A vertex of the sheet's triangle that a pixel lies in: its corner, its weight on the screen, and how that changes.
struct Weighted {
  uint corner;
  double weight, dx, dy;  // a pixel
};
// A sheet's first triangle has its left top, right top and left bottom corners, the second the other three.
std::array<Weighted, 3> on_screen(const Rectangle& r, bool clockwise, uint32_t x, uint32_t y, uint32_t& triangle) {
  const double dx = 1.0 / r.width, dy = 1.0 / r.height, fx = (x - r.x + 0.5) * dx, fy = (y - r.y + 0.5) * dy;
  triangle = fx + fy < 1 ? 0 : 1;
  std::array<Weighted, 3> v = {{{0, 1 - fx - fy, -dx, -dy}, {1, fx, dx, 0}, {2, fy, 0, dy}}};
  if (triangle == 1) v = {{{3, fx + fy - 1, dx, dy}, {2, 1 - fx, -dx, 0}, {1, 1 - fy, 0, -dy}}};
  if (!clockwise) std::swap(v[1], v[2]);
  return v;
}

glm::dvec3 corner_normal(const Frame& f, const Shape& s, uint corner) {
  const glm::dvec3 across = f.tangent, down = glm::cross(f.normal, f.tangent);
  return f.normal + s.bulge * ((corner % 2 == 0 ? -1.0 : 1.0) * across + (corner / 2 == 0 ? -1.0 : 1.0) * down);
}

// Corrected for perspective: weights over w, in proportion.
Interpolated interpolated(const std::array<Weighted, 3>& v, const Frame& frame, const Shape& shape) {
  double sum = 0, sum_dx = 0, sum_dy = 0;
  for (const Weighted& k : v) {
    const double w = shape.depths[k.corner];
    sum += k.weight / w, sum_dx += k.dx / w, sum_dy += k.dy / w;
  }
  Interpolated p = {{}, {}, {}, frame};
  p.frame.normal = {};
  for (size_t k = 0; k < 3; ++k) {
    const double w = shape.depths[v[k].corner], weight = v[k].weight / w / sum;
    p.frame.normal += weight * corner_normal(frame, shape, v[k].corner);
    if (k == 0) continue;
    const int of = static_cast<int>(k) - 1;
    p.weights[of] = weight;
    p.d_dx[of] = (v[k].dx / w - weight * sum_dx) / sum, p.d_dy[of] = (v[k].dy / w - weight * sum_dy) / sum;
  }
  return p;
}

const glm::dvec3 kMoved = {0.25, -0.5, 0.75};  // clip space, from where the mesh lies

bool is_shown(const Builder& b, uint32_t shader) {
  const auto is_of_class = [&](uint32_t material) {
    return material < b.materials.size() && b.materials[material].shader == shader;
  };
  if (b.registers_unseen)
    return std::ranges::any_of(b.surfaces, [&](const SurfaceRecord& s) { return is_of_class(s.material); });
  return std::ranges::any_of(b.visibility, [&](const uvec2& v) {
    const uint32_t surface = v.y & kVisibilitySurfaceMask;
    return surface < b.surfaces.size() && is_of_class(b.surfaces[surface].material);
  });
}

}  // namespace

Encoded encode(const Interpolated& p) {
  return {unorm16(p.weights.x) | unorm16(p.weights.y) << 16,
          shared_exponent(p, flags_of(p.frame)),
          {lambert(p.frame.normal), lambert(p.frame.tangent)}};
}

Builder::Builder(Extent e) : extent(e) {
  const uint64_t n = pixel_count(e);
  visibility.assign(n, uvec2(kVisibilityNone)), barycentrics.assign(n, 0);
  derivatives.assign(n, uvec2(0)), tangent_frame.assign(n, uvec2(0));
}

uint32_t Builder::add_material(const MaterialRecord& m) {
  materials.push_back(m);
  return static_cast<uint32_t>(materials.size() - 1);
}

uint32_t Builder::add_sheet(const Rectangle& r, uint32_t material, const std::array<vec2, 4>& corners,
                            const Frame& frame, const Shape& shape) {
  const auto surface = static_cast<uint32_t>(surfaces.size());
  const bool clockwise = frame.front_facing == shape.mirrored;
  const glm::dvec3 stretched = {shape.mirrored ? -2 : 2, 1, 0.5};  // from the mesh's space to the world
  SurfaceRecord s = {};
  s.clip_x = vec4(1, 0, 0, kMoved.x), s.clip_y = vec4(0, 1, 0, kMoved.y), s.clip_w = vec4(0, 0, 1, kMoved.z);
  s.world_x = vec4(stretched.x, 0, 0, 0), s.world_y = vec4(0, stretched.y, 0, 0);
  s.world_z = vec4(0, 0, stretched.z, 0), s.flags = shape.mirrored ? kSurfaceFlipped : 0;
  s.material = material, s.first_index = static_cast<uint32_t>(indices.size()), s.triangle_count = 2;
  s.vertex_offset = static_cast<uint32_t>(vertices.size());
  surfaces.push_back(s);
  for (const uint i : clockwise ? std::array{0u, 1u, 2u, 3u, 2u, 1u} : std::array{0u, 2u, 1u, 3u, 1u, 2u})
    indices.push_back(i);
  for (uint k = 0; k < 4; ++k) {
    const uint right = k % 2, below = k / 2;
    const double w = shape.depths[k], x = r.x + right * r.width, y = r.y + below * r.height;
    const glm::dvec3 clip = w * glm::dvec3(2 * x / extent.width - 1, 2 * y / extent.height - 1, 1);
    positions.push_back(vec3(clip - kMoved));
    vertices.push_back({vec3(stretched * corner_normal(frame, shape, k)),
                        vec4(vec3(frame.tangent / stretched), frame.left_handed != shape.mirrored ? -1 : 1),
                        corners[k]});
  }
  for (uint32_t y = r.y; y < std::min(r.y + r.height, extent.height); ++y)
    for (uint32_t x = r.x; x < std::min(r.x + r.width, extent.width); ++x) {
      uint32_t triangle;
      set(x, y, interpolated(on_screen(r, clockwise, x, y, triangle), frame, shape));
      visibility[size_t{y} * extent.width + x] = {triangle, surface | (shape.mirrored ? kVisibilityFlipped : 0)};
    }
  return surface;
}

void Builder::flag_surface(uint32_t surface, uint32_t bits) {
  for (uvec2& v : visibility)
    if ((v.y & kVisibilitySurfaceMask) == surface) v.y |= bits;
}

void Builder::set(uint32_t x, uint32_t y, const Interpolated& p) {
  const size_t pixel = size_t{y} * extent.width + x;
  const Encoded e = encode(p);
  barycentrics[pixel] = e.barycentrics, derivatives[pixel] = e.derivatives, tangent_frame[pixel] = e.tangent_frame;
}

Case Builder::finish(std::string name) const {
  TexturingParams params = {};
  params.width = extent.width, params.height = extent.height;
  params.surfaces = static_cast<uint32_t>(surfaces.size()), params.materials = static_cast<uint32_t>(materials.size());
  params.indices = static_cast<uint32_t>(indices.size()), params.vertices = static_cast<uint32_t>(vertices.size());
  params.probe_factor = kProbeFactor, params.probe_addend = kProbeAddend;
  for (uint32_t k = 0; k < kShaderClasses; ++k) {
    const bool is_registered = is_shown(*this, k) && std::ranges::find(hidden_classes, k) == hidden_classes.end();
    params.slot_of_class[k] = is_registered ? params.shaders++ : kUnregistered;
  }
  std::vector<SurfaceSlot> slots;
  for (const SurfaceRecord& s : surfaces) {
    const bool is_known = s.material < materials.size() && materials[s.material].shader < kShaderClasses;
    slots.push_back({is_known ? params.slot_of_class[materials[s.material].shader] : kUnregistered, s.material});
  }
  const Lists lists = lists_of({extent, visibility, slots, copy_bits, params.shaders, tiles_with_room, stale});
  params.waves = lists.waves;
  Case c = {.name = std::move(name), .extent = extent};
  c.set_params(params);
  c.set_input("visibility", visibility);
  c.set_input("surfaces", surfaces), c.set_input("materials", materials);
  c.set_input("indices", indices), c.set_input("positions", positions), c.set_input("vertices", vertices);
  c.set_input("barycentrics", barycentrics), c.set_input("derivatives", derivatives);
  c.set_input("tangent_frame", tangent_frame);
  c.set_input("entries", lists.entries), c.set_input("commands", lists.commands);
  c.set_input("command_rows", lists.rows), c.set_input("args", lists.args);
  c.textures["textures"] = textures;
  return c;
}

std::array<vec2, 4> uv_by_pixel(const Rectangle& r, vec2 per_pixel, vec2 origin) {
  const vec2 across = vec2(per_pixel.x * static_cast<float>(r.width), 0),
             down = vec2(0, per_pixel.y * static_cast<float>(r.height));
  return {origin, origin + across, origin + down, origin + across + down};
}

MaterialRecord plain_material(uint32_t shader) {
  MaterialRecord m = {};
  m.base_colour = vec4(1), m.base_texture = kNoTexture, m.features = 1;
  m.emissive_texture = m.metallic_roughness_texture = m.normal_texture = m.occlusion_texture = kNoTexture;
  m.roughness = 1, m.metallic = 1, m.normal_scale = 1, m.occlusion_strength = 1;
  m.shader = shader, m.layer = kNoMaterial, m.mask_texture = m.detail_texture = kNoTexture;
  m.blend_depth = 0.25f, m.detail_scale = 1;
  return m;
}

uint32_t texture_name(uint32_t array, uint32_t layer) { return array << 16 | layer; }

namespace {

// The means of the level before, appended.
void append_level(Texture& t, size_t before, uint32_t width, uint32_t height) {
  const uint32_t w = std::max(width / 2, 1u), h = std::max(height / 2, 1u);
  for (uint32_t layer = 0; layer < t.layers; ++layer)
    for (uint32_t y = 0; y < h; ++y)
      for (uint32_t x = 0; x < w; ++x)
        for (uint32_t c = 0; c < 4; ++c) {
          uint32_t sum = 2;
          for (uint32_t i = 0; i < 4; ++i) {
            const uint32_t sx = std::min(2 * x + (i & 1), width - 1), sy = std::min(2 * y + (i >> 1), height - 1);
            sum += std::to_integer<uint32_t>(t.bytes[before + ((size_t{layer} * height + sy) * width + sx) * 4 + c]);
          }
          t.bytes.push_back(static_cast<std::byte>(sum / 4));
        }
}

}  // namespace

Texture texture_of(Format format, Extent e, uint32_t layers, const TexelFunction& texel, bool chain) {
  Texture t = {.format = format, .width = e.width, .height = e.height, .layers = layers, .levels = 1, .bytes = {}};
  for (uint32_t layer = 0; layer < layers; ++layer)
    for (uint32_t y = 0; y < e.height; ++y)
      for (uint32_t x = 0; x < e.width; ++x)
        for (uint32_t c = 0; c < 4; ++c)
          t.bytes.push_back(static_cast<std::byte>(std::min(texel(x, y, layer, c), 255u)));
  size_t before = 0;
  for (uint32_t w = e.width, h = e.height; chain && (w > 1 || h > 1); ++t.levels) {
    const size_t end = t.bytes.size();
    append_level(t, before, w, h);
    before = end, w = std::max(w / 2, 1u), h = std::max(h / 2, 1u);
  }
  return t;
}

Texture constant_texture(Format format, const std::array<uint32_t, 4>& texel) {
  return texture_of(format, {4, 4}, 1, [=](uint32_t, uint32_t, uint32_t, uint32_t c) { return texel[c]; });
}

Texture levels_texture(Format format, Extent e, const std::function<uint32_t(uint32_t, uint32_t)>& colour) {
  Texture t = {.format = format, .width = e.width, .height = e.height, .layers = 1, .levels = 0, .bytes = {}};
  for (uint32_t w = e.width, h = e.height;; w = std::max(w / 2, 1u), h = std::max(h / 2, 1u)) {
    for (uint64_t i = 0; i < uint64_t{w} * h; ++i)
      for (uint32_t c = 0; c < 4; ++c) t.bytes.push_back(static_cast<std::byte>(colour(t.levels, c)));
    ++t.levels;
    if (w == 1 && h == 1) return t;
  }
}

}  // namespace assay::deferred_texturing
