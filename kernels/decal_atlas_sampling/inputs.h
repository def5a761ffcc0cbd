#pragma once
#include <optional>

#include "harness/oracle.h"
#include "kernels/decal_atlas_sampling/layout.h"

namespace assay::decal_atlas_sampling {

Case random_case(Random&);
std::vector<std::string> branches();
std::vector<HardCase> hard_cases();
std::vector<Case> smaller(const Case&);  // the later half of the decals in no pixel
Case typical(Extent);                    // 256 decals on floor and walls, one or two to a pixel
// Base colour against the mean over a pixel's ellipse.
ErrorTable error_table();

// ---- For hard.cpp and errors.cpp, and tests

std::vector<HardCase> hard_cases_of_lists();

// Pages of decals side by side, each `side` texels square and aligned, `levels` of mips. Painted: discs that fade out;
// loud: a decal one colour, far from its neighbours'; levels: a colour a level; stripes: eight texels wide, opaque.
struct AtlasPlan {
  uint32_t width = 128, height = 128, side = 32, levels = 4, pages = 2;
  uint32_t border = 0;  // texels of a decal's own that its rectangle leaves out on each side
  uint64_t seed = 1;
  enum class Look { painted, loud, levels, stripes } look = Look::painted;
};
std::vector<Texture> atlas_of(const AtlasPlan&);
void set_atlas(Case&, std::vector<Texture> atlas);  // as it is, and in blocks

// A view straight ahead (-z), the screen's edges at slopes of 1, surfaces set by planes, and decals.
struct View {
  explicit View(Extent e);
  Extent extent;
  DecalParams params = {};
  float far = 100;  // of the table of slices
  AtlasPlan atlas = {};
  std::vector<float> depth;
  std::vector<std::array<uint16_t, 2>> gradients;
  std::vector<uint32_t> base_roughness, normal;
  // Of the lists: which triangle each pixel with a surface shows, the rates of cells of 2x2 pixels, and the tiles that
  // are listed; where empty, squares of 24 pixels, 1x1, and those with a pixel in whose cell a decal is.
  std::vector<uvec2> visibility = {};
  std::vector<uint8_t> rates = {};
  std::optional<std::vector<uint32_t>> tiles = {};
  std::vector<DecalRecord> decals = {};
  std::vector<ReceiverRecord> receivers = {};
  std::function<void(Case&)> last = {};  // what is done to the case when all is set

  glm::dvec3 ray(double x, double y) const;  // pixels
  // Pixels of a rectangle on the plane through `at` with this unit normal; those where it is behind stay as they are.
  void set_plane(uint32_t x0, uint32_t y0, uint32_t x1, uint32_t y1, const glm::dvec3& at, const glm::dvec3& normal);
  glm::dvec3 position(uint32_t x, uint32_t y) const;
  // Lists of cells by the boxes' bounds on the screen and in depth. Duplicates have their primary's material.
  Case to_case() const;
};

// What lies behind the list are the other tiles, where nothing may happen.
void set_decal_tiles(Case&, const std::vector<uint32_t>& listed);
void set_primaries(Case&, const View&);

// A decal of half extents `half` about `at`, `outward` towards z = 0 of the box, turned by `angle`; the atlas's
// `cell`-th rectangle.
DecalRecord decal(const glm::dvec3& at, const glm::dvec3& outward, double angle, const glm::dvec3& half,
                  const AtlasPlan&, uint32_t cell);
uint32_t packed_normal(const glm::dvec3&);

}  // namespace assay::decal_atlas_sampling
