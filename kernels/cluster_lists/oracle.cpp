#include "kernels/cluster_lists/oracle.h"

#include <algorithm>
#include <array>

#include "harness/oracle.h"

namespace assay::cluster_lists {

namespace {

constexpr std::array<const char*, 3> kPorts = {"light_bits", "decal_bits", "probe_bits"};
constexpr std::array<uint64_t, 3> kShift = {0, 12, 24};
constexpr std::array<uint64_t, 3> kRoom = {256, 256, 255};

struct Bits {
  std::span<const uint32_t> words;
  uint64_t items, cells;
  bool has(uint64_t item, uint64_t cell) const { return words[item / 32 * cells + cell] >> item % 32 & 1; }
};

}  // namespace

Answer lists(const Case& c) {
  const auto p = c.params<ListParams>();
  const uint64_t cells = std::min(p.cells, kMaxCells);
  const std::array<uint64_t, 3> items = {std::min(p.lights, kMaxClusterLights), std::min(p.decals, kMaxClusterDecals),
                                         std::min(p.probes, kMaxClusterProbes)};
  std::vector<uvec2> heads;
  std::vector<uint32_t> entries, blocks((cells + kBlock - 1) / kBlock);
  std::array<uint32_t, 3> dropped = {};
  uint64_t wanted_so_far = 0;
  for (uint64_t cell = 0; cell < cells; ++cell) {
    std::array<std::vector<uint32_t>, 3> found;
    uint64_t wanted = 0;
    for (size_t kind = 0; kind < 3; ++kind) {
      const Bits bits = {c.input<uint32_t>(kPorts[kind]), items[kind], cells};
      for (uint32_t i = 0; i < items[kind]; ++i)
        if (i % 32 == 0 && bits.words[i / 32 * cells + cell] == 0)
          i += 31;
        else if (bits.has(i, cell))
          found[kind].push_back(i);
      wanted = std::max(wanted, std::min<uint64_t>(found[kind].size(), kRoom[kind]));
    }
    const uint64_t begin = std::min<uint64_t>(wanted_so_far, p.capacity);
    uint32_t counts = 0;
    for (size_t kind = 0; kind < 3; ++kind) {
      const uint64_t kept = std::min({static_cast<uint64_t>(found[kind].size()), kRoom[kind], p.capacity - begin});
      dropped[kind] += static_cast<uint32_t>(found[kind].size() - kept);
      counts |= static_cast<uint32_t>(kept << kShift[kind]);
      entries.resize(std::max<size_t>(entries.size(), begin + kept), 0);
      for (size_t i = 0; i < kept; ++i) entries[begin + i] |= found[kind][i] << kShift[kind];
    }
    heads.emplace_back(static_cast<uint32_t>(begin), counts);
    blocks[cell / kBlock] += static_cast<uint32_t>(wanted);
    wanted_so_far += wanted;
  }
  Expected listed = expect_all(entries);
  listed.live = std::vector<Expected::Run>{{0, entries.size()}};
  const std::vector<ClusterListStatus> status = {
      {static_cast<uint32_t>(wanted_so_far), dropped[0], dropped[1], dropped[2]}};
  return {{"cells", expect_all(heads)},
          {"entries", std::move(listed)},
          {"block_entries", expect_all(blocks)},
          {"list_status", expect_all(status)}};
}

}  // namespace assay::cluster_lists
