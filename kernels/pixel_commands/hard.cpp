// Named hard cases, and the faults that they must find.
#include <algorithm>

#include "kernels/pixel_commands/inputs.h"
#include "kernels/pixel_commands/oracle.h"

namespace assay::pixel_commands {

namespace {

// One surface a slot; `at` gives a pixel's slot, or kNothing.
constexpr uint kNothing = UINT32_MAX;

template <class F>
Screen drawn(Screen s, F at) {
  for (uint32_t y = 0; y < s.extent.height; ++y)
    for (uint32_t x = 0; x < s.extent.width; ++x)
      if (const uint surface = at(x, y); surface != kNothing)
        s.visibility[size_t{y} * s.extent.width + x] = {x * y, surface};
  return s;
}

Screen with_slots(Extent e, uint shaders, uint materials, std::vector<SurfaceSlot> slots) {
  Screen s = screen_of(e, shaders, materials);
  s.slots = std::move(slots);
  return s;
}

// Surfaces 0 .. n - 1 over the materials in turn, all of shader 0.
Screen of_materials(Extent e, uint n, uint materials) {
  Screen s = screen_of(e, 1, materials);
  for (uint i = 0; i < n; ++i) s.slots.push_back({0, i % materials});
  return s;
}

// Every pixel has its own surface, and the surfaces' materials and shaders follow `slot`.
template <class F>
Screen all_apart(Extent e, uint shaders, uint materials, F slot) {
  Screen s = screen_of(e, shaders, materials);
  for (uint i = 0; i < pixel_count(e); ++i) s.slots.push_back(slot(i));
  return drawn(std::move(s), [&](uint32_t x, uint32_t y) { return y * e.width + x; });
}
Screen every_pixel_another_material(Extent e) {
  return all_apart(e, 1, 4096, [](uint i) { return SurfaceSlot{0, i % 4096}; });
}

// Bands of surfaces 0, 1, 2, ... across three tiles, of two shaders and divergent in the second tile.
Screen bands(uint wave_log2) {
  Screen s = with_slots({96, 64}, 3, 8, {{0, 7}, {0, 3}, {1, 3}, {1, 0}, {0, 3}, {2, 1}});
  s.params.wave_log2 = wave_log2;
  return drawn(std::move(s), [](uint32_t x, uint32_t y) { return (x / 7 + y / 5) % 6; });
}

Case with_waves_short(const Case& c, uint waves) {
  return with_params(c, [&](CommandParams& p) { p.waves -= waves; });
}
// Nothing is lost, nothing padded.
Case unpadded(const Case& c) { return with_capacity(c, demand_of(c).unpadded + wave_size(c) - 1); }
// Half of the padding finds room.
Case half_padded(const Case& c) {
  const Demand d = demand_of(c);
  return with_capacity(c, (d.unpadded + d.wanted) / 2 + wave_size(c) - 1);
}

// As many pixels of the tile's slots as `counts` says, one after the other in scan order.
Case counted(const std::vector<uint>& counts, uint wave_log2 = 5) {
  Screen s = of_materials({32, 32}, static_cast<uint>(counts.size()), static_cast<uint>(counts.size()));
  s.params.wave_log2 = wave_log2;
  return to_case(drawn(std::move(s), [&](uint32_t x, uint32_t y) {
    uint left = y * 32 + x;
    for (uint i = 0; i < counts.size(); ++i) {
      if (left < counts[i]) return i;
      left -= counts[i];
    }
    return kNothing;
  }));
}

// Where the sum of reserved entries, pixels and padding is exactly `sum`; all pixels have room unpadded.
Case reserving(uint64_t sum) {
  Case c = to_case(bands(5));
  const uint64_t wanted = demand_of(c).wanted;
  c = unpadded(c);
  return with_params(c, [&](CommandParams& p) { p.reserved = static_cast<uint>(sum - wanted); });
}

// Surfaces that share a slot of the tile's table (table.glsl).
Case colliding() {
  std::vector<uint> alike;
  for (uint surface = 0; alike.size() < 60; ++surface)
    if (surface * 2654435769u >> 22 == 1023) alike.push_back(surface);
  Screen s = of_materials({64, 32}, alike.back() + 1, 16);
  return to_case(drawn(std::move(s), [&](uint32_t x, uint32_t y) { return alike[(x + y * 3) % alike.size()]; }));
}

std::vector<HardCase> materials() {
  return {
      {"one_material", "all pixels meet on one counter, and every wave is full",
       [] {
         return to_case(drawn(of_materials({96, 64}, 1, 1), [](uint32_t, uint32_t) { return 0u; }));
       }},
      {"every_pixel_another_material",
       "4096 materials: no table of a tile holds them all, and 31 of 32 entries are padding",
       [] {
         return to_case(every_pixel_another_material({64, 64}));
       }},
      {"every_pixel_another_surface", "1024 surfaces of one material in a tile: a full table, one divergent group",
       [] {
         return to_case(all_apart({64, 32}, 1, 2, [](uint) { return SurfaceSlot{0, 1}; }));
       }},
      {"twenty_surfaces", "every subgroup has pixels of surfaces that several others place",
       [] {
         return to_case(
             drawn(of_materials({64, 32}, 20, 10), [](uint32_t x, uint32_t y) { return (x * 7 + y * 3) % 20; }));
       }},
      {"materials_4096", "one shader of 4096 materials, a hundred in each tile, in no order",
       [] {
         return to_case(drawn(of_materials({160, 96}, 4096, 4096), [](uint32_t x, uint32_t y) {
           return (x / 3 * 2654435769u + y / 3 * 40503u) >> 7 & 4095u;
         }));
       }},
      {"shaders_64", "64 shaders x 64 materials, each pair on a pixel of its own",
       [] {
         return to_case(all_apart({64, 64}, 64, 64, [](uint i) { return SurfaceSlot{i % 64, i / 64}; }));
       }},
      {"two_surfaces", "one material, the second surface on one pixel a tile: divergent there, uniform elsewhere",
       [] {
         return to_case(drawn(of_materials({128, 64}, 2, 1),
                              [](uint32_t x, uint32_t y) { return uint{x % 64 == 63 && y % 32 == 31}; }));
       }},
      {"uniform_after_divergent", "material 0 is divergent and material 1 uniform: the uniform one comes first",
       [] {
         return to_case(drawn(with_slots({64, 32}, 1, 2, {{0, 0}, {0, 0}, {0, 1}}),
                              [](uint32_t x, uint32_t y) { return (x + y) % 3; }));
       }},
      {"sixty_uniform_after_divergent",
       "where the divergent group stands, the last of sixty uniform ones after it decides",
       [] {
         std::vector<SurfaceSlot> slots = {{0, 0}, {0, 0}};
         for (uint i = 1; i <= 60; ++i) slots.push_back({0, i});
         return to_case(
             drawn(with_slots({64, 32}, 1, 61, slots), [](uint32_t x, uint32_t y) { return (x * 5 + y * 7) % 62; }));
       }},
      {"material_of_two_shaders", "one material slot under two shaders is two groups",
       [] {
         return to_case(
             drawn(with_slots({64, 40}, 2, 1, {{0, 0}, {1, 0}}), [](uint32_t x, uint32_t y) { return (x ^ y) % 2; }));
       }},
      {"shader_without_pixels", "the middle one of three visible shaders is on no pixel",
       [] {
         return to_case(drawn(with_slots({70, 40}, 3, 2, {{0, 0}, {2, 1}, {1, 0}}),
                              [](uint32_t x, uint32_t) { return x / 5 % 2; }));
       }},
      {"descending_materials", "later pixels have lower materials: the order is not that of arrival",
       [] {
         return to_case(drawn(of_materials({64, 64}, 32, 32), [](uint32_t, uint32_t y) { return 31 - y % 32; }));
       }},
      {"hash_collisions", "sixty surfaces whose first slot is the table's last", colliding},
      {"bands", "tiles of several shaders, uniform and divergent", [] { return to_case(bands(5)); }},
  };
}

std::vector<HardCase> hostile() {
  return {
      {"nothing", "no pixel has a surface: every list is empty and nothing is dispatched",
       [] {
         return to_case(of_materials({65, 65}, 4, 4));
       }},
      {"no_shaders", "no shader is visible, yet pixels are covered: all unlisted",
       [] {
         return to_case(drawn(with_slots({40, 40}, 0, 0, {{0, 0}}), [](uint32_t, uint32_t) { return 0u; }));
       }},
      {"unregistered_material", "a material that culling did not register, by its mark and by one beyond the last",
       [] {
         return to_case(drawn(with_slots({64, 32}, 2, 3, {{0, 2}, {0, 3}, {1, kUnregistered}}),
                              [](uint32_t x, uint32_t y) { return (x + y) % 3; }));
       }},
      {"unregistered_shader", "the same of shaders",
       [] {
         return to_case(
             drawn(with_slots({64, 32}, 2, 3, {{1, 2}, {2, 0}, {kUnregistered, 1}, {kUnregistered, kUnregistered}}),
                   [](uint32_t x, uint32_t y) { return (x + y) % 4; }));
       }},
      {"surface_out_of_range", "indices at, just beyond and far beyond the surfaces",
       [] {
         return to_case(drawn(of_materials({64, 32}, 3, 3), [](uint32_t x, uint32_t y) {
           constexpr uint kSurfaces[] = {0, 2, 3, 4, 0x3ffffffe};
           return kSurfaces[(x + y) % 5];
         }));
       }},
      {"last_surface", "the last surface is in range",
       [] {
         return to_case(drawn(of_materials({40, 40}, 9, 9), [](uint32_t, uint32_t) { return 8u; }));
       }},
      {"flags", "the instanced and flipped bits are no part of the index",
       [] {
         return to_case(
             drawn(of_materials({64, 32}, 4, 4), [](uint32_t x, uint32_t y) { return x % 4 | y % 4 << 30; }));
       }},
      {"all_ones_surface",
       "all ones in the surface alone is a surface out of range, in the triangle alone nothing special",
       [] {
         Screen s =
             drawn(of_materials({64, 32}, 4, 4), [](uint32_t x, uint32_t) { return x % 2 ? 1u : kVisibilityNone; });
         for (uvec2& v : s.visibility) v.x = v.y == 1u ? kVisibilityNone : 5u;
         return to_case(s);
       }},
      {"too_many_shaders",
       "counts of 2^32 - 1: slots beyond the limits are unlisted, nothing is read or written beyond",
       [] {
         Screen s = with_slots({64, 64}, ~0u, ~0u, {{63, 4095}, {64, 0}, {0, 4096}, {~0u, ~0u}});
         return to_case(drawn(std::move(s), [](uint32_t x, uint32_t y) { return (x + y) % 4; }));
       }},
      {"largest_coordinates", "x = 16383: the last that 14 bits hold",
       [] {
         return to_case(drawn(of_materials({16384, 1}, 2, 2), [](uint32_t x, uint32_t) { return x / 3 % 2; }));
       }},
      {"largest_row", "y = 16383",
       [] {
         return to_case(drawn(of_materials({1, 16384}, 2, 2), [](uint32_t, uint32_t y) { return y / 3 % 2; }));
       }},
  };
}

std::vector<HardCase> capacities() {
  return {
      {"room_for_all", "the least capacity that pads everything", [] { return to_case(bands(5)); }},
      {"a_wave_short", "one wave less: the last tile of the last shader is not padded",
       [] { return with_waves_short(to_case(bands(5)), 1); }},
      {"half_padded", "the room ends within a shader's tiles",
       [] {
         return half_padded(to_case(
             drawn(of_materials({320, 160}, 64, 64), [](uint32_t x, uint32_t y) { return (x / 3 + y / 5 * 7) % 64; })));
       }},
      {"half_padded_shaders", "the room ends within one of many shaders",
       [] {
         return half_padded(to_case(all_apart({96, 96}, 9, 64, [](uint i) { return SurfaceSlot{i % 9, i % 64}; })));
       }},
      {"unpadded", "room for every pixel, for no padding",
       [] {
         return unpadded(to_case(every_pixel_another_material({64, 64})));
       }},
      {"unpadded_shaders", "the overflow of each shader starts a wave, and its last is filled up",
       [] { return unpadded(to_case(bands(5))); }},
      {"pixels_lost", "not even room for every pixel: tiles are written whole or not at all, and the lost are counted",
       [] { return with_capacity(to_case(bands(5)), 3000); }},
      {"pixels_lost_odd", "the same where tiles have few pixels and the room ends within a wave of them",
       [] {
         return with_capacity(
             to_case(drawn(of_materials({320, 64}, 3, 3),
                           [](uint32_t x, uint32_t y) { return (x * y) % 29 == 3 ? x % 3 : kNothing; })),
             160);
       }},
      {"no_room", "capacity 0", [] { return with_capacity(to_case(bands(5)), 0); }},
      {"sum_2_32_less_1", "reserved, pixels and padding sum to 2^32 - 1", [] { return reserving(UINT32_MAX); }},
      {"sum_2_32", "they sum to 2^32: wrapped it would be 0, an empty list", [] { return reserving(1ull << 32); }},
      {"sum_past_2_32", "and beyond", [] { return reserving((1ull << 32) + 300); }},
      {"reserved_over", "the reserved entries alone with the pixels are over 2^32",
       [] { return with_params(unpadded(to_case(bands(5))), [](CommandParams& p) { p.reserved = UINT32_MAX; }); }},
  };
}

std::vector<HardCase> waves() {
  std::vector<HardCase> cases = {
      {"wave_boundaries", "groups of 1, 31, 32, 33, 63, 64 and 65 pixels",
       [] {
         return counted({1, 31, 32, 33, 63, 64, 65});
       }},
      {"all_digits", "groups of 1 + 2 + 4 + 8 + 16 waves: a command in each of five buckets",
       [] { return counted({992}); }},
      {"odd_commands", "one command of one wave: half a group of the consumer's", [] { return counted({32}); }},
      {"high_lanes", "many surfaces in the tile's last pixels, seen by the highest subgroups only",
       [] {
         return to_case(drawn(of_materials({32, 32}, 300, 7),
                              [](uint32_t x, uint32_t y) { return y * 32 + x >= 724 ? y * 32 + x - 724 : kNothing; }));
       }},
      {"small_waves", "waves of 8: 128 of them in a tile are four commands of the last bucket",
       [] { return counted({1024}, 3); }},
      {"waves_out_of_range", "2^31 entries a wave: held to 128", [] { return to_case(bands(31)); }},
      {"copies", "copy bits go with the entries, duplicates are not listed",
       [] {
         Screen s = bands(5);
         for (size_t i = 0; i < s.visibility.size(); ++i) s.copy_bits.push_back(static_cast<uint8_t>(i * 37));
         return to_case(s);
       }},
  };
  for (const uint log2 : {3u, 4u, 6u, 7u})
    cases.push_back(
        {"waves_of_" + std::to_string(1u << log2), "another wave size", [log2] { return to_case(bands(log2)); }});
  for (const uint log2 : {0u, 3u, 5u, 40u})
    cases.push_back({"groups_of_2_to_" + std::to_string(log2), "another consumer's workgroup", [log2] {
                       return with_params(to_case(bands(3)), [&](CommandParams& p) { p.waves_per_group_log2 = log2; });
                     }});
  return cases;
}

std::vector<HardCase> sizes() {
  std::vector<HardCase> cases = {
      {"partial_tiles", "columns and rows left over, of one pixel each",
       [] {
         return to_case(drawn(of_materials({33, 65}, 12, 5), [](uint32_t x, uint32_t y) { return (x + y * 33) % 12; }));
       }},
      {"tiles_1536", "more tiles than a block of the scan, one pixel in each",
       [] {
         return to_case(drawn(of_materials({16384, 65}, 3, 2), [](uint32_t x, uint32_t y) {
           return x % 32 == 31 && (y % 32 == 31 || y == 64) ? (x / 32 + y) % 3 : kNothing;
         }));
       }},
      {"planes", "131,072 waves in a row, a group each: more than a dimension of a dispatch holds",
       [] {
         Screen s = of_materials({1024, 1024}, 1, 1);
         s.params.wave_log2 = 3;
         s.params.waves = 1 << 17;
         s.params.reserved = UINT32_MAX;
         s.params.waves_per_group_log2 = 0;
         return to_case(drawn(std::move(s), [](uint32_t, uint32_t) { return 0u; }));
       }},
  };
  for (const Extent e : {Extent{1, 1}, {31, 33}, {32, 32}, {33, 31}, {255, 257}, {1921, 1081}})
    cases.push_back({"size_" + std::to_string(e.width) + "x" + std::to_string(e.height),
                     "a size at or beside a boundary", [e] { return typical(e); }});
  cases.push_back({"size_3840x2160", "the frame's largest", [] { return typical({3840, 2160}); }, true});
  return cases;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = materials();
  for (auto& more : {hostile(), capacities(), waves(), sizes()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Mutant> mutants() {
  return {
      {"sums.glsl", 1, "sums wrap: a list over 2^32 looks empty", "sum_past_2_32"},
      {"pixels.glsl", 2, "a triangle of all ones is taken for nothing", "all_ones_surface"},
      {"pixels.glsl", 3, "the flags stay in the index", "flags"},
      {"pixels.glsl", 4, "the last surface is out of range", "last_surface"},
      {"slots.glsl", 5, "an unregistered material is taken for the last", "unregistered_material"},
      {"slot_of.glsl", 6, "a slot of another surface will do", "hash_collisions"},
      {"match_runs.glsl", 8, "the atomic of a surface's count is lost", "one_material"},
      {"match_lanes.glsl", 7, "the lanes of a surface share one place", "one_material"},
      {"groups.glsl", 9, "a surface's place counts its own pixels", "two_surfaces"},
      {"groups.glsl", 10, "several surfaces pass for one", "two_surfaces"},
      {"groups.glsl", 11, "the barrier before the keys is dropped", "high_lanes"},
      {"groups.glsl", 12, "waves are rounded down", "wave_boundaries"},
      {"scan.comp", 13, "the barrier of the scan is dropped", "tiles_1536"},
      {"scan.glsl", 44, "each block of the scan begins at nothing", "tiles_1536"},
      {"scan.glsl", 14, "divergent waves do not count", "two_surfaces"},
      {"room.glsl", 15, "groups of small commands are rounded down", "odd_commands"},
      {"room.glsl", 16, "a tile's own padding is not looked at", "half_padded"},
      {"room.glsl", 17, "the last wave of an overflow is not filled up", "unpadded_shaders"},
      {"groups.glsl", 18, "divergent groups stand over the uniform ones", "uniform_after_divergent"},
      {"place.glsl", 19, "the pixels of padded tiles leave a hole in the overflow", "half_padded"},
      {"list_waves.glsl", 20, "a group that goes on from the word before begins a wave", "bands"},
      {"scatter.glsl", 21, "the last wave of a group is not filled up", "wave_boundaries"},
      {"commands.glsl", 22, "every command takes its row's first place", "one_material"},
      {"commands.glsl", 23, "the commands of a tile start where the first did", "all_digits"},
      {"place.glsl", 24, "a tile is written where its first pixel finds room", "pixels_lost"},
      {"list_stable.glsl", 26, "a run looks at those of its thread alone", "one_material"},
      {"commands_stable.comp", 27, "the barrier before the sum is dropped", "tiles_1536"},
      {"global_pixels.glsl", 28, "a slot in global memory is taken without an atomic", "hash_collisions"},
      {"global_count.glsl", 29, "the atomic of a pixel is lost", "one_material"},
      {"groups.glsl", 33, "the barrier before the places is dropped", "sixty_uniform_after_divergent"},
      {"list_runs.glsl", 34, "the pixels of a run share one place", "one_material"},
      {"sort_surfaces.glsl", 36, "the barrier before the sorted words is dropped", "hash_collisions"},
      {"sort_surfaces.glsl", 37, "the sort merges no halves", "shaders_64"},
      {"scatter.glsl", 38, "the barrier before the entries is dropped", "twenty_surfaces"},
      {"scatter.glsl", 39, "every wave begins a group", "one_material"},
      {"scatter.glsl", 40, "the waves of lower shaders leave a hole", "bands"},
      {"scatter.glsl", 41, "the pixels of lower shaders leave a hole", "unpadded_shaders"},
      {"count_chained.glsl", 35, "a chained sum leaves out what is before", "one_material"},
      {"tile_dispatch.glsl", 32, "the overflow's waves are dispatched by tile too", "half_padded"},
      {"sort_scatter.glsl", 30, "the barrier after the scan of a block is dropped", "twenty_surfaces"},
      {"sort_scan.comp", 31, "a block's own pairs are before it", "twenty_surfaces"},
      {"digits.glsl", 42, "only every 32nd thread's commands count", "tiles_1536"},
      {"rows.comp", 43, "rows beyond the group's threads are left out", "shaders_64"},
      {"digits.glsl", 25, "what is beyond the last bucket is one command", "small_waves"},
  };
}

}  // namespace assay::pixel_commands
