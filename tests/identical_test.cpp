// Answers that are promised to the bit, beyond their bounds: from run to run, from variant to variant, and where all
// roundings are known, the very bits. ctest runs it at several subgroup widths and numbers of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <set>

#include "harness/check/cases.h"
#include "harness/half.h"
#include "kernels/deferred_lighting/picture.h"
#include "kernels/deferred_lighting/sources.h"
#include "kernels/particle_light_atlas/inputs.h"
#include "kernels/resolve/layout.h"
#include "tests/lowered.h"

namespace assay::tests {
namespace {

struct Promise {
  const char* kernel;
  std::vector<const char*> variants, ports;
};
const Promise kPromises[] = {
    {"decal_atlas_sampling", {"gradient", "scalarised"}, {"base_roughness", "normal"}},
    {"deferred_lighting", {"plain", "tiled_shared", "subgroup_cull"}, {"radiance"}},
    {"deferred_lighting", {"clustered", "clustered_scalarised"}, {"radiance"}},
    {"resolve", {"two_level", "subgroup_tree", "bucketed_curve"}, {"partials", "exposure", "image"}},
};

std::vector<Bytes> answers(const Kernel& k, const char* variant, const Case& c, const Promise& p) {
  const Ran r = run_variant(*device(), k, variant, c);
  std::vector<Bytes> bytes;
  for (const char* port : p.ports) bytes.push_back(device::read(*device(), *r.ports.at(port)));
  return bytes;
}

void expect_identical(const Promise& p, const Case& c, const std::string& name) {
  const Kernel& k = kernel_named(p.kernel);
  const auto first = answers(k, p.variants[0], c, p);
  for (const char* variant : p.variants) {
    if (!device::missing(device::info(*device()), variant_of(k, variant)).empty()) continue;
    EXPECT_EQ(answers(k, variant, c, p), first) << p.kernel << "." << variant << ", case " << name;
  }
}

// Cases that are quickly run: the order of operations does not depend on the extent.
bool is_small(const Case& c) { return pixel_count(c.extent) <= 40000; }

TEST(Identical, VariantsAndRuns) {
  for (const Promise& p : kPromises) {
    const Kernel& k = kernel_named(p.kernel);
    for (const HardCase& hard : k.inputs.hard) {
      if (hard.nightly) continue;
      if (const Case c = hard.make(); is_small(c)) expect_identical(p, c, hard.name);
    }
    for (uint64_t seed = 1; seed <= 12; ++seed)
      if (const Case c = check::random_case(k, seed).input; is_small(c)) expect_identical(p, c, c.name);
  }
}

// ---- Primaries and copies have the bits that shading every pixel gives the primary ----

struct Primaries {
  const char *variant, *every_pixel;
  deferred_lighting::Sources (*sources)(const Case&);
};
constexpr Primaries kPrimaries[] = {
    {"clustered_tile_list", "clustered", deferred_lighting::sources_by_tiles},
    {"plain_tile_list", "plain", deferred_lighting::sources_by_tiles},
    {"clustered_list", "clustered", deferred_lighting::sources_by_list},
    {"clustered_tile_list_shadowed", "clustered_shadowed", deferred_lighting::sources_by_tiles},
    {"plain_tile_list_shadowed", "plain_shadowed", deferred_lighting::sources_by_tiles}};

using Texel = std::array<uint16_t, 4>;

std::vector<Texel> radiance(const Kernel& k, const char* variant, const Case& c) {
  return values<Texel>(answers(k, variant, c, {k.name.c_str(), {}, {"radiance"}})[0]);
}

// Pixels that one source reaches; how many of them are copies.
uint64_t expect_primaries(const Kernel& k, const Primaries& p, const Case& c, const std::string& name) {
  const auto shaded = radiance(k, p.every_pixel, c), got = radiance(k, p.variant, c);
  const deferred_lighting::Sources sources = p.sources(c);
  uint64_t wrong = 0, copies = 0;
  for (size_t i = 0; i < got.size(); ++i) {
    const uint32_t from = sources.first[i];
    if (from == deferred_lighting::kNobody || sources.others.contains(i)) continue;
    copies += from != i && from != deferred_lighting::kFromNowhere;
    wrong += got[i] != (from == deferred_lighting::kFromNowhere ? Texel{} : shaded[from]);
  }
  EXPECT_EQ(wrong, 0u) << p.variant << ", case " << name;
  return copies;
}

TEST(Identical, PrimariesAreEveryPixelsBits) {
  const Kernel& k = kernel_named("deferred_lighting");
  uint64_t copies = 0;
  for (const Primaries& p : kPrimaries) {
    for (const HardCase& hard : k.inputs.hard) {
      if (hard.nightly) continue;
      if (const Case c = hard.make(); is_small(c)) copies += expect_primaries(k, p, c, hard.name);
    }
    for (uint64_t seed = 1; seed <= 6; ++seed)
      if (const Case c = check::random_case(k, seed).input; is_small(c)) copies += expect_primaries(k, p, c, c.name);
  }
  EXPECT_GT(copies, 10000u);
}

// ---- Surfaces and particles are lit alike: the texels of a particle, and a wall of white leaf in its place ----

constexpr uint32_t kSide = 32;
struct Quad {
  vec3 centre, right, up, normal;  // whose numbers have few bits: no place on it is rounded
};
const Quad kQuads[] = {{{0.25f, -0.5f, -2}, {0.5f, 0, 0}, {0, 0.75f, 0}, {0, 0, 1}},
                       {{-1, 0.25f, -2.5f}, {0, 0.5f, 0}, {0, 0, 0.75f}, {1, 0, 0}},
                       {{1, 0, -2}, {0, 0.25f, 0}, {0, 0, 0.5f}, {-1, 0, 0}},
                       {{0, -0.75f, -2}, {0.25f, 0, 0}, {0, 0, 0.5f}, {0, 1, 0}},
                       {{0.5f, 1, -3}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}};

ParticleRecord record_of(const Quad& q) {
  return {.centre = q.centre, .opacity = 1, .right = q.right, .up = q.up, .quality = 1, .albedo = vec3(1)};
}

// At depth 1 a pixel's position is its ray. Particles go up from row to row, so the view is upside down.
Case as_surface(const Quad& q) {
  deferred_lighting::Picture wall = deferred_lighting::wall({kSide, kSide});
  Pcg32 rng(0x5a9e);
  deferred_lighting::add_lights(wall, rng, 40, 3);
  for (LightRecord& l : wall.lights) l.position += q.centre + vec3(0, 0, 3);
  wall.params.ambient = particle_light_atlas::Scene(128).params.ambient;
  wall.params.rays = {q.centre - q.right - q.up, q.right / float{kSide / 2}, q.up / float{kSide / 2}};
  std::ranges::fill(wall.depth, wall.params.near_plane);
  std::ranges::fill(wall.base, deferred_lighting::base_code(255, 255, 255, 255));
  std::ranges::fill(wall.metal, deferred_lighting::metal_code(0, 255));
  std::ranges::fill(wall.normal, deferred_lighting::octahedral_code(glm::dvec3(q.normal)));
  std::ranges::fill(wall.emissive, 0);
  std::ranges::fill(wall.features, kFeatureSubsurface);
  Case c = to_case("wall", wall);
  c.set_input("particles", std::vector<ParticleRecord>{record_of(q)});
  return c;
}

std::vector<Texel> in_atlas(const Quad& q, std::span<const LightRecord> lights) {
  particle_light_atlas::Scene s(128);
  s.lights.assign(lights.begin(), lights.end());
  s.add_cells(256, {0.25f, 60}, [&](uint32_t) {
    std::vector<uint32_t> all(lights.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  });
  s.add(record_of(q), 3);
  const auto atlas = values<Texel>(
      answers(kernel_named("particle_light_atlas"), "rgba16f", to_case(s), {"", {}, {"atlas_rgba16"}})[0]);
  const ParticleRegion region = s.region(3);
  std::vector<Texel> texels;
  for (uint32_t y = 0; y < kSide; ++y)
    for (uint32_t x = 0; x < kSide; ++x) texels.push_back(atlas[size_t{region.row + y} * s.params.side + x]);
  return texels;
}

Case for_kernel(const Kernel& k, Case c) {
  std::erase_if(c.inputs, [&](const auto& input) {
    return std::ranges::none_of(k.ports, [&](const Port& p) { return p.name == input.first; });
  });
  return c;
}

// The sums' bits; and what the two kernels store is those sums rounded: to nearest by hand, either way by the device.
TEST(Identical, SurfacesAndParticlesAreLitAlike) {
  for (const Quad& q : kQuads) {
    const Case c = as_surface(q);
    const Kernel &both = planted("shaded_twice"), &lighting = kernel_named("deferred_lighting");
    const auto sums = answers(both, "all_lights", for_kernel(both, c), {"", {}, {"as_surface", "as_particle"}});
    EXPECT_EQ(sums[0], sums[1]);
    const auto surface = radiance(lighting, "plain", for_kernel(lighting, c));
    const auto particle = in_atlas(q, c.input<LightRecord>("lights"));
    const auto sum = values<vec3>(sums[0]);
    for (size_t i = 0; i < sum.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        ASSERT_EQ(particle[i][size_t(k)], nearest_half(sum[i][k])) << i;
        ASSERT_GE(surface[i][size_t(k)], half_bits(half_at_most(sum[i][k]))) << i;
        ASSERT_LE(surface[i][size_t(k)], half_bits(half_at_least(sum[i][k]))) << i;
      }
    EXPECT_GT((std::set<Texel>(surface.begin(), surface.end()).size()), 500u) << "the same everywhere tells nothing";
  }
}

// ---- The sum of resolve, in float as its README orders it ----

using resolve::ResolveParams;

float luminance_of(const std::array<uint16_t, 4>& t) {
  if (!(half_value(t[3]) > 0)) return 0;
  const auto channel = [&](size_t i) { return static_cast<float>(half_value(t[i])); };
  if (!std::isfinite(channel(0) + channel(1) + channel(2))) return 0;
  const float red = resolve::kLuminanceRed * std::max(channel(0), 0.0f);
  const float green = resolve::kLuminanceGreen * std::max(channel(1), 0.0f);
  return red + green + resolve::kLuminanceBlue * std::max(channel(2), 0.0f);
}

float tree_sum(std::array<float, 256> v) {
  for (size_t stride = 1; stride < 256; stride *= 2)
    for (size_t i = 0; i < 256; i += 2 * stride) v[i] += v[i + stride];
  return v[0];
}

float sum_in_order(const Case& c) {
  const auto texels = c.input<std::array<uint16_t, 4>>("radiance");
  const auto at = [&](uint32_t x, uint32_t y) {
    return x < c.extent.width && y < c.extent.height ? luminance_of(texels[size_t{y} * c.extent.width + x]) : 0.0f;
  };
  const Extent blocks = tiles_of(c.extent, resolve::kBlockPixels);
  std::array<float, 256> last = {};
  for (uint32_t block = 0; block < pixel_count(blocks); ++block) {
    const uint32_t x0 = block % blocks.width * resolve::kBlockPixels, y0 = block / blocks.width * resolve::kBlockPixels;
    std::array<float, 256> threads = {};
    for (uint32_t t = 0; t < 256; ++t)
      for (uint32_t j = 0; j < 8; ++j) {
        float row = 0;
        for (uint32_t i = 0; i < 8; ++i) row += at(x0 + t % 16 + 16 * i, y0 + t / 16 + 16 * j);
        threads[t] += row;
      }
    last[block % 256] += tree_sum(threads);
  }
  return tree_sum(last);
}

TEST(Identical, TheSumHasTheBitsOfItsOrder) {
  const Kernel& k = kernel_named("resolve");
  uint32_t summed = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    const Case c = check::random_case(k, seed).input;
    if (c.params<ResolveParams>().metering != resolve::kMeterMean) continue;
    ++summed;
    for (const char* variant : {"two_level", "subgroup_tree"}) {
      if (!device::missing(device::info(*device()), variant_of(k, variant)).empty()) continue;
      const Ran r = run_variant(*device(), k, variant, c);
      EXPECT_EQ(read<ExposureRecord>(*device(), r, "exposure")[0].sum, sum_in_order(c)) << variant << seed;
    }
  }
  EXPECT_GE(summed, 10u);
}

}  // namespace
}  // namespace assay::tests
