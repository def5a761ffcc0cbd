// What no scene should hold: nothing is written past the outputs, nothing hangs, and what comes out is said in
// README.md.
#include <limits>

#include "kernels/attribute_interpolation/inputs.h"

namespace assay::attribute_interpolation {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN(),
                kLargest = std::numeric_limits<float>::max(), kDenormal = 1e-40f;

Case broken_numbers() {
  std::vector<ClipSample> samples;
  const ClipSample good = {vec3(-1, -1, 1), vec3(3, -1, 2), vec3(-1, 3, 2), {1024, 1024}, {2048, 2048}};
  for (const float bad : {kNan, kInfinity, -kInfinity, kLargest, kDenormal, -0.0f})
    for (int i = 0; i < 9; ++i) {
      ClipSample s = good;
      (i < 3 ? s.v0 : i < 6 ? s.v1 : s.v2)[i % 3] = bad;
      samples.push_back(s);
    }
  for (const float all : {kNan, kInfinity, kLargest, kDenormal, 0.0f})
    samples.push_back({vec3(all), vec3(all), vec3(all), {1024, 1024}, {2048, 2048}});
  samples.push_back({good.v0 * kDenormal, good.v1 * kDenormal, good.v2 * kDenormal, {1024, 1024}, {2048, 2048}});
  return clip_case("broken_numbers", samples, 10);
}

SceneBuilder two_triangles() {
  SceneBuilder scene({16, 16});
  scene.add_surface(glm::dmat4(1));
  for (int i = 0; i < 2; ++i) {
    const VertexAttributes v = flat_attributes();
    const float z = -3.0f - static_cast<float>(i);
    scene.add_triangle({vec3(-9, -9, z), vec3(9, -9, z), vec3(-9, 9, z)}, {v, v, v});
  }
  return scene;
}

Case indices_out_of_range() {
  SceneBuilder scene = two_triangles();
  scene.indices[1] = 0xffffffffu, scene.indices[5] = 6;
  const uvec2 words[] = {{0, 0}, {1, 0},           {2, 0},           {0x55555555u, 0}, {0xfffffffeu, 0},
                         {0, 1}, {0, 0x3fffffffu}, {1, 0x7fffffffu}, {1, 0xbfffffffu}, {0xffffffffu, 0}};
  for (uint32_t i = 0; i < 256; ++i) scene.show_bits(i % 16, i / 16, words[i % std::size(words)]);
  return scene.finish("indices_out_of_range");
}

// Records that point past everything.
Case records_out_of_range() {
  SceneBuilder scene = two_triangles();
  SurfaceRecord s = scene.surfaces[0];
  s.first_index = 0xfffffffdu;
  scene.surfaces.push_back(s);
  s.first_index = 1u << 20, s.vertex_offset = 0xffffffffu;
  scene.surfaces.push_back(s);
  for (uint32_t i = 0; i < 256; ++i) scene.show_bits(i % 16, i / 16, {i % 3, i / 16 % 3});
  return scene.finish("records_out_of_range");
}

Case empty_scene() {
  SceneBuilder scene({16, 16});
  for (uint32_t i = 0; i < 256; ++i) scene.show_bits(i % 16, i / 16, {i, i % 2});
  return scene.finish("empty_scene");
}

Case broken_vectors() {
  SceneBuilder scene = two_triangles();
  for (const vec3& bad : {vec3(kNan), vec3(kInfinity, 0, 0), vec3(0), vec3(kLargest), vec3(kDenormal)}) {
    const VertexAttributes v = {bad, vec4(bad, kNan), vec2(kNan)};
    scene.add_triangle({vec3(-9, -9, -3), vec3(9, -9, -3), vec3(-9, 9, -3)}, {v, v, v});
  }
  for (const float bad : {kNan, kInfinity, kLargest}) {
    const VertexAttributes v = flat_attributes();
    scene.add_triangle({vec3(bad, 0, -3), vec3(9, -9, -3), vec3(-9, 9, -3)}, {v, v, v});
  }
  for (uint32_t i = 0; i < 256; ++i) scene.show(i % 16, i / 16, i % 10);
  return scene.finish("broken_vectors");
}

}  // namespace

std::vector<HardCase> hostile_cases() {
  return {{"broken_numbers", "NaN, infinities, the largest and a denormal at each coordinate in turn", broken_numbers},
          {"indices_out_of_range", "triangles, vertices and surfaces past their ends", indices_out_of_range},
          {"records_out_of_range", "offsets that overflow when they are added", records_out_of_range},
          {"empty_scene", "a visibility buffer that names what is not there", empty_scene},
          {"broken_vectors", "positions, normals and tangents that are NaN, infinite or nothing", broken_vectors}};
}

}  // namespace assay::attribute_interpolation
