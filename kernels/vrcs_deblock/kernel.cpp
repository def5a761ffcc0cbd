#include "harness/kernel.h"

#include "kernels/vrcs_deblock/inputs.h"
#include "kernels/vrcs_deblock/oracle.h"

namespace assay::vrcs_deblock {

namespace {

const std::vector<std::string> kApart = {"ping_pong", "guarded", "guarded_by_triangle"};
const std::vector<std::string> kListed = {"ping_pong", "in_place", "guarded", "guarded_by_triangle"};
const std::vector<std::string> kReading = {"ping_pong", "guarded", "guarded_by_triangle", "luma_alone"};

Groups per_256_halves(const Case& c) { return pixels(c) == 0 ? Groups{0, 1, 1} : Groups{16, 16, 1}; }
Groups per_tile(const Case& c) {
  const Extent tiles = tiles_of(c.extent, kVrcsTileSide);
  return {tiles.width, tiles.height, 1};
}

// Texels as words: what is not changed is kept to the bit, and no device's rounding is asked for.
Port words_of_radiance(const std::string& name, Use use, std::vector<std::string> only_in,
                       std::vector<std::string> producers = {}) {
  return {.name = name,
          .use = use,
          .kind = PortKind::image,
          .format = Format::rgba16_float,
          .view = Format::rg32_uint,
          .producers = std::move(producers),
          .only_in = std::move(only_in)};
}
Port half_codes_port() {
  Port p = writes_image("half_codes", Format::r8_uint);
  p.extent = [](const Case&) { return Extent{kHalfCodesSide, kHalfCodesSide}; };
  return p;
}
Port only_in(std::vector<std::string> variants, Port p) {
  p.only_in = std::move(variants);
  return p;
}

Bound named(Bound b, const std::string& of) {
  b.answer = b.ports[0] + of;
  return b;
}
// The table of codes goes before whatever asks it.
std::vector<Pass> passes(const std::string& shader) {
  return {Dispatch{"half_codes.comp", per_256_halves}, Dispatch{shader, per_tile}};
}
Bound half_codes() { return exact("half_codes", "codes by comparison"); }
std::vector<Bound> bounds(const std::string& of) {
  return {half_codes(), named(exact("deblocked_radiance", "sums of floats in a given order, to the nearest half"), of),
          named(exact("luma", "codes by comparison, weights in whole numbers"), of)};
}
std::vector<Bound> ranges() {
  Bound radiance =
      between({"radiance_in_place"}, "neighbours that are duplicates may be old or new (README, The race)");
  radiance.unpack = Unpack{layout_of<ColourRange>(), unpack_texels};
  Bound luma = named(between({"luma"}, "of the radiance's range: it grows with each channel"), " of in_place");
  luma.unpack = Unpack{layout_of<LumaRange>(), unpack_luma};
  return {half_codes(), radiance, luma};
}

Variant variant(const std::string& name, const std::string& of, const std::string& note) {
  return {.name = name, .passes = passes(name + ".comp"), .bounds = bounds(of), .note = note};
}

Variant luma_alone() {
  Variant v = variant("luma_alone", "", "nothing is deblocked: only what the next frame's rates are made of");
  v.bounds = {{half_codes(), named(exact("luma", "codes by comparison, weights in whole numbers"), " of luma_alone")}};
  v.cost = [](const Case& c) {
    return Cost{.bytes_read = pixels(c) * 8 + sizeof(ExposureRecord) + uint64_t{kCodes + kBuckets} * 4,
                .bytes_written = pixels(c) * 2 + 65536,
                .operations = pixels(c) * 40};
  };
  return v;
}

// Each port of the default once.
Cost cost(const Case& c) {
  return {.bytes_read =
              pixels(c) * 8 + (tiles(c) + entries(c)) * 4 + sizeof(ExposureRecord) + uint64_t{kCodes + kBuckets} * 4,
          .bytes_written = pixels(c) * (8 + 2) + 65536,
          .operations = pixels(c) * 60};
}

}  // namespace

Kernel describe() {
  return {
      .name = "vrcs_deblock",
      .source = "Fuller, Hammer 2025, Activision's Deblocker; Drobot 2020",
      .default_variant = "ping_pong",
      .params = layout_of<DeblockParams>(),
      .ports = {words_of_radiance("radiance", Use::reads, kReading, {"deferred_lighting.radiance"}),
                words_of_radiance("radiance_in_place", Use::updates, {"in_place"}, {"deferred_lighting.radiance"}),
                only_in(kListed, reads<uint>("tiles", tiles, {"vrcs_coordinates.tiles"})),
                only_in(kListed, reads<uint>("entries", entries, {"vrcs_coordinates.entries"})),
                reads<ExposureRecord>("exposure", fixed(1)), reads<float>("thresholds", fixed(kCodes)),
                reads<uint>("first_codes", fixed(kBuckets)), half_codes_port(),
                only_in({"guarded", "guarded_by_triangle"},
                        reads_image("visibility", Format::rg32_uint, {"visibility.visibility"})),
                only_in({"guarded"}, reads_image("depth", Format::d32_float, {"visibility.depth"})),
                words_of_radiance("deblocked_radiance", Use::writes, kApart), writes_image("luma", Format::rg8_unorm)},
      .variants = {variant("ping_pong", "", "from one image to another; every neighbour counts"),
                   {.name = "in_place",
                    .passes = passes("in_place.comp"),
                    .bounds = ranges(),
                    .note = "one image: a neighbour may have changed already"},
                   variant("guarded", " of guarded", "neighbours of the surface at about the pixel's depth"),
                   variant("guarded_by_triangle", " of guarded_by_triangle", "neighbours of the triangle"),
                   luma_alone()},
      .oracle = answers,
      .inputs = inputs(),
      .bounds = bounds(""),
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
      .errors = error_table(),
  };
}

}  // namespace assay::vrcs_deblock
