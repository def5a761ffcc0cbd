// assay diff: how far one picture is off another.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/cli/command.h"
#include "harness/image/flip.h"

namespace assay::cli {

namespace {

namespace fs = std::filesystem;

struct Flags {
  Common common;
  std::string reference, test, map;
  double pixels_a_degree = image::kPixelsADegree;
  double max_flip = -1;
};

struct Difference {
  image::Flip flip;
  double psnr = 0;
  uint32_t width = 0, height = 0;
};

image::Pixels radiance(const std::string& file) {
  const image::Layers layers = image::read_exr(file);
  try {
    return image::linear_of(layers);
  } catch (const std::runtime_error& e) {
    throw Unusable(file + ": " + e.what());
  }
}

Difference difference(const Flags& f, bool is_radiance) {
  if (is_radiance) {
    const image::Pixels a = radiance(f.reference), b = radiance(f.test);
    return {image::flip_hdr(a, b, f.pixels_a_degree), image::psnr(a, b), a.width, a.height};
  }
  const image::Rgba8 a = image::read_png(f.reference), b = image::read_png(f.test);
  return {image::flip(linear_of(a), linear_of(b), f.pixels_a_degree), image::psnr(a, b), a.width, a.height};
}

// Grey of 0 to 255 in a PNG, the values themselves in an EXR.
void write_map(const std::string& file, const Difference& d) {
  if (fs::path(file).extension() == ".exr")
    return image::write_exr(file, {d.width, d.height, {{"flip.Y", image::Sample::float32, d.flip.map, {}}}});
  image::Rgba8 grey = {d.width, d.height, {}};
  for (const float v : d.flip.map) {
    const auto code = static_cast<uint8_t>(std::lround(v * 255));
    grey.texels.insert(grey.texels.end(), {code, code, code, 255});
  }
  image::write_png(file, grey);
}

std::string kind_of(const std::string& file) {
  std::string kind = fs::path(file).extension().string();
  if (kind != ".png" && kind != ".exr") throw Unusable(file + ": is neither .png nor .exr");
  return kind;
}

int run(const Flags& f) {
  const bool is_radiance = kind_of(f.reference) == ".exr";
  if (kind_of(f.test) != kind_of(f.reference)) throw Unusable("a .png and a .exr cannot be compared");
  if (!f.map.empty()) kind_of(f.map);
  probe_writable(f.map), probe_writable(f.common.json);
  const Difference d = difference(f, is_radiance);
  if (!f.map.empty()) write_map(f.map, d);
  nlohmann::ordered_json j = {{"reference", f.reference}, {"test", f.test},
                              {"width", d.width},         {"height", d.height},
                              {"flip", d.flip.mean},      {"pixels_a_degree", f.pixels_a_degree}};
  j["psnr_db"] = std::isinf(d.psnr) ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(d.psnr);
  if (is_radiance) j["exposures"] = {{"count", d.flip.exposures}, {"start", d.flip.start}, {"stop", d.flip.stop}};
  write_json(f.common, j);
  if (!json_on_stdout(f.common)) {
    fmt::print("FLIP {:.6f} mean, PSNR {:.2f} dB, {}x{}\n", d.flip.mean, d.psnr, d.width, d.height);
    if (is_radiance)
      fmt::print("{} exposures from {:+.4f} to {:+.4f} stops; PSNR over the reference's largest value\n",
                 d.flip.exposures, d.flip.start, d.flip.stop);
  }
  if (f.max_flip < 0 || d.flip.mean <= f.max_flip) return kSuccess;
  fmt::print(stderr, "FLIP {:.6f} is over {}\n", d.flip.mean, f.max_flip);
  return kViolation;
}

}  // namespace

void add_diff(CLI::App& app, Action& action) {
  auto f = std::make_shared<Flags>();
  CLI::App* command = subcommand(
      app, "diff", "How far a picture is off another, as a viewer sees it: FLIP and PSNR",
      "Two PNGs, or two EXRs with R, G and B, or radiance.R and so on: then over the exposures at which the reference\n"
      "shows anything. Exit 1 over --max-flip.",
      {"assay diff before.png out/frame.png",
       "assay diff before.exr out/frame.exr --map out/flip.png --max-flip 0.01"});
  command->add_option("reference", f->reference, "The picture that is right")->required()->type_name("REFERENCE");
  command->add_option("test", f->test, "The other")->required()->type_name("TEST");
  command->add_option("--map", f->map, "The error a pixel: grey in a .png, numbers in a .exr")->type_name("FILE");
  command->add_option("--max-flip", f->max_flip, "Most that the mean may be")
      ->check(CLI::Range(0.0, 1.0))
      ->type_name("X");
  command->add_option("--pixels-a-degree", f->pixels_a_degree, "By default a 4K screen 0.7 m wide, 0.7 m away")
      ->check(CLI::Range(1.0, 1000.0))
      ->type_name("N");
  add_json_flag(command, f->common, "The figures as JSON");
  command->callback([&action, f] { action = [f] { return run(*f); }; });
}

}  // namespace assay::cli
