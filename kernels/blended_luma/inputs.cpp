#include "kernels/blended_luma/inputs.h"

#include <array>

#include "harness/crop.h"
#include "kernels/blended_luma/layout.h"

namespace assay::blended_luma {

namespace {

using Texel = std::array<uint16_t, 4>;
using Codes = std::array<uint8_t, 2>;

struct Picture {
  Extent extent;
  std::vector<Texel> texels = {};
  std::vector<uint8_t> half_codes = {};
  std::vector<Codes> luma = {};
};
// Any halves, any codes: the table need not be a curve.
Picture noise(Extent e, uint64_t seed) {
  Pcg32 rng(seed);
  const auto half = [&] { return static_cast<uint16_t>(rng.next()); };
  const auto byte = [&] { return static_cast<uint8_t>(rng.next()); };
  Picture p = {.extent = e};
  for (uint64_t i = 0; i < pixel_count(e); ++i) {
    p.texels.push_back({half(), half(), half(), half()});
    p.luma.push_back({byte(), byte()});
  }
  for (uint32_t i = 0; i < kHalfCodesSide * kHalfCodesSide; ++i) p.half_codes.push_back(byte());
  return p;
}
Case to_case(const std::string& name, const Picture& p) {
  Case c = {.name = name, .extent = p.extent};
  c.set_params(LumaParams{p.extent.width, p.extent.height});
  c.set_input("radiance", p.texels);
  c.set_input("half_codes", p.half_codes);
  c.set_input("luma", p.luma);
  return c;
}

// Each half in each channel once; the table a staircase over magnitudes.
Picture every_half() {
  Picture p = noise({256, 256}, 3);
  for (uint32_t i = 0; i < 65536; ++i) {
    p.texels[i] = {static_cast<uint16_t>(i), static_cast<uint16_t>(i * 17u), static_cast<uint16_t>(i * 31u), 0};
    p.half_codes[i] = static_cast<uint8_t>((i & 0x7fffu) >> 7);
  }
  return p;
}

Case random_case(Random& r) {
  Picture p = noise(random_extent(r, 32), r.rng.next());
  if (r.branch({{"any_codes", 0.5}, {"curve", 0.5}}) != 0) p.half_codes = every_half().half_codes;
  return to_case("random", p);
}

std::vector<Case> smaller(const Case& c) {
  std::vector<Case> found;
  for (const Crop& crop : smaller_crops(c.extent)) {
    Case part = c;
    part.extent = crop.size;
    part.set_params(LumaParams{crop.size.width, crop.size.height});
    part.set_input("radiance", cropped(c.input<Texel>("radiance"), c.extent, crop));
    part.set_input("luma", cropped(c.input<Codes>("luma"), c.extent, crop));
    found.push_back(std::move(part));
  }
  return found;
}

HardCase of_size(const std::string& name, const std::string& why, Extent e) {
  return {name, why, [=] { return to_case(name, noise(e, 9)); }};
}

}  // namespace

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  branches.insert(branches.end(), {"any_codes", "curve"});
  return {.random = random_case,
          .branches = branches,
          .hard = {of_size("one_pixel", "one thread of a group has work", {1, 1}),
                   of_size("odd_extent", "groups that reach out of the picture", {31, 33}),
                   of_size("wide", "width and height cannot be swapped", {200, 3}),
                   {"every_half", "each half, NaN and infinities too, in each channel",
                    [] { return to_case("every_half", every_half()); }},
                   of_size("full_hd_and_one", "an odd extent of real size", {1921, 1081})},
          .smaller = smaller};
}

Case typical(Extent e) {
  Picture p = noise(e, 1);
  p.half_codes = every_half().half_codes;
  return to_case("typical", p);
}

Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.vrcs ? f.extent : Extent{0, 0}};
  c.set_params(LumaParams{f.extent.width, f.extent.height});
  return c;
}

}  // namespace assay::blended_luma
