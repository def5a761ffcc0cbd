#include "kernels/particle_light_atlas/oracle.h"

#include <algorithm>
#include <cmath>

#include "harness/lighting_oracle.h"
#include "harness/radiance_oracle.h"
#include "harness/shadow_oracle.h"
#include "kernels/particle_light_atlas/sources.h"

namespace assay::particle_light_atlas {

using glm::dvec3;
using shading::Colour;

namespace {

constexpr double u = kUnitRoundoff;
constexpr uint64_t kJudgedQuads = 2048, kJudgedShades = 1u << 18;  // of a case; texels times lights
constexpr uint32_t kShadowTaps = 3;
constexpr double kDecided = 0.01;
constexpr double kFlushed = 0x1p-100;  // denormal floats may be, on the way
// An octahedral code is off by a step a coordinate, sqrt(6) of them in space at a length of 1 / sqrt(3) or more; 1 %
// more for the encoder's arithmetic.
const double kOctahedral = 1.01 * std::sqrt(18.0) / 32767;

struct View {
  const Case& c;
  ParticleLightParams params = c.params<ParticleLightParams>();
  std::span<const ParticleRecord> particles = c.input<ParticleRecord>("particles");
  std::span<const uint32_t> rects = c.input<uint32_t>("rects");
  std::span<const LightRecord> lights =
      c.input<LightRecord>("lights").first(std::min<size_t>(params.lights, kMostLights));
  shadowing::Map shadows = {
      c.input<ShadowView>("shadow_views"), {params.shadow_width, params.shadow_height}, c.input<float>("shadow_depth")};
};

struct Walk {
  bool listed, shadowed;
};

// Of one texel. Undecided: rounding may tip what it is lit by.
struct Lit {
  Colour colour;
  Ball towards;
  bool undecided = false;
};

Ball scaled(const Ball& b, double s) {
  return {b.value * s, (b.error + u * reach(b)) * std::fabs(s) * bounded::kSlack};
}
Ball weighted(const Ball& b, Interval w) {
  const double middle = 0.5 * (w.low + w.high);
  return {b.value * middle,
          (b.error + u * reach(b)) * w.high * bounded::kSlack + 0.5 * (w.high - w.low) * glm::length(b.value)};
}

bool is_within(const vec3& v) {
  const auto is = [](float e) { return std::fabs(e) <= kMostReach; };
  return is(v.x) && is(v.y) && is(v.z);
}

struct Quad {
  dvec3 centre = {}, right = {}, up = {};
};
Quad quad_of(const ParticleRecord& p) {
  if (!is_within(p.centre) || !is_within(p.right) || !is_within(p.up)) return {};
  return {dvec3(p.centre), dvec3(p.right), dvec3(p.up)};
}

// Of the plane, either way round: rounding may tip which is towards the eye.
std::vector<Ball> normals_of(const Quad& q) {
  if (q.right == dvec3(0) || q.up == dvec3(0)) return {Ball{}};
  const Ball n = normalised(cross(normalised({q.right, 0}, kShortestVector), normalised({q.up, 0}, kShortestVector)),
                            kShortestVector);
  const Interval facing = dot(n, {q.centre, 0});
  std::vector<Ball> normals;
  if (facing.low <= 0) normals.push_back(n);
  if (facing.high > 0) normals.push_back(-n);
  return normals;
}

shading::OracleSurface surface_of(const Quad& q, const Texel& t, const Ball& normal) {
  const auto at = [&t](uint32_t i) { return (2.0 * i + 1) / t.side - 1; };
  shading::OracleSurface s;
  s.position = Ball{q.centre, 0} + scaled({q.right, 0}, at(t.x)) + scaled({q.up, 0}, at(t.y));
  s.normal = normal;
  s.to_eye =
      glm::length(s.position.value) == 0 && s.position.error == 0 ? Ball{} : -normalised(s.position, kShortestVector);
  s.base_colour = {exactly(1), exactly(1), exactly(1)};
  s.metallic = exactly(0), s.roughness = exactly(1);
  s.features = kFeatureSubsurface;
  return s;
}

// ---- The lights of a position's cell: one list for each cell that it may be in ----

using Lights = std::vector<uint32_t>;

struct Whole {
  uint32_t low, high;
};
Whole pixel_in(Interval at) {
  const auto whole = [](double v) { return static_cast<uint32_t>(std::clamp(v, 0.0, double{kMostPixel})); };
  return {whole(at.low), whole(at.high)};
}

Lights list_of(const View& v, uint64_t cell) {
  const uvec2 head = v.c.input<uvec2>("cells")[cell];
  const auto entries = v.c.input<uint32_t>("entries");
  Lights found;
  for (uint64_t i = head.x; i < uint64_t{head.x} + std::min(head.y % 4096, 256u) && i < entries.size(); ++i)
    if (const uint32_t light = entries[i] % 4096; light < v.lights.size()) found.push_back(light);
  return found;
}

uint32_t slice_of(const View& v, double depth) {
  const auto edges = v.c.input<float>("slice_edges");
  uint32_t slice = 0;
  for (uint32_t k = 1; k < v.params.grid.slices; ++k)
    if (depth <= edges[k]) slice = k;
  return slice;
}

std::vector<Lights> lists_at(const View& v, const Ball& position) {
  const ClusterGrid& g = v.params.grid;
  if (g.columns == 0 || g.rows == 0) return {{}};
  const auto along = [&position](const vec3& axis) { return dot(Ball{dvec3(axis), 0}, position); };
  const Interval w = at_least(along(v.params.depth), v.params.near_plane), d = exactly(v.params.near_plane) / w;
  const Whole x = pixel_in(along(v.params.column) / w), y = pixel_in(along(v.params.row) / w);
  const auto cell = [](uint32_t pixel, uint32_t size, uint32_t count) { return std::min(pixel / size, count - 1); };
  std::vector<Lights> lists;
  for (uint64_t slice = slice_of(v, d.high); slice <= slice_of(v, d.low); ++slice)
    for (uint64_t r = cell(y.low, g.cell_height, g.rows); r <= cell(y.high, g.cell_height, g.rows); ++r)
      for (uint64_t i = cell(x.low, g.cell_width, g.columns); i <= cell(x.high, g.cell_width, g.columns); ++i)
        if (Lights list = list_of(v, (slice * g.rows + r) * g.columns + i);
            std::ranges::find(lists, list) == lists.end())
          lists.push_back(std::move(list));
  return lists;
}

// ---- A texel ----

Ball direction_to(const LightRecord& light, const Ball& position) {
  if (light.kind == kLightDirectional) return {-dvec3(light.direction), 0};
  return normalised(Ball{dvec3(light.position), 0} - position, kShortestVector);
}

Interval weight_of(const Colour& c) {
  const Interval luminance =
      sum_of({exactly(kLuminanceRed) * c[0], exactly(kLuminanceGreen) * c[1], exactly(kLuminanceBlue) * c[2]});
  return clamped(luminance, 0, kMostWeight);
}

Lit lit_by(const View& v, const shading::OracleSurface& s, const Lights& lights, bool shadowed, float dither) {
  Lit lit = {shading::shade_ambient(s, v.params.ambient), {}};
  for (const uint32_t i : lights) {
    const LightRecord& light = v.lights[i];
    const Interval visible =
        shadowed ? shadowing::share_of(v.shadows, kShadowTaps, light, s.position, {}, dither) : exactly(1);
    const Colour c = shading::shade(s, light, visible);
    if (visible.high - visible.low > kDecided)
      for (const Interval& channel : c) lit.undecided |= channel.low != channel.high;
    lit.colour = lit.colour + c;
    if (const Interval weight = weight_of(c); weight.high > 0)
      lit.towards = lit.towards + weighted(direction_to(light, s.position), weight);
  }
  return lit;
}

void join(Lit& a, const Lit& b) {
  for (size_t i = 0; i < 3; ++i) {
    a.undecided |= a.colour[i].low != b.colour[i].low || a.colour[i].high != b.colour[i].high;
    a.colour[i] = hull(a.colour[i], b.colour[i]);
  }
  a.towards.error = std::max(a.towards.error, glm::length(a.towards.value - b.towards.value) + b.towards.error);
}

Lit light_of(const View& v, const Texel& t, Walk walk) {
  const Quad q = quad_of(v.particles[t.particle]);
  const float dither = walk.shadowed ? shadowing::dither_of(t.at_x, t.at_y, v.params.frame) : 0;
  std::optional<Lit> lit;
  for (const Ball& normal : normals_of(q)) {
    const shading::OracleSurface s = surface_of(q, t, normal);
    std::vector<Lights> lists;
    if (walk.listed) {
      lists = lists_at(v, s.position);
    } else {
      lists.emplace_back(std::min<size_t>(v.lights.size(), walk.shadowed ? kMostShadowedLights : kMostLights));
      for (uint32_t i = 0; i < lists[0].size(); ++i) lists[0][i] = i;
    }
    for (const Lights& list : lists) {
      const Lit one = lit_by(v, s, list, walk.shadowed, dither);
      if (lit)
        join(*lit, one);
      else
        lit = one;
    }
  }
  return *lit;
}

// ---- The answer ----

struct Answered {
  Expected e = {.first = {0}};
  std::vector<vec4> low, high;

  // Twice what is undecided.
  void add(const vec4& a, const vec4& b, bool undecided) {
    for (int n = undecided ? 2 : 1; n > 0; --n) low.push_back(a), high.push_back(b);
  }
  void close() { e.first.push_back(static_cast<uint32_t>(low.size())); }
};

void add_texel(Answered& a, const Lit& lit, uint32_t encoding) {
  Intervals3 c = lit.colour;
  for (Interval& i : c) i.low -= kFlushed, i.high += kFlushed;
  const radiance::Stored s = radiance::stored(c, encoding);
  a.add(vec4(vec3(s.low), 1), vec4(vec3(s.high), 1), lit.undecided);
}

// The dominant direction of four texels.
void add_direction(Answered& a, const Lit (&four)[4]) {
  const Ball sum = (four[0].towards + four[1].towards) + (four[2].towards + four[3].towards);
  bool undecided = false;
  for (const Lit& lit : four) undecided |= lit.undecided;
  const double length = glm::length(sum.value);
  if (length == 0 && sum.error == 0) return a.add(vec4(0, 0, 1, 0), vec4(0, 0, 1, 0), undecided);
  if (!(length > 1e-30 && sum.error < 0.9 * length)) return a.add(vec4(-1, -1, -1, 0), vec4(1, 1, 1, 0), undecided);
  const dvec3 unit = sum.value / length;
  const double reach = sum.error / (length - sum.error) + kOctahedral;
  a.add(vec4(vec3(unit - reach), 0), vec4(vec3(unit + reach), 0), undecided);
}

Expected done(Answered a, bool three) {
  const auto bytes = [three](const std::vector<vec4>& all) {
    if (!three) return expect_all(all).low;
    std::vector<vec3> some;
    for (const vec4& v : all) some.emplace_back(v.x, v.y, v.z);
    return expect_all(some).low;
  };
  a.e.low = bytes(a.low), a.e.high = bytes(a.high);
  return a.e;
}

// Direction texels that are judged, ascending; all of few.
std::vector<uint64_t> judged_quads(const View& v, const Sources& s, uint64_t lights) {
  std::vector<uint64_t> lit;
  for (uint64_t i = 0; i < s.quads(); ++i)
    if (s.first[i] != kNobody) lit.push_back(i);
  const uint64_t most = std::clamp<uint64_t>(kJudgedShades / (4 * std::max<uint64_t>(lights, 1)), 64, kJudgedQuads);
  if (v.c.judge_all || lit.size() <= most) return lit;
  std::vector<uint64_t> some;
  for (uint64_t i = 0; i < lit.size(); i += lit.size() / most | 1) some.push_back(lit[i]);
  return some;
}

void answer_walk(Answer& to, const View& v, const Sources& s, Walk walk, const std::string& name) {
  const uint64_t lights = walk.listed ? std::min<size_t>(v.lights.size(), kMaxClusterEntries) : v.lights.size();
  const std::vector<uint64_t> quads = judged_quads(v, s, lights);
  struct Judged {
    uint64_t element;
    std::vector<Lit> candidates;
  };
  std::vector<Judged> texels;
  Answered direction;
  direction.e.live = s.live_quads(), direction.e.judged = quads;
  for (const uint64_t quad : quads) {
    std::vector<Judged> four(4);
    for (const uint32_t block : s.blocks_at(quad)) {
      Lit lit[4];
      for (uint32_t k = 0; k < 4; ++k) {
        const Texel t = s.texel(block, quad, k);
        lit[k] = light_of(v, t, walk);
        four[k].element = uint64_t{t.at_y} * v.params.side + t.at_x;
        four[k].candidates.push_back(lit[k]);
      }
      add_direction(direction, lit);
    }
    direction.close();
    texels.insert(texels.end(), four.begin(), four.end());
  }
  std::ranges::sort(texels, {}, &Judged::element);
  const std::pair<const char*, uint32_t> encodings[] = {
      {"r11g11b10f", kLightR11G11B10}, {"rgb9e5", kLightRgb9e5}, {"rgba16f", kLightRgba16}};
  for (const auto& [called, encoding] : encodings) {
    Answered atlas;
    atlas.e.live = s.live_texels();
    for (const Judged& j : texels) {
      for (const Lit& lit : j.candidates) add_texel(atlas, lit, encoding);
      atlas.close();
      atlas.e.judged.push_back(j.element);
    }
    to[name + " atlas " + called] = done(std::move(atlas), false);
  }
  to[name + " direction"] = done(std::move(direction), true);
}

}  // namespace

Layout texel_layout() { return {"", 16, {{"radiance", 0, 3, Scalar::f32}, {"alpha", 12, 1, Scalar::f32}}}; }
Layout direction_layout() { return {"", 12, {{"direction", 0, 3, Scalar::f32}}}; }

std::function<Bytes(std::span<const std::byte>)> unpack_texels(uint32_t encoding) {
  return [encoding](std::span<const std::byte> texels) {
    const size_t size = encoding == kLightRgba16 ? 8 : 4;
    std::vector<vec4> values;
    for (size_t i = 0; i < texels.size(); i += size) {
      uvec2 code = uvec2(0);
      std::memcpy(&code, texels.data() + i, size);
      const float alpha = encoding != kLightRgba16 || code.y >> 16 == 0x3c00u ? 1 : 0;
      values.emplace_back(vec3(radiance::decoded(code, encoding)), alpha);
    }
    return expect_all(values).low;
  };
}

Bytes unpack_directions(std::span<const std::byte> texels) {
  std::vector<vec3> values;
  for (size_t i = 0; i < texels.size(); i += 4) {
    int16_t code[2];
    std::memcpy(code, texels.data() + i, 4);
    dvec3 n = {std::max(code[0] / 32767.0, -1.0), std::max(code[1] / 32767.0, -1.0), 0};
    n.z = 1 - std::fabs(n.x) - std::fabs(n.y);
    if (n.z < 0) {
      const double x = (1 - std::fabs(n.y)) * (n.x < 0 ? -1 : 1);
      n.y = (1 - std::fabs(n.x)) * (n.y < 0 ? -1 : 1), n.x = x;
    }
    values.emplace_back(glm::normalize(n));
  }
  return expect_all(values).low;
}

Answer expected_light(const Case& c) {
  const View v = {c};
  const Sources sources(c);
  Answer answer;
  answer_walk(answer, v, sources, {true, false}, "listed");
  answer_walk(answer, v, sources, {false, false}, "all");
  answer_walk(answer, v, sources, {true, true}, "listed_shadowed");
  answer_walk(answer, v, sources, {false, true}, "all_shadowed");
  return answer;
}

}  // namespace assay::particle_light_atlas
