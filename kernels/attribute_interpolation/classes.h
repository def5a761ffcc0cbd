// Classes of triangles, seen by a pixel: what the accuracy goals speak of.
#pragma once
#include <array>

#include "harness/oracle.h"
#include "kernels/attribute_interpolation/scene_builder.h"

namespace assay::attribute_interpolation {

// Accuracy promised of the compensated formula over a class, arithmetic alone; infinite where there is no promise.
struct Goal {
  double weight_max, weight_p999, level_max;
};
struct InputClass {
  const char* name;
  uvec2 viewport;
  ClipSample (*make)(Pcg32&, uvec2 pixel, uvec2 viewport);
  Goal goal;
  const char* why;         // what is hard about it
  bool undecided = false;  // many are: float arithmetic cannot tell on which side of its edges the centre lies
};
std::span<const InputClass> input_classes();
const InputClass& input_class(const std::string& name);

// A sample of a class at a pixel of its viewport, or at one of its own choice.
ClipSample any_sample(const InputClass&, Pcg32&);
// Samples of one class, always the same, 64 a row; named after the class.
Case class_case(const InputClass&, uint32_t samples);

}  // namespace assay::attribute_interpolation
