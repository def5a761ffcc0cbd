// Draws triangles in every way that a Draw pass can: culled, counted, direct, with depth, blended.
#include "harness/kernel.h"

#include "tests/planted/device_draw/layout.h"
#include "tests/planted/ports.h"

namespace assay::device_draw {

namespace {
uint64_t first(const Case& c) { return c.params<DrawParams>().first; }
uint64_t count(const Case& c) { return c.params<DrawParams>().count; }
uint64_t most(const Case& c) { return c.params<DrawParams>().most; }
Count size_of(const char* port, uint64_t bytes) {
  return [=](const Case& c) { return c.inputs.at(port).size() / bytes; };
}

Draw draw(DrawCall call) {
  call.vertex = "world.vert";
  call.fragment = "face.frag";
  if (!call.first) call.first = first;
  if (!call.count) call.count = count;
  return {.colours = {{.port = "colour", .clear = glm::uvec4(9)}},
          .depth = DepthTarget{.port = "depth", .clear = 0.0f},
          .indices = "indices",
          .commands = "commands",
          .calls = {std::move(call)}};
}

Draw direct(bool indexed) {
  Draw d = draw({});
  d.commands.clear();
  if (!indexed) d.indices.clear();
  return d;
}

Draw unclear() {
  Draw d = draw({});
  d.colours[0].clear.reset();
  d.depth->clear.reset();
  return d;
}

Draw blended(Blend blend) {
  return {.colours = {{.port = "light", .clear = glm::uvec4(0x3f000000), .blend = blend}},
          .calls = {{.vertex = "world.vert", .fragment = "light.frag", .first = first, .count = count}}};
}

Draw tested(Compare compare, bool write) {
  Draw d = draw({});
  d.depth->compare = compare;
  d.depth->write = write;
  d.depth->clear = 0.5f;
  return d;
}
}  // namespace

Kernel describe();
Kernel describe() {
  const std::vector<std::string> commanded = {"both",    "back", "front",   "counted",
                                              "unclear", "less", "greater", "unwritten"};
  std::vector<std::string> indexed = commanded, faces;
  indexed.push_back("indexed");
  faces = indexed;
  faces.push_back("plain");
  return {
      .name = "device_draw",
      .source = "a test of harness/device",
      .default_variant = "both",
      .params = layout_of<DrawParams>(),
      .ports = {reads<glm::vec3>("positions", size_of("positions", 12)),
                only_in(reads<uint32_t>("indices", size_of("indices", 4)), indexed),
                only_in(reads<DrawCommand>("commands", size_of("commands", 20)), commanded),
                only_in(reads<uint32_t>("limit", fixed(1)), {"counted"}),
                only_in(updates<uint32_t>("fragments", fixed(1)), faces),
                only_in(writes_image("colour", Format::r32_uint), faces),
                only_in(writes_image("depth", Format::d32_float), faces),
                only_in(writes_image("light", Format::rgba16_float), {"over", "add"})},
      .variants = {{.name = "both", .passes = {draw({})}},
                   {.name = "back", .passes = {draw({.cull = Cull::back})}},
                   {.name = "front", .passes = {draw({.cull = Cull::front})}},
                   {.name = "counted",
                    .passes = {draw({.count = most, .count_port = "limit"})},
                    .needs = {Feature::draw_indirect_count}},
                   {.name = "indexed", .passes = {direct(true)}},
                   {.name = "plain", .passes = {direct(false)}},
                   {.name = "unclear", .passes = {unclear()}},
                   {.name = "over", .passes = {blended(Blend::over)}},
                   {.name = "add", .passes = {blended(Blend::add)}},
                   {.name = "less", .passes = {tested(Compare::less, true)}},
                   {.name = "greater", .passes = {tested(Compare::greater, true)}},
                   {.name = "unwritten", .passes = {tested(Compare::greater, false)}}},
  };
}

}  // namespace assay::device_draw
