// How a variant counts the pixels of a tile's surfaces, and writes them where the surfaces have their places.
#ifdef SCATTERS
const uint kNowhere = 0xffffffffu;
shared uint place_at[kTilePixels];  // a slot: entry of its first pixel; kNowhere where there is no room
WRITES(6, uint, entries);
#endif

#ifdef MATCH_LANES
#include "kernels/pixel_commands/match_lanes.glsl"
#else
#include "kernels/pixel_commands/match_runs.glsl"
#endif
