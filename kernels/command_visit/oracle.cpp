#include "kernels/command_visit/oracle.h"

#include <algorithm>

#include "harness/oracle.h"

namespace assay::command_visit {

uint64_t visible(const Case& c) { return std::min(c.params<VisitParams>().shaders, 2u); }

namespace {

struct Visits {
  const Case& input;
  std::vector<uint> visits, visitors;
};

void visit_wave(Visits& v, uint64_t wave, uint slot, uint row) {
  const auto entries = v.input.input<uint>("entries").subspan(wave * 32, 32);
  for (const uint entry : entries) {
    if (entry >> 31) continue;
    const uint64_t x = entry % 16384, y = entry / 16384 % 16384;
    if (x >= v.input.extent.width || y >= v.input.extent.height) continue;
    const size_t at = y * v.input.extent.width + x;
    v.visits[at] += slot == 0 ? 1 : 256;
    const uint one_surface = row < 6, one_material = row < 12;
    const uint surface = v.input.input<uint>("surfaces")[at] % 16 * (1u << 26);
    const uint promises = one_surface * (1u << 24) + one_material * (1u << 25);
    v.visitors[at] =
        std::max(v.visitors[at], (1u << 31) + surface + promises + slot * 65536 + entry / (1u << 28) % 8 * 256 + row);
  }
}

}  // namespace

Answer visit(const Case& c) {
  const auto rows = c.input<CommandRow>("command_rows");
  const auto args = c.input<DispatchArgs>("args");
  const auto commands = c.input<uint>("commands");
  Visits v = {c, std::vector<uint>(pixels(c)), std::vector<uint>(pixels(c))};
  for (uint slot = 0; slot < visible(c); ++slot)
    for (uint row = 0; row < 13; ++row) {
      const CommandRow list = rows[slot * 13 + row];
      const DispatchArgs a = args[slot * 13 + row];
      const uint64_t size = row == 12 ? 1 : 1u << row % 6;
      const uint64_t dispatched = uint64_t{a.x} * a.y * a.z * kWavesPerGroup;
      for (uint64_t wave = 0; wave < std::min(dispatched, list.count * size); ++wave)
        visit_wave(v, row == 12 ? list.first + wave : commands[list.first + wave / size] + wave % size, slot, row);
    }
  return {{"visits", expect_all(v.visits)}, {"visitors", expect_all(v.visitors)}};
}

}  // namespace assay::command_visit
