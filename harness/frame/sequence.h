// Frames in a row: things, lights and the viewer move at 60 Hz (harness/scene/motion.cpp), and each frame has what the
// one before left.
#pragma once
#include <optional>

#include "harness/frame/frame.h"

namespace assay::frame {

struct Sequence {
  uint32_t frames = 1;               // 1 or more
  bool still = false;                // nothing moves
  std::optional<uint32_t> cut = {};  // a frame, after the first, from which on the viewer is elsewhere
};
struct FrameSummary {
  uint32_t frame = 0;
  double gpu_ns = 0, cpu_ns = 0;
  VrcsShares vrcs = {};
  scene::ShadowStatistics shadows = {};
};
struct Drawn {
  Result last;
  std::vector<FrameSummary> frames;
  FrameHistory history;  // what the last leaves to the next
};

// Where the viewer is in a frame.
scene::Camera camera_of(const Sequence&, const scene::Camera&, uint32_t frame);

void require(const Sequence&);
// Draws them all, the last in the view that is asked for, those before lit. Throws as render() does, and
// std::invalid_argument for no frames or a cut that is none of them.
Drawn render_sequence(device::Device&, const scene::Scene&, const scene::Camera&, const Options&, const Sequence&);

std::string to_text(const std::vector<FrameSummary>&);  // a line each
nlohmann::json to_json(const std::vector<FrameSummary>&);

}  // namespace assay::frame
