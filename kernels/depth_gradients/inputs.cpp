#include "kernels/depth_gradients/inputs.h"

#include "harness/crop.h"

namespace assay::depth_gradients {

namespace {

constexpr double kTau = 6.283185307179586;

dvec2 direction(Pcg32& rng) {
  const double a = rng.range(0, kTau);
  return {std::cos(a), std::sin(a)};
}

// Around a pixel, `size` pixels from it, as narrow as `width` of that.
std::array<dvec2, 3> corners_around(Pcg32& rng, const dvec2& at, double size, double width) {
  const dvec2 along = direction(rng), aside = dvec2(-along.y, along.x) * width;
  const double turn = rng.range(0, kTau), hand = rng.below(2) == 0 ? 1 : -1;
  std::array<dvec2, 3> corners;
  for (size_t k = 0; k < 3; ++k) {
    const double a = turn + hand * kTau * (static_cast<double>(k) + rng.range(-0.25, 0.25)) / 3;
    corners[k] = at + size * rng.range(0.7, 1.4) * (along * std::cos(a) + aside * std::sin(a));
  }
  return corners;
}

void add_random_surface(Random& r, Picture& p) {
  SurfaceRecord s = {};
  s.clip_x = {1, 0, 0, 0}, s.clip_y = {0, 1, 0, 0}, s.clip_w = {0, 0, 1, 0};
  switch (r.branch({{"plain", 2}, {"mirrored", 1}, {"instanced", 1}, {"placed", 2}})) {
    case 1:
      s.clip_x.x = -1, s.flags = kSurfaceFlipped;
      break;
    case 2:
      s.flags = kSurfaceInstanced;
      break;
    case 3:
      for (vec4* row : {&s.clip_x, &s.clip_y, &s.clip_w})
        *row = *row * 2.0f +
               vec4(r.rng.range(-0.4, 0.4), r.rng.range(-0.4, 0.4), r.rng.range(-0.4, 0.4), r.rng.range(-9, 9));
      break;
    default:
      break;
  }
  p.add_surface(s);
}

// Blocks of pixels show a triangle each.
Case random_case(Random& r) {
  Picture p(random_extent(r, 32));
  const bool holes = r.branch({{"covered", 2}, {"holes", 1}}) == 1;
  const size_t kind =
      r.branch({{"walls", 2}, {"grazing", 1}, {"crossing", 1}, {"slivers", 1}, {"tiny", 1}, {"far", 1}});
  uint32_t side = 1 + r.rng.below(8);
  while (tile_count(p.extent, side) > 4096) side *= 2;
  const Extent blocks = tiles_of(p.extent, side);
  uint32_t left = 0;  // blocks until the next surface
  for (uint32_t by = 0; by < blocks.height; ++by)
    for (uint32_t bx = 0; bx < blocks.width; ++bx, --left) {
      if (left == 0) add_random_surface(r, p), left = 1 + r.rng.below(ceil_div(blocks.width * blocks.height, 4));
      if (holes && r.rng.below(4) == 0) continue;
      const double steepest[] = {-2.5, 1, -1, -2.5, -1, -2.5};
      const Plane plane = {.at = {bx * side + 0.5 * side, by * side + 0.5 * side},
                           .w = std::pow(10, kind == 5 ? r.rng.range(4, 7) : r.rng.range(-0.5, 3)),
                           .slope = direction(r.rng) * std::pow(10, r.rng.range(-5, steepest[kind]))};
      const double size = kind == 4 ? 0.8 * side * std::exp2(r.rng.range(0, 2)) : side * std::exp2(r.rng.range(0, 8));
      const double width = kind == 3 ? std::pow(10, r.rng.range(-3, 0)) : 1;
      const uint32_t triangle = p.add_triangle(plane, corners_around(r.rng, plane.at, size, width));
      for (uint32_t y = by * side; y < std::min((by + 1) * side, p.extent.height); ++y)
        for (uint32_t x = bx * side; x < std::min((bx + 1) * side, p.extent.width); ++x) p.show(x, y, triangle, plane);
    }
  Case c = p.to_case();
  c.name = "random";
  return c;
}

// Crops of the screen; the triangles stay, so their pixels see them from elsewhere: still a case.
std::vector<Case> smaller(const Case& c) {
  std::vector<Case> cases;
  for (const Crop& crop : smaller_crops(c.extent)) {
    Case s = c;
    s.extent = crop.size;
    auto p = c.params<GradientParams>();
    p.width = crop.size.width, p.height = crop.size.height;
    s.set_params(p);
    s.set_input("visibility", cropped(c.input<uvec2>("visibility"), c.extent, crop));
    s.set_input("depth", cropped(c.input<float>("depth"), c.extent, crop));
    cases.push_back(std::move(s));
  }
  return cases;
}

}  // namespace

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  for (const char* b : {"plain", "mirrored", "instanced", "placed", "covered", "holes", "walls", "grazing", "crossing",
                        "slivers", "tiny", "far"})
    branches.emplace_back(b);
  return {.random = random_case, .branches = branches, .hard = hard_cases(), .smaller = smaller};
}

namespace {

// Through three corners (x, y, w) of clip space in front of the eye.
Plane plane_through(const std::array<dvec3, 3>& corners, Extent e) {
  const auto pixel = [e](const dvec3& c) { return (dvec2(c) / c.z + 1.0) * 0.5 * dvec2(e.width, e.height); };
  const dvec2 at = pixel(corners[0]);
  const double w = corners[0].z;
  const glm::dmat2 sides = {pixel(corners[1]) - at, pixel(corners[2]) - at};
  return {at, w, glm::inverse(glm::transpose(sides)) * dvec2(w / corners[1].z - 1, w / corners[2].z - 1)};
}

}  // namespace

Case typical(Extent e) {
  constexpr uint32_t kCell = 8;
  Picture p(e);
  p.add_surface();
  const Extent cells = tiles_of(e, kCell);
  const auto corner = [&](uint32_t i, uint32_t j) {
    const double x = i * kCell, y = j * kCell, w = 8 + 2 * std::sin(0.011 * x) + 3 * std::cos(0.007 * y);
    return dvec3((2 * x / e.width - 1) * w, (2 * y / e.height - 1) * w, w);
  };
  for (uint32_t j = 0; j < cells.height; ++j)
    for (uint32_t i = 0; i < cells.width; ++i)
      for (uint32_t second = 0; second < 2; ++second) {
        const std::array<dvec3, 3> c = {second ? corner(i + 1, j + 1) : corner(i, j), corner(i, j + 1),
                                        corner(i + 1, j)};
        const uint32_t triangle = p.add_triangle(c);
        const Plane plane = plane_through(c, e);
        for (uint32_t y = j * kCell; y < std::min((j + 1) * kCell, e.height); ++y)
          for (uint32_t x = i * kCell; x < std::min((i + 1) * kCell, e.width); ++x)
            if ((x % kCell + y % kCell + 1 >= kCell) == (second != 0)) p.show(x, y, triangle, plane);
      }
  Case c = p.to_case();
  c.name = "typical";
  return c;
}

Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  c.set_params(GradientParams{f.extent.width, f.extent.height, f.scene.vertices, f.scene.indices, f.scene.surfaces,
                              kProbeFactor, kProbeAddend});
  return c;
}

}  // namespace assay::depth_gradients
