// What the colours of a picture mean, and how much of it has each.
#pragma once
#include <vector>

#include "harness/frame/frame.h"

namespace assay::frame {

inline constexpr const char* kClusterCells = "cluster_lists.cells";
inline constexpr const char* kCommandStatus = "pixel_commands.status";

// `palette` is the case of the kernel that made the picture: its colour ports are what was drawn with.
std::vector<image::LegendRow> legend_of(const Result&, const scene::Scene&, const scene::Gathered&, const Case& palette,
                                        uint32_t view);
std::string feature_names(uint32_t mask);  // "opaque masked textured"; "nothing" for 0

}  // namespace assay::frame
