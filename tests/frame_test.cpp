// The frame on the device: what passes between kernels, what a scene needs and what it does not, and every odd size.
#include "harness/frame/frame.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "harness/formats/debug_view.h"
#include "harness/formats/visibility.h"
#include "harness/formats/workloads.h"
#include "harness/frame/graph.h"
#include "harness/frame/resources.h"
#include "tests/drawn.h"

namespace assay::tests {
namespace {

using frame::Options;
using frame::Result;

// Views of rates are of rates that vary.
Options in_view(Extent size, const std::string& view) {
  const bool of_rates = view == "rate" || view == "primary";
  return {.size = size, .view = view, .vrcs = of_rates ? "on" : "off", .warm_up = false};
}
Result draw_at(const scene::Scene& s, Extent size, const std::string& view = "material") {
  return draw(s, in_view(size, view));
}

scene::Camera looking_away(const scene::Scene& s) {
  scene::Camera camera = scene::default_camera(s);
  const scene::Bounds box = scene::bounds_of(s);
  camera.eye = box.highest + (box.highest - box.lowest) * 10.0 + 10.0;
  const glm::dvec3 away = camera.eye + (camera.eye - box.lowest);
  return scene::look_at(camera.eye, away, camera.vertical_fov_rad);
}

// Every opaque surface of a scene, the masked ones dropped.
scene::Scene without_masked(scene::Scene s) {
  for (scene::Mesh& m : s.meshes)
    std::erase_if(m.parts,
                  [&](const scene::Part& p) { return s.materials[p.material].alpha == scene::AlphaMode::masked; });
  return s;
}

const frame::ResourceNote* resource(const frame::Explanation& e, const std::string& name) {
  const auto it = std::ranges::find(e.resources, name, &frame::ResourceNote::name);
  return it == e.resources.end() ? nullptr : &*it;
}
std::vector<std::string> running(const frame::Explanation& e) {
  std::vector<std::string> passes;
  for (const frame::PassNote& p : e.passes)
    if (p.runs) passes.push_back(p.kernel + " " + p.pass);
  return passes;
}
bool mentions(const std::vector<std::string>& passes, const std::string& text) {
  return std::ranges::any_of(passes, [&](const std::string& p) { return p.find(text) != std::string::npos; });
}

// ---- What passes between the kernels
// -----------------------------------------------------------------------------------

// A kernel's oracle over what its producers really wrote.
void expect_as_by_oracle(const frame::Graph& graph, const Result& r, const scene::Gathered& gathered,
                         const std::string& name) {
  const auto node = std::ranges::find_if(graph.nodes, [&](const frame::Node& n) { return n.kernel->name == name; });
  ASSERT_NE(node, graph.nodes.end()) << name;
  Case c = node->input;
  c.device = device::info(*device()).traits;
  for (const frame::Bound& b : node->ports) {
    if (b.port->use == Use::writes || c.inputs.contains(b.port->name)) continue;
    const std::string& source = graph.resources[b.resource].name;
    if (source == "scene.surfaces")
      c.set_input(b.port->name, gathered.surfaces);
    else if (source == "scene.materials")
      c.set_input(b.port->name, gathered.materials);
    else if (source == "scene.surface_slots")
      c.set_input(b.port->name, gathered.surface_slots);
    else
      c.inputs[b.port->name] = r.downloads.at(source);
  }
  for (const auto& [port, expected] : node->kernel->oracle(c)) {
    auto want = words<uint32_t>(expected.low), got = words<uint32_t>(r.downloads.at(fmt::format("{}.{}", name, port)));
    if (!expected.live) {
      EXPECT_EQ(want == got, true) << name << "." << port;
      continue;
    }
    for (const auto& run : *expected.live) {  // lists whose order is free
      std::vector<uint32_t> live(got.begin() + static_cast<ptrdiff_t>(run.first),
                                 got.begin() + static_cast<ptrdiff_t>(run.first + run.count));
      std::vector<uint32_t> listed(want.begin(), want.begin() + static_cast<ptrdiff_t>(run.count));
      want.erase(want.begin(), want.begin() + static_cast<ptrdiff_t>(run.count));
      std::ranges::sort(live), std::ranges::sort(listed);
      EXPECT_EQ(live == listed, true) << name << "." << port << " run at " << run.first;
    }
  }
}

TEST(Frame, EveryKernelAgreesWithItsOracleOverWhatTheOthersWrote) {
  const scene::Scene s = scene::small();
  const Extent size = {323, 201};
  const auto gathered = scene::gather(s, scene::default_camera(s), size);
  const std::vector<std::string> goals = {"debug_view.image",
                                          "material_features.features",
                                          "deferred_texturing.features",
                                          "tile_classification.masks",
                                          "tile_classification.workload_tiles",
                                          "tile_classification.workload_counts",
                                          "tile_classification.workload_args",
                                          "tile_classification.statistics",
                                          "visibility.visibility"};
  const std::pair<const char*, uint32_t> views[] = {{"material", kViewMaterial},
                                                    {"triangle", kViewTriangle},
                                                    {"tile", kViewTile},
                                                    {"workload", kViewWorkload},
                                                    {"shader", kViewShader}};
  for (const auto& [name, view] : views) {
    SCOPED_TRACE(name);
    const Result r = draw(s, {.size = size, .view = name, .goals = goals, .warm_up = false});
    const auto graph = frame::build_graph(
        {.kernels = all_kernels(),
         .view = {.extent = size, .scene = gathered.counts, .shaders = gathered.shaders, .view = view},
         .scene = frame::scene_bytes(gathered),
         .goals = goals});
    for (const char* kernel : {"material_features", "tile_classification", "debug_view"})
      expect_as_by_oracle(graph, r, gathered, kernel);
  }
}

TEST(Frame, TheDepthPyramidIsOfTheDepthThatWasDrawn) {
  const scene::Scene s = scene::small();
  const Extent size = {323, 201};
  const auto gathered = scene::gather(s, scene::default_camera(s), size);
  const std::vector<std::string> goals = {"hi_z.ranges"};
  const Result r = draw(s, {.size = size, .goals = goals, .warm_up = false});
  const auto graph =
      frame::build_graph({.kernels = all_kernels(),
                          .view = {.extent = size, .scene = gathered.counts, .shaders = gathered.shaders},
                          .scene = frame::scene_bytes(gathered),
                          .goals = goals});
  expect_as_by_oracle(graph, r, gathered, "hi_z");
}

TEST(Frame, EveryVariantDrawsTheSamePicture) {
  const scene::Scene s = scene::small();
  const Result usual = draw_at(s, {200, 150}, "workload");
  for (const char* kernel : {"visibility", "material_features", "tile_classification", "debug_view"})
    for (const Variant& v : kernel_named(kernel).variants) {
      if (!device::missing(device::info(*device()), v).empty()) continue;
      const Result r =
          draw(s, {.size = {200, 150}, .view = "workload", .variants = {{kernel, v.name}}, .warm_up = false});
      EXPECT_EQ(r.image.texels == usual.image.texels, true) << kernel << "." << v.name;
    }
}

// ---- Sizes and empty views
// ---------------------------------------------------------------------------------------------

TEST(Frame, EverySizeInEveryView) {
  const scene::Scene s = scene::small();
  for (const Extent size : {Extent{1, 1}, {1, 200}, {31, 33}, {32, 32}, {33, 65}, {257, 129}})
    for (const std::string& view : frame::view_names()) {
      SCOPED_TRACE(testing::Message() << size.width << "x" << size.height << " " << view);
      const Result r = draw_at(s, size, view);
      EXPECT_EQ(r.image.texels.size(), pixel_count(size) * 4);
      EXPECT_FALSE(r.legend.empty());
      for (size_t i = 3; i < r.image.texels.size(); i += 4) ASSERT_EQ(r.image.texels[i], 255);
    }
}

TEST(Frame, UltraHighDefinition) {
  const Result r = draw_at(scene::bare(), {3840, 2160}, "workload");
  const auto visibility = words<uvec2>(r.downloads.at("visibility.visibility"));
  const auto covered = std::ranges::count_if(visibility, [](uvec2 v) { return v.x == 0 && v.y == 0; });
  const auto background = std::ranges::count(visibility, uvec2(kVisibilityNone));
  EXPECT_GT(covered, 0);
  EXPECT_EQ(covered + background, 3840 * 2160);
  EXPECT_EQ(r.statistics.back().theoretical % 8160, 0u);  // 120 x 68 tiles
}

TEST(Frame, ACameraThatLooksAwaySeesNothing) {
  const scene::Scene s = scene::small();
  for (const std::string& view : frame::view_names()) {
    if (view == "shadows") {  // no light reaches the view, so there is no atlas
      EXPECT_THROW(frame::render(*device(), s, looking_away(s), in_view({100, 70}, view)), std::invalid_argument);
      continue;
    }
    const Result r = frame::render(*device(), s, looking_away(s), in_view({100, 70}, view));
    for (const uvec2 v : words<uvec2>(r.downloads.at("visibility.visibility"))) ASSERT_EQ(v, uvec2(kVisibilityNone));
    for (const float z : words<float>(r.downloads.at("visibility.depth"))) ASSERT_EQ(z, 0.0f);
    for (const uint32_t mask : words<uint32_t>(r.downloads.at("tile_classification.masks"))) ASSERT_EQ(mask, 0u);
    for (const auto& pass : r.statistics) EXPECT_EQ(pass.dispatched, 0u) << pass.name;
    EXPECT_FALSE(mentions(running(r.explanation), "draw ")) << "nothing is in view, and something is drawn";
  }
}

// ---- Only what the scene needs
// -----------------------------------------------------------------------------------------

TEST(Frame, BareNeedsNoMaskedPassAndNoTextures) {
  const Result r = draw(scene::bare(), {.size = {64, 64}, .view = "material", .goals = {"debug_view.image"}});
  const auto passes = running(r.explanation);
  EXPECT_TRUE(mentions(passes, "draw opaque.vert opaque.frag"));
  EXPECT_FALSE(mentions(passes, "masked"));
  for (const char* name : {"scene.textures", "scene.attributes"}) {
    ASSERT_NE(resource(r.explanation, name), nullptr) << name;
    EXPECT_EQ(resource(r.explanation, name)->bytes, 0u) << name;
    EXPECT_EQ(resource(r.explanation, name)->note, "left out: no pass that runs reads it") << name;
  }
}

TEST(Frame, RemovingMaskedMaterialsRemovesTheirPassesAndBytes) {
  const scene::Scene with = scene::small(), without = without_masked(with);
  const Options options = {.size = {320, 200}, .view = "material", .goals = {"debug_view.image"}};
  const auto info = device::info(*device());
  const auto full = frame::explain(info, with, scene::default_camera(with), options);
  const auto bare = frame::explain(info, without, scene::default_camera(with), options);
  EXPECT_TRUE(mentions(running(full), "masked.frag"));
  EXPECT_FALSE(mentions(running(bare), "masked.frag"));
  for (const char* name : {"scene.textures", "scene.attributes"}) {
    EXPECT_GT(resource(full, name)->bytes, 0u) << name;
    EXPECT_EQ(resource(bare, name)->bytes, 0u) << name;
  }
  EXPECT_LT(frame::total_bytes(bare), frame::total_bytes(full));
  EXPECT_LT(running(bare).size(), running(full).size());
}

// Without a decal in view none of it is there: no pass, no atlas, no gradients, no record, no bits.
TEST(Frame, RemovingDecalsRemovesTheirPassesAndBytes) {
  scene::Scene with = scene::small();
  for (scene::Light& l : with.lights) l.casts_shadows = false;  // they ask for gradients too
  scene::Scene without = with, elsewhere = with;
  without.decals.clear();
  for (scene::Decal& d : elsewhere.decals) d.centre += glm::dvec3(0, 0, 1e4), d.receiver = scene::kNone;
  const auto info = device::info(*device());
  for (const std::string clusters : {"none", "coarse"}) {
    SCOPED_TRACE(clusters);
    const auto explained = [&](const scene::Scene& s) {
      return frame::explain(info, s, scene::default_camera(with), {.size = {320, 200}, .clusters = clusters});
    };
    const auto full = explained(with), bare = explained(without);
    for (const char* kernel : {"decal_atlas_sampling", "depth_gradients"}) {
      EXPECT_TRUE(mentions(running(full), kernel)) << kernel;
      EXPECT_FALSE(mentions(running(bare), kernel)) << kernel;
    }
    EXPECT_EQ(mentions(running(bare), "cluster_voxelization"), clusters != "none");
    EXPECT_EQ(mentions(running(full), "decal_tiles"), clusters != "none");
    EXPECT_FALSE(mentions(running(bare), "decal_tiles"));
    for (const frame::ResourceNote& r : bare.resources) {
      const bool is_decals = r.name.find("decal") != std::string::npos || r.name.find("gradients") != std::string::npos;
      EXPECT_TRUE(!is_decals || r.bytes == 0) << r.name;
    }
    for (const char* name : {"scene.decals", "scene.decal_atlas", "scene.receivers", "depth_gradients.gradients"}) {
      ASSERT_NE(resource(full, name), nullptr) << name;
      EXPECT_GT(resource(full, name)->bytes, 0u) << name;
    }
    EXPECT_LT(frame::total_bytes(bare), frame::total_bytes(full));
    EXPECT_EQ(frame::total_bytes(explained(elsewhere)), frame::total_bytes(bare));
  }
}

TEST(Frame, WorkloadPassesRunOnlyForTheirView) {
  const scene::Scene s = scene::small();
  EXPECT_FALSE(mentions(running(draw_at(s, {64, 64}, "material").explanation), "workload.comp"));
  EXPECT_TRUE(mentions(running(draw_at(s, {64, 64}, "workload").explanation), "workload.comp"));
}

TEST(Frame, OnlyViewsOfTilesNeedTheirClassification) {
  const scene::Scene s = scene::small();
  const auto info = device::info(*device());
  for (const std::string view : {"material", "triangle", "tile"}) {
    const auto e = frame::explain(info, s, scene::default_camera(s),
                                  {.size = {64, 64}, .view = view, .goals = {"debug_view.image"}});
    EXPECT_EQ(mentions(running(e), "tile_classification"), view == "tile") << view;
  }
}

TEST(Frame, GoalsPruneTheChain) {
  const Result r = draw(scene::small(), {.size = {64, 64}, .goals = {"visibility.depth"}, .warm_up = false});
  for (const std::string& pass : running(r.explanation)) EXPECT_TRUE(pass.starts_with("visibility ")) << pass;
  EXPECT_EQ(resource(r.explanation, "tile_classification.masks"), nullptr);
  EXPECT_TRUE(r.statistics.empty());
  EXPECT_TRUE(r.image.texels.empty());
}

TEST(Frame, EveryRunningPassIsTimedAndEveryLeftOutOneHasAReason) {
  const Result r = draw(scene::small(), {.size = {160, 90}, .view = "workload"});
  EXPECT_GE(r.passes.size(), 5u);
  double sum = 0;
  for (const auto& p : r.passes) sum += p.time_ns;
  EXPECT_NEAR(sum, r.gpu_ns, 1e-6 * r.gpu_ns);
  for (const auto& p : r.explanation.passes) EXPECT_FALSE(p.reason.empty()) << p.kernel << " " << p.pass;
  for (const auto& x : r.explanation.resources) EXPECT_TRUE(x.bytes > 0 || !x.note.empty()) << x.name;
}

// ---- Statistics, files, refusals
// ---------------------------------------------------------------------------------------

TEST(Frame, StatisticsAddUp) {
  const Result r = draw_at(scene::small(), {640, 360}, "workload");
  ASSERT_EQ(r.statistics.size(), std::size(kFramePasses));
  for (const auto& pass : r.statistics) {
    EXPECT_EQ(pass.theoretical, pass.dispatched + pass.discarded);
    uint64_t groups = 0;
    for (const auto& w : pass.workloads) groups += w.groups;
    EXPECT_EQ(groups, pass.dispatched) << pass.name;
  }
  EXPECT_GT(r.statistics.back().dispatched, 0u);
}

TEST(Frame, StatisticsAreTextAsTheSeedPrintsIt) {
  const std::vector<frame::PassShare> passes = {
      {"deferred lighting", 65280, 61792, 3488, {{"X_DEFAULT", "RED", 774, 24768, 24768.0 / 65280}}}};
  EXPECT_EQ(frame::to_text(passes),
            "1. deferred lighting group stats\n"
            "1a. theoretical fullscreen threadgroups: 65280 (100%)\n"
            "1b. actual dispatched threadgroups: 61792 (95%)\n"
            "1c. discarded threadgroups (not dispatched): 3488 (5%)\n"
            "indirect dispatch DISPATCHWORKLOAD_X_DEFAULT (RED): 24768 threadgroups (37.9%)\n");
}

TEST(Frame, WritesPngAndExr) {
  const Result r = draw_at(scene::small(), {45, 31});
  const auto folder = std::filesystem::temp_directory_path() / "assay_frame_test";
  std::filesystem::create_directories(folder);
  frame::write_png(folder / "frame.png", r);
  frame::write_exr(folder / "frame.exr", r);
  EXPECT_GE(image::read_png(folder / "frame.png").height, 31u);
  const auto layers = image::read_exr(folder / "frame.exr");
  const auto channel = [&](const std::string& name) {
    return *std::ranges::find(layers.channels, name, &image::Channel::name);
  };
  const auto visibility = words<uvec2>(r.downloads.at("visibility.visibility"));
  const auto depth = words<float>(r.downloads.at("visibility.depth"));
  for (size_t i = 0; i < visibility.size(); ++i) {
    ASSERT_EQ(channel("visibility.triangle").integers[i], visibility[i].x);
    ASSERT_EQ(channel("visibility.surface").integers[i], visibility[i].y);
    ASSERT_EQ(channel("depth.Z").values[i], depth[i]);
  }
  std::filesystem::remove_all(folder);
}

TEST(Frame, RefusesWhatItCannotDraw) {
  const scene::Scene s = scene::bare();
  EXPECT_THROW(draw_at(s, Extent{0, 10}), std::invalid_argument);
  EXPECT_THROW(draw_at(s, Extent{10, 20000}), std::invalid_argument);
  EXPECT_THROW(draw_at(s, Extent{10, 10}, "beauty"), std::invalid_argument);
  EXPECT_THROW(draw(s, {.size = {8, 8}, .variants = {{"visibility", "plump"}}}), std::invalid_argument);
  EXPECT_THROW(draw(s, {.size = {8, 8}, .goals = {"texturing.albedo"}}), std::invalid_argument);
}

TEST(Frame, ExplanationsAreTextAndJson) {
  const auto e = draw_at(scene::bare(), {16, 16}).explanation;
  const std::string text = frame::to_text(e);
  for (const char* word : {"left out", "visibility.slim", "scene.indices", "debug_view.image"})
    EXPECT_NE(text.find(word), std::string::npos) << word;
  const auto json = frame::to_json(e);
  EXPECT_EQ(json["bytes"], frame::total_bytes(e));
  EXPECT_EQ(json["passes"].size(), e.passes.size());
}

}  // namespace
}  // namespace assay::tests
