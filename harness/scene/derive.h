// Normals and tangents that a file lacks.
#pragma once
#include "harness/scene/scene.h"

namespace assay::scene {

// Each triangle's own normal; triangles must not share vertices. Degenerate ones get +y.
void derive_flat_normals(Mesh&, uint32_t first_index, uint32_t index_count);
// Tangents of the marked vertices from the gradient of u over position, summed over each vertex's triangles by area,
// made orthogonal to the normal; any perpendicular where there is no gradient. Not MikkTSpace: a vertex whose
// triangles mirror the texture differently gets the majority's sign instead of being split.
void derive_tangents(Mesh&, const std::vector<bool>& marked);

}  // namespace assay::scene
