// Prelude of every layout.h and formats/*.h: one struct text for GLSL and C++. Blocks are layout(scalar), so members
// pack as in C: vec3 takes 12 bytes on both sides and nothing needs alignas. No include guard tricks: both compilers
// know #ifndef.
#ifndef HARNESS_SHARED_H
#define HARNESS_SHARED_H
#ifdef __cplusplus
#include <cstdint>
#include "harness/layout_table.h"
namespace assay {
using uint = uint32_t;
using glm::ivec2;
using glm::mat4;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
}  // namespace assay
#define SHARED_CONST inline constexpr
#define SHARED_BEGIN(ns) namespace assay::ns {
#define SHARED_FORMATS_BEGIN namespace assay {
#define SHARED_END }
#else
#extension GL_EXT_scalar_block_layout : require
#define SHARED_CONST const
#define SHARED_BEGIN(ns)
#define SHARED_FORMATS_BEGIN
#define SHARED_END
#endif
#endif
