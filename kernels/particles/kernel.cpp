#include "harness/kernel.h"

#include "kernels/particles/inputs.h"
#include "kernels/particles/layout.h"
#include "kernels/particles/oracle.h"

namespace assay::particles {

namespace {

const std::vector<std::string> kSampling = {"bilinear", "b_spline", "catmull_rom"},
                               kLighting = {"per_vertex", "per_pixel"};

Count counted(uint ParticlesParams::*member) {
  return [member](const Case& c) { return uint64_t{c.params<ParticlesParams>().*member}; };
}
uint64_t vertices(const Case& c) { return uint64_t{c.params<ParticlesParams>().drawn} * kVertices; }
uint64_t corners(const Case& c) { return uint64_t{c.params<ParticlesParams>().drawn} * kCorners; }
Extent atlas_extent(const Case& c) {
  const uint32_t side = c.params<ParticlesParams>().atlas_side;
  return {side, side};
}

Format atlas_format(const Case& c) {
  const uint32_t encoding = c.params<ParticlesParams>().encoding;
  return encoding == kLightRgb9e5   ? Format::rgb9e5_float
         : encoding == kLightRgba16 ? Format::rgba16_float
                                    : Format::r11g11b10_float;
}

Port only_in(const std::vector<std::string>& variants, Port p) {
  p.only_in = variants;
  return p;
}
std::vector<Port> ports() {
  Port radiance = {
      .name = "radiance",
      .use = Use::updates,
      .kind = PortKind::image,
      .format = Format::rgba16_float,
      .producers = {"vrcs_deblock.deblocked_radiance", "vrcs_deblock.radiance_in_place", "deferred_lighting.radiance"}};
  Port atlas = reads_image(
      "atlas", Format::r11g11b10_float,
      {"particle_light_atlas.atlas", "particle_light_atlas.atlas_rgb9e5", "particle_light_atlas.atlas_rgba16"});
  atlas.format_in = atlas_format;
  atlas.extent = atlas_extent;
  return {reads<ParticleRecord>("particles", counted(&ParticlesParams::particles), {"scene.particles"}),
          reads<uint>("order", counted(&ParticlesParams::drawn), {"scene.particle_order"}),
          reads_image("depth", Format::d32_float, {"visibility.depth"}),
          radiance,
          only_in(kSampling, reads<uint>("rects", counted(&ParticlesParams::particles), {"particle_rects.rects"})),
          only_in(kSampling, atlas),
          only_in(kLighting, reads<LightRecord>("lights", counted(&ParticlesParams::lights), {"scene.lights"})),
          only_in({"per_vertex"}, writes<vec3>("corners", corners))};
}

Bound picture(const std::string& variant) {
  Bound b = between({"radiance"}, "place, opacity and colour by running error, each blend in halves (README, Bounds)");
  b.unpack = Unpack{texel_layout(), unpack_texels};
  b.answer = variant;
  return b;
}

uint64_t bytes_of_all(const Case& c) {
  const auto p = c.params<ParticlesParams>();
  return pixels(c) * (8 + 4) + p.particles * sizeof(ParticleRecord) + p.drawn * sizeof(uint);
}
// A fragment an entry at a tenth of the pixels is what a plume has; its lights, or its taps, come on top.
Cost cost_of(const Case& c, uint64_t bytes_read, uint64_t bytes_written) {
  return {.bytes_read = bytes_of_all(c) + bytes_read,
          .bytes_written = pixels(c) * 8 + bytes_written,
          .operations = pixels(c) * 60};
}
Cost cost(const Case& c) {
  const auto p = c.params<ParticlesParams>();
  return cost_of(c, p.particles * sizeof(uint) + pixel_count(atlas_extent(c)) * bytes_per_block(atlas_format(c)), 0);
}
Cost cost_of_lights(const Case& c) { return cost_of(c, c.params<ParticlesParams>().lights * sizeof(LightRecord), 0); }
Cost cost_of_corners(const Case& c) {
  return cost_of(c, c.params<ParticlesParams>().lights * sizeof(LightRecord), corners(c) * sizeof(vec3));
}

Draw draw(const std::string& name) {
  return {.colours = {{.port = "radiance", .blend = Blend::over}},
          .calls = {{.vertex = "quad.vert", .fragment = name + ".frag", .count = vertices}}};
}
Variant variant(const std::string& name, const std::string& note) {
  return {.name = name, .passes = {draw(name)}, .bounds = std::vector{picture(name)}, .note = note};
}
std::vector<Variant> variants() {
  Variant per_vertex = variant("per_vertex", "lit at the quad's corners, linear between"),
          per_pixel = variant("per_pixel", "lit at every fragment");
  per_vertex.passes.insert(per_vertex.passes.begin(),
                           Dispatch{"corners.comp", [](const Case& c) {
                                      return Groups{ceil_div(static_cast<uint32_t>(corners(c)), kCornersGroup), 1, 1};
                                    }});
  per_vertex.bounds->push_back(between({"corners"}, "running error of the shading model (deferred_lighting's README)"));
  per_vertex.cost = cost_of_corners, per_pixel.cost = cost_of_lights;
  return {variant("catmull_rom", "16 texels of the atlas, through them, held within the inner four"),
          variant("b_spline", "16 texels, smoother and blurred"), variant("bilinear", "4 texels"), per_vertex,
          per_pixel};
}

}  // namespace

Kernel describe() {
  return {
      .name = "particles",
      .source = "Sousa, Geffroy 2016, Decoupled Particle Lighting; Catmull, Rom 1974",
      .default_variant = "catmull_rom",
      .params = layout_of<ParticlesParams>(),
      .ports = ports(),
      .variants = variants(),
      .oracle = drawn,
      .inputs = inputs(),
      .bounds = {picture("catmull_rom")},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{128, 72}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
      .errors = error_table(),
  };
}

}  // namespace assay::particles
