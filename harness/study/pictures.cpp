#include "harness/study/pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "harness/crop.h"
#include "harness/frame/frame.h"
#include "harness/half.h"
#include "harness/image/flip.h"
#include "harness/scene/scene.h"
#include "harness/tone_curve.h"
#include "harness/vrcs_scene.h"

namespace assay::study {

namespace fs = std::filesystem;

namespace {

constexpr uint16_t kOne = 0x3c00;  // alpha where there is a surface

// Kernel resolve's default: the mean luminance, by Rec. 709's weights, of what is covered and finite becomes middle
// grey.
float metered(const std::vector<Texel>& radiance) {
  double sum = 0, counted = 0;
  for (const Texel& t : radiance) {
    const double luminance = 0.2126 * half_value(t[0]) + 0.7152 * half_value(t[1]) + 0.0722 * half_value(t[2]);
    if (!(half_value(t[3]) > 0) || !std::isfinite(luminance)) continue;
    sum += std::max(luminance, 0.0), counted += 1;
  }
  return static_cast<float>(0.18 / std::clamp(counted == 0 ? 0.0 : sum / counted, 0x1p-14, 0x1p16));
}

}  // namespace

Picture cut(const Picture& p, uint32_t side) {
  const Extent to = {std::min(p.size.width, side), std::min(p.size.height, side)};
  Picture part = p;
  part.size = to;
  part.radiance =
      cropped(std::span(p.radiance), p.size, {{(p.size.width - to.width) / 2, (p.size.height - to.height) / 2}, to});
  return part;
}

Picture synthetic(uint32_t side) {
  Picture p = {.input_class = "synthetic", .name = "patches", .size = {side, side}};
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      const uint16_t grey = nearest_half(radiance_of(vrcs::scene(x, y)));
      p.radiance.push_back({grey, grey, grey, kOne});
    }
  return p;
}

Picture photograph(const fs::path& file) {
  const image::Pixels pixels = image::linear_of(image::read_exr(file));
  Picture p = {.input_class = "photographs", .name = file.stem().string(), .size = {pixels.width, pixels.height}};
  for (const glm::vec3& c : pixels.rgb)
    p.radiance.push_back({nearest_half(double{c.x}), nearest_half(double{c.y}), nearest_half(double{c.z}), kOne});
  p.exposure = metered(p.radiance);
  return p;
}

Picture frame(device::Device& d, const std::string& scene, const fs::path& sidecar, Extent size) {
  const std::string radiance = "deferred_lighting.radiance";
  const scene::Scene s = scene::load(scene, sidecar);
  const frame::Result r =
      assay::frame::render(d, s, scene::default_camera(s), {.size = size, .goals = {radiance}, .warm_up = false});
  Picture p = {.input_class = "frames", .name = fs::path(scene).stem().string(), .size = size};
  const Bytes& bytes = r.downloads.at(radiance);
  p.radiance.resize(bytes.size() / sizeof(Texel));
  std::memcpy(p.radiance.data(), bytes.data(), bytes.size());
  p.exposure = metered(p.radiance);
  return p;
}

fs::path data_folder() {
  const char* data = std::getenv("ASSAY_DATA");
  return data ? data : "../shared/data";
}

std::vector<fs::path> photographs() {
  std::vector<fs::path> files;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(data_folder() / "hdr", missing))
    if (entry.path().extension() == ".exr") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

}  // namespace assay::study
