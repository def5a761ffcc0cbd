// What each rule leaves to be shaded, by the size of triangles.
#include <algorithm>

#include "kernels/vrcs_coordinates/inputs.h"

namespace assay::vrcs_coordinates {

namespace {

constexpr Extent kView = {640, 352};  // whole tiles

// Waves: all eight where no list is taken.
std::vector<Figure> figures(const Variant&, const Case& c, const std::map<std::string, Bytes>& written) {
  const Bytes& bytes = written.at("tiles");
  double primaries = 0, waves = 0, whole = 0;
  const double tiles = static_cast<double>(bytes.size() / sizeof(uint));
  for (size_t i = 0; i < bytes.size(); i += sizeof(uint)) {
    uint word;
    std::memcpy(&word, bytes.data() + i, sizeof(uint));
    const uint count = word & kVrcsTileCount;
    primaries += count;
    whole += count > kVrcsTileEntries;
    waves += count > kVrcsTileEntries ? 8 : (count + 31) / 32;
  }
  return {{"primaries, % of pixels", 100 * primaries / static_cast<double>(pixels(c)), 0},
          {"waves of 32 with work, %", 100 * waves / (8 * tiles), 0},
          {"tiles shaded whole, %", 100 * whole / tiles, 0}};
}

Case named(Case c, const std::string& name) {
  c.name = name;
  return c;
}

}  // namespace

ErrorTable figures_table() {
  ErrorTable t = {.classes = {}, .figures = figures};
  for (const uint side : {2u, 4u, 8u, 16u, 32u}) {
    const std::string name = "2x2, triangles of half " + std::to_string(side) + " px squared";
    t.classes.push_back({name, "what seams between triangles cost",
                         [=] { return named(case_of(vrcs::uneven_screen(kView, side)), name); }});
  }
  t.classes.push_back({"the bench's screen", "all rates", [] { return named(typical(kView), "the bench's screen"); }});
  return t;
}

}  // namespace assay::vrcs_coordinates
