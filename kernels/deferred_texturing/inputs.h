// Cases for deferred texturing.
#pragma once
#include "kernels/deferred_texturing/builder.h"

namespace assay::deferred_texturing {

// 60 materials of all eight classes over 400 sheets, as a frame has them.
Case typical(Extent);
// The parameters alone: a frame has a producer for everything else.
Case frame(const FrameInputs&);
Inputs inputs();
std::vector<HardCase> class_cases();   // what each class does
std::vector<HardCase> sample_cases();  // coordinates, gradients, textures
std::vector<HardCase> list_cases();    // sizes, lists, hostile indices
std::vector<HardCase> mesh_cases();    // what interpolates inline
std::vector<Mutant> mutants();

// Arrays that random and typical cases share: 0 colours (sRGB), 1 surfaces (metallic-roughness and height), 2 normals,
// 3 masks, 4 details. Each layer differs.
std::vector<Texture> shared_textures(uint32_t side, uint32_t layers, double contrast);

}  // namespace assay::deferred_texturing
