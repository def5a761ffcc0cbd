// Lights from a file beside the scene's: what it may say, and one line for what it may not.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "harness/image/image.h"
#include "tests/glb.h"

namespace assay::tests {
namespace {

namespace fs = std::filesystem;
using scene::LightKind;
using scene::Scene;

// Removed with the test.
struct TemporaryFile {
  fs::path path;
  TemporaryFile(const std::string& name, const std::string& text) : path(temporary(name)) {
    std::ofstream(path, std::ios::binary) << text;
  }
  ~TemporaryFile() { fs::remove(path); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
};

Scene with(const std::string& text) {
  const TemporaryFile file("some.json", text);
  return scene::load("bare", file.path);
}

std::string complaint(const std::string& text) {
  try {
    with(text);
    return "";
  } catch (const std::runtime_error& e) {
    std::string what = e.what();
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    EXPECT_EQ(what.rfind(temporary("some.json").string() + ": ", 0), 0u) << "names no file: " << what;
    return what;
  }
}

TEST(Sidecar, LightsOfEveryKind) {
  const Scene s = with(R"({"about": "test", "lights": [
    {"kind": "spot", "position": [1, 2, 3], "direction": [0, -2, 0], "colour": [1, 0.5, 0.25], "intensity": 40,
     "range": 8, "inner_deg": 30, "outer_deg": 60},
    {"kind": "spot", "position": [1, 2, 3], "direction": [0, 0, 1], "inner_rad": 0.25, "outer_rad": 0.5},
    {"kind": "point", "position": [1e6, 2, 0.125], "shadows": true},
    {"kind": "directional", "direction": [3, 0, -4], "intensity": 2, "shadows": false}]})");
  ASSERT_EQ(s.lights.size(), 4u);
  EXPECT_EQ(s.lights[0].kind, LightKind::spot);
  EXPECT_EQ(s.lights[0].position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(s.lights[0].direction, glm::vec3(0, -1, 0));
  EXPECT_EQ(s.lights[0].colour, glm::vec3(1, 0.5f, 0.25f));
  EXPECT_EQ(s.lights[0].intensity, 40);
  EXPECT_EQ(s.lights[0].range, 8);
  EXPECT_FLOAT_EQ(s.lights[0].inner_rad, 0.52359878f);
  EXPECT_FLOAT_EQ(s.lights[0].outer_rad, 1.04719755f);
  EXPECT_EQ(s.lights[1].inner_rad, 0.25f);
  EXPECT_EQ(s.lights[1].outer_rad, 0.5f);
  EXPECT_EQ(s.lights[2].kind, LightKind::point);
  EXPECT_EQ(s.lights[2].position, glm::dvec3(1e6, 2, 0.125));
  EXPECT_EQ(s.lights[2].colour, glm::vec3(1));
  EXPECT_EQ(s.lights[2].intensity, 1);
  EXPECT_EQ(s.lights[2].range, 0);
  EXPECT_EQ(s.lights[3].kind, LightKind::directional);
  EXPECT_NEAR(length(s.lights[3].direction - glm::vec3(0.6f, 0, -0.8f)), 0, 1e-6);
  for (size_t i = 0; i < 4; ++i) EXPECT_EQ(s.lights[i].casts_shadows, i == 2);
  ASSERT_EQ(s.notes.size(), 1u);
  EXPECT_NE(s.notes[0].find("4 lights"), std::string::npos);
}

TEST(Sidecar, BrokenOnesAreOneLineWithThePlace) {
  const auto light = [](const std::string& members) { return "{\"lights\": [" + members + "]}"; };
  const auto decal = [](const std::string& members) { return "{\"decals\": [" + members + "]}"; };
  const std::string spot = R"("kind": "spot", "position": [0, 0, 0], "direction": [0, -1, 0])",
                    laid = R"("position": [0, 0, 0], "outward": [0, 0, 1])";
  const std::pair<std::string, const char*> broken[] = {
      {"", "JSON"},
      {"{\"lights\": [", "JSON, byte"},
      {"[]", "not an object"},
      {"{}", "lights"},
      {"{\"lights\": {}}", "lights"},
      {"{\"lights\": [], \"probes\": []}", "\"probes\""},
      {"{\"decals\": 3}", "decals: is not an array"},
      {decal("7"), "decals[0]: is not an object"},
      {decal("{}"), "decals[0]: position is missing"},
      {decal(R"({"position": [0, 0, 0], "half_extents": [1, 1, 1]})"), "decals[0]: outward is missing"},
      {decal(R"({"position": [0, 0, 0], "outward": [0, 0, 0], "half_extents": [1, 1, 1]})"), "decals[0].outward"},
      {decal("{" + laid + R"(, "half_extents": [1, 0, 1]})"), "decals[0]: a half extent"},
      {decal("{" + laid + R"(, "half_extents": [1, 1]})"), "decals[0].half_extents"},
      {decal("{" + laid + R"(, "up": [0, 0, 2], "half_extents": [1, 1, 1]})"), "decals[0].up: is along outward"},
      {decal("{" + laid + R"(, "half_extents": [1, 1, 1], "weights": [1, 2, 0]})"), "decals[0]: a weight"},
      {decal("{" + laid + R"(, "half_extents": [1, 1, 1], "coverage": -1})"), "decals[0]: its coverage"},
      {decal("{" + laid + R"(, "half_extents": [1, 1, 1], "color": [1, 1, 1]})"), "\"color\""},
      {decal("{" + laid + R"(, "half_extents": [1, 1, 1], "normal_mode": "up"})"), "decals[0].normal_mode"},
      {decal("{" + laid + R"(, "half_extents": [1, 1, 1], "receiver": 1})"), "there is no instance 1"},
      {decal("{" + laid + R"(, "half_extents": [1, 1, 1], "receiver": -1})"), "decals[0].receiver"},
      {decal("{" + laid + R"(, "half_extents": [1, 1, 1], "colour_image": 4})"), "decals[0].colour_image"},
      {decal("{" + laid + R"(, "half_extents": [1, 1, 1], "colour_image": "no_such.png"})"), "decals[0].colour_image"},
      {decal("{" + laid + R"(, "half_extents": [1, 1, 1], "normal_image": "some.json"})"), "decals[0].normal_image"},
      {light("7"), "lights[0]"},
      {light("{}"), "kind is missing"},
      {light(R"({"kind": "area"})"), "lights[0].kind"},
      {light(R"({"kind": 3})"), "lights[0].kind"},
      {light(R"({"kind": "point"})"), "lights[0]: position is missing"},
      {light(R"({"kind": "point", "position": [0, 0]})"), "lights[0].position"},
      {light(R"({"kind": "point", "position": [0, 0, "up"]})"), "lights[0].position"},
      {light(R"({"kind": "point", "position": [0, 0, 1e300]})"), "lights[0].position"},
      {light(R"({"kind": "point", "position": [0, 0, 1e999]})"), "1e999"},
      {light(R"({"kind": "point", "position": [0, 0, 0], "direction": [0, 1, 0]})"), "\"direction\""},
      {light(R"({"kind": "point", "position": [0, 0, 0], "color": [0, 1, 0]})"), "\"color\""},
      {light(R"({"kind": "point", "position": [0, 0, 0], "intensity": -1})"), "lights[0]: its intensity"},
      {light(R"({"kind": "point", "position": [0, 0, 0], "intensity": "9"})"), "lights[0].intensity"},
      {light(R"({"kind": "point", "position": [0, 0, 0], "range": -1})"), "lights[0]: its range"},
      {light(R"({"kind": "point", "position": [0, 0, 0], "colour": [0, -1, 0]})"), "lights[0]: its colour"},
      {light(R"({"kind": "directional", "direction": [0, 0, 0]})"), "lights[0].direction"},
      {light(R"({"kind": "directional", "direction": [0, 1, 0], "position": [0, 0, 0]})"), "\"position\""},
      {light("{" + spot + R"(, "outer_deg": 91})"), "lights[0]: its cone"},
      {light("{" + spot + R"(, "inner_deg": 50})"), "lights[0]: its cone"},
      {light("{" + spot + R"(, "inner_deg": -1})"), "lights[0]: its cone"},
      {light("{" + spot + R"(, "inner_deg": 1, "inner_rad": 1})"), "inner is given"},
      {light("{" + spot + "}, {" + spot + R"(, "outer_deg": true})"), "lights[1].outer_deg"},
      {light("{" + spot + R"(, "shadows": 1})"), "lights[0].shadows: is neither true nor false"},
      {light("{" + spot + R"(, "shadows": "true"})"), "lights[0].shadows"},
      {light("{" + spot + R"(, "shadows": null})"), "lights[0].shadows"},
      {"{\"about\":" + std::string(100000, '[') + std::string(100000, ']') + "}", "nested"},
  };
  for (const auto& [text, place] : broken) {
    const std::string said = complaint(text);
    EXPECT_NE(said.find(place), std::string::npos) << text.substr(0, 200) << "\n: \"" << said << "\" lacks " << place;
  }
  EXPECT_THROW(scene::load("bare", "/no/such.lights.json"), std::runtime_error);
  EXPECT_EQ(complaint(light("{" + spot + "}")), "");
}

TEST(Sidecar, DecalsWithPicturesBesideTheFile) {
  const fs::path a = temporary("decal_a.png"), b = temporary("decal_b.png");
  image::write_png(a, {2, 1, {255, 0, 0, 255, 0, 255, 0, 128}});
  image::write_png(b, {1, 1, {9, 9, 9, 255}});
  const std::string name = a.filename().string();
  const Scene s = with(R"({"decals": [
    {"position": [1, 2, 3], "outward": [0, 3, 0], "up": [1, 0, 0], "half_extents": [0.5, 0.25, 0.1],
     "colour_image": ")" +
                       name + R"(", "normal_image": ")" + name + R"(", "weights": [1, 0.5, 0.25],
     "fade_distance": 9, "normal_mode": "reoriented", "receiver": 0},
    {"position": [0, 0, 0], "outward": [0, 0, 1], "half_extents": [1, 1, 1], "colour": [0.25, 0.5, 1],
     "coverage": 0.75, "roughness": 0.5, "roughness_image": ")" +
                       b.filename().string() + R"("}]})");
  ASSERT_EQ(s.decals.size(), 2u);
  EXPECT_TRUE(s.lights.empty());
  const scene::Decal &d = s.decals[0], &e = s.decals[1];
  EXPECT_EQ(d.centre, glm::dvec3(1, 2, 3));
  const glm::dmat3 axes = mat3_cast(d.orientation);
  EXPECT_NEAR(length(axes[2] - glm::dvec3(0, 1, 0)), 0, 1e-12);
  EXPECT_NEAR(length(axes[1] - glm::dvec3(1, 0, 0)), 0, 1e-12);
  EXPECT_EQ(d.colour_image, d.normal_image) << "one file is one image";
  EXPECT_EQ(s.images.at(d.colour_image).rgba[6], 0);
  EXPECT_EQ(s.images.at(d.colour_image).rgba[7], 128);
  EXPECT_EQ(d.weights, glm::vec3(1, 0.5f, 0.25f));
  EXPECT_EQ(d.fade_distance, 9);
  EXPECT_EQ(d.normal_mode, kNormalReoriented);
  EXPECT_EQ(d.receiver, 0u);
  EXPECT_EQ(e.colour, glm::vec4(0.25f, 0.5f, 1, 0.75f));
  EXPECT_EQ(e.weights, glm::vec3(1, 0, 0));
  EXPECT_EQ(e.receiver, scene::kNone);
  ASSERT_EQ(s.notes.size(), 1u);
  EXPECT_NE(s.notes[0].find("2 decals"), std::string::npos);
  const std::string unequal = complaint(R"({"decals": [{"position": [0, 0, 0], "outward": [0, 0, 1],
    "half_extents": [1, 1, 1], "colour_image": ")" +
                                        name + R"(", "normal_image": ")" + b.filename().string() + "\"}]}");
  EXPECT_NE(unequal.find("decals[0]: its pictures are 2x1 and 1x1 texels"), std::string::npos) << unequal;
  fs::remove(a), fs::remove(b);
}

TEST(Sidecar, ParticlesOfEitherKind) {
  const Scene s = with(R"({"particles": [
    {"kind": "smoke", "position": [1, 2, 3], "count": 5, "radius": 0.5, "height": 3, "opacity": 0.25},
    {"kind": "dust", "position": [0, 1, 0], "half_extents": [2, 1, 2], "count": 7, "colour": [0.5, 0.25, 1]}]})");
  ASSERT_EQ(s.particles.size(), 12u);
  EXPECT_GT(s.particles[0].velocity.y, 0) << "smoke rises";
  EXPECT_EQ(s.particles[0].opacity, 0.25f);
  EXPECT_EQ(s.particles[5].albedo, glm::vec3(0.5f, 0.25f, 1));
  const auto refused = [](const std::string& emitter) { return complaint(R"({"particles": [)" + emitter + "]}"); };
  EXPECT_NE(refused(R"({"position": [0, 0, 0]})").find("particles[0]: kind is missing"), std::string::npos);
  EXPECT_NE(refused(R"({"kind": "rain", "position": [0, 0, 0]})").find("is not smoke or dust"), std::string::npos);
  EXPECT_NE(refused(R"({"kind": "smoke"})").find("position"), std::string::npos);
  EXPECT_NE(refused(R"({"kind": "dust", "position": [0, 0, 0], "height": 2})").find("has no member \"height\""),
            std::string::npos);
  EXPECT_NE(refused(R"({"kind": "dust", "position": [0, 0, 0], "count": -1})").find("no whole number"),
            std::string::npos);
  EXPECT_NE(refused(R"({"kind": "dust", "position": [0, 0, 0], "opacity": 2})").find("opacity"), std::string::npos);
}

TEST(Sidecar, EveryTruncationIsRefused) {
  const std::string whole = R"({"lights": [{"kind": "point", "position": [1, 2, 3], "intensity": 1.5}]})";
  ASSERT_EQ(complaint(whole), "");
  for (size_t size = 0; size < whole.size(); ++size) EXPECT_NE(complaint(whole.substr(0, size)), "") << size;
}

TEST(Sidecar, TheNeighbourIsFoundUnlessAnotherIsNamed) {
  const std::string one = R"({"lights": [{"kind": "point", "position": [1, 2, 3]}]})";
  const TemporaryFile glb("quad.glb", bytes_of(quad())), beside("quad.lights.json", one),
      other("other.json", R"({"lights": []})");
  EXPECT_EQ(scene::load(glb.path.string()).lights.size(), 2u);  // the file's own spot comes first
  EXPECT_EQ(scene::load(glb.path.string()).lights[1].kind, LightKind::point);
  EXPECT_EQ(scene::load(glb.path.string(), other.path).lights.size(), 1u);
  fs::remove(beside.path);
  EXPECT_EQ(scene::load(glb.path.string()).lights.size(), 1u);
}

// Tests run in the source folder, where the fixture is.
TEST(Sidecar, SponzasLightsHitTheAtrium) {
  const fs::path fixture = "fixtures/scenes/sponza.lights.json";
  if (!fs::exists(fixture)) GTEST_SKIP() << "no " << fixture;
  const Scene alone = scene::load("bare", fixture);
  ASSERT_EQ(alone.lights.size(), 21u);
  for (const scene::Light& l : alone.lights) EXPECT_TRUE(l.casts_shadows);
  for (size_t i = 1; i < alone.lights.size(); ++i) {
    const scene::Light& l = alone.lights[i];
    EXPECT_EQ(l.kind, LightKind::spot);
    EXPECT_EQ(l.range, 7.5f);
    EXPECT_LE(std::abs(l.position.x), 14);  // the walls
    EXPECT_LE(std::abs(l.position.z + 0.36), 5.8);
    EXPECT_LE(l.position.y, 12.6);
  }
}

}  // namespace
}  // namespace assay::tests
