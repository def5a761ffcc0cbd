// Radiance in 32 or 64 bits (kLight... of harness/formats/particle.h). What is not above 0 is 0, NaN too; what is above
// an encoding's largest number is that. All round to nearest by hand: Vulkan leaves the rounding of a store to the
// device, and truncation doubles the error and darkens by 0.6 % (kernels/radiance_encodings/README.md).
#ifndef HARNESS_GLSL_RADIANCE_ENCODINGS
#define HARNESS_GLSL_RADIANCE_ENCODINGS
#include "harness/formats/particle.h"
#include "harness/glsl/gbuffer.glsl"
#include "harness/glsl/r11g11b10.glsl"
#include "harness/glsl/rgba16.glsl"

// Of the encodings that fit a word; `encoding` is one of them.
uint encode_radiance(vec3 radiance, uint encoding) {
  return encoding == kLightRgb9e5 ? encode_shared_exponent(radiance) : encode_r11g11b10(radiance);
}
#endif
