// assay bench particle-light: how a particle may be lit, its error against its time, and at which sizes of frames.
#include <fmt/format.h>

#include <algorithm>

#include "harness/cli/command.h"
#include "harness/report/json.h"
#include "harness/report/progress.h"
#include "harness/study/particle_light.h"

namespace assay::cli {

namespace {

constexpr const char* kWays = "ways";
constexpr const char* kSizes = "sizes";

struct Flags {
  Common common;
  std::string only, scene = "small";
  std::vector<std::string> sizes = {"1280x720", "1920x1080", "3840x2160"};
  study::ParticleQuestion question;
  bool all = false;
};

struct Studied {
  std::vector<study::ParticleOutcome> outcomes;
  std::vector<study::ParticleFrame> frames;
};

void print(const Flags& f, const Studied& s) {
  std::vector<std::string> classes;
  for (const auto& o : s.outcomes)
    if (std::ranges::find(classes, o.input_class) == classes.end()) classes.push_back(o.input_class);
  const auto& q = f.question;
  if (!classes.empty())
    fmt::print("A particle of {0}x{0} pixels under {1} lights. Error against light at every pixel, over its mean.\n",
               q.pixels, q.lights);
  for (const auto& c : classes)
    fmt::print("\n{}; * is in front: nothing errs less in as little time\n\n{}", c,
               report::as_text(table_of(s.outcomes, c, f.all)));
  if (!s.frames.empty())
    fmt::print("{}Particles of a frame of {}; x: times the first size's\n\n{}", classes.empty() ? "" : "\n", f.scene,
               report::as_text(table_of(s.frames)));
}

std::vector<Extent> extents_of(const Flags& f) {
  std::vector<Extent> extents;
  for (const auto& size : f.sizes) extents.push_back(parse_size(size));
  return extents;
}

int run(const Flags& f) {
  for (const auto& name : f.question.filters) must_have_variant({&kernel_named("particles")}, name);
  const auto extents = extents_of(f);
  probe_writable(f.common.json);
  const scene::Scene scene = scene::load(f.scene);
  if (f.only != kWays && scene.particles.empty()) throw Unusable(f.scene + " has no particles");
  auto d = open_device(f.common);
  report::Progress progress;
  const auto tell = [&](const std::string& what, uint64_t done, uint64_t of) { progress.update(what, done, of); };
  Studied s;
  if (f.only != kSizes) s.outcomes = study::try_all(*d, f.question, tell);
  if (f.only != kWays) s.frames = study::at_sizes(*d, scene, extents, f.question.samples, tell);
  progress.clear();
  if (!json_on_stdout(f.common)) print(f, s);
  write_json(f.common, {{"device", report::to_json(device::info(*d))},
                        {"commit", report::commit()},
                        {"pixels", f.question.pixels},
                        {"lights", f.question.lights},
                        {"samples", f.question.samples},
                        {"scene", f.scene},
                        {"outcomes", study::to_json(s.outcomes)},
                        {"frames", study::to_json(s.frames)}});
  return validation_verdict(*d);
}

}  // namespace

void add_bench_particle_light(CLI::App& bench, Action& action) {
  auto f = std::make_shared<Flags>();
  CLI::App* command = subcommand(
      bench, "particle-light", "How particles may be lit: error against time, and time against the frame's size",
      "Ways: each filter, encoding and resolution of the light atlas, the particle's corners, every pixel; under\n"
      "smooth light, a light close by and the edge of a shadow. Their time is that of the particle's pixels and of\n"
      "its texels, under equal lights. Sizes: the passes of a frame that concern particles, and how many texels\n"
      "they light.",
      {"assay bench particle-light", "assay bench particle-light --all --json out/particle_light.json",
       "assay bench particle-light --only ways --encoding rgb9e5 --side 16 --pixels 64",
       "assay bench particle-light --only sizes --scene default --size 1280x720 --size 3840x2160"});
  auto& q = f->question;
  command->add_option("--only", f->only, "Only this part: ways, sizes")->check(CLI::IsMember({kWays, kSizes}));
  command->add_option("--filter", q.filters, "Repeatable; this variant of particles, else all")
      ->allow_extra_args(false);
  command->add_option("--encoding", q.encodings, "Repeatable; r11g11b10f, rgb9e5, rgba16f, else all")
      ->check(CLI::IsMember({"r11g11b10f", "rgb9e5", "rgba16f"}))
      ->allow_extra_args(false);
  command->add_option("--side", q.sides, "Repeatable; texels of the particle's rectangle: 8, 16, 32, else all")
      ->check(CLI::IsMember({8, 16, 32}))
      ->allow_extra_args(false)
      ->type_name("TEXELS");
  command->add_option("--pixels", q.pixels, "A side of the square that the particle covers on the screen")
      ->capture_default_str()
      ->check(CLI::Range(1, 16384))
      ->type_name("PIXELS");
  command->add_option("--lights", q.lights, "Lights that each texel or pixel walks as it is timed")
      ->capture_default_str()
      ->check(CLI::Range(1, 64))
      ->type_name("N");
  command->add_option("--scene", f->scene, "Of the sizes: small, default, or a .gltf or .glb file")
      ->capture_default_str();
  command->add_option("--size", f->sizes, "Repeatable; 1280x720, 1920x1080 and 3840x2160 by default")
      ->type_name("WxH")
      ->allow_extra_args(false);
  command->add_option("--samples", q.samples, "Samples of each time; the least is shown")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000))
      ->type_name("N");
  command->add_flag("--all", f->all, "Every way, not only the Pareto front and the default");
  add_device_flags(command, f->common);
  add_json_flag(command, f->common, "Every way and size as JSON");
  command->callback([&action, f] { action = [f] { return run(*f); }; });
}

}  // namespace assay::cli
