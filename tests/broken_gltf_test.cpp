// Broken files: one line with the file and the place, never a crash, never a silence.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <functional>

#include "tests/glb.h"

namespace assay::tests {
namespace {

// What loading says: the error's text, or nothing.
std::string complaint(const std::string& bytes, const std::string& suffix = "test.glb") {
  try {
    load_bytes(bytes, suffix);
    return "";
  } catch (const std::runtime_error& e) {
    std::string what = e.what();
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    EXPECT_EQ(what.rfind(temporary(suffix).string() + ": ", 0), 0u) << "names no file: " << what;
    return what;
  }
}

struct Breakage {
  const char* name;
  const char* place;  // that the message must name
  std::function<void(Glb&)> apply;
};

Json& primitive(Glb& g) { return g.doc["meshes"][0]["primitives"][0]; }

const std::vector<Breakage>& breakages() {
  static const std::vector<Breakage> all = {
      {"index beyond the vertices", "meshes[0].primitives[0].indices",
       [](Glb& g) {
         primitive(g)["indices"] = g.add<uint16_t>({0, 1, 4}, 5123, "SCALAR", 1);
       }},
      {"indices that make no whole triangle", "meshes[0].primitives[0]",
       [](Glb& g) {
         primitive(g)["indices"] = g.add<uint16_t>({0, 1, 2, 3}, 5123, "SCALAR", 1);
       }},
      {"float indices", "indices",
       [](Glb& g) {
         primitive(g)["indices"] = g.add<float>({0, 1, 2}, 5126, "SCALAR", 1);
       }},
      {"accessor beyond its view", "accessors[0]", [](Glb& g) { g.doc["accessors"][0]["count"] = 5; }},
      {"accessor with a huge count", "accessors[0]", [](Glb& g) { g.doc["accessors"][0]["count"] = 1000000000000; }},
      {"accessor with a fraction of elements", "accessors[0]", [](Glb& g) { g.doc["accessors"][0]["count"] = 2.5; }},
      {"accessor with a negative count", "accessors[0]", [](Glb& g) { g.doc["accessors"][0]["count"] = -1; }},
      {"accessor offset beyond its view", "accessors[0]",
       [](Glb& g) { g.doc["accessors"][0]["byteOffset"] = 4000000000u; }},
      {"accessor of an unknown type", "", [](Glb& g) { g.doc["accessors"][0]["type"] = "VEC9"; }},
      {"accessor of an unknown component type", "", [](Glb& g) { g.doc["accessors"][0]["componentType"] = 77; }},
      {"view beyond its buffer", "bufferViews[0]", [](Glb& g) { g.doc["bufferViews"][0]["byteLength"] = 1 << 20; }},
      {"image view beyond its buffer", "bufferViews[4]",
       [](Glb& g) { g.doc["bufferViews"][4]["byteOffset"] = 1 << 28; }},
      {"view of an absent buffer", "bufferViews[1].buffer", [](Glb& g) { g.doc["bufferViews"][1]["buffer"] = 3; }},
      {"view without a length", "bufferViews[1]", [](Glb& g) { g.doc["bufferViews"][1].erase("byteLength"); }},
      {"stride under the element", "accessors[0]", [](Glb& g) { g.doc["bufferViews"][0]["byteStride"] = 4; }},
      {"buffer longer than the file", "buffers[0]",
       [](Glb& g) {
         g.doc["buffers"] = {{{"byteLength", 1 << 20}}};
       }},
      {"absent buffer file", "absent.bin",
       [](Glb& g) {
         g.doc["buffers"] = {{{"byteLength", 4}, {"uri", "absent.bin"}}}, g.doc["bufferViews"] = Json::array(),
         g.doc.erase("accessors"), g.doc.erase("images"), g.doc.erase("textures"), g.doc.erase("materials"),
         g.doc.erase("meshes"), g.doc.erase("nodes"), g.doc.erase("scenes"), g.doc.erase("scene");
       }},
      {"absent image file", "absent.png",
       [](Glb& g) {
         g.doc["images"] = {{{"uri", "absent.png"}}};
       }},
      {"image that is no image", "images[0]", [](Glb& g) { g.doc["images"][0]["bufferView"] = 0; }},
      {"attribute of an absent accessor", "attributes.NORMAL",
       [](Glb& g) { primitive(g)["attributes"]["NORMAL"] = 99; }},
      {"normals of another count", "NORMAL",
       [](Glb& g) {
         primitive(g)["attributes"]["NORMAL"] = g.add<float>({0, 0, 1}, 5126, "VEC3", 3);
       }},
      {"two-component positions", "POSITION",
       [](Glb& g) {
         primitive(g)["attributes"]["POSITION"] = g.add<float>({0, 0, 1, 0, 0, 1}, 5126, "VEC2", 2);
       }},
      {"NaN position", "POSITION",
       [](Glb& g) {
         primitive(g)["attributes"]["POSITION"] =
             g.add<float>({0, 0, 0, 1, std::nanf(""), 0, 0, 1, 0, 1, 1, 1}, 5126, "VEC3", 3);
       }},
      {"infinite position", "element 3",
       [](Glb& g) {
         primitive(g)["attributes"]["POSITION"] =
             g.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, INFINITY, 1, 1}, 5126, "VEC3", 3);
       }},
      {"absent material", "primitives[0].material", [](Glb& g) { primitive(g)["material"] = 4; }},
      {"absent texture", "baseColorTexture.index",
       [](Glb& g) { g.doc["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 1; }},
      {"absent image", "textures[0].source", [](Glb& g) { g.doc["textures"][0]["source"] = 1; }},
      {"unknown alpha mode", "materials[0]", [](Glb& g) { g.doc["materials"][0]["alphaMode"] = "SOMETIMES"; }},
      {"absent mesh", "nodes[0].mesh", [](Glb& g) { g.doc["nodes"][0]["mesh"] = 1; }},
      {"absent child", "nodes[0].children[1]",
       [](Glb& g) {
         g.doc["nodes"][0]["children"] = {1, 17};
       }},
      {"negative child", "nodes[0].children[0]", [](Glb& g) { g.doc["nodes"][0]["children"] = {-1}; }},
      {"a node that is its own child", "nodes[0]", [](Glb& g) { g.doc["nodes"][0]["children"] = {0}; }},
      {"a node with two parents", "nodes[2]", [](Glb& g) { g.doc["nodes"][1]["children"] = {2}; }},
      {"absent light", "KHR_lights_punctual.light",
       [](Glb& g) { g.doc["nodes"][2]["extensions"]["KHR_lights_punctual"]["light"] = 5; }},
      {"a light that darkens", "nodes[2]: light",
       [](Glb& g) { g.doc["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"] = -1; }},
      {"a light of two colours", "nodes[2]: light",
       [](Glb& g) {
         g.doc["extensions"]["KHR_lights_punctual"]["lights"][0]["color"] = {1, 1};
       }},
      {"a cone whose inside is the wider", "nodes[2]: light",
       [](Glb& g) { g.doc["extensions"]["KHR_lights_punctual"]["lights"][0]["spot"]["innerConeAngle"] = 0.7; }},
      {"a cone wider than a half space", "nodes[2]: light",
       [](Glb& g) { g.doc["extensions"]["KHR_lights_punctual"]["lights"][0]["spot"]["outerConeAngle"] = 1.6; }},
      {"a light that is no object", "lights[0]",
       [](Glb& g) { g.doc["extensions"]["KHR_lights_punctual"]["lights"] = {7}; }},
      {"absent scene", "scene", [](Glb& g) { g.doc["scene"] = 3; }},
      {"a scene that shows nothing", "scene", [](Glb& g) { g.doc["scenes"][0]["nodes"] = Json::array(); }},
      {"nodes that are no array", "nodes", [](Glb& g) { g.doc["nodes"] = 3; }},
      {"a node that is no object", "nodes[1]", [](Glb& g) { g.doc["nodes"][1] = "node"; }},
      {"projective matrix", "nodes[0]",
       [](Glb& g) {
         g.doc["nodes"][0] = {{"mesh", 0}, {"matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
       }},
      {"a camera that sees nothing", "nodes[1]", [](Glb& g) { g.doc["cameras"][0]["perspective"]["yfov"] = 0; }},
      {"required Draco", "KHR_draco_mesh_compression",
       [](Glb& g) { g.doc["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }},
      {"required meshopt", "EXT_meshopt_compression",
       [](Glb& g) { g.doc["extensionsRequired"] = {"EXT_meshopt_compression"}; }},
      {"required KTX2", "KHR_texture_basisu", [](Glb& g) { g.doc["extensionsRequired"] = {"KHR_texture_basisu"}; }},
      {"sparse index beyond the elements", "accessors[0]",
       [](Glb& g) {
         const int indices = g.add_view(std::string("\x09\x00", 2)), values = g.add_view(std::string(12, '\0'));
         g.doc["accessors"][0]["sparse"] = {{"count", 1},
                                            {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                            {"values", {{"bufferView", values}}}};
       }},
      {"no version", "", [](Glb& g) { g.doc["asset"] = Json::object(); }},
  };
  return all;
}

TEST(BrokenGltf, EveryBreakageIsOneLineWithItsPlace) {
  for (const Breakage& b : breakages()) {
    Glb g = quad();
    b.apply(g);
    const std::string said = complaint(bytes_of(g));
    EXPECT_FALSE(said.empty()) << b.name << " was accepted";
    EXPECT_NE(said.find(b.place), std::string::npos) << b.name << ": \"" << said << "\" does not name " << b.place;
  }
}

TEST(BrokenGltf, EveryTruncationIsRefused) {
  const std::string whole = bytes_of(quad());
  ASSERT_EQ(complaint(whole), "");
  for (size_t size = 0; size < whole.size(); ++size) EXPECT_NE(complaint(whole.substr(0, size)), "") << size;
}

TEST(BrokenGltf, TextFilesTruncatedAnywhereAreRefused) {
  const std::string whole = quad().doc.dump();
  for (size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(complaint(whole.substr(0, size), "test.gltf"), "") << size;
}

TEST(BrokenGltf, DeepNestingIsRefused) {
  std::string doc = quad().doc.dump();
  doc.insert(1, "\"extras\":" + std::string(100000, '[') + std::string(100000, ']') + ",");
  EXPECT_NE(complaint(doc, "test.gltf").find("nested"), std::string::npos);
}

TEST(BrokenGltf, AChainOfManyNodesLoads) {
  Glb g = quad();
  Json nodes = Json::array();
  for (int i = 0; i < 20000; ++i) nodes.push_back({{"children", {i + 1}}});
  nodes.push_back({{"mesh", 0}});
  g.doc["nodes"] = nodes;
  EXPECT_EQ(complaint(bytes_of(g)), "");
}

// Each byte in turn becomes something else: whatever comes of it, it is a scene or one line.
TEST(BrokenGltf, AnyByteMayChange) {
  const std::string whole = bytes_of(quad());
  const char values[] = {'\0', '9', '-', '"', '\xff'};
  for (size_t i = 0; i < whole.size(); ++i) {
    std::string bytes = whole;
    bytes[i] = values[i % std::size(values)];
    complaint(bytes);
  }
}

// Every number of the document in turn becomes hostile.
TEST(BrokenGltf, AnyNumberMayBeHostile) {
  const Glb whole = quad();
  const Json flat = whole.doc.flatten();
  for (const auto& [path, value] : flat.items()) {
    for (const Json& hostile :
         {Json(-1), Json(1e30), Json(4294967295u), Json(0.5), Json("text"), Json(nullptr), Json::array()}) {
      Glb g = whole;
      g.doc[Json::json_pointer(path)] = hostile;
      complaint(bytes_of(g));
    }
  }
}

TEST(BrokenGltf, SeveralBytesMayChange) {
  const std::string whole = bytes_of(quad());
  const bool passed = rc::check("several bytes changed", [&] {
    std::string bytes = whole;
    const auto changes = *rc::gen::container<std::vector<std::pair<size_t, char>>>(
        rc::gen::pair(rc::gen::inRange<size_t>(0, whole.size()), rc::gen::arbitrary<char>()));
    for (const auto& [at, value] : changes) bytes[at] = value;
    complaint(bytes);
  });
  EXPECT_TRUE(passed);
}

TEST(BrokenGltf, AbsentFileAndUnknownNameAreOneLine) {
  for (const char* name : {"no/such/file.glb", "barn"})
    EXPECT_THROW(
        {
          try {
            scene::load(name);
          } catch (const std::runtime_error& e) {
            EXPECT_NE(std::string(e.what()).find(name), std::string::npos);
            throw;
          }
        },
        std::runtime_error);
}

}  // namespace
}  // namespace assay::tests
