#include "kernels/command_visit/inputs.h"

#include <algorithm>
#include <array>

#include "harness/groups.h"
#include "kernels/command_visit/layout.h"

namespace assay::command_visit {

namespace {

// Lists as a producer may leave them: waves, and rows of first waves of commands.
struct Lists {
  Extent extent;
  uint shaders = 1;
  std::vector<uint> entries = {};
  std::vector<uint> surfaces = {};  // a pixel
  std::array<std::vector<uint>, size_t{kVisitors}* kCommandRows> rows = {};
  std::array<CommandRow, kVisitors> overflow = {};
};

uint pixel_entry(uint32_t x, uint32_t y, uint copies) { return x | y << 14 | copies << 28; }

// Appends pixels as waves, `fill` valid entries in each; returns how many waves there are.
uint append_waves(Lists& l, std::span<const uint> pixels, size_t fill) {
  const size_t before = l.entries.size();
  for (size_t i = 0; i < pixels.size(); i += fill) {
    const auto wave = pixels.subspan(i, std::min(fill, pixels.size() - i));
    l.entries.insert(l.entries.end(), wave.begin(), wave.end());
    l.entries.resize(l.entries.size() + kWaveSize - wave.size(), kEntryInvalid);
  }
  return static_cast<uint>((l.entries.size() - before) / kWaveSize);
}

// `waves` waves from `first` on as commands of at most 2^largest waves.
void command(Lists& l, uint slot, uint kind, uint first, uint waves, uint largest) {
  for (uint k = largest + 1; k-- > 0;)
    for (; waves >= 1u << k; waves -= 1u << k, first += 1u << k)
      l.rows[slot * kCommandRows + kind * kCommandBuckets + k].push_back(first);
}

DispatchArgs args_of(uint64_t commands, uint k) {
  const uint x = std::max(1u, (1u << k) / kWavesPerGroup);
  const Groups spread =
      spread_groups((commands * (1u << k) + uint64_t{x} * kWavesPerGroup - 1) / (uint64_t{x} * kWavesPerGroup));
  return {x, spread.x, commands ? spread.y : 0};
}

Case case_of(const Lists& l) {
  std::vector<uint> commands;
  std::vector<CommandRow> rows;
  std::vector<DispatchArgs> args;
  for (uint slot = 0; slot < kVisitors; ++slot) {
    for (uint r = 0; r < kOverflowRow; ++r) {
      const auto& list = l.rows[slot * kCommandRows + r];
      rows.push_back({static_cast<uint>(commands.size()), static_cast<uint>(list.size())});
      args.push_back(args_of(list.size(), r % kCommandBuckets));
      commands.insert(commands.end(), list.begin(), list.end());
    }
    rows.push_back(l.overflow[slot]);
    args.push_back(args_of(l.overflow[slot].count, 0));
  }
  // What lies behind the lists is the first wave, and pixel 0: an invocation that goes there is noticed.
  std::vector<uint> entries = l.entries;
  entries.resize(entries.size() + kWaveSize, 0);
  commands.resize(entries.size() / kWaveSize, 0);
  Case c{.extent = l.extent};
  c.set_params(VisitParams{l.extent.width, l.extent.height, l.shaders, static_cast<uint>(entries.size() / kWaveSize)});
  c.set_input("entries", entries);
  c.set_input("commands", commands);
  c.set_input("command_rows", rows);
  c.set_input("args", args);
  c.set_input("surfaces", l.surfaces);
  return c;
}

std::vector<uint> all_pixels(Extent e, uint copies) {
  std::vector<uint> pixels;
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) pixels.push_back(pixel_entry(x, y, (x + y) & copies));
  return pixels;
}

// All pixels dealt out to slots, kinds and the overflow in turn, some waves full and some with `fill` pixels.
Lists dealt(Extent e, uint shaders, uint32_t share, size_t fill, uint largest, Pcg32& rng) {
  Lists l{e, shaders};
  const auto pixels = all_pixels(e, kCopyBits);
  std::vector<std::array<uint, 4>> runs;  // slot, kind, first, waves
  l.surfaces.resize(pixels.size());
  for (size_t i = 0; i < pixels.size(); i += share) {
    const auto part = std::span(pixels).subspan(i, std::min<size_t>(share, pixels.size() - i));
    const auto first = static_cast<uint>(l.entries.size() / kWaveSize);
    const uint waves = append_waves(l, part, rng.below(2) ? kWaveSize : fill);
    runs.push_back({rng.below(shaders), rng.below(2), first, waves});
    const uint surface = rng.below(16);
    for (size_t p = i; p < i + part.size(); ++p)
      l.surfaces[p] = runs.back()[1] == kUniformLists ? surface : surface + static_cast<uint>(p / 3 % 2);
  }
  for (const auto& [slot, kind, first, waves] : runs)
    if (slot < kVisitors) command(l, slot, kind, first, waves, largest);
  for (auto& row : l.rows)  // in any order
    for (size_t i = row.size(); i > 1; --i) std::swap(row[i - 1], row[rng.below(static_cast<uint32_t>(i))]);
  return l;
}

// The last commands' waves as the overflow of a slot.
void add_overflow(Lists& l, uint slot, std::span<const uint> pixels) {
  const auto first = static_cast<uint>(l.entries.size() / kWaveSize);
  l.overflow[slot] = {first, append_waves(l, pixels, kWaveSize)};
}

Case random_case(Random& r) {
  const Extent e = random_extent(r, kTileSide);
  const uint shaders = r.branch({{"one_shader", 0.4}, {"two_shaders", 0.4}, {"more_shaders", 0.2}}) == 2
                           ? 3 + r.rng.below(4)
                       : r.taken.contains("one_shader") ? 1
                                                        : 2;
  Lists l = dealt(e, shaders, 1 + r.rng.below(3000), 1 + r.rng.below(kWaveSize), r.rng.below(kCommandBuckets), r.rng);
  if (r.branch({{"overflow_none", 0.6}, {"overflow", 0.4}}) == 1) {
    const auto pixels = all_pixels(e, 0);
    add_overflow(l, r.rng.below(kVisitors),
                 std::span(pixels).first(1 + r.rng.below(static_cast<uint32_t>(pixels.size()))));
  }
  Case c = case_of(l);
  switch (r.branch({{"honest", 0.7}, {"too_many_groups", 0.15}, {"off_screen", 0.15}})) {
    case 0:
      break;
    case 1: {
      auto args = std::vector(c.input<DispatchArgs>("args").begin(), c.input<DispatchArgs>("args").end());
      for (DispatchArgs& a : args) a.y += r.rng.below(40), a.z += r.rng.below(2);
      c.set_input("args", args);
      break;
    }
    default: {
      auto entries = std::vector(c.input<uint>("entries").begin(), c.input<uint>("entries").end());
      for (uint& entry : entries)
        if (r.rng.below(4) == 0) entry |= 0x3fffu << kEntryCoordinateBits;  // y = 16383
      c.set_input("entries", entries);
    }
  }
  return c;
}

Case rolled(Extent e, uint shaders, uint32_t share, size_t fill, uint largest) {
  Pcg32 rng(5);
  return case_of(dealt(e, shaders, share, fill, largest, rng));
}

Case overflowing(uint slot) {
  Pcg32 rng(6);
  Lists l = dealt({64, 48}, 2, 500, 20, 5, rng);
  const auto pixels = all_pixels(l.extent, 0);
  add_overflow(l, slot, std::span(pixels).first(1000));
  return case_of(l);
}

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = {
      {"one_command", "a single wave: half of a group has nothing to do",
       [] {
         return rolled({32, 1}, 1, 32, 32, 0);
       }},
      {"commands_of_one", "many commands of one wave share groups",
       [] {
         return rolled({64, 40}, 1, 32, 32, 0);
       }},
      {"commands_of_32", "all waves in the largest commands",
       [] {
         return rolled({128, 64}, 1, 1024, 32, 5);
       }},
      {"all_buckets", "commands of every size",
       [] {
         return rolled({96, 63}, 1, 2016, 32, 5);
       }},
      {"mostly_padding", "one valid entry a wave",
       [] {
         return rolled({40, 40}, 1, 40, 1, 3);
       }},
      {"second_shader", "two slots share out the pixels: their rows are apart",
       [] {
         return rolled({100, 50}, 2, 70, 31, 4);
       }},
      {"other_shaders", "slots that no shader of this kernel has",
       [] {
         return rolled({100, 50}, 6, 70, 31, 4);
       }},
      {"overflow", "waves without commands, of the first slot", [] { return overflowing(0); }},
      {"overflow_second", "and of the second", [] { return overflowing(1); }},
      {"nothing", "no command at all",
       [] {
         Lists l{{40, 40}, 2};
         l.surfaces.resize(1600);
         return case_of(l);
       }},
      {"too_many_groups", "groups far past the ends of all rows, in all dimensions",
       [] {
         Case c = rolled({64, 64}, 2, 100, 32, 5);
         auto args = std::vector(c.input<DispatchArgs>("args").begin(), c.input<DispatchArgs>("args").end());
         for (DispatchArgs& a : args) a = {a.x, a.y + 3, a.z + 2};
         c.set_input("args", args);
         return c;
       }},
  };
  for (const Extent e : {Extent{1, 1}, {31, 33}, {1921, 1081}})
    all.push_back({"size_" + std::to_string(e.width) + "x" + std::to_string(e.height), "a size at or beside a boundary",
                   [e] { return typical(e); }});
  all.push_back({"size_3840x2160", "the frame's largest", [] { return typical({3840, 2160}); }, true});
  return all;
}

}  // namespace

Case typical(Extent e) { return rolled(e, 2, 700, 24, 5); }

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  for (const char* b : {"one_shader", "two_shaders", "more_shaders", "overflow_none", "overflow", "honest",
                        "too_many_groups", "off_screen"})
    branches.push_back(b);
  return {.random = random_case, .branches = branches, .hard = hard_cases()};
}

}  // namespace assay::command_visit
