#include "kernels/decal_atlas_sampling/inputs.h"

#include "harness/clusters.h"
#include "harness/vrcs_screens.h"

namespace assay::decal_atlas_sampling {

using glm::dvec3;

namespace {

constexpr double kPi = 3.141592653589793;

dvec3 random_direction(Pcg32& rng) {
  const double z = rng.range(-1, 1), angle = rng.range(0, 2 * kPi), r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}
// Towards the eye, of a surface on the view's axis.
dvec3 facing_direction(Pcg32& rng) {
  const dvec3 d = random_direction(rng);
  return {d.x, d.y, std::fabs(d.z) + 0.05};
}

// A floor 1.5 m below the eye, a wall 20 m ahead.
void set_hall(View& v) {
  const Extent e = v.extent;
  v.set_plane(0, 0, e.width, e.height, {0, 0, -20}, {0, 0, 1});
  v.set_plane(0, e.height / 2 + 1, e.width, e.height, {0, -1.5, 0}, {0, 1, 0});
}
void set_patches(View& v, Pcg32& rng) {
  for (uint32_t i = 0; i < 12; ++i) {
    const uint32_t x = rng.below(v.extent.width), y = rng.below(v.extent.height);
    v.set_plane(x, y, std::min(v.extent.width, x + 1 + rng.below(v.extent.width / 2 + 2)),
                std::min(v.extent.height, y + 1 + rng.below(v.extent.height / 2 + 2)),
                {0, 0, -std::exp2(rng.range(0.5, 6))}, glm::normalize(facing_direction(rng)));
  }
}

// On what is seen at a random pixel, `pixels` of the screen large about.
void add_decal(View& v, Pcg32& rng, double pixels) {
  const uint32_t x = rng.below(v.extent.width), y = rng.below(v.extent.height);
  if (!(v.depth[size_t{y} * v.extent.width + x] > 0)) return;
  const dvec3 at = v.position(x, y);
  const double half = pixels * -at.z / v.extent.width;
  const dvec3 outward = glm::normalize(dvec3(0, 0.3, 1) + random_direction(rng) * 0.8);
  DecalRecord d =
      decal(at + random_direction(rng) * (0.1 * half), outward, rng.range(0, 2 * kPi),
            {half * rng.range(0.5, 2), half * rng.range(0.5, 2), half * rng.range(0.5, 3)}, v.atlas, rng.below(1000));
  d.normal_mode = rng.below(3);
  for (int i = 0; i < 3; ++i) d.weights[i] = static_cast<float>(rng.below(3) == 0 ? 0 : rng.range(0, 1));
  if (rng.below(4) == 0) d.fade_distance = static_cast<float>(-at.z * rng.range(0.9, 3));
  if (rng.below(4) == 0) {  // mirrored
    d.scale_bias.z += d.scale_bias.x, d.scale_bias.x = -d.scale_bias.x;
  }
  v.decals.push_back(d);
}

// The same decals on something that has turned and moved: their boxes are in its space.
void put_on_receiver(View& v, Pcg32& rng) {
  const dvec3 z = random_direction(rng), x = glm::normalize(glm::cross(z, dvec3(0.3, 0.9, 0.1))), y = glm::cross(z, x),
              origin = random_direction(rng) * 5.0;
  const auto row = [](const dvec3& r, double w) { return vec4(vec3(r), static_cast<float>(w)); };
  const ReceiverRecord r = {row(x, origin.x), row(y, origin.y), row(z, origin.z)};
  v.receivers.push_back(r);
  const auto into = [&](const dvec3& a) { return dvec3(glm::dot(x, a), glm::dot(y, a), glm::dot(z, a)); };
  for (size_t i = 0; i < v.decals.size(); i += 2) {
    DecalRecord& d = v.decals[i];
    for (vec4* of : {&d.row_x, &d.row_y, &d.row_z}) {
      const dvec3 turned = into(dvec3(of->x, of->y, of->z));
      *of = row(turned, of->w - glm::dot(turned, origin));
    }
    for (vec3* of : {&d.tangent, &d.bitangent, &d.outward}) *of = vec3(into(dvec3(*of)));
    d.receiver = static_cast<uint32_t>(v.receivers.size()) - 1;
  }
}

void roughen(View& v, Pcg32& rng) {
  for (size_t i = 0; i < v.depth.size(); ++i) {
    v.base_roughness[i] = rng.next();
    if (rng.below(8) == 0) v.normal[i] = packed_normal(random_direction(rng));
  }
}

// Triangles of a screen where it has some, and its rates.
void set_rates(View& v, vrcs::Pictured s) {
  for (uvec2& seen : s.visibility)
    if (seen == uvec2(kVisibilityNone)) seen = {1u << 20, 0};
  v.visibility = std::move(s.visibility), v.rates = std::move(s.rates);
}

// Tiles whatever they hold, in any order.
std::vector<uint32_t> some_tiles(Random& r, Extent e, uint32_t one_in) {
  std::vector<uint32_t> tiles;
  for (uint32_t t = 0; t < tile_count(e, kDecalTileSide); ++t)
    if (r.rng.below(one_in) == 0) tiles.push_back(t);
  for (size_t i = tiles.size(); i > 1; --i) std::swap(tiles[i - 1], tiles[r.rng.below(static_cast<uint32_t>(i))]);
  return tiles;
}

// Of a list that is nobody's: tiles that there are not, and more groups or tiles than there are.
void spoil_tiles(Random& r, Case& c) {
  const auto was = c.input<uint32_t>("decal_tiles");
  std::vector<uint32_t> tiles(was.begin(), was.end());
  for (uint32_t& t : tiles)
    if (r.rng.below(4) == 0)
      t = r.rng.below(2) == 0 ? t + static_cast<uint32_t>(tiles.size()) : ~(r.rng.next() & 0xffffu);
  c.set_input("decal_tiles", tiles);
  DispatchArgs args = c.input<DispatchArgs>("decal_tile_args")[0];
  if (r.rng.below(2) == 0) args.x += r.rng.below(9), args.y += 1;
  c.set_input("decal_tile_args", std::vector{args});
  if (r.rng.below(2) == 0) c.set_input("decal_tile_count", std::vector{r.rng.next()});
}

}  // namespace

Case random_case(Random& r) {
  View v(random_extent(r, 32));
  v.atlas.seed = r.rng.next();
  const Extent cell = {ceil_div(v.extent.width, 1 + r.rng.below(40)), ceil_div(v.extent.height, 1 + r.rng.below(20))};
  v.params.grid = grid_over(v.extent, cell, 1 + r.rng.below(kMaxClusterSlices));
  if (r.branch({{"hall", 0.5}, {"patches", 0.5}}) == 0)
    set_hall(v);
  else
    set_patches(v, r.rng);
  roughen(v, r.rng);
  const AtlasPlan::Look looks[] = {AtlasPlan::Look::painted, AtlasPlan::Look::loud, AtlasPlan::Look::levels,
                                   AtlasPlan::Look::stripes};
  v.atlas.look = looks[r.branch({{"painted", 0.6}, {"loud", 0.2}, {"levels", 0.1}, {"stripes", 0.1}})];
  if (r.branch({{"no_border", 0.5}, {"border", 0.5}}) != 0) v.atlas.border = 1 + r.rng.below(8);
  const uint32_t counts[] = {0, 1, 1 + r.rng.below(40), 100 + r.rng.below(200)};
  const uint32_t count = counts[r.branch({{"no_decal", 0.05}, {"one", 0.1}, {"some", 0.7}, {"many", 0.15}})];
  const double size = v.extent.width / std::sqrt(count + 1.0);
  for (uint32_t i = 0; i < count; ++i) add_decal(v, r.rng, size * std::exp2(r.rng.range(-3, 0)));
  if (r.branch({{"at_rest", 0.7}, {"moving", 0.3}}) != 0) put_on_receiver(v, r.rng);
  v.params.frame = r.rng.next();
  if (r.branch({{"full_rate", 0.4}, {"rates_vary", 0.6}}) != 0) set_rates(v, vrcs::random_screen(r, v.extent));
  const size_t tiles = r.branch({{"tiles_with_decals", 0.5}, {"tiles_any", 0.35}, {"tiles_spoilt", 0.15}});
  if (tiles != 0) v.tiles = some_tiles(r, v.extent, 1 + r.rng.below(3));
  Case c = v.to_case();
  if (tiles == 2) spoil_tiles(r, c);
  c.name = "random";
  return c;
}

std::vector<std::string> branches() {
  std::vector<std::string> all = kExtentBranches;
  for (const char* b :
       {"hall", "patches", "painted", "loud", "levels", "stripes", "no_border", "border", "no_decal", "one", "some",
        "many", "at_rest", "moving", "full_rate", "rates_vary", "tiles_with_decals", "tiles_any", "tiles_spoilt"})
    all.push_back(b);
  all.insert(all.end(), vrcs::kScreenBranches.begin(), vrcs::kScreenBranches.end());
  return all;
}

std::vector<Case> smaller(const Case& c) {
  std::vector<Case> found;
  const auto params = c.params<DecalParams>();
  if (params.decals > 0) {
    Case part = c;
    const auto all = c.input<DecalRecord>("decals");
    std::vector<DecalRecord> kept(all.begin(), all.end());
    bool changed = false;
    for (size_t i = kept.size() / 2; i < kept.size(); ++i) {
      changed |= kept[i].row_z.w != -1e6f;
      kept[i].row_z = {0, 0, 0, -1e6f};
    }
    part.set_input("decals", kept);
    if (changed) found.push_back(std::move(part));
  }
  return found;
}

Case typical(Extent e) {
  Pcg32 rng(1);
  View v(e);
  v.atlas = {.width = 512, .height = 512, .side = 64, .levels = 5, .pages = 2, .border = 9};
  set_hall(v);
  for (uint32_t i = 0; i < 256; ++i) add_decal(v, rng, e.width / 14.0 * std::exp2(rng.range(-1.5, 0.5)));
  v.rates = vrcs::rates_in_blocks(e, rng, 4);
  Case c = v.to_case();
  c.name = "typical";
  return c;
}

}  // namespace assay::decal_atlas_sampling
