#include "harness/kernel.h"

#include "harness/groups.h"
#include "kernels/radiance_encodings/inputs.h"
#include "kernels/radiance_encodings/oracle.h"

namespace assay::radiance_encodings {

namespace {

uint64_t colours(const Case& c) { return c.params<EncodingParams>().colours; }
Groups per_256(const Case& c) { return spread_groups((colours(c) + 255) / 256); }

Variant variant(const std::string& name, const std::string& note) {
  std::vector<Bound> bounds = {exact("codes", "scales are powers of two: rounding is the encoding's alone"),
                               exact("decoded", "a whole number times a power of two")};
  for (Bound& b : bounds) b.answer = name + " " + b.ports[0];
  return {.name = name, .passes = {Dispatch{name + ".comp", per_256}}, .bounds = bounds, .note = note};
}

}  // namespace

Kernel describe() {
  return {
      .name = "radiance_encodings",
      .source = "Sousa, Geffroy 2016, R11G11B10_FLOAT; Vulkan's shared exponent; IEEE 754 binary16",
      .default_variant = "r11g11b10f",
      .params = layout_of<EncodingParams>(),
      .ports = {reads<vec3>("colours", colours), writes<uvec2>("codes", colours), writes<vec3>("decoded", colours)},
      .variants = {variant("r11g11b10f", "floats of 6, 6 and 5 bits, to the nearest, ties to even"),
                   variant("rgb9e5", "9 bits each under one exponent, to the nearest, ties up"),
                   variant("rgba16f", "halves, to the nearest, ties to even")},
      .oracle = round_trips,
      .inputs = inputs(),
      .mutants = {{"harness/glsl/half.glsl", 9811, "too much is not held", "largest"},
                  {"harness/glsl/half.glsl", 9812, "denormal codes have a leading 1", "denormal"},
                  {"harness/glsl/r11g11b10.glsl", 9813, "blue as fine as red", "one_colour"},
                  {"harness/glsl/rgba16.glsl", 9814, "an alpha of 0", "one_colour"},
                  {"harness/glsl/half.glsl", 9815, "denormal codes are read too small", "denormal"},
                  {"harness/glsl/r11g11b10.glsl", 9816, "blue held at red's largest", "largest"},
                  {"harness/glsl/half.glsl", 9116, "truncates", "carries"},
                  {"harness/glsl/gbuffer.glsl", 9303, "truncates", "carries"},
                  {"harness/glsl/gbuffer.glsl", 9304, "the shared exponent's bias is off by one", "carries"}},
      .cost =
          [](const Case& c) {
            return Cost{.bytes_read = colours(c) * 12, .bytes_written = colours(c) * 20, .operations = colours(c) * 30};
          },
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .errors = errors(),
  };
}

}  // namespace assay::radiance_encodings
