// What the loader makes of whole files: small ones of every kind, and the real scenes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "tests/glb.h"

namespace assay::tests {
namespace {

Json& primitive(Glb& g) { return g.doc["meshes"][0]["primitives"][0]; }

TEST(Gltf, ReadsEverythingThatTheQuadHolds) {
  const scene::Scene s = load(quad());
  ASSERT_EQ(s.meshes.size(), 1u);
  EXPECT_EQ(s.meshes[0].positions.size(), 4u);
  EXPECT_EQ(s.meshes[0].indices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(s.meshes[0].attributes[1].uv, glm::vec2(1, 1));
  ASSERT_EQ(s.materials.size(), 1u);
  EXPECT_EQ(s.materials[0].alpha, scene::AlphaMode::masked);
  EXPECT_FLOAT_EQ(s.materials[0].alpha_cutoff, 0.25f);
  EXPECT_TRUE(s.materials[0].double_sided);
  EXPECT_EQ(scene::feature_bits(s, s.materials[0]),
            kFeatureOpaque | kFeatureMasked | kFeatureDoubleSided | kFeatureTextured | kFeatureSubsurface);
  ASSERT_EQ(s.images.size(), 1u);
  EXPECT_EQ(s.images[0].width, 4u);
  EXPECT_EQ(s.images[0].rgba[4 * 5 + 1], 50);
  EXPECT_TRUE(s.notes.empty());
}

TEST(Gltf, LightsAndCamerasFollowTheirNodes) {
  const scene::Scene s = load(quad());
  ASSERT_EQ(s.cameras.size(), 1u);
  EXPECT_NEAR(length(s.cameras[0].eye - glm::dvec3(10, 0, 5)), 0, 1e-12);
  EXPECT_NEAR(length(s.cameras[0].orientation * glm::dvec3(0, 0, -1) - glm::dvec3(0, 0, -1)), 0, 1e-12);
  EXPECT_DOUBLE_EQ(s.cameras[0].vertical_fov_rad, 0.7);
  EXPECT_DOUBLE_EQ(s.cameras[0].near_plane, 0.05);
  ASSERT_EQ(s.lights.size(), 1u);
  EXPECT_EQ(s.lights[0].kind, scene::LightKind::spot);
  EXPECT_EQ(s.lights[0].position, glm::dvec3(10, 0, 0));
  EXPECT_NEAR(length(s.lights[0].direction - glm::vec3(0, -1, 0)), 0, 1e-6);  // -z turned by -90 degrees about x
  EXPECT_FLOAT_EQ(s.lights[0].intensity, 7);
  EXPECT_FLOAT_EQ(s.lights[0].outer_rad, 0.6f);
}

TEST(Gltf, MaterialsKeepScalesAndStrengths) {
  Glb g = quad();
  g.doc["materials"][0]["normalTexture"] = {{"index", 0}, {"scale", 0.25}};
  g.doc["materials"][0]["occlusionTexture"] = {{"index", 0}, {"strength", 0.75}};
  const scene::Scene s = load(g);
  EXPECT_EQ(s.materials[0].normal_scale, 0.25f);
  EXPECT_EQ(s.materials[0].occlusion_strength, 0.75f);
  EXPECT_FALSE(s.materials[0].shader.has_value());
  EXPECT_EQ(shader_class(s, s.materials[0]), kShaderFoliage);  // a masked leaf
  const scene::Scene plain = load(quad());
  EXPECT_EQ(plain.materials[0].normal_scale, 1);
  EXPECT_EQ(plain.materials[0].occlusion_strength, 1);
}

TEST(Gltf, MatrixAndTrsNodesMultiplyDownTheTree) {
  Glb g = quad();
  g.doc["nodes"] = {{{"children", {1}}, {"matrix", {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 3, 4, 5, 1}}},
                    {{"mesh", 0}, {"translation", {1, 0, 0}}, {"scale", {2, 2, -2}}}};
  const scene::Scene s = load(g);
  ASSERT_EQ(s.instances.size(), 1u);
  // (1, 1, 1) scaled to (2, 2, -2), moved to (3, 2, -2), then x -> -z and z -> x, then moved.
  EXPECT_NEAR(length(glm::dvec3(s.instances[0].to_world * glm::dvec4(1, 1, 1, 1)) - glm::dvec3(3 - 2, 4 + 2, 5 - 3)), 0,
              1e-12);
  EXPECT_LT(determinant(s.instances[0].to_world), 0);
}

TEST(Gltf, StripsAndFansKeepTheirWinding) {
  Glb strip = quad();
  primitive(strip)["mode"] = 5;
  primitive(strip)["indices"] = strip.add<uint8_t>({0, 1, 3, 2}, 5121, "SCALAR", 1);
  EXPECT_EQ(load(strip).meshes[0].indices, (std::vector<uint32_t>{0, 1, 3, 3, 1, 2}));
  Glb fan = quad();
  primitive(fan)["mode"] = 6;
  primitive(fan)["indices"] = fan.add<uint32_t>({0, 1, 2, 3}, 5125, "SCALAR", 1);
  EXPECT_EQ(load(fan).meshes[0].indices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
}

TEST(Gltf, PointsAndLinesAreNotedAndLeftOut) {
  Glb g = quad();
  Json lines = primitive(g);
  lines["mode"] = 1;
  g.doc["meshes"][0]["primitives"].push_back(lines);
  const scene::Scene s = load(g);
  EXPECT_EQ(s.meshes[0].parts.size(), 1u);
  ASSERT_EQ(s.notes.size(), 1u);
  EXPECT_NE(s.notes[0].find("meshes[0].primitives[1]"), std::string::npos);
}

TEST(Gltf, UnindexedPrimitivesNumberTheirVertices) {
  Glb g = quad();
  primitive(g).erase("indices");
  const int position = g.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, 5126, "VEC3", 3);
  primitive(g)["attributes"] = {{"POSITION", position}};
  const scene::Scene s = load(g);
  EXPECT_EQ(s.meshes[0].indices, (std::vector<uint32_t>{0, 1, 2}));
  EXPECT_EQ(s.meshes[0].attributes[2].uv, glm::vec2(0));
}

TEST(Gltf, MissingNormalsAreFlatAndSplitVertices) {
  Glb g = quad();
  primitive(g)["attributes"].erase("NORMAL");
  const int bent = g.add<float>({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 2}, 5126, "VEC3", 3);
  primitive(g)["attributes"]["POSITION"] = bent;
  const scene::Scene s = load(g);
  const scene::Mesh& m = s.meshes[0];
  ASSERT_EQ(m.positions.size(), 6u);
  EXPECT_EQ(m.attributes[0].normal, glm::vec3(0, 0, 1));
  const glm::vec3 expected = normalize(cross(m.positions[4] - m.positions[3], m.positions[5] - m.positions[3]));
  for (int i = 3; i < 6; ++i) EXPECT_NEAR(length(m.attributes[static_cast<size_t>(i)].normal - expected), 0, 1e-6);
}

TEST(Gltf, MissingTangentsFollowU) {
  const scene::Scene s = load(quad());
  for (const VertexAttributes& a : s.meshes[0].attributes) EXPECT_EQ(a.tangent, glm::vec4(1, 0, 0, 1));
  Glb mirrored = quad();
  primitive(mirrored)["attributes"]["TEXCOORD_0"] = mirrored.add<float>({1, 1, 0, 1, 0, 0, 1, 0}, 5126, "VEC2", 2);
  const scene::Scene other = load(mirrored);
  for (const VertexAttributes& a : other.meshes[0].attributes) EXPECT_EQ(a.tangent, glm::vec4(-1, 0, 0, -1));
}

TEST(Gltf, QuantisedUvs) {
  Glb g = quad();
  primitive(g)["attributes"]["TEXCOORD_0"] = g.add<uint8_t>({0, 255, 255, 255, 255, 0, 51, 0}, 5121, "VEC2", 2, true);
  EXPECT_FLOAT_EQ(load(g).meshes[0].attributes[3].uv.x, 0.2f);
  primitive(g)["attributes"]["TEXCOORD_0"] =
      g.add<uint16_t>({0, 65535, 65535, 65535, 65535, 0, 13107, 0}, 5123, "VEC2", 2, true);
  EXPECT_FLOAT_EQ(load(g).meshes[0].attributes[3].uv.x, 0.2f);
}

TEST(Gltf, SparseAccessorsOverlayTheirBase) {
  Glb g = quad();
  const int indices = g.add_view(std::string("\x02\x00", 2));
  const std::vector<float> moved = {5, 6, 7};
  const int values = g.add_view(std::string(reinterpret_cast<const char*>(moved.data()), 12));
  Json sparse = {{"count", 1},
                 {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                 {"values", {{"bufferView", values}}}};
  g.doc["accessors"][0]["sparse"] = sparse;
  const scene::Scene s = load(g);
  EXPECT_EQ(s.meshes[0].positions[2], glm::vec3(5, 6, 7));
  EXPECT_EQ(s.meshes[0].positions[1], glm::vec3(1, -1, 0));
}

TEST(Gltf, PrimitivesThatNameTheSameAccessorsShareVertices) {
  Glb g = quad();
  g.doc["meshes"][0]["primitives"].push_back(primitive(g));
  const scene::Scene s = load(g);
  EXPECT_EQ(s.meshes[0].positions.size(), 4u);
  EXPECT_EQ(s.meshes[0].parts.size(), 2u);
}

TEST(Gltf, NoMaterialMeansTheDefaultOne) {
  Glb g = quad();
  primitive(g).erase("material");
  const scene::Scene s = load(g);
  ASSERT_EQ(s.materials.size(), 2u);
  EXPECT_EQ(s.meshes[0].parts[0].material, 1u);
}

TEST(Gltf, TextFilesWithADataUri) {
  Glb g = quad();
  g.doc.erase("images"), g.doc.erase("textures"), g.doc.erase("samplers"), g.doc.erase("materials");
  primitive(g).erase("material");
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  g.bin.resize((g.bin.size() + 2) / 3 * 3);
  std::string text;
  for (size_t i = 0; i < g.bin.size(); i += 3) {
    uint32_t three = 0;
    for (size_t k = 0; k < 3; ++k) three = three << 8 | static_cast<uint8_t>(g.bin[i + k]);
    for (int shift = 18; shift >= 0; shift -= 6) text += digits[three >> shift & 63];
  }
  g.doc["buffers"] = {{{"byteLength", g.bin.size()}, {"uri", "data:application/octet-stream;base64," + text}}};
  EXPECT_EQ(load_bytes(g.doc.dump(), "test.gltf").meshes[0].positions[2], glm::vec3(1, 1, 0));
}

TEST(Gltf, ExternalBuffersAndImagesAreFoundBesideTheFile) {
  Glb g = quad();
  const Json view = g.doc["bufferViews"][4];  // the PNG
  const std::filesystem::path buffer = temporary("some buffer.bin"), texture = temporary("external.png");
  std::ofstream(buffer, std::ios::binary) << g.bin;
  std::ofstream(texture, std::ios::binary) << g.bin.substr(view["byteOffset"], view["byteLength"]);
  std::string address = buffer.filename().string();
  address.replace(address.find(' '), 1, "%20");
  g.doc["buffers"] = {{{"byteLength", g.bin.size()}, {"uri", address}}};
  g.doc["images"] = {{{"uri", texture.filename().string()}}};
  const scene::Scene s = load_bytes(g.doc.dump(), "test.gltf");
  EXPECT_EQ(s.meshes[0].positions.size(), 4u);
  EXPECT_EQ(s.images[0].width, 4u);
  std::filesystem::remove(texture);
  EXPECT_THROW(load_bytes(g.doc.dump(), "test.gltf"), std::runtime_error);
  std::filesystem::remove(buffer);
}

TEST(Gltf, WhatIsLeftOutIsNoted) {
  Glb g = quad();
  g.doc["extensionsUsed"].push_back("KHR_texture_transform");
  g.doc["samplers"][0]["wrapS"] = 33071;
  g.doc["cameras"].push_back(
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 9}}}});
  g.doc["nodes"][2]["camera"] = 1;
  g.doc["scenes"].push_back({{"nodes", {0}}});
  const scene::Scene s = load(g);
  std::string all;
  for (const std::string& note : s.notes) all += note + "\n";
  for (const char* word : {"KHR_texture_transform", "samplers[0]", "orthographic", "1 further scene"})
    EXPECT_NE(all.find(word), std::string::npos) << word << " not in\n" << all;
}

// ---- Real files ----------------------------------------------------------------------------------------------------

std::filesystem::path scenes_folder() {
  const char* data = std::getenv("ASSAY_DATA");
#ifdef ASSAY_SOURCE_DIR
  const std::filesystem::path beside = std::filesystem::path(ASSAY_SOURCE_DIR) / ".." / "shared" / "data";
#else
  const std::filesystem::path beside = "../shared/data";  // tests run in the source folder
#endif
  return (data ? std::filesystem::path(data) : beside) / "scenes";
}

void expect_counts(const scene::Scene& s, const Json& counts) {
  uint64_t triangles = 0, instanced = 0, vertices = 0, primitives = 0, masked = 0, blended = 0;
  for (const scene::Mesh& m : s.meshes) {
    triangles += m.indices.size() / 3, vertices += m.positions.size(), primitives += m.parts.size();
  }
  for (const scene::Instance& i : s.instances) instanced += s.meshes[i.mesh].indices.size() / 3;
  for (const scene::Material& m : s.materials)
    masked += m.alpha == scene::AlphaMode::masked, blended += m.alpha == scene::AlphaMode::blended;
  EXPECT_EQ(triangles, counts["triangles_unique"]);
  EXPECT_EQ(instanced, counts["triangles_instanced"]);
  EXPECT_EQ(vertices, counts["vertices_unique"]);
  EXPECT_EQ(primitives, counts["primitives"]);
  EXPECT_EQ(s.meshes.size(), counts["meshes"]);
  EXPECT_EQ(s.instances.size(), counts["mesh_instances"]);
  EXPECT_EQ(s.materials.size(), counts["materials"]);
  EXPECT_EQ(s.images.size(), counts["images"]);
  EXPECT_EQ(masked, counts["materials_alpha_mask"]);
  EXPECT_EQ(blended, counts["materials_alpha_blend"]);
  const scene::Bounds box = bounds_of(s);
  // Boxes of turned instances are wider than their vertices'; the manifest has five decimals.
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(box.lowest[axis], counts["bounds_min"][static_cast<size_t>(axis)].get<double>() + 1e-5);
    EXPECT_GE(box.highest[axis], counts["bounds_max"][static_cast<size_t>(axis)].get<double>() - 1e-5);
  }
}

TEST(Gltf, RealScenesHaveTheManifestsCounts) {
  const std::filesystem::path folder = scenes_folder();
  if (!std::filesystem::exists(folder / "manifest.json"))
    GTEST_SKIP() << "no scenes in " << folder << "; set ASSAY_DATA to the folder that holds them";
  std::ifstream in(folder / "manifest.json");
  const Json manifest = Json::parse(in);
  int files = 0;
  for (const Json& item : manifest["items"]) {
    if (!item.contains("counts")) continue;
    SCOPED_TRACE(item["file"].get<std::string>());
    const scene::Scene s = scene::load((folder / item["file"].get<std::string>()).string());
    expect_counts(s, item["counts"]);
    const scene::Gathered g = gather(s, default_camera(s), {1280, 720});
    EXPECT_GT(g.counts.surfaces, 0u);
    EXPECT_GE(g.counts.lights, 1u);
    std::string arrays;
    for (const Texture& t : g.textures)
      arrays += fmt::format(" {} x {}x{} {};", t.layers, t.width, t.height,
                            t.format == Format::rgba8_srgb ? "sRGB" : "linear");
    fmt::print("{}: {} arrays:{}\n", s.name, g.textures.size(), arrays);
    EXPECT_LE(g.textures.size(), 16u);
    ++files;
  }
  EXPECT_GT(files, 0);
}

TEST(Gltf, SponzaIsSeenFromInsideTheOthersFromOutside) {
  const std::filesystem::path folder = scenes_folder();
  if (!std::filesystem::exists(folder / "sponza.glb")) GTEST_SKIP() << "no scenes in " << folder;
  for (const char* name : {"sponza", "skull", "flight_helmet", "eztree_grove"})
    EXPECT_EQ(default_camera(scene::load((folder / name).string() + ".glb")).name,
              std::string(name) == "sponza" ? "inside" : "outside")
        << name;
}

}  // namespace
}  // namespace assay::tests
