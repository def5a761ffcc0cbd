#include "kernels/cluster_lists/inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace assay::cluster_lists {

namespace {

constexpr uint32_t kMostEntries = 1u << 20;  // of a case

// Bits of each kind, word after word, of each all cells.
struct Grid {
  uint32_t lights = 0, decals = 0, probes = 0, cells = 0;
  uint32_t capacity = 1u << 20;
  std::vector<uint32_t> bits[3] = {};

  explicit Grid(uint32_t l, uint32_t d, uint32_t p, uint32_t n) : lights(l), decals(d), probes(p), cells(n) {
    for (uint32_t kind = 0; kind < 3; ++kind) bits[kind].resize(size_t{words(kind)} * cells);
  }
  uint32_t items(uint32_t kind) const { return kind == 0 ? lights : kind == 1 ? decals : probes; }
  uint32_t words(uint32_t kind) const { return ceil_div(items(kind), 32); }
  void set(uint32_t kind, uint32_t cell, uint32_t item) {
    bits[kind][size_t{item / 32} * cells + cell] |= 1u << item % 32;
  }
  void set_first(uint32_t kind, uint32_t cell, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) set(kind, cell, i);
  }
  Case to_case(const std::string& name = "") const {
    Case c = {.name = name, .extent = {cells, 1}};
    c.set_params(ListParams{lights, decals, probes, cells, capacity});
    c.set_input("light_bits", bits[0]), c.set_input("decal_bits", bits[1]), c.set_input("probe_bits", bits[2]);
    return c;
  }
};

// Each bit with the chance of 2^-halvings.
void sprinkle(Grid& g, Pcg32& rng, uint32_t halvings) {
  for (auto& words : g.bits)
    for (uint32_t& word : words) {
      word = rng.next();
      for (uint32_t i = 1; i < halvings && word; ++i) word &= rng.next();
    }
}

// Neighbouring cells meet the same items, or nothing.
void cluster(Grid& g, Pcg32& rng) {
  for (uint32_t first = 0; first < g.cells;) {
    const uint32_t last = std::min(g.cells, first + 1 + rng.below(64));
    for (uint32_t kind = 0; kind < 3; ++kind)
      for (uint32_t n = rng.below(3) ? 0 : rng.below(20); n > 0 && g.items(kind) > 0; --n) {
        const uint32_t item = rng.below(g.items(kind));
        for (uint32_t cell = first; cell < last; ++cell) g.set(kind, cell, item);
      }
    first = last;
  }
}

uint32_t random_items(Random& r, uint32_t most) {
  const uint32_t shift = r.rng.below(13);
  return std::min(most, r.rng.below(2) ? r.rng.below((1u << shift) + 1) : 32 * r.rng.below((1u << shift) / 32 + 1));
}

Case random_case(Random& r) {
  const uint32_t most_cells[] = {40, 3000, 20000, 130000};
  const size_t size = r.branch({{"cells_few", 0.3}, {"cells_usual", 0.5}, {"cells_fine", 0.14}, {"cells_many", 0.06}});
  const uint32_t cells = most_cells[size] - r.rng.below(most_cells[size] / 4 + 1);
  // Bits of a case: 2^24 at most.
  const uint32_t most = size == 3 ? 128 : size == 2 ? 1024 : 4096;
  Grid g(random_items(r, most), random_items(r, most), random_items(r, std::min(most, 256u)), cells);
  switch (r.branch({{"nothing", 0.03}, {"sparse", 0.25}, {"even", 0.25}, {"dense", 0.12}, {"clustered", 0.35}})) {
    case 0:
      break;
    case 1:
      sprinkle(g, r.rng, 8);
      break;
    case 2:
      sprinkle(g, r.rng, 3 + r.rng.below(4));
      break;
    case 3:
      sprinkle(g, r.rng, 1 + r.rng.below(2));
      break;
    default:
      cluster(g, r.rng);
  }
  switch (r.branch({{"room_for_most", 0.75}, {"room_for_some", 0.2}, {"no_room", 0.05}})) {
    case 0:
      g.capacity = std::min(cells * kMaxClusterEntries, kMostEntries);
      break;
    case 1:
      g.capacity = r.rng.below(cells * 4 + 1);
      break;
    default:
      g.capacity = 0;
  }
  return g.to_case("random");
}

// The first half of the cells, and the second; without a kind.
std::vector<Case> smaller(const Case& c) {
  std::vector<Case> found;
  const auto p = c.params<ListParams>();
  const char* ports[] = {"light_bits", "decal_bits", "probe_bits"};
  const auto part = [&](uint32_t first, uint32_t count) {
    Grid g(p.lights, p.decals, p.probes, count);
    g.capacity = p.capacity;
    for (uint32_t kind = 0; kind < 3; ++kind) {
      const auto all = c.input<uint32_t>(ports[kind]);
      for (uint32_t w = 0; w < g.words(kind); ++w)
        for (uint32_t i = 0; i < count; ++i) g.bits[kind][size_t{w} * count + i] = all[size_t{w} * p.cells + first + i];
    }
    found.push_back(g.to_case(c.name));
  };
  if (p.cells > 1) part(0, p.cells / 2), part(p.cells / 2, p.cells - p.cells / 2);
  for (uint32_t kind = 0; kind < 3; ++kind) {
    ListParams q = p;
    (kind == 0 ? q.lights : kind == 1 ? q.decals : q.probes) = 0;
    if (c.input<uint32_t>(ports[kind]).empty()) continue;
    found.push_back(c);
    found.back().set_params(q), found.back().set_input(ports[kind], std::vector<uint32_t>());
  }
  return found;
}

HardCase sized(const std::string& name, const std::string& why, uint32_t cells) {
  return {name, why, [=] {
            Grid g(70, 40, 33, cells);
            Pcg32 rng(cells);
            sprinkle(g, rng, 4);
            return g.to_case();
          }};
}

// That all cells ask for.
uint32_t entries_of(const Grid& g) {
  uint32_t entries = 0;
  for (uint32_t cell = 0; cell < g.cells; ++cell) {
    uint32_t longest = 0;
    for (uint32_t kind = 0; kind < 3; ++kind) {
      uint32_t items = 0;
      for (uint32_t w = 0; w < g.words(kind); ++w)
        items += static_cast<uint32_t>(std::popcount(g.bits[kind][size_t{w} * g.cells + cell]));
      longest = std::max(longest, items);
    }
    entries += longest;
  }
  return entries;
}

Grid many(uint32_t n, bool fine) {
  Grid g(n, n, n / 16, fine ? 120 * 68 * 24 : 16 * 8 * 24);
  Pcg32 rng(0x1157);
  for (uint32_t cell = 0; cell < g.cells; ++cell)
    for (uint32_t kind = 0; kind < 3; ++kind)
      for (uint32_t i = 0, first = cell / 16 * 8 % n; i < 64; ++i)
        if (rng.below(8) == 0) g.set(kind, cell, (first + i) % g.items(kind));
  g.capacity = entries_of(g);
  return g;
}

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> cases = {
      sized("one_cell", "one thread of one group is alive", 1),
      sized("one_block", "exactly one block of the sum", kBlock),
      sized("one_block_less_one", "the last thread of the block has no cell", kBlock - 1),
      sized("one_block_and_one", "a block of a single cell, after all of another", kBlock + 1),
      sized("many_blocks", "more blocks than the threads that add them up", kBlock * 256 + 257),
      {"no_items", "no kind has an item: lists are empty, offsets 0", [] { return Grid(0, 0, 0, 100).to_case(); }},
      {"no_cells", "nothing to write", [] { return Grid(5, 5, 5, 0).to_case(); }},
      {"one_kind_each", "cells with lights alone, decals alone, probes alone: an entry's other fields are 0",
       [] {
         Grid g(64, 64, 64, 30);
         for (uint32_t cell = 0; cell < 30; ++cell) g.set_first(cell % 3, cell, 1 + cell);
         return g.to_case();
       }},
      {"full_cell", "256 lights and decals and 255 probes: all that an entry has room for",
       [] {
         Grid g(4096, 4096, 256, 3);
         g.set_first(0, 1, 256), g.set_first(1, 1, 256), g.set_first(2, 1, 255);
         g.set(0, 2, 4095), g.set(1, 2, 4095), g.set(2, 2, 255);
         return g.to_case();
       }},
      {"one_too_many", "257 lights, 300 decals, 256 probes: the lowest are kept, the others counted",
       [] {
         Grid g(4096, 4096, 256, 3);
         for (uint32_t i = 0; i < 257; ++i) g.set(0, 1, 15 * i + 1);
         for (uint32_t i = 0; i < 300; ++i) g.set(1, 1, 4095 - 13 * i);
         g.set_first(2, 1, 256);
         return g.to_case();
       }},
      {"all_in_one_cell", "4096 lights and decals, 256 probes in the middle of three cells",
       [] {
         Grid g(4096, 4096, 256, 3);
         g.set_first(0, 1, 4096), g.set_first(1, 1, 4096), g.set_first(2, 1, 256), g.set(0, 2, 7);
         return g.to_case();
       }},
      {"words_apart", "one item in each word, so that every round of words has some",
       [] {
         Grid g(4096, 4096, 256, 17);
         for (uint32_t cell = 0; cell < 17; ++cell)
           for (uint32_t i = cell; i < 4096; i += 32) {
             g.set(0, cell, i), g.set(1, cell, 4095 - i);
             if (i < 256) g.set(2, cell, i);
           }
         return g.to_case();
       }},
      {"bits_past_the_last", "bits of items that there are not are set",
       [] {
         Grid g(33, 5, 31, 50);
         for (auto& words : g.bits) std::ranges::fill(words, ~0u);
         return g.to_case();
       }},
      {"counts_past_the_most", "more of each kind than there may be: those beyond are not looked at",
       [] {
         Grid g(4096, 4096, 256, 9);
         Pcg32 rng(9);
         sprinkle(g, rng, 6);
         g.lights = 5000, g.decals = ~0u, g.probes = 257;
         return g.to_case();
       }},
      {"no_room", "a list of no entries: everything is counted as dropped",
       [] {
         Grid g(64, 64, 64, 300);
         Pcg32 rng(3);
         sprinkle(g, rng, 2), g.capacity = 0;
         return g.to_case();
       }},
      {"room_ends_within_a_cell", "the last list is cut at its lowest items, those after it are empty",
       [] {
         Grid g(64, 64, 64, 600);
         Pcg32 rng(4);
         sprinkle(g, rng, 2), g.capacity = 5005;
         return g.to_case();
       }},
  };
  // How time grows with items: as many lights as decals, a sixteenth as many probes.
  for (uint32_t n = kMaxClusterLights; n >= 256; n /= 2)
    for (const bool fine : {false, true})
      cases.push_back({fmt::format("{}_{}", fine ? "fine" : "coarse", n),
                       fmt::format("{0}, {0} and {1} items in {2}x24 cells", n, n / 16, fine ? "120x68" : "16x8"),
                       [=] { return many(n, fine).to_case(); }, fine || n < kMaxClusterLights});
  return cases;
}

}  // namespace

Case typical(Extent e) {
  Case c = many(e.width >= 1920 ? 4096 : 256, e.width >= 3840).to_case("typical");
  c.extent = e;
  return c;
}

Inputs inputs() {
  return {.random = random_case,
          .branches = {"cells_few", "cells_usual", "cells_fine", "cells_many", "nothing", "sparse", "even", "dense",
                       "clustered", "room_for_most", "room_for_some", "no_room"},
          .hard = hard_cases(),
          .smaller = smaller};
}

std::vector<Mutant> mutants() {
  return {{"common.glsl", 1, "256 probes, whose count of 8 bits is then 0", "one_too_many"},
          {"common.glsl", 2, "the last word's other bits are items", "bits_past_the_last"},
          {"counted.glsl", 3, "what is dropped is not told", "one_too_many"},
          {"count_team.comp", 4, "the atomic is lost", "words_apart"},
          {"sum.comp", 5, "a block's first cell is left out", "one_block_and_one"},
          {"harness/glsl/scan.glsl", 9821, "the barrier between steps dropped", "many_blocks"},
          {"place.comp", 7, "a block's own entries count as earlier ones", "one_block_and_one"},
          {"place.comp", 8, "offsets inclusive", "one_cell"},
          {"write_thread.comp", 9, "from the highest", "one_cell"},
          {"write_team.comp", 10, "the last kind alone is left", "full_cell"},
          {"write_team.comp", 11, "each round of words begins at the front again", "words_apart"}};
}

}  // namespace assay::cluster_lists
