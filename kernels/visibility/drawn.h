// The triangles of a case in the order that they are drawn, and the pixels that are judged.
#pragma once
#include <functional>

#include "harness/judged.h"
#include "harness/raster/winners.h"
#include "kernels/visibility/layout.h"

namespace assay::visibility {

void for_each_triangle(const Case&, const std::function<void(const raster::DrawnTriangle&)>&);

// Of large targets the borders of every tile and a stratified sample; of others, or where the case says so, all pixels.
JudgedMap judged_map(const Case&);

}  // namespace assay::visibility
