#include "harness/kernel.h"

#include "kernels/command_visit/inputs.h"
#include "kernels/command_visit/oracle.h"

namespace assay::command_visit {

namespace {

uint64_t waves(const Case& c) { return c.params<VisitParams>().waves; }
uint64_t entries(const Case& c) { return waves(c) * kWaveSize; }
uint64_t rows(const Case&) { return uint64_t{kVisitors} * kCommandRows; }

// A dispatch a row of the slot, none where the slot has no shader.
Dispatch over_slot(const std::string& shader, uint slot) {
  return {.shader = shader,
          .indirect = "args",
          .first_args = fixed(uint64_t{slot} * kCommandRows),
          .repeat = [slot](const Case& c) { return slot < visible(c) ? kCommandRows : 0; }};
}

Cost cost(const Case& c) {
  return {.bytes_read = entries(c) * sizeof(uint) + (waves(c) + pixels(c)) * sizeof(uint) +
                        rows(c) * (sizeof(CommandRow) + sizeof(DispatchArgs)),
          .bytes_written = pixels(c) * 2 * sizeof(uint),
          .operations = pixels(c) * 2};  // an addition and a store's packing
}

}  // namespace

Kernel describe() {
  return {
      .name = "command_visit",
      .source =
          "Lazarek, Hammer 2025, Material Compute Dispatch: dispatching waves, uniform and divergent permutations",
      .default_variant = "lists",
      .params = layout_of<VisitParams>(),
      .ports = {reads<uint>("entries", entries, {"pixel_commands.entries"}),
                reads<uint>("commands", waves, {"pixel_commands.commands"}),
                reads<CommandRow>("command_rows", rows, {"pixel_commands.command_rows"}),
                reads<DispatchArgs>("args", rows, {"pixel_commands.args"}), reads<uint>("surfaces", pixels),
                writes<uint>("visits", pixels), writes<uint>("visitors", pixels)},
      .variants = {{.name = "lists",
                    .passes = {Clear{"visits"}, Clear{"visitors"}, over_slot("first.comp", 0),
                               over_slot("second.comp", 1)},
                    .needs = {Feature::subgroup_ballot},
                    .note = "an indirect dispatch a row; uniform and divergent waves listed apart"},
                   {.name = "early_out",
                    .passes = {Clear{"visits"}, Clear{"visitors"}, over_slot("first_uniform.comp", 0),
                               over_slot("first_divergent.comp", 0), over_slot("second_uniform.comp", 1),
                               over_slot("second_divergent.comp", 1)},
                    .needs = {Feature::subgroup_ballot},
                    .note = "every row twice: a permutation for uniform subgroups, one for the others"}},
      .oracle = visit,
      .inputs = inputs(),
      .bounds = {exact("visits", "integers only"), exact("visitors", "integers only, the largest visitor")},
      .mutants = {{"early_out.glsl", 1, "one lane speaks for its subgroup", "second_shader"},
                  {"early_out.glsl", 2, "the divergent permutation runs every subgroup", "commands_of_one"},
                  {"visit.glsl", 3, "one pixel's surface for the wave, whatever the list", "second_shader"},
                  {"visit.glsl", 4, "the last row is left out", "second_shader"},
                  {"visit.glsl", 5, "every visit is the first slot's", "second_shader"},
                  {"visit.glsl", 6, "copy bits are dropped", "second_shader"},
                  {"pixel_commands.glsl", 9201, "one command too many", "one_command"},
                  {"pixel_commands.glsl", 9202, "every wave of a command is its first", "commands_of_32"},
                  {"pixel_commands.glsl", 9203, "the overflow taken for commands", "overflow"},
                  {"pixel_commands.glsl", 9204, "padding is shaded", "mostly_padding"},
                  {"pixel_commands.glsl", 9205, "the row of another slot", "second_shader"}},
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
  };
}

}  // namespace assay::command_visit
