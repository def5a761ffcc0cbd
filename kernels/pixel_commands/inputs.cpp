#include "kernels/pixel_commands/inputs.h"

#include <algorithm>
#include <bit>

#include "harness/commands.h"
#include "harness/crop.h"
#include "kernels/pixel_commands/oracle.h"

namespace assay::pixel_commands {

Screen screen_of(Extent e, uint shaders, uint materials) {
  Screen s = {.extent = e, .visibility = std::vector<uvec2>(pixel_count(e), uvec2(kVisibilityNone))};
  s.params.shaders = shaders;
  s.params.materials = materials;
  s.params.wave_log2 = std::countr_zero(kWaveSize);
  s.params.waves_per_group_log2 = std::countr_zero(kWavesPerGroup);
  return s;
}

Case with_params(Case c, const std::function<void(CommandParams&)>& change) {
  auto params = c.params<CommandParams>();
  change(params);
  c.set_params(params);
  return c;
}

Case with_capacity(Case c, uint64_t entries) {
  const uint64_t waves = entries / wave_size(c);
  return with_params(std::move(c), [&](CommandParams& p) { p.waves = static_cast<uint>(waves); });
}

Case to_case(const Screen& s) {
  Case c = {.extent = s.extent};
  CommandParams params = s.params;
  params.width = s.extent.width;
  params.height = s.extent.height;
  params.surfaces = static_cast<uint>(s.slots.size());
  params.copies = s.copy_bits.empty() ? 0 : 1;
  c.set_params(params);
  c.set_input("visibility", s.visibility);
  c.set_input("surface_slots", s.slots);
  c.set_input("copy_bits", s.copy_bits.empty() ? std::vector<uint8_t>{0} : s.copy_bits);
  if (params.waves == 0) return with_capacity(c, demand_of(c).wanted + wave_size(c) - 1);
  return c;
}

namespace {

void add_rectangles(Screen& s, Pcg32& rng, uint32_t count) {
  const auto surfaces = static_cast<uint32_t>(s.slots.size());
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t x0 = rng.below(s.extent.width), y0 = rng.below(s.extent.height);
    const uint32_t x1 = std::min(s.extent.width, x0 + 1 + rng.below(s.extent.width / 4 + 8));
    const uint32_t y1 = std::min(s.extent.height, y0 + 1 + rng.below(s.extent.height / 4 + 8));
    const uint32_t surface = rng.below(surfaces) | (rng.next() & (kVisibilityInstanced | kVisibilityFlipped));
    for (uint32_t y = y0; y < y1; ++y)
      for (uint32_t x = x0; x < x1; ++x) s.visibility[size_t{y} * s.extent.width + x] = {(x ^ y) / 4, surface};
  }
}

void add_noise(Screen& s, Pcg32& rng, uint32_t one_in, uint32_t surfaces) {
  for (uvec2& v : s.visibility)
    if (rng.below(one_in) == 0) v = {rng.next(), rng.below(surfaces) | (rng.next() & kVisibilityFlipped)};
}

// ---- Random cases
// ----------------------------------------------------------------------------------------------------

void random_slots(Random& r, Screen& s) {
  const size_t few = r.branch({{"slots_none", 0.05}, {"slots_few", 0.35}, {"slots_scene", 0.4}, {"slots_full", 0.2}});
  constexpr uint kShaders[] = {0, 1, 8, 64}, kMaterials[] = {0, 4, 64, 4096};
  s.params.shaders = few == 1 ? 1 + r.rng.below(3) : kShaders[few];
  s.params.materials = few == 1 ? 1 + r.rng.below(4) : kMaterials[few];
  const uint32_t surfaces = 1 + r.rng.below(few == 3 ? 6000 : 300);
  const uint shaders = std::max(1u, s.params.shaders), materials = std::max(1u, s.params.materials);
  for (uint32_t i = 0; i < surfaces; ++i) s.slots.push_back({r.rng.below(shaders), r.rng.below(materials)});
  switch (r.branch({{"registered", 0.7}, {"unregistered", 0.2}, {"over", 0.1}})) {
    case 0:
      break;
    case 1:
      for (SurfaceSlot& slot : s.slots) {
        if (r.rng.below(8) == 0) slot.material = kUnregistered;
        if (r.rng.below(8) == 0) slot.shader = r.rng.below(2) ? kUnregistered : s.params.shaders;
      }
      break;
    default:
      s.params.shaders = r.rng.next() | kMaxShaders;
      s.params.materials = r.rng.next() | kMaxMaterials;
  }
}

void random_pixels(Random& r, Screen& s) {
  const auto surfaces = static_cast<uint32_t>(s.slots.size());
  switch (r.branch({{"pixels_none", 0.05},
                    {"pixels_one_surface", 0.1},
                    {"pixels_regions", 0.5},
                    {"pixels_noise", 0.2},
                    {"pixels_out_of_range", 0.15}})) {
    case 0:
      break;
    case 1:
      std::ranges::fill(s.visibility, uvec2(7, r.rng.below(surfaces)));
      break;
    case 2:
      add_rectangles(s, r.rng, 4 + r.rng.below(60));
      break;
    case 3:
      add_noise(s, r.rng, 1 + r.rng.below(3), surfaces);
      break;
    default:
      add_rectangles(s, r.rng, 8);
      add_noise(s, r.rng, 16, 1u << 30);
      add_noise(s, r.rng, 16, surfaces + 1);
  }
  if (r.branch({{"copies_none", 0.75}, {"copies", 0.25}}) == 0) return;
  for (size_t i = 0; i < s.visibility.size(); ++i) s.copy_bits.push_back(static_cast<uint8_t>(r.rng.next()));
}

// Between what holds every pixel unpadded and what pads all of them; or too little.
Case random_capacity(Random& r, const Case& c) {
  const Demand demand = demand_of(c);
  const uint64_t round_up = wave_size(c) - 1, padding = demand.wanted - demand.unpadded;
  switch (r.branch({{"room_ample", 0.25},
                    {"room_just", 0.2},
                    {"room_tight", 0.3},
                    {"room_unpadded", 0.1},
                    {"room_short", 0.1},
                    {"room_none", 0.05}})) {
    case 0:
      return with_capacity(c, demand.wanted + 1000);
    case 1:
      return with_capacity(c, demand.wanted + round_up);
    case 2:
      return with_capacity(c, demand.unpadded + round_up + padding / 1024 * r.rng.below(1024));
    case 3:
      return with_capacity(c, demand.unpadded + round_up);
    case 4:
      return with_capacity(c, r.rng.below(static_cast<uint32_t>(pixels(c)) + 1));
    default:
      return with_capacity(c, 0);
  }
}

Case random_case(Random& r) {
  Screen s = screen_of(random_extent(r, kTileSide), 0, 0);
  random_slots(r, s);
  random_pixels(r, s);
  const size_t wave = r.branch({{"wave_32", 0.5}, {"wave_other", 0.3}, {"wave_out_of_range", 0.2}});
  if (wave == 1) s.params.wave_log2 = kSmallestWaveLog2 + r.rng.below(5);
  if (wave == 2) s.params.wave_log2 = r.rng.below(2) ? 0 : 8 + r.rng.below(2000);
  s.params.waves_per_group_log2 = r.rng.below(8);
  s.params.waves = 1;  // replaced
  switch (r.branch({{"reserved_none", 0.7}, {"reserved_some", 0.2}, {"reserved_most", 0.1}})) {
    case 0:
      break;
    case 1:
      s.params.reserved = r.rng.below(5000);
      break;
    default:
      s.params.reserved = UINT32_MAX - r.rng.below(5000);
  }
  Case c = to_case(s);
  if (s.params.reserved > 5000) return with_capacity(c, pixels(c) + uint64_t{live_shaders(c)} * wave_size(c));
  return random_capacity(r, c);
}

// ---- Smaller cases
// ---------------------------------------------------------------------------------------------------

Case cropped_case(const Case& c, const Crop& crop) {
  Case smaller = with_params(c, [&](CommandParams& p) { p.width = crop.size.width, p.height = crop.size.height; });
  smaller.extent = crop.size;
  smaller.set_input("visibility", cropped(c.input<uvec2>("visibility"), c.extent, crop));
  if (c.params<CommandParams>().copies)
    smaller.set_input("copy_bits", cropped(c.input<uint8_t>("copy_bits"), c.extent, crop));
  return smaller;
}

std::vector<Case> smaller_cases(const Case& c) {
  std::vector<Case> cases;
  for (const Crop& crop : smaller_crops(c.extent)) cases.push_back(cropped_case(c, crop));
  return cases;
}

}  // namespace

Case typical(Extent e) {
  Screen s = screen_of(e, 8, 64);
  Pcg32 rng(3);
  for (uint i = 0; i < 400; ++i) {
    const uint material = i < 64 ? i : rng.below(64);
    s.slots.push_back({material / 8, material});
  }
  std::ranges::fill(s.visibility, uvec2(1, 5));
  add_rectangles(s, rng, 900);
  return to_case(s);
}

Case frame(const FrameInputs& f) {
  Screen s = screen_of(f.extent, f.scene.visible_shaders, f.scene.visible_materials);
  Case c = {.name = "frame", .extent = f.extent};
  s.params.width = f.extent.width;
  s.params.height = f.extent.height;
  s.params.surfaces = f.scene.surfaces;
  s.params.waves = static_cast<uint>(command_waves(f.extent, f.scene.visible_shaders));
  s.params.copies = f.vrcs;
  c.set_params(s.params);
  return c;
}

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  for (const char* b : {"slots_none",
                        "slots_few",
                        "slots_scene",
                        "slots_full",
                        "registered",
                        "unregistered",
                        "over",
                        "pixels_none",
                        "pixels_one_surface",
                        "pixels_regions",
                        "pixels_noise",
                        "pixels_out_of_range",
                        "copies_none",
                        "copies",
                        "room_ample",
                        "room_just",
                        "room_tight",
                        "room_unpadded",
                        "room_short",
                        "room_none",
                        "wave_32",
                        "wave_other",
                        "wave_out_of_range",
                        "reserved_none",
                        "reserved_some",
                        "reserved_most"})
    branches.push_back(b);
  return {.random = random_case, .branches = branches, .hard = hard_cases(), .smaller = smaller_cases};
}

}  // namespace assay::pixel_commands
