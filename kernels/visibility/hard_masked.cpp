// Hard cases of the cut, and those that no scene should hold.
#include <cmath>
#include <limits>

#include "kernels/visibility/hard.h"

namespace assay::visibility {

namespace {

constexpr Extent kExtent = {72, 56};

// A screen-filling quad cut by this texture, over an opaque one behind it.
Case cut_case(const Look& look, std::vector<Texture> textures = {}) {
  SceneBuilder scene(kExtent);
  for (Texture& t : textures) scene.add_texture(std::move(t));
  const auto at = [&](float z) {
    Mesh m = quad_mesh(1);
    for (vec3& p : m.positions) p = vec3(p.x * 3, p.y * 3, z);
    return m;
  };
  scene.add(at(-4), {});
  scene.add(at(-3), look);
  return scene.finish();
}

Texture constant(uint32_t alpha) {
  return alpha_texture(4, 4, 1, Format::rgba8_unorm, [=](uint32_t, uint32_t, uint32_t) { return alpha; });
}
Texture stripes(uint32_t width, uint32_t height, uint32_t layers) {
  return alpha_texture(width, height, layers, Format::rgba8_srgb,
                       [](uint32_t x, uint32_t, uint32_t layer) { return (x + layer) % 2 * 255; });
}

}  // namespace

std::vector<HardCase> masked_cases() {
  return {
      {"masked_all_cut", "every pixel is a hole: what lies behind stays",
       [] { return cut_case(masked_look(1, 0.5f, texture_name(0, 0)), {constant(0)}); }},
      {"masked_none_cut", "no pixel is a hole",
       [] { return cut_case(masked_look(1, 0.5f, texture_name(0, 0)), {constant(255)}); }},
      {"cutoff_equal", "alpha equal to the cutoff is kept: less than, not at most",
       [] { return cut_case(masked_look(0.625f, 0.625f)); }},
      {"cutoff_in_texture", "the cutoff is the alpha of a constant texture: rounding may tip it",
       [] { return cut_case(masked_look(1, 51 / 255.0f, texture_name(0, 0)), {constant(51)}); }},
      {"masked_factor", "the material's own alpha counts",
       [] { return cut_case(masked_look(0.25f, 0.5f, texture_name(0, 0)), {constant(255)}); }},
      {"cutoff_zero", "a cutoff of 0 keeps alpha 0", [] { return cut_case(masked_look(0, 0)); }},
      {"cutoff_above_one", "a cutoff of 2 leaves nothing", [] { return cut_case(masked_look(1, 2)); }},
      {"masked_stripes", "one column in two of the texture is a hole, upright: u and v differ",
       [] { return cut_case(masked_look(1, 0.5f, texture_name(0, 0)), {stripes(8, 2, 1)}); }},
      {"masked_layers", "layers differ: the second is the first's negative",
       [] { return cut_case(masked_look(1, 0.5f, texture_name(0, 1)), {stripes(8, 2, 2)}); }},
      {"masked_sixteen", "the last of sixteen arrays",
       [] {
         std::vector<Texture> all(15, constant(0));
         all.push_back(stripes(5, 3, 1));
         return cut_case(masked_look(1, 0.5f, texture_name(15, 0)), all);
       }},
      {"masked_minified", "64 texels a pixel at level 0: no filter hides a wrong coordinate",
       [] { return cut_case(masked_look(1, 0.5f, texture_name(0, 0)), {stripes(1021, 3, 1)}); }},
  };
}

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A quad, and before it a triangle with this vertex.
Case with_vertex(const vec3& broken) {
  SceneBuilder scene({48, 40});
  Mesh quad = quad_mesh(2), triangle;
  for (vec3& p : quad.positions) p.z = -3;
  scene.add(quad, {});
  for (const vec3& v : {vec3(-1, -1, -2), vec3(1, -1, -2), broken})
    triangle.indices.push_back(add_vertex(triangle, v, vec2(v.x, v.y)));
  scene.add(triangle, both_sides());
  return scene.finish();
}

Case with_indices(const std::function<void(uint32_t&)>& change) {
  Case c = space_case({48, 40}, {{-1, -1, -2}, {1, -1, -2}, {0, 1, -2}}, both_sides());
  const auto indices = c.input<uint>("indices");
  std::vector<uint> changed(indices.begin(), indices.end());
  change(changed.back());
  c.set_input("indices", changed);
  return c;
}

template <class T>
Case changed(Case c, const std::string& port, const std::function<void(T&)>& change) {
  const auto values = c.input<T>(port);
  std::vector<T> all(values.begin(), values.end());
  for (T& value : all) change(value);
  c.set_input(port, all);
  return c;
}

}  // namespace

std::vector<HardCase> hostile_cases() {
  return {
      {"vertex_nan", "NaN in a position: nothing hangs, nothing beside its triangle changes",
       [] { return with_vertex(vec3(kNaN, 0, -2)); }},
      {"vertex_infinite", "infinity in a position", [] { return with_vertex(vec3(0, kInfinity, -2)); }},
      {"vertex_infinite_w", "infinite distance", [] { return with_vertex(vec3(0, 0, -kInfinity)); }},
      {"vertex_denormal", "denormal coordinates, flushed or not",
       [] { return with_vertex(vec3(1e-40f, -1e-42f, -2)); }},
      {"vertex_huge", "coordinates near the largest float", [] { return with_vertex(vec3(1e38f, 1e38f, -1)); }},
      {"index_past_end", "an index past the vertices reads the last one",
       [] { return with_indices([](uint32_t& i) { i = 1000000; }); }},
      {"index_largest", "the largest index that is no restart",
       [] { return with_indices([](uint32_t& i) { i = 0x7fffffff; }); }},
      {"uv_nan", "NaN in the coordinates of a cut: any texel, or none",
       [] {
         return changed<VertexAttributes>(cut_case(masked_look(1, 0.5f, texture_name(0, 0)), {stripes(8, 2, 1)}),
                                          "attributes", [](VertexAttributes& a) { a.uv.x = kNaN; });
       }},
      {"alpha_nan", "an alpha that is no number is compared as the device likes",
       [] { return cut_case(masked_look(kNaN, 0.5f)); }},
      {"texture_array_past_end", "a texture array that does not exist is white",
       [] { return cut_case(masked_look(1, 0.5f, texture_name(40, 0)), {constant(0)}); }},
      {"texture_slot_unused", "a slot without an array is white",
       [] { return cut_case(masked_look(1, 0.5f, texture_name(9, 0)), {constant(0)}); }},
      {"texture_layer_past_end", "a layer past the end is the last one",
       [] { return cut_case(masked_look(1, 0.5f, texture_name(0, 900)), {stripes(8, 2, 2)}); }},
      {"material_past_end", "a material past the end is the last one",
       [] {
         return changed<SurfaceRecord>(cut_case(masked_look(1, 0.5f, texture_name(0, 0)), {stripes(8, 2, 1)}),
                                       "surfaces", [](SurfaceRecord& s) { s.material += 70000; });
       }},
      {"instance_past_end", "instances past the surfaces are the last surface again",
       [] {
         return changed<DrawCommand>(space_case({48, 40}, {{-1, -1, -2}, {1, -1, -2}, {0, 1, -2}}), "draws",
                                     [](DrawCommand& d) { d.instance_count = 5, d.first_instance = 3; });
       }},
  };
}

std::vector<Mutant> mutants() {
  return {
      {"pull.glsl", 1, "every instance is the draw's first", "instances"},
      {"pull.glsl", 2, "y by the row of x", "flat_quad"},
      {"pull.glsl", 3, "a near distance of 0.999", "tie_at_one_depth"},
      {"pull.glsl", 4, "the instanced flag where the winding is flipped", "instances"},
      {"pull.glsl", 5, "the winding flag is lost", "mirrored"},
      {"opaque.frag", 6, "primitives count from one", "flat_quad"},
      {"masked.vert", 7, "u and v swapped", "masked_stripes"},
      {"cut.glsl", 9501, "alpha at most the cutoff is cut", "cutoff_equal"},
      {"cut.glsl", 9502, "nothing is cut", "masked_all_cut"},
      {"cut.glsl", 9503, "the material's alpha is forgotten", "masked_factor"},
      {"masked.frag", 11, "primitives count from one", "masked_none_cut"},
      {"fat.vert", 12, "u and v swapped", "masked_stripes"},
      {"fat.vert", 13, "mirroring is forgotten", "mirrored"},
      {"fat.glsl", 14, "d/dx and d/dy swapped", "flat_quad"},
      {"fat.glsl", 15, "the handedness is lost", "mirrored"},
      {"fat_opaque.frag", 16, "primitives count from one", "flat_quad"},
      {"fat_masked.frag", 17, "primitives count from one", "masked_none_cut"},
  };
}

}  // namespace assay::visibility
