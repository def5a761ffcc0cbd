#include "harness/study/chain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "harness/formats/exposure.h"
#include "harness/formats/visibility.h"
#include "harness/formats/vrcs.h"
#include "harness/study/parameters.h"

namespace assay::study {

namespace {

// The benchmark's case with another input; no rates, lists or borders of its own count, for earlier steps write them.
Step step_of(const std::string& kernel, Extent e) {
  const Kernel& k = kernel_named(kernel);
  return {.kernel = &k, .input = k.typical(e)};
}
void add(Chain& c, Step& step, const std::string& variant, const device::Ports& have) {
  const Variant& v = variant_of(*step.kernel, variant);
  device::Ports known = step.ports;
  known.insert(have.begin(), have.end());
  step.ports = device::make_ports(*c.device, *step.kernel, step.input, std::move(known), &v);
  step.commands[variant] = device::lower(*c.device, {step.kernel, &v}, step.input, step.ports);
}

void append(std::vector<device::Command>& to, const std::vector<device::Command>& more) {
  if (!to.empty()) to.push_back(device::barrier());
  to.insert(to.end(), more.begin(), more.end());
}

template <class T>
std::vector<T> read(Chain& c, const device::Owned& from) {
  const Bytes bytes = device::read(*c.device, *from);
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}
template <class T>
void write(Chain& c, const device::Owned& to, const std::vector<T>& values) {
  device::write(*c.device, *to, std::as_bytes(std::span(values)));
}

// Every pixel shaded: the tiles' words say so.
void measure_luma(Chain& c) {
  device::fill(*c.device, *c.coordinates.ports.at("tiles"), kVrcsTile1x1 | kVrcsTilePixels);
  device::run(*c.device, c.deblock.commands.at("ping_pong"));
  const auto both = read<std::array<uint8_t, 2>>(c, c.deblock.ports.at("luma"));
  for (const auto& l : both) c.luma.push_back(l[0]);
}

// Whose colour each pixel gets, by its place.
std::vector<uint32_t> sources(Chain& c, const Choice& choice) {
  const auto set = [&](const std::string& name, auto value) {
    set_parameter(*c.rates.kernel, c.rates.input, name, value);
  };
  set("tolerance", choice.tolerance);
  set("flags", choice.weber ? kWeber : 0u);
  set("extra_half", choice.extra_half);
  device::write(*c.device, *c.rates.ports.at("params"), c.rates.input.parameters);
  std::vector<device::Command> commands;
  append(commands, c.rates.commands.at(choice.estimator));
  append(commands, c.coordinates.commands.at("tile_list"));
  append(commands, c.remap.commands.at("tile_list"));
  device::run(*c.device, commands);
  auto from = read<uint32_t>(c, c.remap.ports.at("values"));
  for (uint32_t& place : from)
    if (place-- == 0 || place >= from.size()) throw std::logic_error("vrcs_remap left a pixel out");
  return from;
}

double share_copied(const std::vector<uint32_t>& from) {
  size_t copies = 0;
  for (size_t i = 0; i < from.size(); ++i) copies += from[i] != i;
  return static_cast<double>(copies) / static_cast<double>(from.size());
}

}  // namespace

std::string label_of(const Choice& c) {
  std::string label = c.estimator;
  if (c.weber) label += ", Weber";
  if (c.extra_half != 0) label += fmt::format(", extra half {}", c.extra_half);
  return label;
}

Chain make_chain(device::Device& d, Picture picture) {
  const Extent e = picture.size;
  Chain c = {.device = &d,
             .picture = std::move(picture),
             .rates = step_of("vrcs_shading_rate", e),
             .coordinates = step_of("vrcs_coordinates", e),
             .remap = step_of("vrcs_remap", e),
             .deblock = step_of("vrcs_deblock", e)};
  const std::vector<uvec2> one_triangle(pixel_count(e), uvec2(7, 3));
  c.coordinates.input.set_input("visibility", one_triangle);
  c.remap.input.set_input("visibility", one_triangle);
  c.deblock.input.set_input("radiance", c.picture.radiance);
  c.deblock.input.set_input("exposure", std::vector{ExposureRecord{0, 0, 0, c.picture.exposure}});
  for (const Variant& v : c.rates.kernel->variants) add(c, c.rates, v.name, {});
  add(c, c.coordinates, "tile_list", {{"rates", c.rates.ports.at("rates")}});
  const device::Ports lists = {{"tiles", c.coordinates.ports.at("tiles")},
                               {"entries", c.coordinates.ports.at("entries")}};
  add(c, c.remap, "tile_list", lists);
  add(c, c.deblock, "ping_pong", lists);
  measure_luma(c);
  set_luma(c, 0, 0);
  return c;
}

void set_luma(Chain& c, double right, double down) {
  const int64_t width = c.picture.size.width, height = c.picture.size.height;
  const auto at = [&](int64_t x, int64_t y) -> double {
    return c.luma[static_cast<size_t>(std::clamp<int64_t>(y, 0, height - 1) * width +
                                      std::clamp<int64_t>(x, 0, width - 1))];
  };
  std::vector<std::array<uint8_t, 2>> moved;
  for (int64_t y = 0; y < height; ++y)
    for (int64_t x = 0; x < width; ++x) {
      const double u = static_cast<double>(x) - right, v = static_cast<double>(y) - down;
      const auto i = static_cast<int64_t>(std::floor(u)), j = static_cast<int64_t>(std::floor(v));
      const double s = u - std::floor(u), t = v - std::floor(v);
      const double code =
          std::lerp(std::lerp(at(i, j), at(i + 1, j), s), std::lerp(at(i, j + 1), at(i + 1, j + 1), s), t);
      const auto rounded = static_cast<uint8_t>(std::lround(code));
      moved.push_back({rounded, rounded});
    }
  write(c, c.rates.ports.at("luma"), moved);
}

Shaded shade(Chain& c, const Choice& choice) {
  Shaded s = {.from = sources(c, choice), .copied = {}, .deblocked = {}};
  s.saved = share_copied(s.from);
  for (const uint32_t place : s.from) s.copied.push_back(c.picture.radiance[place]);
  write(c, c.deblock.ports.at("radiance"), s.copied);
  device::run(*c.device, c.deblock.commands.at("ping_pong"));
  s.deblocked = read<Texel>(c, c.deblock.ports.at("deblocked_radiance"));
  return s;
}

double saved(Chain& c, const Choice& choice) { return share_copied(sources(c, choice)); }

}  // namespace assay::study
