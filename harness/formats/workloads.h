// Tile workloads (Lazarek, Hammer 2025, deferred dispatches with tile classification): which shader permutation runs
// over which 32x32 tiles, and what the classification counted. Masks and requirements are bits of formats/features.h.
#ifndef FORMATS_WORKLOADS_H
#define FORMATS_WORKLOADS_H
#include "harness/formats/features.h"
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

SHARED_CONST uint kMaxWorkloads = 32u;  // rows of the table over all passes; later rows are ignored
SHARED_CONST uint kMaxPasses = 8u;
SHARED_CONST uint kMaxGroups = 65535u;  // groups a dimension that every Vulkan device dispatches
SHARED_CONST uint kEveryFeature = 0xffffffffu;

// A row of the table. Of a pass's rows the first that has all of `required` and none of `excluded` in a tile's mask
// takes the tile; the last row takes the tiles that no row matched, whatever its bits.
struct Workload {
  uint pass;
  uint required;
  uint excluded;
  uint permutation;  // of the pass's shader; classification does not read it
};

struct WorkloadCount {
  uint tiles;   // length of the workload's list
  uint groups;  // tiles * groups a tile, saturated
};

// Workgroups of a pass, saturated: over the whole screen, over the tiles that want the pass, and the difference.
struct PassStatistics {
  uint theoretical;
  uint dispatched;
  uint discarded;
};

#ifdef __cplusplus
SHARED_LAYOUT(Workload, pass, required, excluded, permutation);
SHARED_LAYOUT(WorkloadCount, tiles, groups);
SHARED_LAYOUT(PassStatistics, theoretical, dispatched, discarded);

// The frame's table, named and coloured as Lazarek and Hammer print it. A pass runs over the tiles with a bit of
// `relevant`.
struct FramePass {
  const char* name;
  uint relevant;
};
inline constexpr FramePass kFramePasses[] = {
    {"deferred gbuffer update", kFeatureDecals | kFeatureWetnessDrops | kFeaturePuddles | kFeatureCaustics},
    {"deferred lighting", kFeatureOpaque},
};
struct FrameWorkload {
  const char* name;
  const char* colour;
  Workload row;
};
inline constexpr uint kFeatureWet = kFeatureWetnessDrops | kFeaturePuddles | kFeatureCaustics;
inline constexpr uint kFeatureCostlyLighting =
    kFeatureCloth | kFeatureSkin | kFeatureSubsurface | kFeatureReflective | kFeatureEmissive;
inline constexpr FrameWorkload kFrameWorkloads[] = {
    {"DEFERRED_GBUFFERUPDATE_FEATURESUBSET0", "GREEN", {0, kFeatureDecals, kFeatureWet, 1}},  // decals on dry ground
    {"DEFERRED_GBUFFERUPDATE_FEATURESUBSET1", "BLUE", {0, 0, kFeatureDecals, 2}},             // wetness alone
    {"DEFERRED_GBUFFERUPDATE_DEFAULT", "RED", {0, 0, 0, 0}},
    {"DEFERRED_LIGHTINGONLY_FEATURESUBSET0",
     "GREEN",
     {1, 0, kFeatureCostlyLighting | kFeatureMasked | kFeatureDoubleSided, 1}},           // plain opaque
    {"DEFERRED_LIGHTINGONLY_FEATURESUBSET1", "BLUE", {1, 0, kFeatureCostlyLighting, 2}},  // foliage and cards too
    {"DEFERRED_LIGHTINGONLY_DEFAULT", "RED", {1, 0, 0, 0}},
};
#endif
SHARED_END
#endif
