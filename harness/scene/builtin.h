// What the scenes made by code are made with: images painted by functions, patches of quads, instances.
#pragma once
#include <functional>
#include <string>

#include "harness/scene/scene.h"

namespace assay::scene::builtin {

constexpr double kTau = 6.283185307179586;

// A texel's position in 0..1 to its colour, as stored.
using Paint = std::function<glm::vec4(float u, float v)>;
uint32_t add_image(Scene&, const std::string& name, uint32_t side, const Paint&);
uint32_t add_material(Scene&, Material);

// A patch of columns x rows quads over u and v in 0..1, counter-clockwise seen from where u runs right and v up.
using Patch = std::function<glm::dvec3(double u, double v)>;
void append_patch(Mesh&, uint32_t columns, uint32_t rows, const glm::vec2& repeats, const Patch&);
// The mesh's indices after its last part's become a part of this material.
void end_part(Mesh&, uint32_t material);
uint32_t add_mesh(Scene&, Mesh, uint32_t material);  // with a last part
uint32_t add_patch_mesh(Scene&, const std::string& name, uint32_t material, uint32_t columns, uint32_t rows,
                        const glm::vec2& repeats, const Patch&);
void place(Scene&, uint32_t mesh, const glm::dvec3& at, double turn_rad = 0, const glm::dvec3& scale = glm::dvec3(1));
// Of all instances of meshes of the name.
void set_motion(Scene&, const std::string& mesh, const Motion&);

// ---- Shapes that several scenes have
glm::dvec3 sphere(double u, double v);  // radius 1, short of the poles, where u has no direction
// Seven pointed leaves on a stem; alpha falls linearly across a leaf's outline, so the cut is a line between texels.
glm::vec4 leaves(float u, float v);
glm::vec4 grille(float u, float v);  // bars around square holes

}  // namespace assay::scene::builtin
