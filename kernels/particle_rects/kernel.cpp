#include "harness/kernel.h"

#include <algorithm>

#include "harness/formats/workloads.h"
#include "harness/particles.h"
#include "kernels/particle_rects/inputs.h"
#include "kernels/particle_rects/oracle.h"

namespace assay::particle_rects {

namespace {

uint64_t records(const Case& c) { return c.params<RectParams>().particles; }
uint64_t particles(const Case& c) { return particle_count(c); }
uint64_t slots(const Case& c) { return all_particle_slots(c.params<RectParams>().atlas); }
uint64_t blocks(const Case& c) { return most_particle_blocks(c.params<RectParams>().atlas, particle_count(c)); }

// Over particles and slots alike; nothing runs without particles.
Groups per_block(const Case& c) {
  const auto most = static_cast<uint32_t>(std::max(particles(c), slots(c)));
  return particles(c) == 0 ? Groups{0, 1, 1} : Groups{ceil_div(most, kBlock)};
}
uint64_t sums(const Case& c) { return per_block(c).x; }
Groups once(const Case& c) { return {particles(c) == 0 ? 0u : 1u}; }

// What must be moved at least: the blocks' list as long as its room.
Cost cost(const Case& c) {
  const uint64_t updated = (particles(c) + 2 * slots(c)) * sizeof(uint) + sizeof(ParticleRectCounts);
  return {.bytes_read = records(c) * (sizeof(ParticleRecord) + sizeof(uint)),
          .bytes_written = updated + blocks(c) * sizeof(uint) + sizeof(DispatchArgs),
          .operations = particles(c) * 100 + slots(c) * 4};
}
Cost cost_of_scan(const Case& c) {
  Cost all = cost(c);
  all.bytes_written += sums(c) * sizeof(uvec2);
  return all;
}

std::vector<Pass> scan_passes() {
  std::vector<Pass> passes;
  for (const char* shader : {"start.comp", "claim_32.comp", "count_32.comp", "list_32.comp", "place_32.comp",
                             "count_16.comp", "list_16.comp", "place_16.comp", "count_8.comp", "list_8.comp",
                             "place_8.comp", "count_blocks.comp", "list_blocks.comp"})
    passes.emplace_back(Dispatch{shader, per_block});
  return passes;
}

}  // namespace

Kernel describe() {
  Port between_passes = writes<uvec2>("block_sums", sums);
  between_passes.only_in = {"scan"};
  return {
      .name = "particle_rects",
      .source = "Sousa, Geffroy 2016, Decoupled Particle Lighting; Coenen 2020, DOOM Eternal",
      .default_variant = "scan",
      .params = layout_of<RectParams>(),
      .ports = {reads<ParticleRecord>("particles", records, {"scene.particles"}), reads<uint>("previous", records),
                writes<uint>("rects", particles), writes<uint>("owners", slots), writes<uint>("free_slots", slots),
                writes<ParticleRectCounts>("counts", fixed(1)), writes<uint>("blocks", blocks),
                writes<DispatchArgs>("args", fixed(1)), between_passes},
      .variants = {{.name = "scan",
                    .passes = scan_passes(),
                    .cost = cost_of_scan,
                    .note = "a thread a particle and a slot; sums over blocks of 256 between passes"},
                   {.name = "single_group",
                    .passes = {Dispatch{"single_group.comp", once}},
                    .note = "one group, a thread a run of particles: one dispatch"}},
      .oracle = allocation,
      .inputs = inputs(),
      .bounds = {exact("rects", "correctly rounded sums and products, comparisons; ranks in the particles' order"),
                 exact("owners", "the least index of those that claim a slot; else by rank"),
                 exact("blocks", "integers only, in the particles' order"),
                 exact("counts", "integers only; sums in any order"), exact("args", "integers only")},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{1280, 720}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
  };
}

}  // namespace assay::particle_rects
