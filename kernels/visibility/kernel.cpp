#include "harness/kernel.h"

#include "kernels/visibility/fat_texel.h"
#include "kernels/visibility/inputs.h"
#include "kernels/visibility/oracle.h"

namespace assay::visibility {

namespace {

Count counted(uint SceneCounts::*member) {
  return [member](const Case& c) { return uint64_t{c.params<VisibilityParams>().scene.*member}; };
}

// Six calls, one a bucket of formats/scene.h; `slim` and `fat` differ in shaders and in one target.
Draw draw(const char* opaque_vertex, const char* opaque, const char* masked_vertex, const char* masked, bool fat) {
  Draw d = {.colours = {{.port = "visibility", .clear = glm::uvec4(kVisibilityNone)}},
            .depth = DepthTarget{.port = "depth", .compare = Compare::greater, .write = true, .clear = 0.0f},
            .indices = "indices",
            .commands = "draws",
            .calls = {}};
  if (fat) d.colours.push_back({.port = "fat", .clear = glm::uvec4(0)});
  for (uint32_t bucket = 0; bucket < kDrawBuckets; ++bucket) {
    const auto edge = [bucket](const Case& c, uint32_t i) {
      return c.params<VisibilityParams>().scene.bucket_first[bucket + i];
    };
    const bool cut = bucket >= 3;
    d.calls.push_back({.vertex = cut ? masked_vertex : opaque_vertex,
                       .fragment = cut ? masked : opaque,
                       .cull = std::array{Cull::back, Cull::front, Cull::none}[bucket % 3],
                       .first = [edge](const Case& c) { return uint64_t{edge(c, 0)}; },
                       .count = [edge](const Case& c) { return uint64_t{edge(c, 1)} - edge(c, 0); }});
  }
  return d;
}

// Each index, and each vertex and record at its use, read once; a pixel of each target written once.
Cost cost(const Case& c) {
  const SceneCounts n = c.params<VisibilityParams>().scene;
  const bool masked = n.bucket_first[3] < n.bucket_first[kDrawBuckets];
  uint64_t cut = 0;  // what only masked draws read
  if (masked) {
    cut = uint64_t{n.vertices} * sizeof(VertexAttributes) + n.materials * sizeof(MaterialRecord);
    if (const auto t = c.textures.find("textures"); t != c.textures.end())
      for (const Texture& texture : t->second) cut += texture.bytes.size();
  }
  return {.bytes_read = uint64_t{n.indices} * 4 + uint64_t{n.vertices} * sizeof(vec3) +
                        n.surfaces * sizeof(SurfaceRecord) + n.draws * sizeof(DrawCommand) + cut,
          .bytes_written = pixels(c) * 12,
          .operations = uint64_t{n.vertices} * 21};  // three dot products of four
}

const char* const kIds =
    "coverage by the top-left rule within the sub-pixel grid, depth within plane rounding, alpha within the filter's "
    "(README, Bounds)";
const char* const kFat = "either row or column of the quad, then the encoding's half steps (README, Fat)";

}  // namespace

Kernel describe() {
  Port fat = writes_image("fat", Format::rg32_uint);
  fat.only_in = {"fat"};
  const Bound ids = between({"visibility", "depth"}, kIds);
  Bound fat_bound = between({"fat"}, kFat);
  fat_bound.unpack = Unpack{layout_of<FatFields>(), unpack_fat};
  return {
      .name = "visibility",
      .source = "Lazarek, Hammer 2025, Triangle Visibility Buffer",
      .default_variant = "slim",
      .params = layout_of<VisibilityParams>(),
      .ports = {reads<vec3>("positions", counted(&SceneCounts::vertices), {"scene.positions"}),
                reads<VertexAttributes>("attributes", counted(&SceneCounts::vertices), {"scene.attributes"}),
                reads<uint>("indices", counted(&SceneCounts::indices), {"scene.indices"}),
                reads<SurfaceRecord>("surfaces", counted(&SceneCounts::surfaces), {"scene.surfaces"}),
                reads<DrawCommand>("draws", counted(&SceneCounts::draws), {"scene.draws"}),
                reads<MaterialRecord>("materials", counted(&SceneCounts::materials), {"scene.materials"}),
                reads_textures("textures", 16, {"scene.textures"}), writes_image("visibility", Format::rg32_uint),
                writes_image("depth", Format::d32_float), fat},
      .variants = {{.name = "slim",
                    .passes = {draw("opaque.vert", "opaque.frag", "masked.vert", "masked.frag", false)},
                    .needs = {Feature::primitive_id},
                    .note = "64 bits a pixel: triangle and surface"},
                   {.name = "fat",
                    .passes = {draw("fat.vert", "fat_opaque.frag", "fat.vert", "fat_masked.frag", true)},
                    .needs = {Feature::primitive_id},
                    .bounds = std::vector{ids, fat_bound},
                    .note = "128 bits a pixel: UV derivatives and tangent frame too"}},
      .oracle = rasterise,
      .inputs = inputs(),
      .bounds = {ids},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = frame,
      .undecided_limit = 5e-3,
      .undecided_reason = "pixels within 1/256 px of an edge, depth ties and alpha at its cutoff",
  };
}

}  // namespace assay::visibility
