// The encodings of formats/attributes.h as the oracle knows them: what a code stands for, and which codes a rounding
// interval may become. All are monotone, so the codes of an interval's ends enclose those between.
#pragma once

#include "harness/oracle.h"
#include "harness/rounded.h"
#include "kernels/attribute_interpolation/layout.h"

namespace assay::attribute_interpolation {

using interpolation::Few;

struct Interval {
  double low, high;
};

// Nearest multiple of a step, ties to even.
double nearest_step(double v, double step);
// Nearest number with five bits of exponent over `kept` of mantissa (binary16: 10), ties to even; no overflow.
double nearest_small_float(double v, int kept);
double small_float(uint bits, int kept);  // what sign, exponent and mantissa stand for

// An element unpacked, as bounds judge it. `blank`: all bits zero, as where there is no surface.
struct BarycentricFields {
  vec2 weights;  // lambda_1, lambda_2
  float blank;
};
struct DerivativeFields {
  vec4 derivatives;  // d lambda_1/dx, d lambda_2/dx, d lambda_1/dy, d lambda_2/dy
  uint front_facing, normal_negative, tangent_negative, left_handed;
  float blank;
};
struct FrameFields {
  vec2 normal, tangent;  // the two numbers stored of each
  float blank;
};
SHARED_LAYOUT(BarycentricFields, weights, blank);
SHARED_LAYOUT(DerivativeFields, derivatives, front_facing, normal_negative, tangent_negative, left_handed, blank);
SHARED_LAYOUT(FrameFields, normal, tangent, blank);

// `encoding`: kAttributes... of formats/attributes.h.
BarycentricFields barycentric_fields(uint word, uint encoding);
DerivativeFields derivative_fields(uvec2 words, uint encoding);
FrameFields frame_fields(uvec2 words, uint encoding);
Bytes unpack_barycentrics(std::span<const std::byte>, uint encoding);
Bytes unpack_derivatives(std::span<const std::byte>, uint encoding);
Bytes unpack_frame(std::span<const std::byte>, uint encoding);

// What is stored of numbers in these intervals.
Interval stored_weight(Interval, uint encoding);
Few<Interval, 4> stored_derivatives(const Few<Interval, 4>&, uint encoding);
Interval stored_direction(Interval, uint encoding);

// The unit vector that two stored numbers and a sign stand for.
glm::dvec3 direction_of(const vec2& stored, bool negative, uint encoding);

}  // namespace assay::attribute_interpolation
