// Decal records of a view, the instances that they lie on, and the atlas of their pictures.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "harness/image/atlas.h"
#include "harness/scene/gather.h"

namespace assay::scene {
namespace {

using glm::dmat3;
using glm::dvec3;
using glm::dvec4;

static_assert(kNone == kNoReceiver);

constexpr uint32_t kAtlasLevels = 5, kLargestPage = 4096;   // texels a side
constexpr uint32_t kLargestPicture = kLargestPage - 2 * 9;  // within a border of 9/16 of the last level's texel

// ---- Where they are

// A rotation, by Gram and Schmidt on the columns of a transform, and what is left of it: m = rotation * rest. A mirror
// is the rest's.
dmat3 rotation_of(const dmat3& m) {
  const dvec3 x = normalize(m[0]), y = normalize(m[1] - x * dot(x, m[1]));
  return {x, y, cross(x, y)};
}

struct Rows {  // p -> rows p + moved
  dmat3 linear = dmat3(1);
  dvec3 moved = {};
};
vec4 row(const Rows& r, int i) {
  return {vec3(glm::dvec3(r.linear[0][i], r.linear[1][i], r.linear[2][i])), r.moved[i]};
}
Rows rows_of(const vec4& x, const vec4& y, const vec4& z) {
  return {transpose(dmat3(dvec3(x), dvec3(y), dvec3(z))), {x.w, y.w, z.w}};
}

// From camera-relative positions to a rigid space of the instance.
Rows into_receiver(const Instance& i, const dvec3& eye) {
  const dmat3 turned_back = transpose(rotation_of(dmat3(i.to_world)));
  return {turned_back, turned_back * (eye - dvec3(i.to_world[3]))};
}
ReceiverRecord record_of(const Rows& r) { return {row(r, 0), row(r, 1), row(r, 2)}; }

// `place` takes the decal's space to that of the record, whose origin lies at `eye` there.
void set_box(const Decal& d, const dmat3& place, const dvec3& eye, DecalRecord& r) {
  const dmat3 axes = mat3_cast(normalize(d.orientation));
  // In the box x grows with the box's own, y and z against it: down the picture, and into the surface.
  const dvec3 to_unit = dvec3(0.5, -0.5, -0.5) / d.half_extents;
  const dmat3 linear = dmat3(to_unit.x, 0, 0, 0, to_unit.y, 0, 0, 0, to_unit.z) * transpose(axes) * inverse(place);
  const Rows rows = {linear, linear * (eye - place * d.centre) + 0.5};
  r.row_x = row(rows, 0), r.row_y = row(rows, 1), r.row_z = row(rows, 2);
  r.tangent = vec3(normalize(place * axes[0])), r.bitangent = vec3(normalize(place * axes[1]));
  r.outward = vec3(normalize(transpose(inverse(place)) * axes[2]));
}

bool in_view(const ClusterItem& box, const ClipRows& rows, double near_plane) {
  const dvec3 x(rows.x), y(rows.y), w(rows.w);
  const dvec3 outward[4] = {x - w, -x - w, y - w, -y - w};
  double least[5] = {1e300, 1e300, 1e300, 1e300, 1e300};
  for (int i = 0; i < 8; ++i) {
    const dvec3 corner = dvec3(box.origin) + dvec3(box.a) * (i & 1 ? 1.0 : -1.0) + dvec3(box.b) * (i & 2 ? 1.0 : -1.0) +
                         dvec3(box.c) * (i & 4 ? 1.0 : -1.0);
    for (int k = 0; k < 4; ++k) least[k] = std::min(least[k], dot(outward[k], corner));
    least[4] = std::min(least[4], near_plane - dot(w, corner));
  }
  return !std::any_of(least, least + 5, [](double v) { return v > 0; });
}

// ---- Their pictures

// Decals that show the same have one rectangle.
using Look = std::tuple<uint32_t, uint32_t, uint32_t, std::array<float, 5>>;
Look look_of(const Decal& d) {
  const bool coloured = d.colour_image != kNone, rough = d.roughness_image != kNone;
  const glm::vec4 c = coloured ? glm::vec4(0) : d.colour;
  return {d.colour_image, d.normal_image, d.roughness_image, {c.x, c.y, c.z, c.w, rough ? 0 : d.roughness}};
}

uint8_t code(double v) { return static_cast<uint8_t>(std::lround(255 * std::clamp(v, 0.0, 1.0))); }
uint8_t srgb_code(double v) { return code(v <= 0.0031308 ? v * 12.92 : 1.055 * std::pow(v, 1 / 2.4) - 0.055); }
image::Rgba8 picture(const Scene& s, uint32_t image, const std::array<uint8_t, 4>& constant) {
  if (image != kNone) return {s.images[image].width, s.images[image].height, s.images[image].rgba};
  return {1, 1, {constant.begin(), constant.end()}};
}
image::DecalPictures pictures_of(const Scene& s, const Decal& d) {
  const uint8_t rough = code(double{d.roughness});
  return {picture(s, d.colour_image,
                  {srgb_code(double{d.colour.x}), srgb_code(double{d.colour.y}), srgb_code(double{d.colour.z}),
                   code(double{d.colour.w})}),
          picture(s, d.normal_image, {128, 128, 255, 255}), picture(s, d.roughness_image, {rough, rough, rough, 255})};
}

// Of the sides that hold the largest picture, the one whose pages are smallest together.
image::DecalAtlas packed(const std::vector<image::DecalPictures>& pictures) {
  constexpr uint32_t kLast = 1u << (kAtlasLevels - 1);
  std::vector<Extent> cells;
  uint32_t largest = kLast;
  for (const image::DecalPictures& p : pictures) {
    const auto cell = [&](uint32_t image::Rgba8::*side) {
      return ceil_div(std::max({p.albedo.*side, p.normal.*side, p.roughness.*side}) + 2 * ceil_div(9 * kLast, 16),
                      kLast) *
             kLast;
    };
    cells.push_back({cell(&image::Rgba8::width), cell(&image::Rgba8::height)});
    largest = std::max({largest, cells.back().width, cells.back().height});
  }
  uint32_t best = 0;
  uint64_t least = ~uint64_t{0};
  for (uint32_t side = std::bit_ceil(largest); side <= kLargestPage; side *= 2) {
    uint64_t pages = 1;
    for (const image::PagePlace& p : image::pack_shelves(cells, side)) pages = std::max<uint64_t>(pages, p.page + 1);
    if (pages * side * side <= least) best = side, least = pages * side * side;
  }
  return image::make_atlas(pictures, best, kAtlasLevels);
}

}  // namespace

std::string fault_of(const Decal& d, const Scene& s) {
  const auto finite = [](double v) { return std::abs(v) < 1e30; };
  for (int i = 0; i < 3; ++i) {
    if (!finite(d.centre[i])) return "its centre is not finite";
    if (!(d.half_extents[i] > 1e-6 && d.half_extents[i] < 1e6)) return "a half extent is not within 1e-6 and 1e6 m";
    if (!(d.weights[i] >= 0 && d.weights[i] <= 1)) return "a weight is not within 0 and 1";
    if (!(d.colour[i] >= 0 && d.colour[i] <= 1)) return "its colour is not within 0 and 1";
  }
  if (!(std::abs(length(d.orientation) - 1) < 1e-3)) return "its orientation is no unit quaternion";
  if (!(d.colour.w >= 0 && d.colour.w <= 1)) return "its coverage is not within 0 and 1";
  if (!(d.roughness >= 0 && d.roughness <= 1)) return "its roughness is not within 0 and 1";
  if (!finite(double{d.fade_distance}) || d.fade_distance < 0) return "its fade distance is negative or not finite";
  if (d.normal_mode > kNormalReoriented) return "there is no such normal mode";
  if (d.receiver != kNone && d.receiver >= s.instances.size())
    return fmt::format("there is no instance {} to receive it", d.receiver);
  std::optional<Extent> size;
  for (const uint32_t image : {d.colour_image, d.normal_image, d.roughness_image}) {
    if (image == kNone) continue;
    if (image >= s.images.size()) return fmt::format("there is no image {}", image);
    const Extent e = {s.images[image].width, s.images[image].height};
    if (e.width == 0 || e.height == 0 || e.width > kLargestPicture || e.height > kLargestPicture)
      return fmt::format("a picture of {}x{} texels is not within 1 and {} a side", e.width, e.height, kLargestPicture);
    if (size && (size->width != e.width || size->height != e.height))
      return fmt::format("its pictures are {}x{} and {}x{} texels", size->width, size->height, e.width, e.height);
    size = e;
  }
  return {};
}

// In shaders a position is off by 15 u of its length |p| (kernels/deferred_lighting, Bounds); a receiver's rows, unit
// vectors and a translation t, add 4 u (|p| + |t|) in each of three components, 7 u |p| + 4 u |t|; of a row of the box,
// 4 u of its terms' magnitudes, which are |row| |p'| and no more than 1 + |row| |p'|, over |row|: 8 u |p'| + 4 u of the
// distance of its faces. |p'| is at most |p| + |t|, |p| at most the centre's distance and half the diagonal: together
// under 30 u |centre| + 12 u |t| + 19 u diagonal, and the item's own rounding to float 2 u more.
ClusterItem reach_of(const DecalRecord& d, const ReceiverRecord* receiver) {
  Rows rows = rows_of(d.row_x, d.row_y, d.row_z);
  double moved = 0;
  if (receiver) {
    const Rows into = rows_of(receiver->row_x, receiver->row_y, receiver->row_z);
    rows = {rows.linear * into.linear, rows.linear * into.moved + rows.moved};
    moved = length(into.moved);
  }
  const dmat3 back = inverse(rows.linear);  // columns: the box's edges
  const dvec3 centre = back * (0.5 - rows.moved);
  const double off = kPositionSlack * (length(centre) + moved + length(back[0]) + length(back[1]) + length(back[2]));
  dvec3 half[3];
  for (int i = 0; i < 3; ++i) {
    const double steepness = length(dvec3(rows.linear[0][i], rows.linear[1][i], rows.linear[2][i]));
    half[i] = back[i] * (0.5 + off * steepness);  // both faces move outwards by `off`
  }
  return {vec3(centre), kShapeBox, vec3(half[0]), vec3(half[1]), vec3(half[2])};
}

void append_decals(const Scene& scene, const Camera& camera, const ClipRows& rows, Gathered& to) {
  std::map<uint32_t, uint32_t> receivers;  // by instance
  std::map<Look, uint32_t> looks;
  std::vector<image::DecalPictures> pictures;
  std::vector<uint32_t> look_of_decal;
  size_t in_reach = 0;
  for (const Decal& d : scene.decals) {
    if (const std::string fault = fault_of(d, scene); !fault.empty())
      throw std::runtime_error(fmt::format("{}: decals[{}]: {}", scene.name, &d - scene.decals.data(), fault));
    DecalRecord r = {
        .weights = d.weights, .fade_distance = d.fade_distance, .normal_mode = d.normal_mode, .receiver = kNoReceiver};
    std::optional<ReceiverRecord> receiver;
    if (d.receiver == kNone) {
      set_box(d, dmat3(1), camera.eye, r);
    } else {
      const Instance& i = scene.instances[d.receiver];
      receiver = record_of(into_receiver(i, camera.eye));
      set_box(d, transpose(rotation_of(dmat3(i.to_world))) * dmat3(i.to_world), dvec3(0), r);
    }
    if (!in_view(reach_of(r, receiver ? &*receiver : nullptr), rows, camera.near_plane)) continue;
    if (++in_reach > kMaxClusterDecals) continue;
    if (receiver) {
      const auto [at, is_new] = receivers.try_emplace(d.receiver, static_cast<uint32_t>(to.receivers.size()));
      if (is_new) to.receivers.push_back(*receiver);
      r.receiver = at->second;
    }
    const auto [look, is_new] = looks.try_emplace(look_of(d), static_cast<uint32_t>(pictures.size()));
    if (is_new) pictures.push_back(pictures_of(scene, d));
    look_of_decal.push_back(look->second);
    to.decals.push_back(r);
  }
  if (const size_t culled = scene.decals.size() - in_reach)
    to.notes.push_back(fmt::format("{} of {} decals lie outside the view and are culled", culled, scene.decals.size()));
  if (in_reach > kMaxClusterDecals)
    to.notes.push_back(
        fmt::format("cells know the first {} of {} decals; the others are not drawn", kMaxClusterDecals, in_reach));
  if (to.decals.empty()) return;
  image::DecalAtlas atlas = packed(pictures);
  for (size_t i = 0; i < to.decals.size(); ++i) {
    const image::AtlasRectangle& at = atlas.rectangles[look_of_decal[i]];
    to.decals[i].scale_bias = {at.width, at.height, at.u, at.v}, to.decals[i].page = at.page;
  }
  to.decal_atlas = std::move(atlas.textures);
  to.decal_counts = {static_cast<uint32_t>(to.decals.size()), static_cast<uint32_t>(to.receivers.size()), atlas.border};
}

}  // namespace assay::scene
