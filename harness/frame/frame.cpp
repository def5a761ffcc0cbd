#include "harness/frame/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <stdexcept>

#include "harness/clusters.h"
#include "harness/formats/cluster_lists.h"
#include "harness/formats/debug_view.h"
#include "harness/formats/exposure.h"
#include "harness/frame/downloads.h"
#include "harness/frame/hazards.h"
#include "harness/frame/legend.h"
#include "harness/frame/record.h"
#include "harness/frame/views.h"

namespace assay::frame {

namespace {

constexpr const char* kListStatus = "cluster_lists.list_status";
// The picture before it is exposed, the one that is shown first.
constexpr const char* kRadiance[] = {"particles.radiance", "vrcs_deblock.deblocked_radiance",
                                     "vrcs_deblock.radiance_in_place", "deferred_lighting.radiance"};
constexpr const char* kLuma = "vrcs_deblock.luma";
constexpr const char* kBlendedLuma = "blended_luma.luma";  // the same image, after particles
constexpr const char* kParticleRects = "particle_rects.rects";
constexpr const char* kExposure = "resolve.exposure";
// Beside the goals: what legends, statistics and layers are made of.
constexpr const char* kDownloads[] = {"visibility.visibility",
                                      "visibility.depth",
                                      "tile_classification.masks",
                                      kRadiance[0],
                                      kRadiance[1],
                                      kRadiance[2],
                                      kRadiance[3],
                                      kParticleRects,
                                      kLuma,
                                      kRates,
                                      kTiles,
                                      kCopyBits,
                                      kExposure,
                                      kCommandStatus,
                                      kListStatus,
                                      kClusterCells};
constexpr uint32_t kLargestSide = 16384;  // that every Vulkan 1.3 device renders to, lavapipe included

struct Prepared {
  scene::Gathered gathered;
  std::map<std::string, uint64_t> scene_bytes;
  const View* view = nullptr;
  Graph graph;
};

bool varies(const Options& options) { return options.vrcs != "off"; }

// Blended surfaces change it, where there are some and kernels that draw them.
const char* luma_of(const scene::Gathered& gathered) {
  const bool drawn = !gathered.particle_order.empty() && in_registry(kRadiance[0]) &&
                     in_registry("particle_light_atlas.atlas") && in_registry(kBlendedLuma);
  return drawn ? kBlendedLuma : kLuma;
}

std::vector<std::string> goals_of(const Options& options, const View& view, const scene::Gathered& gathered) {
  if (!options.goals.empty()) return options.goals;
  std::vector<std::string> goals;
  if (varies(options)) goals.push_back(kTiles);
  goals.emplace_back(view.image);
  for (const char* statistics : {kStatistics, kWorkloadCounts})
    if (in_registry(statistics)) goals.push_back(statistics);
  if (varies(options) && view.debug == kViewCount) goals.emplace_back(luma_of(gathered));
  return goals;
}

void require_size(Extent e) {
  if (e.width == 0 || e.height == 0 || e.width > kLargestSide || e.height > kLargestSide)
    throw std::invalid_argument(
        fmt::format("a frame of {}x{} pixels cannot be drawn; a side has 1 to {}", e.width, e.height, kLargestSide));
}

void require_clusters(const std::string& clusters) {
  if (clusters != "none" && clusters != "coarse" && clusters != "fine")
    throw std::invalid_argument(fmt::format("no clusters '{}'; there are none, coarse, fine", clusters));
}

void require_vrcs(const Options& o) {
  if (o.vrcs != "off" && o.vrcs != "on" && o.vrcs != "deblocked")
    throw std::invalid_argument(fmt::format("no variable rates '{}'; there are off, on, deblocked", o.vrcs));
  if (!(o.vrcs_tolerance >= 0))
    throw std::invalid_argument(fmt::format("a tolerance of {} is none; it is 0 or more", o.vrcs_tolerance));
  if (!(o.vrcs_resolution >= 0 && o.vrcs_resolution <= 1))
    throw std::invalid_argument(fmt::format(
        "a resolution of {} is none; it is a share of the display's height, above 0 and at most 1", o.vrcs_resolution));
}

void require_ranges(const Graph& g, const device::Info& info) {
  for (const Resource& r : g.resources)
    if (r.port->kind == PortKind::buffer && r.bytes + device::kGuardBytes > info.max_buffer_range)
      throw std::invalid_argument(
          fmt::format("{} needs {} bytes, and {} binds {} at most: ask for a smaller picture or scene", r.name, r.bytes,
                      info.name, info.max_buffer_range));
}

// Without lights or clusters no light is looked up in cells, and the passes that fill them are not needed. Decals
// without clusters are all of the view's, as the bits of its only cell. Rates that vary need luma, whoever deblocks.
std::map<std::string, std::string> variants_of(const Options& options, const scene::Gathered& gathered) {
  std::map<std::string, std::string> variants = options.variants;
  const bool by_all = gathered.lights.empty() || options.clusters == "none";
  const std::string shadowed = gathered.shadow_counts.views > 0 ? "_shadowed" : "";
  variants.try_emplace("deferred_lighting",
                       (by_all ? "plain" : "clustered") + std::string(varies(options) ? "_tile_list" : "") + shadowed);
  if (in_registry("particle_light_atlas.direction"))
    variants.try_emplace("particle_light_atlas", (by_all ? "all_lights" : "r11g11b10f") + shadowed);
  if (options.clusters == "none")
    variants.try_emplace("decal_atlas_sampling", "bitfield");
  else if (varies(options))
    variants.try_emplace("decal_atlas_sampling", "tiles_primaries");
  if (options.vrcs == "on" && in_registry(kLuma)) variants.try_emplace("vrcs_deblock", "luma_alone");
  return variants;
}

void append_clusters(const scene::Camera& camera, const Options& o, scene::Gathered& to) {
  if (o.clusters == "none") return scene::append_clusters(camera, o.size, o.size, 1, to);
  const Extent cell = o.clusters == "fine" ? fine_cell(o.size) : coarse_cell(o.size);
  scene::append_clusters(camera, o.size, cell, scene::kClusterSlices, to);
}

// Of a picture of another size nothing is left.
FrameHistory usable(const FrameHistory& history, Extent size) {
  return history.extent.width == size.width && history.extent.height == size.height ? history : FrameHistory{};
}

Prepared prepare(const device::Info& info, const scene::Scene& scene, const scene::Camera& camera,
                 const Options& options) {
  require(options);
  Prepared p = {.view = &view_named(options.view)};
  const FrameHistory history = usable(options.history, options.size);
  const scene::ShadowRequest shadows = {
      .before = history.shadow_still.empty() ? scene::ShadowCache{} : options.shadow_cache,
      .frame = options.frame,
      .sliced = options.shadow_slices};
  p.gathered =
      scene::gather(scene, camera, options.size, options.shadows && in_registry(kShadowDepth) ? &shadows : nullptr);
  append_clusters(camera, options, p.gathered);
  p.scene_bytes = scene_bytes(p.gathered);
  p.graph = build_graph({.kernels = all_kernels(),
                         .view = {.extent = options.size,
                                  .scene = p.gathered.counts,
                                  .decals = p.gathered.decal_counts,
                                  .shadows = p.gathered.shadow_counts,
                                  .particles = {static_cast<uint32_t>(p.gathered.particles.size()),
                                                static_cast<uint32_t>(p.gathered.particle_order.size())},
                                  .shaders = p.gathered.shaders,
                                  .rays = p.gathered.rays,
                                  .grid = p.gathered.grid,
                                  .near_plane = static_cast<float>(camera.near_plane),
                                  .exposure_stops = options.exposure_stops,
                                  .frame = options.frame,
                                  .vrcs = varies(options),
                                  .vrcs_tolerance = options.vrcs_tolerance,
                                  .vrcs_resolution = options.vrcs_resolution,
                                  .vrcs_border = options.vrcs_border,
                                  .history = history,
                                  .view = p.view->debug},
                         .scene = p.scene_bytes,
                         .variants = variants_of(options, p.gathered),
                         .goals = goals_of(options, *p.view, p.gathered),
                         .device = &info});
  require_ranges(p.graph, info);
  return p;
}

std::map<std::string, Bytes> download(device::Device& d, const Graph& graph, const Allocated& allocated,
                                      bool with_shadows) {
  std::vector<std::string> names = graph.goals;
  names.insert(names.end(), std::begin(kDownloads), std::end(kDownloads));
  if (with_shadows) names.insert(names.end(), {kShadowStill, kShadowDepth});
  std::map<std::string, Bytes> downloads;
  for (const std::string& name : names)
    if (const size_t at = resource_named(graph, name); at != kNobody && !downloads.contains(name))
      downloads[name] = device::read(d, *allocated.resources[at]);
  return downloads;
}

void show(Result& r, const Prepared& p, const scene::Scene& scene) {
  const auto picture = r.downloads.find(p.view->image);
  if (picture == r.downloads.end()) return;
  r.image = {r.size.width, r.size.height, std::vector<uint8_t>(picture->second.size())};
  std::memcpy(r.image.texels.data(), picture->second.data(), picture->second.size());
  const size_t maker = p.graph.resources[resource_named(p.graph, p.view->image)].producer;
  r.legend = legend_of(r, scene, p.gathered, p.graph.nodes[maker].input, p.view->debug);
}

template <class T>
std::vector<T> values_of(const Result& r, const std::string& name) {
  if (!r.downloads.contains(name)) throw std::invalid_argument("the frame holds no " + name);
  return frame::values_of<T>(r.downloads, name);
}

// What found no room in the lists of cells is missing from the picture.
void note_dropped(Result& r) {
  if (!r.downloads.contains(kListStatus)) return;
  const ClusterListStatus status = values_of<ClusterListStatus>(r, kListStatus).at(0);
  if (const uint64_t dropped = uint64_t{status.dropped_lights} + status.dropped_decals + status.dropped_probes)
    r.notes.push_back(fmt::format("{} items of cells found no room in their lists and are missing", dropped));
}

void add_radiance(image::Layers& layers, const Bytes& halves) {
  for (size_t channel = 0; channel < 3; ++channel) {
    std::vector<float> values(halves.size() / 8);
    for (size_t i = 0; i < values.size(); ++i) {
      uint16_t half;
      std::memcpy(&half, &halves[i * 8 + channel * 2], sizeof(half));
      values[i] = glm::unpackHalf1x16(half);
    }
    layers.channels.push_back({std::string("radiance.") + "RGB" [channel], image::Sample::half, std::move(values), {}});
  }
}

}  // namespace

void require(const Options& o) {
  require_size(o.size);
  require_clusters(o.clusters);
  require_vrcs(o);
  if (const View& view = view_named(o.view); view.of_rates && !varies(o))
    throw std::invalid_argument(
        fmt::format("the view {} is of rates that vary: ask for --vrcs on or deblocked", view.name));
}

Result render(device::Device& d, const scene::Scene& scene, const scene::Camera& camera, const Options& options) {
  constexpr uint64_t kSteps = 6;
  uint64_t done = 0;
  const auto step = [&](const char* what) {
    if (options.progress) options.progress(what, done, kSteps);
    ++done;
  };
  step("gathering the scene");
  const Prepared p = prepare(device::info(d), scene, camera, options);
  step("uploading");
  const Allocated allocated = allocate(d, p.graph, p.gathered);
  step("recording");
  const auto commands = record(d, p.graph, allocated);
  require_no_hazards(commands);
  step("warming up");
  if (options.warm_up) {
    double busy_ns = 0;
    do busy_ns += device::run(d, commands).wall_ns;
    while (busy_ns < device::warm_up_ns(device::info(d)));
  }
  step("drawing");
  const device::Timing timing = device::run(d, commands);
  step("reading back");

  Result r = {.size = options.size};
  r.title = fmt::format("{}, {}x{}, {}", scene.name, options.size.width, options.size.height, options.view);
  r.passes = pass_times(commands, timing);
  r.gpu_ns = timing.stamps.empty() ? 0 : timing.stamps.back().time_ns;
  r.cpu_ns = timing.cpu_ns;
  r.explanation = explain(p.graph, p.scene_bytes);
  r.memory = memory_rows(r.explanation, r.size);
  r.notes = scene.notes;
  r.notes.insert(r.notes.end(), p.gathered.notes.begin(), p.gathered.notes.end());
  r.downloads = download(d, p.graph, allocated, options.keep_shadows);
  r.shadows = p.gathered.shadow_statistics;
  r.shadow_cache = p.gathered.shadow_cache;
  note_dropped(r);
  r.statistics = pass_shares(r.downloads);
  r.vrcs = vrcs_shares(r.downloads, r.size);
  show(r, p, scene);
  return r;
}

FrameHistory history_of(const Result& r, const Options& drawn) {
  FrameHistory next = {.extent = r.size};
  const auto luma = r.downloads.find(kLuma);
  if (usable(drawn.history, r.size).exposure > 0 && luma != r.downloads.end()) next.luma = luma->second;
  if (const auto rects = r.downloads.find(kParticleRects); rects != r.downloads.end())
    next.particle_rects = rects->second;
  if (r.downloads.contains(kExposure)) next.exposure = values_of<ExposureRecord>(r, kExposure).at(0).exposure;
  for (const auto& [name, to] :
       {std::pair(kShadowStill, &next.shadow_still), std::pair(kShadowDepth, &next.shadow_depth)})
    if (const auto it = r.downloads.find(name); it != r.downloads.end()) *to = it->second;
  return next;
}

Explanation explain(const device::Info& info, const scene::Scene& scene, const scene::Camera& camera,
                    const Options& options) {
  const Prepared p = prepare(info, scene, camera, options);
  return explain(p.graph, p.scene_bytes);
}

void write_exr(const std::filesystem::path& path, const Result& r) {
  image::Layers layers = {r.size.width, r.size.height, {}};
  std::vector<uint32_t> triangle, surface;
  for (const uvec2 v : values_of<uvec2>(r, "visibility.visibility")) {
    triangle.push_back(v.x);
    surface.push_back(v.y);
  }
  layers.channels.push_back({"depth.Z", image::Sample::float32, values_of<float>(r, "visibility.depth"), {}});
  layers.channels.push_back({"visibility.surface", image::Sample::uint32, {}, std::move(surface)});
  layers.channels.push_back({"visibility.triangle", image::Sample::uint32, {}, std::move(triangle)});
  const auto* shown = std::ranges::find_if(kRadiance, [&](const char* name) { return r.downloads.contains(name); });
  if (shown != std::end(kRadiance)) add_radiance(layers, r.downloads.at(*shown));
  image::write_exr(path, layers);
}

void write_png(const std::filesystem::path& path, const Result& r) {
  image::write_png(path, image::with_legend(r.image, r.title, r.legend));
}

std::string times_to_text(const Result& r) {
  size_t kernel = 0, pass = 0;
  for (const PassTime& t : r.passes) kernel = std::max(kernel, t.kernel.size()), pass = std::max(pass, t.pass.size());
  std::string text;
  for (const PassTime& t : r.passes)
    text += fmt::format("{:<{}}  {:<{}}  {:9.3f} ms  {:4.1f}%\n", t.kernel, kernel,
                        t.commands > 1 ? fmt::format("{} x{}", t.pass, t.commands) : t.pass, pass + 3, t.time_ns / 1e6,
                        r.gpu_ns > 0 ? 100 * t.time_ns / r.gpu_ns : 0.0);
  return text + fmt::format("{:<{}}  {:<{}}  {:9.3f} ms\n", "all", kernel, "", pass + 3, r.gpu_ns / 1e6);
}

nlohmann::json to_json(const scene::ShadowStatistics& s) {
  return {{"lights", s.lights},
          {"views", s.views},
          {"still_drawn", s.still_drawn},
          {"composed", s.composed},
          {"put_off", s.put_off}};
}

std::string to_text(const scene::ShadowStatistics& s) {
  if (s.views == 0) return {};
  return fmt::format("shadows: {} lights, {} tiles, of {} still things drawn, {} composed, {} put off\n", s.lights,
                     s.views, s.still_drawn, s.composed, s.put_off);
}

nlohmann::json to_json(const Result& r) {
  nlohmann::json passes = nlohmann::json::array(), legend = nlohmann::json::array();
  for (const PassTime& t : r.passes)
    passes.push_back({{"kernel", t.kernel}, {"pass", t.pass}, {"commands", t.commands}, {"time_ns", t.time_ns}});
  for (const image::LegendRow& row : r.legend)
    legend.push_back({{"colour", fmt::format("#{:02x}{:02x}{:02x}", row.r, row.g, row.b)}, {"text", row.text}});
  return {{"title", r.title},           {"width", r.size.width},
          {"height", r.size.height},    {"passes", passes},
          {"gpu_ns", r.gpu_ns},         {"cpu_ns", r.cpu_ns},
          {"legend", legend},           {"statistics", to_json(r.statistics)},
          {"notes", r.notes},           {"explanation", to_json(r.explanation)},
          {"vrcs", to_json(r.vrcs)},    {"shadows", to_json(r.shadows)},
          {"memory", to_json(r.memory)}};
}

}  // namespace assay::frame
