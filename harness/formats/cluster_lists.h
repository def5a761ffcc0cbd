// What touches each cell of a grid, as lists: of each cell where its entries begin and how many of each kind it has;
// the i-th entry of a cell names its i-th light, decal and probe at once, so a cell has as many entries as its longest
// kind. Cells are numbered (slice * rows + row) * columns + column, and a cell's items ascend within their kind.
//
// cells      buffer of uvec2, a cell: x: its first entry; y: lights | decals << 12 | probes << 24, the counts
// entries    buffer of uint: light | decal << 12 | probe << 24, each a number within its kind; 0 where the cell has no
//            i-th item of a kind
#ifndef HARNESS_FORMATS_CLUSTER_LISTS_H
#define HARNESS_FORMATS_CLUSTER_LISTS_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

SHARED_CONST uint kMaxClusterEntries =
    256u;  // of a cell; of more items of a kind the lowest stay. Of probes 255 (8 bits)

// Of a cell's counts and of an entry alike.
SHARED_CONST uint kClusterItemBits = 12u;  // lights from bit 0, decals from bit 12
SHARED_CONST uint kClusterItemMask = 0xfffu;
SHARED_CONST uint kClusterDecalShift = 12u;
SHARED_CONST uint kClusterProbeShift = 24u;

SHARED_END
#endif
