// The synthetic scene that variable-rate shading is judged on: what a picture has, apart from each other. Host only.
#pragma once

namespace assay::vrcs {

// 0 to 1 at a place in pixels: patches of 128 pixels, 37.3 and 21.7 off the grid of tiles, each of gradients, slow or
// quick noise of four octaves, edges, or stripes of 18 or 5.2 pixels.
double scene(double x, double y);
double stripes(double along, double period);

}  // namespace assay::vrcs
