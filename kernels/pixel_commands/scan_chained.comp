#version 460
#define CHAINED
#define STEP_BARRIER() barrier()
#include "kernels/pixel_commands/scan.glsl"
