#include "kernels/pixel_commands/groups.h"

#include <algorithm>
#include <tuple>

#include "kernels/pixel_commands/oracle.h"

namespace assay::pixel_commands {

namespace {

struct Pixel {
  uint shader, material, surface, entry;
};

struct Screen {
  const Case& input;
  CommandParams params;
  std::span<const uvec2> visibility;
  std::span<const SurfaceSlot> slots;
  std::span<const uint8_t> copy_bits;  // empty where the case has none
};

Screen screen_of(const Case& c) {
  const auto params = c.params<CommandParams>();
  return {c, params, c.input<uvec2>("visibility"), c.input<SurfaceSlot>("surface_slots"),
          params.copies != 0 ? c.input<uint8_t>("copy_bits") : std::span<const uint8_t>()};
}

enum class Seen { nothing, unlisted, listed };

Seen look_at(const Screen& s, uint32_t x, uint32_t y, Pixel& pixel) {
  const size_t at = size_t{y} * s.input.extent.width + x;
  const uint8_t copies = s.copy_bits.empty() ? 0 : s.copy_bits[at];
  const uvec2 seen = s.visibility[at];
  if ((seen.x == UINT32_MAX && seen.y == UINT32_MAX) || copies / 128 == 1) return Seen::nothing;
  const uint surface = seen.y % (1u << 30);  // without the two flags
  if (surface >= s.params.surfaces) return Seen::unlisted;
  const SurfaceSlot slot = s.slots[surface];
  if (slot.shader >= live_shaders(s.input) || slot.material >= std::min(s.params.materials, 4096u))
    return Seen::unlisted;
  pixel = {slot.shader, slot.material, surface, x + y * 16384 + copies % 8 * (1u << 28)};
  return Seen::listed;
}

// The tile's listed pixels in scan order.
std::vector<Pixel> pixels_of_tile(const Screen& s, uint32_t tile_x, uint32_t tile_y, uint64_t& unlisted) {
  std::vector<Pixel> pixels;
  const Extent e = s.input.extent;
  for (uint32_t y = tile_y * 32; y < std::min(e.height, tile_y * 32 + 32); ++y)
    for (uint32_t x = tile_x * 32; x < std::min(e.width, tile_x * 32 + 32); ++x) {
      Pixel pixel;
      const Seen seen = look_at(s, x, y, pixel);
      if (seen == Seen::listed) pixels.push_back(pixel);
      if (seen == Seen::unlisted) ++unlisted;
    }
  return pixels;
}

void append_groups(Grouped& to, std::vector<Pixel>& pixels) {
  const auto key = [](const Pixel& p) { return std::tuple(p.shader, p.material); };
  std::ranges::stable_sort(pixels, {}, key);
  struct Part {
    Group group;
    std::span<const Pixel> pixels;
  };
  std::vector<Part> parts;
  for (size_t i = 0; i < pixels.size();) {
    size_t end = i;
    bool divergent = false;
    for (; end < pixels.size() && key(pixels[end]) == key(pixels[i]); ++end)
      divergent |= pixels[end].surface != pixels[i].surface;
    parts.push_back({{pixels[i].shader, pixels[i].material, divergent}, std::span(pixels).subspan(i, end - i)});
    i = end;
  }
  std::ranges::sort(parts, {},
                    [](const Part& p) { return std::tuple(p.group.shader, p.group.divergent, p.group.material); });
  for (Part& part : parts) {
    part.group.first = to.entries.size();
    part.group.pixels = part.pixels.size();
    to.groups.push_back(part.group);
    for (const Pixel& p : part.pixels) to.entries.push_back(p.entry);
  }
}

}  // namespace

Grouped group_pixels(const Case& c) {
  const Screen screen = screen_of(c);
  const Extent across = tiles_of(c.extent, 32);
  Grouped grouped;
  for (uint32_t y = 0; y < across.height; ++y)
    for (uint32_t x = 0; x < across.width; ++x) {
      grouped.first_group.push_back(grouped.groups.size());
      auto pixels = pixels_of_tile(screen, x, y, grouped.unlisted);
      append_groups(grouped, pixels);
    }
  grouped.first_group.push_back(grouped.groups.size());
  return grouped;
}

}  // namespace assay::pixel_commands
