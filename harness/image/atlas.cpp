#include "harness/image/atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace assay::image {

namespace {

struct Shelf {
  uint32_t page, y, height, used;  // used: texels from the left
};

// The first shelf with room for it, a new one below the last of the first page with room, or on a new page.
Shelf& shelf_for(Extent e, uint32_t side, std::vector<Shelf>& shelves, std::vector<uint32_t>& page_used) {
  for (Shelf& s : shelves)
    if (s.height >= e.height && side - s.used >= e.width) return s;
  uint32_t page = 0;
  while (page < page_used.size() && side - page_used[page] < e.height) ++page;
  if (page == page_used.size()) page_used.push_back(0);
  shelves.push_back({page, page_used[page], e.height, 0});
  page_used[page] += e.height;
  return shelves.back();
}

using Texel = std::array<double, 4>;  // 0..1; colours linear
struct Picture {
  uint32_t width = 0, height = 0;
  std::vector<Texel> texels;
};

double linear_of(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }
double srgb_of(double linear) {
  return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

Texel decoded(const uint8_t* codes, Format f) {
  static const std::array<double, 256> linear = [] {
    std::array<double, 256> of;
    for (size_t code = 0; code < of.size(); ++code) of[code] = linear_of(static_cast<double>(code) / 255);
    return of;
  }();
  Texel t;
  for (uint32_t c = 0; c < 4; ++c) t[c] = is_srgb(f) && c < 3 ? linear[codes[c]] : codes[c] / 255.0;
  return t;
}
void append_encoded(Bytes& to, const Texel& t, Format f) {
  for (uint32_t c = 0; c < 4; ++c)
    to.push_back(static_cast<std::byte>(std::lround(255 * (is_srgb(f) && c < 3 ? srgb_of(t[c]) : t[c]))));
}

// Coverage weighs colours; where there is none, all count alike.
Texel mean(const std::array<Texel, 4>& of, Format f) {
  Texel sum = {};
  const double covered = of[0][3] + of[1][3] + of[2][3] + of[3][3];
  for (const Texel& t : of)
    for (uint32_t c = 0; c < 4; ++c) {
      const bool is_weighed = is_srgb(f) && c < 3 && covered > 0;
      sum[c] += is_weighed ? t[c] * t[3] / covered : t[c] / 4;
    }
  return sum;
}
Picture halved(const Picture& p, Format f) {
  Picture h = {p.width / 2, p.height / 2, {}};
  for (size_t y = 0; y < h.height; ++y)
    for (size_t x = 0; x < h.width; ++x) {
      const Texel* upper = &p.texels[2 * y * p.width + 2 * x];
      h.texels.push_back(mean({upper[0], upper[1], upper[p.width], upper[p.width + 1]}, f));
    }
  return h;
}

// Over its whole cell, the decal's outermost texels going on.
void draw(Picture& page, const Rgba8& picture, PagePlace at, Extent cell, Extent own, uint32_t border, Format f) {
  const auto within = [border](uint32_t i, uint32_t size) { return std::clamp(i, border, border + size - 1) - border; };
  for (uint32_t y = 0; y < cell.height; ++y)
    for (uint32_t x = 0; x < cell.width; ++x) {
      const size_t from =
          picture.texels.size() == 4 ? 0 : size_t{within(y, own.height)} * picture.width + within(x, own.width);
      page.texels[size_t{at.y + y} * page.width + at.x + x] = decoded(&picture.texels[from * 4], f);
    }
}

Extent size_of(const DecalPictures& d) {
  Extent e = {1, 1};
  for (const Rgba8* p : {&d.albedo, &d.normal, &d.roughness}) {
    if (p->texels.size() != size_t{p->width} * p->height * 4 || p->texels.empty())
      throw std::runtime_error("a decal's picture is empty");
    if (p->texels.size() != 4 && pixel_count(e) != 1 && (p->width != e.width || p->height != e.height))
      throw std::runtime_error(
          fmt::format("a decal's pictures are {}x{} and {}x{} texels", e.width, e.height, p->width, p->height));
    if (p->texels.size() != 4) e = {p->width, p->height};
  }
  return e;
}

}  // namespace

std::vector<PagePlace> pack_shelves(std::span<const Extent> sizes, uint32_t side) {
  std::vector<size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, [&](size_t a, size_t b) { return sizes[a].height > sizes[b].height; });
  std::vector<PagePlace> places(sizes.size());
  std::vector<Shelf> shelves;
  std::vector<uint32_t> page_used;  // texels from the top
  for (const size_t i : order) {
    const Extent e = sizes[i];
    if (e.width == 0 || e.height == 0 || e.width > side || e.height > side)
      throw std::runtime_error(fmt::format("{}x{} texels do not fit a page of {}", e.width, e.height, side));
    Shelf& s = shelf_for(e, side, shelves, page_used);
    places[i] = {s.page, s.used, s.y};
    s.used += e.width;
  }
  return places;
}

DecalAtlas make_atlas(std::span<const DecalPictures> decals, uint32_t side, uint32_t levels, uint32_t block) {
  if (levels == 0 || levels > 16 || side == 0 || block == 0 || side % (block << (levels - 1)) != 0)
    throw std::runtime_error(
        fmt::format("{} levels of blocks of {} texels do not divide a page of {} texels", levels, block, side));
  const uint32_t last = 1u << (levels - 1), border = ceil_div(9 * last, 16), unit = block * last;
  const auto with_border = [&](uint32_t size) { return ceil_div(size + 2 * border, unit) * unit; };
  std::vector<Extent> own, cells;
  for (const DecalPictures& d : decals) {
    own.push_back(size_of(d));
    cells.push_back({with_border(own.back().width), with_border(own.back().height)});
  }
  const std::vector<PagePlace> places = pack_shelves(cells, side);
  uint32_t pages = 1;
  for (const PagePlace& p : places) pages = std::max(pages, p.page + 1);

  DecalAtlas atlas = {.border = border};
  const auto in_page = [side](uint32_t texels) { return static_cast<float>(texels) / static_cast<float>(side); };
  for (size_t i = 0; i < decals.size(); ++i)
    atlas.rectangles.push_back({places[i].page, in_page(places[i].x + border), in_page(places[i].y + border),
                                in_page(own[i].width), in_page(own[i].height)});
  for (Rgba8 DecalPictures::*which : {&DecalPictures::albedo, &DecalPictures::normal, &DecalPictures::roughness}) {
    const Format f = which == &DecalPictures::albedo ? Format::rgba8_srgb : Format::rgba8_unorm;
    Texture t = {.format = f, .width = side, .height = side, .layers = pages, .levels = levels};
    std::vector<Picture> drawn(pages, {side, side, std::vector<Texel>(size_t{side} * side)});
    for (size_t i = 0; i < decals.size(); ++i)
      draw(drawn[places[i].page], decals[i].*which, places[i], cells[i], own[i], border, f);
    for (uint32_t level = 0; level < levels; ++level)
      for (Picture& page : drawn) {
        if (level > 0) page = halved(page, f);
        for (const Texel& texel : page.texels) append_encoded(t.bytes, texel, f);
      }
    atlas.textures.push_back(std::move(t));
  }
  return atlas;
}

}  // namespace assay::image
