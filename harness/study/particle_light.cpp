#include "harness/study/particle_light.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "harness/frame/downloads.h"
#include "harness/frame/frame.h"
#include "harness/report/errors.h"
#include "harness/report/timing.h"
#include "harness/study/parameters.h"

namespace assay::study {

namespace {

constexpr const char* kLights[] = {"smooth light", "close light", "shadow edge"};
constexpr const char* kEncodings[] = {"r11g11b10f", "rgb9e5", "rgba16f"};  // variants of particle_light_atlas
constexpr uint32_t kTimedSide = 16;                                        // taps cost the same whatever the side
constexpr Extent kTimedAtlas = {512, 512};

const Kernel& drawing() { return kernel_named("particles"); }
const Kernel& lighting() { return kernel_named("particle_light_atlas"); }
bool has_atlas(const Variant& v) { return has_port(v, port_of(drawing(), "atlas")); }

// Of the error table of `particles`.
const HardCase& class_of(const std::string& light, uint32_t side, const std::string& encoding) {
  const auto& classes = drawing().errors.classes;
  const std::string name = fmt::format("{}, {} {}", light, side, encoding);
  const auto it = std::ranges::find(classes, name, &HardCase::name);
  if (it == classes.end()) throw std::logic_error("particles has no class of errors " + name);
  return *it;
}
// What a filter without an atlas has its figures under.
const HardCase& usual_class(const std::string& light) {
  for (const HardCase& c : drawing().errors.classes)
    if (c.name.starts_with(light) && !c.nightly) return c;
  throw std::logic_error("particles has no usual class of errors of " + light);
}

std::vector<ParticleWay> ways_of(const ParticleQuestion& q) {
  std::vector<std::string> encodings = q.encodings;
  if (encodings.empty()) encodings.assign(std::begin(kEncodings), std::end(kEncodings));
  std::vector<ParticleWay> ways;
  for (const Variant& v : drawing().variants) {
    if (!q.filters.empty() && std::ranges::find(q.filters, v.name) == q.filters.end()) continue;
    if (!has_atlas(v)) {
      ways.push_back({v.name});
      continue;
    }
    for (const uint32_t side : q.sides)
      for (const std::string& encoding : encodings) ways.push_back({v.name, encoding, side});
  }
  return ways;
}
bool is_default(const ParticleWay& w) {
  return w.filter == drawing().default_variant && w.encoding == lighting().default_variant;
}

std::vector<LightRecord> lights_of(const ParticleQuestion& q, const Case& c) {
  return std::vector<LightRecord>(q.lights, c.input<LightRecord>("lights")[0]);
}

double timed_ns(device::Device& d, const Kernel& k, const std::string& variant, const Case& c, uint32_t samples) {
  auto loop = report::make_loop(d, {.kernel = &k, .variant = &variant_of(k, variant)}, c);
  report::warm_up(d, loop);
  return report::least_gpu_ns(report::samples(d, loop, report::Cache::cold, samples));
}

// Of a pixel of a particle's square, many of them over each other.
double pixel_ns(device::Device& d, const ParticleQuestion& q, const ParticleWay& w) {
  Case c = (w.side == 0 ? usual_class(kLights[0]) : class_of(kLights[0], kTimedSide, w.encoding)).make();
  c.set_input("order", std::vector<uint32_t>(q.layers, 0));
  set_parameter(drawing(), c, "drawn", q.layers);
  c.set_input("lights", lights_of(q, c));
  set_parameter(drawing(), c, "lights", q.lights);
  return timed_ns(d, drawing(), w.filter, c, q.samples) / static_cast<double>(q.layers * pixels(c));
}

// Of a texel, in an atlas that is full: every cell lists the same lights, those that fragments are timed with.
double texel_ns(device::Device& d, const ParticleQuestion& q, const std::string& encoding) {
  Case c = lighting().typical(kTimedAtlas);
  c.set_input("lights", lights_of(q, usual_class(kLights[0]).make()));
  std::vector<uint32_t> entries;
  for (uint32_t i = 0; i < q.lights; ++i) entries.push_back(i);
  c.set_input("entries", entries);
  c.set_input("cells", std::vector<uvec2>(c.input<uvec2>("cells").size(), uvec2(0, q.lights)));
  set_parameter(lighting(), c, "lights", q.lights);
  set_parameter(lighting(), c, "entries", q.lights);
  const double texels = c.input<ParticleRectCounts>("counts")[0].blocks * double{kLightBlockSide * kLightBlockSide};
  return timed_ns(d, lighting(), encoding, c, q.samples) / texels;
}

class Times {
 public:
  Times(device::Device& d, const ParticleQuestion& q) : device_(d), q_(q) {}
  double draw_ns(const ParticleWay& w) {
    const auto [it, is_new] = pixel_.try_emplace(w.filter + w.encoding);
    if (is_new) it->second = pixel_ns(device_, q_, w);
    return it->second * q_.pixels * q_.pixels;
  }
  double light_ns(const ParticleWay& w) {
    if (w.side == 0) return 0;
    const auto [it, is_new] = texel_.try_emplace(w.encoding);
    if (is_new) it->second = texel_ns(device_, q_, w.encoding);
    return it->second * w.side * w.side;
  }

 private:
  device::Device& device_;
  const ParticleQuestion& q_;
  std::map<std::string, double> pixel_, texel_;
};

double sum_of(const frame::Result& r, const std::string& kernel) {
  double sum = 0;
  for (const frame::PassTime& p : r.passes)
    if (p.kernel.starts_with(kernel + ".")) sum += p.time_ns;
  return sum;
}

}  // namespace

std::string label_of(const ParticleWay& w) {
  return w.side == 0 ? w.filter : fmt::format("{}, {} {}", w.filter, w.side, w.encoding);
}

double time_of(const ParticleOutcome& o) { return o.draw_ns + o.light_ns; }

void mark_front(std::vector<ParticleOutcome>& all) {
  const auto beats = [](const ParticleOutcome& a, const ParticleOutcome& b) {
    return a.input_class == b.input_class && time_of(a) <= time_of(b) && a.rms <= b.rms &&
           (time_of(a) < time_of(b) || a.rms < b.rms);
  };
  for (ParticleOutcome& o : all)
    o.in_front = std::isfinite(o.rms) && std::ranges::none_of(all, [&](const auto& other) { return beats(other, o); });
}

std::vector<ParticleOutcome> try_all(device::Device& d, const ParticleQuestion& q, const Told& tell) {
  const auto ways = ways_of(q);
  Times times(d, q);
  std::vector<ParticleOutcome> all;
  for (size_t i = 0; i < ways.size(); ++i) {
    const ParticleWay& w = ways[i];
    tell(label_of(w), i, ways.size());
    for (const char* light : kLights) {
      const HardCase& input_class = w.side == 0 ? usual_class(light) : class_of(light, w.side, w.encoding);
      const auto figures =
          report::measure_errors(d, {.kernel = &drawing(), .variant = &variant_of(drawing(), w.filter)}, input_class);
      if (figures.empty()) continue;
      all.push_back({.input_class = light,
                     .way = w,
                     .rms = figures.at(0).value,
                     .most = figures.at(1).value,
                     .draw_ns = times.draw_ns(w),
                     .light_ns = times.light_ns(w),
                     .is_default = is_default(w)});
    }
  }
  mark_front(all);
  return all;
}

std::vector<ParticleFrame> at_sizes(device::Device& d, const scene::Scene& scene, const std::vector<Extent>& sizes,
                                    uint32_t samples, const Told& tell) {
  constexpr const char* kDrawn = "particles.radiance";
  constexpr const char* kCounts = "particle_rects.counts";
  std::vector<ParticleFrame> all;
  for (const Extent size : sizes) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    ParticleFrame f = {.size = size, .rects_ns = kNone, .light_ns = kNone, .draw_ns = kNone};
    for (uint32_t i = 0; i < samples; ++i) {
      tell(fmt::format("{}x{}", size.width, size.height), all.size() * samples + i, sizes.size() * samples);
      const frame::Options o = {.size = size, .goals = {kDrawn, kCounts}, .warm_up = i == 0};
      const auto r = frame::render(d, scene, scene::default_camera(scene), o);
      f.rects_ns = std::min(f.rects_ns, sum_of(r, "particle_rects"));
      f.light_ns = std::min(f.light_ns, sum_of(r, "particle_light_atlas"));
      f.draw_ns = std::min(f.draw_ns, sum_of(r, "particles"));
      const auto counts = frame::values_of<ParticleRectCounts>(r.downloads, kCounts).at(0);
      f.lit = counts.lit, f.texels = counts.blocks * kLightBlockSide * kLightBlockSide;
    }
    all.push_back(f);
  }
  return all;
}

}  // namespace assay::study
