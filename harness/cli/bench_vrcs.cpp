// assay bench vrcs: what variable rates save, and what they cost the picture.
#include <fmt/format.h>

#include <algorithm>

#include "harness/cli/command.h"
#include "harness/report/json.h"
#include "harness/report/progress.h"
#include "harness/study/study.h"

namespace assay::cli {

namespace {

namespace fs = std::filesystem;
constexpr uint32_t kSynthetic = 1024;  // pixels a side
constexpr Extent kFrame = {960, 540};

struct Flags {
  Common common;
  std::vector<std::string> scenes, only, estimators;
  uint32_t side = 256;
  bool full = false, all = false;
};

bool wanted(const Flags& f, const std::string& input_class) {
  return f.only.empty() || std::ranges::find(f.only, input_class) != f.only.end();
}

// `default`, and of the data's scenes Sponza where it is there.
std::vector<std::string> scenes_of(const Flags& f) {
  if (!f.scenes.empty()) return f.scenes;
  std::vector<std::string> scenes = {"default"};
  const fs::path sponza = study::data_folder() / "scenes" / "sponza.glb";
  if (fs::exists(sponza))
    scenes.push_back(sponza.string());
  else
    fmt::print(stderr, "left out: {} is not there; set ASSAY_DATA to the folder that holds scenes/\n", sponza.string());
  return scenes;
}

// Of the scene that half is saved of: FLIP, which takes most of the time, is not asked there.
uint32_t half_side(const Flags& f) { return f.full ? kSynthetic : 2 * f.side; }

std::vector<study::Picture> pictures_of(const Flags& f, device::Device& d) {
  std::vector<study::Picture> pictures;
  const auto add = [&](const study::Picture& p) { pictures.push_back(f.full ? p : cut(p, f.side)); };
  if (wanted(f, "photographs")) {
    const auto files = study::photographs();
    for (const auto& file : files) add(study::photograph(file));
    if (files.empty())
      fmt::print(stderr, "left out: no images in {}; set ASSAY_DATA to the folder that holds hdr/\n",
                 (study::data_folder() / "hdr").string());
  }
  if (wanted(f, "synthetic")) pictures.push_back(study::synthetic(f.full ? kSynthetic : f.side));
  if (wanted(f, "frames"))
    for (const auto& scene : scenes_of(f)) {
      const fs::path sidecar = fixtures_folder() / "scenes" / (fs::path(scene).stem().string() + ".lights.json");
      add(study::frame(d, scene, fs::exists(sidecar) ? sidecar : "", kFrame));
    }
  return pictures;
}

struct Studied {
  std::vector<study::Picture> pictures;
  std::vector<study::Outcome> outcomes;
  std::vector<study::Halved> halved;
};

void print(const Flags& f, const Studied& s) {
  const auto rows = rows_of(s.outcomes);
  std::vector<std::string> classes;
  if (!f.full) fmt::print("Of each picture the middle {} pixels at most; --full takes all of it.\n", f.side);
  for (const auto& p : s.pictures) {
    if (std::ranges::find(classes, p.input_class) == classes.end()) classes.push_back(p.input_class);
    fmt::print("{}: {}, {}x{}, exposure {:.3g}\n", p.input_class, p.name, p.size.width, p.size.height, p.exposure);
  }
  for (const auto& c : classes)
    fmt::print(
        "\n{}: pixels saved, FLIP and PSNR against 1x1, copied / deblocked; * is in front: nothing saves more for less "
        "FLIP\n\n{}",
        c, report::as_text(table_of(rows, c, f.all)));
  if (!s.halved.empty())
    fmt::print("\nThe synthetic scene, {} pixels a side, constant tolerances that save half\n\n{}", half_side(f),
               report::as_text(study::table_of(s.halved)));
  if (const auto best = best_of(rows))
    fmt::print("\nMost saved at a mean FLIP of {} at most in every class, moved or not: {}, tolerance {:g}\n",
               study::kMostFlip, label_of(*best), best->tolerance);
  else
    fmt::print("\nNo choice has a mean FLIP of {} at most in every class, moved or not\n", study::kMostFlip);
}

int run(const Flags& f) {
  probe_writable(f.common.json);
  for (const auto& name : f.estimators) must_have_variant({&kernel_named("vrcs_shading_rate")}, name);
  auto d = open_device(f.common);
  report::Progress progress;
  Studied s;
  s.pictures = pictures_of(f, *d);
  if (s.pictures.empty()) throw Unusable("there is no picture to study");
  const auto choices = study::choices(f.estimators);
  for (size_t i = 0; i < s.pictures.size(); ++i) {
    const auto more = study::try_all(*d, s.pictures[i], choices, [&](uint64_t done, uint64_t of) {
      progress.update(s.pictures[i].name, i * of + done, s.pictures.size() * of);
    });
    s.outcomes.insert(s.outcomes.end(), more.begin(), more.end());
  }
  if (wanted(f, "synthetic")) s.halved = study::at_half(*d, study::synthetic(half_side(f)), f.estimators);
  progress.clear();
  if (!json_on_stdout(f.common)) print(f, s);
  report::Json json = {{"device", report::to_json(device::info(*d))}, {"commit", report::commit()}};
  for (const auto& p : s.pictures)
    json["pictures"].push_back({{"class", p.input_class},
                                {"name", p.name},
                                {"width", p.size.width},
                                {"height", p.size.height},
                                {"exposure", p.exposure}});
  json["outcomes"] = study::to_json(s.outcomes);
  json["half_saved"] = study::to_json(s.halved);
  write_json(f.common, json);
  return validation_verdict(*d);
}

}  // namespace

void add_bench_vrcs(CLI::App& bench, Action& action) {
  auto f = std::make_shared<Flags>();
  CLI::App* command =
      subcommand(bench, "vrcs", "What variable rates save, and what they cost the picture, by estimator and tolerance",
                 "Shading rates, coordinates, copies and the deblocker run over pictures as if one triangle covered "
                 "them; the luma\n"
                 "that rates are chosen by is the picture's own, or moved by 0.37 or 3.3 pixels. Pictures: EXRs of "
                 "$ASSAY_DATA/hdr\n"
                 "(../shared/data/hdr without it), a synthetic scene, frames of the scenes.",
                 {"assay bench vrcs", "assay bench vrcs --full --all --json out/vrcs.json",
                  "assay bench vrcs --only frames --scene small"});
  command->add_option("--only", f->only, "Repeatable; this class of pictures: photographs, synthetic, frames")
      ->check(CLI::IsMember({"photographs", "synthetic", "frames"}))
      ->allow_extra_args(false);
  command
      ->add_option("--scene", f->scenes,
                   "Repeatable; bare, small, default, or a .gltf or .glb file; default and Sponza")
      ->allow_extra_args(false);
  command->add_option("--estimator", f->estimators, "Repeatable; this variant of vrcs_shading_rate, else all")
      ->allow_extra_args(false);
  command->add_option("--side", f->side, "The middle so many pixels of each picture, square")
      ->capture_default_str()
      ->check(CLI::Range(1, 16384))
      ->type_name("PIXELS");
  command->add_flag("--full", f->full,
                    fmt::format("Whole pictures; a synthetic scene of {} pixels a side", kSynthetic));
  command->add_flag("--all", f->all, "Every choice, not only the Pareto front");
  add_device_flags(command, f->common);
  add_json_flag(command, f->common, "Every outcome as JSON");
  command->callback([&action, f] { action = [f] { return run(*f); }; });
}

}  // namespace assay::cli
