// Cases for the edge classification.
#pragma once
#include "harness/kernel.h"
#include "harness/oracle.h"
#include "kernels/edge_classification/layout.h"

namespace assay::edge_classification {

// Four samples a pixel at Vulkan's standard places; surfaces that end between pixels.
Case typical(Extent);
Inputs inputs();
std::vector<Mutant> mutants();

// For hard.cpp. One material and one gradient everywhere; the parameters' extent is that of the case.
struct Samples {
  EdgeParams params;
  std::vector<uint> materials, gradients;

  explicit Samples(const EdgeParams&);
  size_t place(uint32_t x, uint32_t y, uint32_t sample = 0) const;
  Case to_case() const;
};
std::vector<HardCase> hard_cases();

}  // namespace assay::edge_classification
