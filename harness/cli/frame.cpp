// assay frame: a scene through the whole chain, as a picture.
#include "harness/frame/sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/quaternion.hpp>

#include "harness/cli/command.h"
#include "harness/report/json.h"
#include "harness/report/progress.h"

namespace assay::cli {

namespace {

namespace fs = std::filesystem;

struct Flags {
  Common common;
  std::string scene = "small", size = "1280x720", out = "out", camera, sidecar;
  std::vector<std::string> variants;
  frame::Options options;
  std::string shadows = "on";
  std::optional<uint32_t> frames, cut;
  bool still = false, explain = false, exr = false;
};

// "ex,ey,ez,tx,ty,tz": from the eye towards the target, y up.
scene::Camera look_at(scene::Camera camera, const std::string& text) {
  glm::dvec3 eye, target;
  int end = 0;
  const int read = std::sscanf(text.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf%n", &eye.x, &eye.y, &eye.z, &target.x, &target.y,
                               &target.z, &end);
  const glm::dvec3 forward = target - eye;
  const double distance = glm::length(forward);
  if (read != 6 || static_cast<size_t>(end) != text.size() || !(distance > 0) || !std::isfinite(distance))
    throw Unusable(fmt::format("'{}' is no camera; write eye and target, six finite numbers as in 0,2,5,0,1,0", text));
  const glm::dvec3 direction = forward / distance;
  const glm::dvec3 up = std::abs(direction.y) > 0.999 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
  camera.eye = eye;
  camera.orientation = glm::quatLookAt(direction, up);
  return camera;
}

void parse_variants(Flags& f) {
  for (const auto& choice : f.variants) {
    const auto equals = choice.find('=');
    if (equals == std::string::npos) throw Unusable(fmt::format("'{}' is no choice; write kernel=variant", choice));
    const Kernel& k = kernel_named(choice.substr(0, equals));
    must_have_variant({&k}, choice.substr(equals + 1));
    f.options.variants[k.name] = choice.substr(equals + 1);
  }
}

// Rates come from the two frames before, and settle in the next.
constexpr uint32_t kVrcsFrames = 4;
frame::Sequence sequence_of(const Flags& f) {
  return {.frames = f.frames.value_or(f.options.vrcs == "off" ? 1 : kVrcsFrames), .still = f.still, .cut = f.cut};
}

void print(const Flags& f, const frame::Drawn& drawn, const fs::path& picture) {
  const frame::Result& r = drawn.last;
  for (const auto& note : r.notes) fmt::print("note: {}\n", note);
  if (f.explain) fmt::print("{}\n{}\n", frame::to_text(r.explanation), frame::to_text(r.memory));
  fmt::print("{}\n{}{}\n", frame::to_text(r.statistics), frame::to_text(r.shadows), frame::times_to_text(r));
  if (drawn.frames.size() > 1) fmt::print("{}\n", frame::to_text(drawn.frames));
  fmt::print("wrote {}\n", picture.string());
}

int run(Flags& f) {
  f.options.size = parse_size(f.size);
  parse_variants(f);
  f.options.shadows = f.shadows == "on";
  frame::require(f.options);
  frame::require(sequence_of(f));
  const fs::path picture = fs::path(f.out) / "frame.png", layers = fs::path(f.out) / "frame.exr";
  probe_writable(picture.string());
  if (f.exr) probe_writable(layers.string());
  probe_writable(f.common.json);
  const scene::Scene s = scene::load(f.scene, f.sidecar);
  scene::Camera camera = scene::default_camera(s);
  if (!f.camera.empty()) camera = look_at(camera, f.camera);

  auto d = open_device(f.common);
  report::Progress progress;
  f.options.progress = [&](const std::string& what, uint64_t done, uint64_t of) { progress.update(what, done, of); };
  const auto drawn = frame::render_sequence(*d, s, camera, f.options, sequence_of(f));
  progress.clear();
  frame::write_png(picture, drawn.last);
  if (f.exr) frame::write_exr(layers, drawn.last);
  if (!json_on_stdout(f.common)) print(f, drawn, picture);
  report::Json json = frame::to_json(drawn.last);
  json["frames"] = frame::to_json(drawn.frames);
  json["device"] = report::to_json(device::info(*d));
  json["commit"] = report::commit();
  write_json(f.common, json);
  return validation_verdict(*d);
}

}  // namespace

void add_frame(CLI::App& app, Action& action) {
  auto f = std::make_shared<Flags>();
  CLI::App* command = subcommand(
      app, "frame", "Renders a scene through the whole chain of kernels and writes out/frame.png with a legend",
      "Prints what tile classification saved and the time of every pass. Only what the scene needs is allocated and "
      "run;\n"
      "--explain prints every pass with the reason that it runs or is left out, and every resource with its bytes.",
      {"assay frame", "assay frame --scene sponza.glb --size 1280x720 --exposure 1",
       "assay frame --scene default --view wave", "assay frame --scene bare --explain",
       "assay frame --camera 0,2,5,0,1,0 --view workload --out out/workload",
       "assay frame --variant visibility=fat --json out/frame.json", "assay frame --scene default --vrcs deblocked"});
  command->add_option("--scene", f->scene, "bare, small, default, or a .gltf or .glb file")->capture_default_str();
  command
      ->add_option("--sidecar", f->sidecar,
                   "More lights and decals for the scene; NAME.lights.json beside NAME.gltf or NAME.glb by default")
      ->type_name("FILE");
  command->add_option("--size", f->size, "Pixels")->capture_default_str()->type_name("WxH");
  command->add_option("--view", f->options.view, fmt::format("{}", fmt::join(frame::view_names(), ", ")))
      ->capture_default_str();
  command->add_option("--camera", f->camera, "Eye and target in metres, y up; the file's first camera by default")
      ->type_name("EX,EY,EZ,TX,TY,TZ");
  command
      ->add_option(
          "--clusters", f->options.clusters,
          "Lights and decals looked up in 16x8x24 cells (coarse) or cells of 32 pixels in 24 slices (fine), or none: "
          "every pixel asks every light and decal")
      ->capture_default_str()
      ->check(CLI::IsMember({"none", "coarse", "fine"}));
  command->add_option("--shadows", f->shadows, "Of the lights that cast them")
      ->capture_default_str()
      ->check(CLI::IsMember({"on", "off"}));
  command
      ->add_option(
          "--vrcs", f->options.vrcs,
          "Variable rates, from the luma of the frame before: pixels of low contrast share what one of them is "
          "shaded, shown as it is (on) or averaged with its neighbours (deblocked)")
      ->capture_default_str()
      ->check(CLI::IsMember({"off", "on", "deblocked"}));
  command
      ->add_option("--vrcs-tolerance", f->options.vrcs_tolerance,
                   "Error that is let pass, of luma 0 to 1; 2x2 by half of it")
      ->capture_default_str()
      ->type_name("LUMA")
      ->check(CLI::Range(0.0, 1e6));
  command
      ->add_option("--vrcs-resolution", f->options.vrcs_resolution,
                   "Share of the display's height that dynamic resolution chose: below 0.85 more error passes, above "
                   "less, from 0.75 down more in the corners")
      ->type_name("SHARE");
  command
      ->add_option("--vrcs-border", f->options.vrcs_border,
                   "Pixels from the picture's sides within which twice the error passes")
      ->type_name("PIXELS");
  command
      ->add_option("--frames", f->frames,
                   "Frames to draw, at 60 Hz along a fixed path; the last is shown (1, or 4 with variable rates)")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000));
  command->add_flag("--still", f->still, "Nothing moves from frame to frame");
  command->add_option("--cut", f->cut, "The viewer is elsewhere from this frame on")->type_name("FRAME");
  command->add_option("--exposure", f->options.exposure_stops, "Stops brighter than the automatic exposure")
      ->capture_default_str()
      ->type_name("STOPS")
      ->check(CLI::Range(-32.0, 32.0));
  command->add_option("--variant", f->variants, "Another variant of a kernel than its default, repeatable")
      ->type_name("KERNEL=VARIANT")
      ->allow_extra_args(false);
  command->add_flag("--explain", f->explain, "Also why each pass runs or is left out, and the bytes of each resource");
  command->add_option("--out", f->out, "Where frame.png goes")->capture_default_str()->type_name("DIR");
  command->add_flag("--exr", f->exr, "Visibility, depth and radiance as frame.exr too");
  add_device_flags(command, f->common);
  add_json_flag(command, f->common, "Statistics, times and the explanation as JSON");
  command->callback([&action, f] { action = [f] { return run(*f); }; });
}

}  // namespace assay::cli
