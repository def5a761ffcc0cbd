#version 460
#ifdef MUTANT_13  // the barrier dropped: the next step reads what higher subgroups have not summed
#define STEP_BARRIER()
#else
#define STEP_BARRIER() barrier()
#endif
#include "kernels/pixel_commands/scan.glsl"
