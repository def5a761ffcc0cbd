// What the edge classification must produce.
#pragma once
#include "harness/kernel.h"
#include "kernels/edge_classification/layout.h"

namespace assay::edge_classification {

uint32_t live_samples(const Case&);  // a pixel
uint64_t samples(const Case&);       // materials
uint64_t gradients(const Case&);     // none where materials alone count
uint64_t tiles(const Case&);

// Exact masks, counts and arguments; the two lists as sets.
Answer classify(const Case&);

}  // namespace assay::edge_classification
