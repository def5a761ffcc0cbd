// How a shader declares what kernel.cpp calls ports. The harness binds by name (reflected from the SPIR-V), so slot
// numbers only have to differ within a shader. Slot 31 is the kernel's parameter block.
#ifndef HARNESS_GLSL_PORTS
#define HARNESS_GLSL_PORTS
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require

#define READS(slot, T, name) layout(scalar, binding = slot) restrict readonly buffer name##_block { T name[]; }
#define WRITES(slot, T, name) layout(scalar, binding = slot) restrict writeonly buffer name##_block { T name[]; }
#define UPDATES(slot, T, name) layout(scalar, binding = slot) restrict coherent buffer name##_block { T name[]; }
#define PARAMS(T) layout(scalar, binding = 31) uniform params_block { T params; }
// The row of the table that a repeated pass runs for.
#define ROW() layout(push_constant) uniform row_block { uint row; }
#endif
