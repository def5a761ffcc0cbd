// Lists of the items that touch each cell (formats/clusters.h). A cell is uvec2(first entry, counts); the i-th of its
// entries names its i-th light, decal and probe, each ascending by index.
#ifndef HARNESS_FORMATS_CLUSTER_LISTS_H
#define HARNESS_FORMATS_CLUSTER_LISTS_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

SHARED_CONST uint kMaxClusterEntries = 256u;  // of a cell; of probes one less, for their count has 8 bits

#ifndef __cplusplus
// Lights, decals, probes: 12, 12 and 8 bits, in a cell's counts and in an entry's indices.
uint pack_cluster_counts(uvec3 counts) { return counts.x | counts.y << 12u | counts.z << 24u; }
uvec3 unpack_cluster_counts(uint counts) { return uvec3(counts & 0xfffu, counts >> 12u & 0xfffu, counts >> 24u); }
uint pack_cluster_entry(uvec3 items) { return pack_cluster_counts(items); }
uvec3 unpack_cluster_entry(uint entry) { return unpack_cluster_counts(entry); }
#endif

SHARED_END
#endif
