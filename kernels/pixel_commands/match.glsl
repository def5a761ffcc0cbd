// How a variant counts the pixels of a tile's surfaces, and then lists them.
#include "kernels/pixel_commands/slot_of.glsl"
#ifdef MATCH_LANES
#include "kernels/pixel_commands/match_lanes.glsl"
#else
#include "kernels/pixel_commands/match_runs.glsl"
#endif
