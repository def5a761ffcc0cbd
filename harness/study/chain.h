// The kernels of variable-rate compute shading over a picture, on the device: vrcs_shading_rate, vrcs_coordinates,
// vrcs_remap, which says whose colour each pixel gets, and vrcs_deblock. One triangle covers the picture, so that rates
// alone decide; frame 0.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "harness/study/pictures.h"

namespace assay::study {

// Parameters of vrcs_shading_rate that are studied.
struct Choice {
  std::string estimator;  // its variant
  float tolerance = 0;
  bool weber = false;
  float extra_half = 0;  // 0: without
};
std::string label_of(const Choice&);  // all but the tolerance

struct Step {
  const Kernel* kernel = nullptr;
  Case input = {};
  device::Ports ports = {};
  std::map<std::string, std::vector<device::Command>> commands = {};  // by variant
};
struct Chain {
  device::Device* device = nullptr;
  Picture picture = {};
  std::vector<uint8_t> luma = {};  // of the picture, by vrcs_deblock, a code a pixel
  Step rates = {}, coordinates = {}, remap = {}, deblock = {};
};
Chain make_chain(device::Device&, Picture);

// The luma that rates are chosen by: the picture's, moved to the right and down by so many pixels, between pixels
// linearly, its sides going on; rounded to codes.
void set_luma(Chain&, double right, double down);

struct Shaded {
  double saved = 0;                 // share of pixels that are copies
  std::vector<uint32_t> from = {};  // whose colour each pixel has, by its place
  std::vector<Texel> copied, deblocked;
};
Shaded shade(Chain&, const Choice&);
double saved(Chain&, const Choice&);  // that alone

}  // namespace assay::study
