// A decal onto a pixel's material, and the material back into the G-buffer.
#ifndef DECAL_ATLAS_SAMPLING_BLEND
#define DECAL_ATLAS_SAMPLING_BLEND
#include "kernels/decal_atlas_sampling/sample.glsl"

struct Material {
  vec3 base;  // linear
  vec3 normal;
  float roughness;
  bvec3 touched;  // base, normal, roughness
  uint base_bits;
  uint normal_bits;
};

Material load_material(uvec2 pixel) {
  Material m;
  m.base_bits = imageLoad(base_roughness, ivec2(pixel)).r;
  m.normal_bits = imageLoad(normal, ivec2(pixel)).r;
  const vec4 code = vec4(uvec4(m.base_bits, m.base_bits >> 8, m.base_bits >> 16, m.base_bits >> 24) & 255u) / 255.0;
  m.base = decode_base_colour(code);
  m.roughness = code.a;
  const ivec2 n = ivec2(int(m.normal_bits << 16) >> 16, int(m.normal_bits) >> 16);
  m.normal = decode_octahedral(vec2(max(n, -32767)) / 32767.0);
  m.touched = bvec3(false);
  return m;
}

// What is stored of a material, where it is touched.
struct Texels {
  uint base_roughness;
  uint normal;
  bvec2 touched;
};

// Rounded to nearest by hand: Vulkan leaves the conversion of a store a code's choice.
uvec4 unorm8(vec4 v) { return uvec4(clamp(v, 0.0, 1.0) * 255.0 + 0.5); }
Texels texels_of(Material m) {
  Texels t = Texels(m.base_bits, m.normal_bits, bvec2(m.touched.x || m.touched.z, m.touched.y));
  if (t.touched.x) {
    const uvec4 code = unorm8(encode_base_roughness(m.base, m.roughness));
    uint bits = m.base_bits;
#ifdef MUTANT_8  // roughness is lost where the base colour is written alone
    if (m.touched.x) bits = code.r | code.g << 8 | code.b << 16;
#else
    if (m.touched.x) bits = (bits & 0xff000000u) | code.r | code.g << 8 | code.b << 16;
#endif
    if (m.touched.z) bits = (bits & 0xffffffu) | code.a << 24;
    t.base_roughness = bits;
  }
  if (t.touched.y) {
    const ivec2 code = ivec2(floor(encode_octahedral(m.normal) * 32767.0 + 0.5));
    t.normal = uint(code.x) & 0xffffu | uint(code.y) << 16;
  }
  return t;
}
void store_texels(uvec2 pixel, Texels t) {
  if (t.touched.x) imageStore(base_roughness, ivec2(pixel), uvec4(t.base_roughness));
  if (t.touched.y) imageStore(normal, ivec2(pixel), uvec4(t.normal));
}
void store_material(uvec2 pixel, Material m) { store_texels(pixel, texels_of(m)); }

// 0..1 and no NaN; a negative zero is 0.
bool is_in_unit(float v) { return floatBitsToUint(v) <= 0x3f800000u || v == 0.0; }

float fade_of(DecalRecord d, float distance) {
#ifdef MUTANT_9  // no decal fades
  return 1.0;
#else
  return d.fade_distance > 0.0 ? saturated(4.0 * (1.0 - distance / d.fade_distance)) : 1.0;
#endif
}

vec3 turned(ReceiverRecord r, vec3 v) { return vec3(dot(r.row_x.xyz, v), dot(r.row_y.xyz, v), dot(r.row_z.xyz, v)); }
vec3 turned_back(ReceiverRecord r, vec3 v) { return r.row_x.xyz * v.x + r.row_y.xyz * v.y + r.row_z.xyz * v.z; }

// The decal's normal in its own frame (t, b, o), and the surface's: one of both, `share` of the decal's.
vec3 blended_normal(vec3 base, vec3 detail, uint mode, float share) {
  if (mode == kNormalLinear) return mix(base, detail, share);
  const vec3 flatter = mix(vec3(0, 0, 1), detail, share);
#ifdef MUTANT_10  // reoriented is whiteout
  const bool is_reoriented = false;
#else
  const bool is_reoriented = mode == kNormalReoriented;
#endif
  if (is_reoriented) {
    const vec3 t = base + vec3(0, 0, 1), u = flatter * vec3(-1, -1, 1);
    return t * dot(t, u) - u * t.z;
  }
  return vec3(base.xy + flatter.xy, base.z * flatter.z);
}

void blend_normal(inout Material m, DecalRecord d, vec3 t, vec3 b, vec3 o, vec3 detail, float share) {
  const vec3 base = vec3(dot(m.normal, t), dot(m.normal, b), dot(m.normal, o));
  const vec3 n = blended_normal(base, detail, d.normal_mode, share);
  const vec3 world = n.x * t + n.y * b + n.z * o;
  const float squared = dot(world, world);
  if (squared >= kLeastNormal && squared < kLargestNormal) m.normal = world * inversesqrt(squared);
  m.touched.y = true;
}

// Whether the decal's box holds the pixel: where in the box, and the point in the space that the box is in.
bool is_held(uint index, inout Point p, out vec3 q) {
  if (index >= params.decals) return false;
  const uint receiver = decals[index].receiver;
  if (receiver != kNoReceiver) {
    if (receiver >= params.receivers) return false;
    const ReceiverRecord r = receivers[receiver];
#ifdef MUTANT_11  // the receiver turns, but does not move
    p.position = turned(r, p.position);
#else
    p.position = turned(r, p.position) + vec3(r.row_x.w, r.row_y.w, r.row_z.w);
#endif
    p.d_dx = turned(r, p.d_dx), p.d_dy = turned(r, p.d_dy);
  }
  const vec4 x = decals[index].row_x, y = decals[index].row_y, z = decals[index].row_z;
  q = vec3(dot(x.xyz, p.position) + x.w, dot(y.xyz, p.position) + y.w, dot(z.xyz, p.position) + z.w);
#ifdef MUTANT_12  // the box has no depth
  return is_in_unit(q.x) && is_in_unit(q.y);
#else
  return is_in_unit(q.x) && is_in_unit(q.y) && is_in_unit(q.z);
#endif
}
// For loops that pass over decals: a loop of its own that reads no more than the box, since what follows a branch that no
// lane takes may be run all the same.
bool holds(uint index, Point p) {
  vec3 q;
  return is_held(index, p, q);
}

void apply_decal(inout Material m, uint index, Point p) {
  vec3 q;
  if (!is_held(index, p, q)) return;
  DecalRecord d = decals[index];
  if (d.receiver != kNoReceiver) {
    const ReceiverRecord r = receivers[d.receiver];
    d.tangent = turned_back(r, d.tangent), d.bitangent = turned_back(r, d.bitangent);
    d.outward = turned_back(r, d.outward);
  }
  const vec2 scale = d.scale_bias.xy;
  const Footprint f =
      Footprint(q.xy * scale + d.scale_bias.zw, usable(vec2(dot(d.row_x.xyz, p.d_dx), dot(d.row_y.xyz, p.d_dx)) * scale),
                usable(vec2(dot(d.row_x.xyz, p.d_dy), dot(d.row_y.xyz, p.d_dy)) * scale));
  const Sample s = sample_of(d, f);
  const vec3 shares = saturated(d.weights) * (s.albedo.a * fade_of(d, p.distance));
  if (d.weights.x > 0.0) {
#ifdef MUTANT_13  // colours are mixed as they are stored
    const vec3 root = mix(sqrt(m.base), sqrt(s.albedo.rgb), shares.x);
    m.base = root * root;
#else
    m.base = mix(m.base, s.albedo.rgb, shares.x);
#endif
    m.touched.x = true;
  }
  if (d.weights.y > 0.0) blend_normal(m, d, d.tangent, d.bitangent, d.outward, s.normal, shares.y);
  if (d.weights.z > 0.0) {
    m.roughness = mix(m.roughness, s.roughness, shares.z);
    m.touched.z = true;
  }
}
#endif
