#include "harness/frame/sequence.h"

#include <fmt/format.h>

#include <stdexcept>

namespace assay::frame {

namespace {

constexpr uint32_t kCutFrames = 60;  // that the viewer's way is ahead after a cut

}  // namespace

void require(const Sequence& s) {
  if (s.frames == 0) throw std::invalid_argument("no frames asked for; draw 1 or more");
  if (s.cut && (*s.cut == 0 || *s.cut >= s.frames))
    throw std::invalid_argument(
        fmt::format("no cut at frame {} of {}: the first is 0, and has none", *s.cut, s.frames));
}

scene::Camera camera_of(const Sequence& s, const scene::Camera& first, uint32_t frame) {
  const uint32_t ahead = s.cut && frame >= *s.cut ? kCutFrames : 0;
  return scene::camera_in_frame(first, (s.still ? 0 : frame) + ahead);
}

Drawn render_sequence(device::Device& d, const scene::Scene& scene, const scene::Camera& camera, const Options& asked,
                      const Sequence& s) {
  require(s);
  scene::Scene moved = scene;
  Options options = asked;
  Drawn drawn;
  for (uint32_t frame = 0; frame < s.frames; ++frame) {
    const bool is_last = frame + 1 == s.frames;
    options.frame = frame;
    options.view = is_last ? asked.view : default_view();
    options.goals = is_last ? asked.goals : std::vector<std::string>{};
    options.keep_shadows = asked.keep_shadows || !is_last;
    if (frame == s.cut) options.history = {};
    if (!s.still) scene::move_to_frame(frame, scene, moved);
    drawn.last = render(d, moved, camera_of(s, camera, frame), options);
    options.history = history_of(drawn.last, options);
    options.shadow_cache = drawn.last.shadow_cache;
    drawn.frames.push_back({frame, drawn.last.gpu_ns, drawn.last.cpu_ns, drawn.last.vrcs, drawn.last.shadows});
  }
  drawn.history = options.history;
  return drawn;
}

std::string to_text(const std::vector<FrameSummary>& frames) {
  std::string text;
  for (const FrameSummary& f : frames) {
    text += fmt::format("frame {:<3} {:9.3f} ms", f.frame, f.gpu_ns / 1e6);
    if (f.vrcs.covered)
      text += fmt::format(", {:.1f}% of the pixels shaded",
                          100 * static_cast<double>(f.vrcs.primaries) / static_cast<double>(f.vrcs.covered));
    if (f.shadows.views)
      text += fmt::format(", {} of {} shadow tiles drawn, {} composed", f.shadows.still_drawn, f.shadows.views,
                          f.shadows.composed);
    text += '\n';
  }
  return text;
}

nlohmann::json to_json(const std::vector<FrameSummary>& frames) {
  nlohmann::json json = nlohmann::json::array();
  for (const FrameSummary& f : frames) {
    json.push_back({{"frame", f.frame}, {"gpu_ns", f.gpu_ns}, {"cpu_ns", f.cpu_ns}});
    if (f.vrcs.tiles) json.back()["vrcs"] = to_json(f.vrcs);
    if (f.shadows.views) json.back()["shadows"] = to_json(f.shadows);
  }
  return json;
}

}  // namespace assay::frame
