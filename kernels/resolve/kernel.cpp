#include "kernels/resolve/inputs.h"
#include "kernels/resolve/layout.h"
#include "kernels/resolve/oracle.h"

namespace assay::resolve {
namespace {

bool is_metered(const Case& c) { return c.params<ResolveParams>().metering != kMeterManual; }

// With manual exposure nothing is summed.
Groups groups_of(const Case& c, uint32_t side) {
  const Extent blocks = tiles_of(c.extent, side);
  return is_metered(c) ? Groups{blocks.width, blocks.height, 1} : Groups{0, 1, 1};
}
Groups per_block(const Case& c) { return groups_of(c, kBlockPixels); }
Groups per_small_block(const Case& c) { return groups_of(c, kSmallBlock); }
Groups one_group(const Case&) { return {1, 1, 1}; }
Groups per_pixel(const Case& c) { return {ceil_div(c.extent.width, 16), ceil_div(c.extent.height, 16), 1}; }

std::vector<Pass> passes(Dispatch sum, const char* finish, const char* tone) {
  return {std::move(sum), Dispatch{finish, one_group}, Dispatch{tone, per_pixel}};
}

// Each byte once, though a metered picture has to be read again: its exposure is not known before.
Cost cost(const Case& c) {
  const uint64_t sums = is_metered(c) ? tile_count(c.extent, kBlockPixels) * sizeof(PartialSum) : 0;
  return {.bytes_read = pixels(c) * 8 + uint64_t{kCodes} * 4,
          .bytes_written = pixels(c) * 4 + sums + sizeof(ExposureRecord),
          .operations = pixels(c) * (is_metered(c) ? 40 : 30)};
}

std::vector<Mutant> mutants() {
  return {{"metering.glsl", 1, "the last column does not count", "odd_extent"},
          {"metering.glsl", 2, "the background counts", "background"},
          {"metering.glsl", 3, "what is no number counts", "no_numbers"},
          {"metering.glsl", 4, "the logarithm of 0", "all_black_logarithm"},
          {"tree.glsl", 5, "the tree's last step left out", "constant_tenth"},
          {"sum_subgroup.comp", 6, "the last exchange between lanes left out", "constant_tenth"},
          {"sum_subgroup.comp", 7, "the barrier after the subgroups' sums dropped", "constant_tenth"},
          {"exposure.glsl", 8, "no end to a black picture's exposure", "all_black"},
          {"exposure.glsl", 9, "manual exposure is not compensated", "manual"},
          {"finish.comp", 10, "blocks past the 256th are left out", "many_blocks"},
          {"tone.comp", 11, "> for >= at a threshold", "at_the_thresholds"},
          {"tone.comp", 12, "neighbouring thresholds swapped", "every_half"},
          {"tone.comp", 13, "red and blue swapped", "channels_apart"},
          {"harness/glsl/tone_curve.glsl", 9701, "a bucket's first code for all of it", "every_half"},
          {"harness/glsl/tone_curve.glsl", 9702, "what is past the last bucket is black", "blinding_manual"}};
}

}  // namespace

Kernel describe() {
  Port small = writes<PartialSum>("small_partials", [](const Case& c) { return tile_count(c.extent, kSmallBlock); });
  small.only_in = {"sequential_groups"};
  Port partials = writes<PartialSum>("partials", [](const Case& c) { return tile_count(c.extent, kBlockPixels); });
  partials.only_in = {"two_level", "subgroup_tree", "bucketed_curve", "computed_curve"};
  Port thresholds = reads<float>("thresholds", fixed(kCodes));
  thresholds.only_in = {"two_level", "subgroup_tree", "bucketed_curve", "sequential_groups"};
  Port first_codes = reads<uint>("first_codes", fixed(kBuckets));
  first_codes.only_in = {"bucketed_curve"};
  Bound image = between({"image"}, "exact codes at either end of the exposure's interval");
  image.unpack = Unpack{codes_layout(), unpack_codes};
  return {
      .name = "resolve",
      .source = "Reinhard et al. 2002, exposure; Narkowicz 2015, tone curve; IEC 61966-2-1",
      .default_variant = "two_level",
      .params = layout_of<ResolveParams>(),
      .ports = {reads_image("radiance", Format::rgba16_float,
                            {"particles.radiance", "vrcs_deblock.deblocked_radiance", "vrcs_deblock.radiance_in_place",
                             "deferred_lighting.radiance"}),
                thresholds, first_codes, partials, small, writes<ExposureRecord>("exposure", fixed(1)),
                writes<uint>("image", pixels)},
      .variants = {{.name = "two_level",
                    .passes = passes({"sum_shared.comp", per_block}, "finish.comp", "tone.comp"),
                    .note = "8x8 pixels a thread, trees in and over groups; the curve is a table"},
                   {.name = "subgroup_tree",
                    .passes = passes({"sum_subgroup.comp", per_block}, "finish.comp", "tone.comp"),
                    .needs = {Feature::subgroup_shuffle},
                    .subgroup_min = 4,
                    .note = "the same tree, its lower levels by exchanging lanes: the same bits"},
                   {.name = "bucketed_curve",
                    .passes = passes({"sum_shared.comp", per_block}, "finish.comp", "tone_bucketed.comp"),
                    .note = "a table of buckets says where in the thresholds to begin"},
                   {.name = "sequential_groups",
                    .passes = passes({"sum_small.comp", per_small_block}, "finish_sequential.comp", "tone.comp"),
                    .baseline = true,
                    .note = "groups of 16x16 pixels added in a chain, as atomics do"},
                   {.name = "computed_curve",
                    .passes = passes({"sum_shared.comp", per_block}, "finish.comp", "tone_computed.comp"),
                    .baseline = true,
                    .note = "the curve and sRGB by powers: codes next to a border may be off by one"}},
      .oracle = expected,
      .inputs = {.random = random_case, .branches = branches(), .hard = hard_cases(), .smaller = smaller},
      .bounds = {between({"exposure"}, "(m + d) u of the terms' magnitudes, then Vulkan's table (README, Bounds)"),
                 image},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{256, 256}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
      .undecided_limit = 5e-3,
      .undecided_reason = "pixels whose code differs between the ends of the exposure's interval (README, Bounds)",
  };
}

}  // namespace assay::resolve
