// A strip of swatches and text below an image, in the little vector font of stb_easy_font.
#include <algorithm>
#include <cmath>
#include <cstring>

#include <stb/stb_easy_font.h>

#include "harness/image/image.h"

namespace assay::image {
namespace {

struct Colour {
  uint8_t r, g, b;
};
constexpr Colour kPaper = {20, 20, 24}, kInk = {238, 238, 238}, kEdge = {140, 140, 140};
constexpr uint32_t kLine = 14, kSwatch = 9, kGap = 5;  // in font units: a line is 12 high, a digit 7
constexpr uint32_t kShortList = 6, kWidestCell = 260;
constexpr uint32_t kWideImage = 1000;  // from here a font unit is two pixels

uint32_t text_width(std::string text) { return static_cast<uint32_t>(stb_easy_font_width(text.data())); }

// Cut to the width with "..." at the end.
std::string fit(const std::string& text, uint32_t width) {
  if (text_width(text) <= width) return text;
  size_t keep = text.size();
  while (keep > 0 && text_width(text.substr(0, keep) + "...") > width) --keep;
  return text.substr(0, keep) + "...";
}

// ASCII only: anything else has no glyph.
std::string printable(std::string text) {
  for (char& c : text)
    if (c < 32 || c > 126) c = '?';
  return text;
}

void fill(Rgba8& image, uint32_t x0, uint32_t y0, uint32_t x1, uint32_t y1, Colour c) {
  for (uint32_t y = y0; y < std::min(y1, image.height); ++y)
    for (uint32_t x = x0; x < std::min(x1, image.width); ++x) {
      const uint8_t texel[4] = {c.r, c.g, c.b, 255};
      std::memcpy(&image.texels[(size_t{y} * image.width + x) * 4], texel, 4);
    }
}

// The font gives axis-aligned rectangles on whole units, four vertices each.
void draw_text(Rgba8& image, uint32_t x, uint32_t y, uint32_t scale, std::string text) {
  struct Vertex {
    float x, y, z;
    uint8_t colour[4];
  };
  std::vector<Vertex> vertices(text.size() * 64 + 64);  // a glyph has at most 14 rectangles
  const int quads = stb_easy_font_print(0, 0, text.data(), nullptr, vertices.data(),
                                        static_cast<int>(vertices.size() * sizeof(Vertex)));
  for (int q = 0; q < quads; ++q) {
    const Vertex &low = vertices[static_cast<size_t>(q) * 4], &high = vertices[static_cast<size_t>(q) * 4 + 2];
    fill(image, x + static_cast<uint32_t>(low.x) * scale, y + static_cast<uint32_t>(low.y) * scale,
         x + static_cast<uint32_t>(high.x) * scale, y + static_cast<uint32_t>(high.y) * scale, kInk);
  }
}

}  // namespace

Rgba8 with_legend(const Rgba8& image, const std::string& title, std::span<const LegendRow> rows) {
  const uint32_t scale = image.width >= kWideImage ? 2 : 1, width = image.width / scale;
  const uint32_t before_text = kGap + kSwatch + kGap;
  uint32_t cell = before_text + kGap;
  for (const LegendRow& row : rows) cell = std::max(cell, before_text + text_width(printable(row.text)) + 3 * kGap);
  if (rows.size() > kShortList) cell = std::min(cell, kWidestCell);  // one long name does not undo the columns
  const uint32_t columns = std::max(1u, width / cell);
  const auto count = static_cast<uint32_t>(rows.size());
  const uint32_t lines = count / columns + (count % columns != 0);
  const uint32_t stride = width / columns;

  Rgba8 out = {image.width, image.height + (kGap + (title.empty() ? 0 : kLine) + lines * kLine + kGap / 2) * scale,
               image.texels};
  out.texels.resize(size_t{out.width} * out.height * 4);
  fill(out, 0, image.height, out.width, out.height, kPaper);
  uint32_t top = image.height + kGap * scale;
  if (!title.empty()) {
    draw_text(out, kGap * scale, top, scale, fit(printable(title), width - std::min(width, 2 * kGap)));
    top += kLine * scale;
  }
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t x = (i / lines) * stride * scale, y = top + (i % lines) * kLine * scale;  // down, then across
    const uint32_t left = x + kGap * scale, side = kSwatch * scale;
    fill(out, left, y, left + side, y + side, kEdge);  // dark colours stay visible on the dark strip
    fill(out, left + 1, y + 1, left + side - 1, y + side - 1, {rows[i].r, rows[i].g, rows[i].b});
    const uint32_t room = stride - std::min(stride, before_text + kGap);
    draw_text(out, x + before_text * scale, y + scale, scale, fit(printable(rows[i].text), room));
  }
  return out;
}

}  // namespace assay::image
