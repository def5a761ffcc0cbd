// What the files of hard cases share.
#pragma once
#include "kernels/visibility/inputs.h"

namespace assay::visibility {

// Framebuffer coordinates at w = 1: what lies on the sub-pixel grid stays there, unrounded.
glm::dmat4 flat_rows();
vec3 flat_at(Extent, double x, double y);
Case flat_case(Extent, const std::vector<glm::dvec2>& pixels, const std::vector<uint32_t>& indices, const Look& = {});
// Separate triangles in front of the camera.
Case space_case(Extent, const std::vector<vec3>& positions, const Look& = {});
Look masked_look(float factor, float cutoff, uint32_t texture = kNoTexture);
Look both_sides();
Mesh quad_mesh(float size);  // [-size, size]^2, facing +z

std::vector<HardCase> masked_cases();
std::vector<HardCase> hostile_cases();

}  // namespace assay::visibility
