// How a particle may be lit, its error against its time, and what the particles of a frame take at each size: the study
// behind `assay bench particle-light`.
#pragma once
#include <functional>
#include <nlohmann/json.hpp>

#include "harness/device/device.h"
#include "harness/report/table.h"
#include "harness/scene/scene.h"

namespace assay::study {

struct ParticleWay {
  std::string filter;    // a variant of `particles`
  std::string encoding;  // a variant of particle_light_atlas; empty: of a filter without an atlas
  uint32_t side = 0;     // texels of its rectangle; 0: none
};
std::string label_of(const ParticleWay&);  // "catmull_rom, 32 r11g11b10f"

struct ParticleQuestion {
  std::vector<std::string> filters = {}, encodings = {};  // empty: all
  std::vector<uint32_t> sides = {8, 16, 32};
  uint32_t lights = 8;    // that each texel, corner or fragment walks as it is timed
  uint32_t pixels = 128;  // a side of the square that the particle covers on the screen
  uint32_t layers = 16;   // particles over each other in a timed draw
  uint32_t samples = 5;   // of each time, the least of which counts: load from elsewhere only ever adds
};

// Of a way, over a class of the error table of `particles`: against light at every pixel.
struct ParticleOutcome {
  std::string input_class;  // smooth light, close light, shadow edge
  ParticleWay way;
  double rms = 0, most = 0;          // over the mean
  double draw_ns = 0, light_ns = 0;  // to draw its pixels, to light its texels
  bool is_default = false;
  bool in_front = false;  // nothing of its class takes less time and errs as little, or errs less in as little time
};
double time_of(const ParticleOutcome&);
void mark_front(std::vector<ParticleOutcome>&);

using Told = std::function<void(const std::string& what, uint64_t done, uint64_t of)>;
// Every way over every class that it has figures of, the front marked.
std::vector<ParticleOutcome> try_all(device::Device&, const ParticleQuestion&, const Told&);

// The passes of a frame that concern particles; the least times of its samples.
struct ParticleFrame {
  Extent size = {};
  uint32_t lit = 0, texels = 0;  // particles that have a rectangle, texels of those
  double rects_ns = 0, light_ns = 0, draw_ns = 0;
};
// The scene must have particles in view.
std::vector<ParticleFrame> at_sizes(device::Device&, const scene::Scene&, const std::vector<Extent>&, uint32_t samples,
                                    const Told&);

// A class's ways, fastest first: all, or those in front and the default.
report::Table table_of(const std::vector<ParticleOutcome>&, const std::string& input_class, bool all);
report::Table table_of(const std::vector<ParticleFrame>&);
nlohmann::ordered_json to_json(const std::vector<ParticleOutcome>&);
nlohmann::ordered_json to_json(const std::vector<ParticleFrame>&);

}  // namespace assay::study
