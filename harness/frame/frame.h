// A frame: a scene and a camera in, a picture out, every pass timed. The chain of kernels is derived from their
// descriptions (graph.h); the recorded commands are checked for missing barriers (hazards.h) before they are submitted.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/device/device.h"
#include "harness/frame/explain.h"
#include "harness/frame/memory.h"
#include "harness/frame/statistics.h"
#include "harness/frame/vrcs_shares.h"
#include "harness/image/image.h"
#include "harness/scene/scene.h"

namespace assay::frame {

// What a frame can show: lit, the picture itself, and the debug views of formats/debug_view.h; those that the registry
// has kernels for. The first is the default.
const std::vector<std::string>& view_names();
std::string default_view();  // the first of them; empty where the kernels built draw none

struct Options {
  Extent size = {1280, 720};  // 1x1 to 16384x16384; what the device's buffers hold (8.4 Mpx on lavapipe)
  std::string view = default_view();
  std::map<std::string, std::string> variants =
      {};                    // kernel -> variant or label ("visibility" -> "slim"); else default
  float exposure_stops = 0;  // brighter than the automatic exposure
  // Lights by cells of 16x8x24 or of 32 pixels in 24 slices, or each pixel asks all of them.
  std::string clusters = "coarse";  // none, coarse, fine
  // Variable rates: pixels of low contrast in the picture before share what one of them is shaded; shown as it is or,
  // deblocked, averaged with its neighbours.
  std::string vrcs = "off";      // off, on, deblocked
  float vrcs_resolution = 0;     // share of the display's height, ]0, 1], that sets tolerance and foveation; 0: neither
  uint32_t vrcs_border = 0;      // pixels from a side within which twice the tolerance passes
  float vrcs_tolerance = 0.02f;  // error that is let pass, of luma 0..1; 2x2 by half of it (kernels/vrcs_shading_rate)
  bool shadows = true;           // of the lights that cast them
  bool shadow_slices = true;     // tiles of lights that are small on the screen follow what moves a few frames late
  uint32_t frame = 0;            // its number in a sequence (sequence.h)
  FrameHistory history = {};     // what the frame before left; of no use if it is of another size
  scene::ShadowCache shadow_cache = {};  // what the history's shadow atlas holds
  bool keep_shadows = false;             // read that of this frame back, for the next
  // Resources that must be computed; whatever none of them needs is left out. Empty: the picture and the statistics.
  std::vector<std::string> goals = {};
  bool warm_up = true;  // draw once before the times are taken: shaders compile at their first dispatch
  // Called as the work proceeds; `done` of `of` steps are finished when `what` begins.
  std::function<void(const std::string& what, uint64_t done, uint64_t of)> progress = {};
};

struct PassTime {
  std::string kernel;  // "tile_classification.reduce"
  std::string pass;    // "gather.comp"
  uint32_t commands = 1;
  double time_ns = 0;  // GPU; the rows of a repeated pass together
};

struct Result {
  Extent size = {};
  image::Rgba8 image;                    // without the legend
  std::string title;                     // of the legend: "bare, 1280x720, material"
  std::vector<image::LegendRow> legend;  // of what the picture shows, largest share first
  std::vector<PassTime> passes;          // in order of execution
  double gpu_ns = 0, cpu_ns = 0;         // first to last timestamp; process CPU time of the submission
  std::vector<PassShare> statistics;     // of tile classification; empty where it did not run
  VrcsShares vrcs;                       // zeros where rates do not vary
  Explanation explanation;
  std::vector<MemoryRow> memory;   // beside Lazarek and Hammer's
  std::vector<std::string> notes;  // of the loader and the gather: what was left out and why
  // What was downloaded, by resource name: the goals, and of kDownloads what the frame has.
  std::map<std::string, Bytes> downloads;
  scene::ShadowStatistics shadows = {};
  scene::ShadowCache shadow_cache = {};
};

// Throws std::invalid_argument for what no scene and no device can make right.
void require(const Options&);
// Renders one frame. Throws std::invalid_argument for an option (unknown view, kernel or variant, a view of rates that
// do not vary, empty size, a goal that nothing produces), std::runtime_error naming both kernels for a cycle or two
// updaters, device::Error for the device.
Result render(device::Device&, const scene::Scene&, const scene::Camera&, const Options&);
// What it leaves to the next, which drew with these options: luma only where the exposure was known, so that a shot's
// first two frames have none.
FrameHistory history_of(const Result&, const Options&);
// The explanation alone: nothing is allocated or run.
Explanation explain(const device::Info&, const scene::Scene&, const scene::Camera&, const Options&);

// A result as one EXR part: visibility.triangle, visibility.surface (uint), depth.Z (float), of a lit one also
// radiance.R, .G and .B (half), scene-linear and before exposure.
void write_exr(const std::filesystem::path&, const Result&);
// The picture with its legend below.
void write_png(const std::filesystem::path&, const Result&);

std::string to_text(const scene::ShadowStatistics&);  // a line; nothing where no light casts shadows
nlohmann::json to_json(const scene::ShadowStatistics&);
std::string times_to_text(const Result&);  // the pass table
nlohmann::json to_json(const Result&);     // all but the pixels

}  // namespace assay::frame
