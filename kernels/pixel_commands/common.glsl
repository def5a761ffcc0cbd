// What every pass binds or knows: the pixels' surfaces, the surfaces' slots, sizes that hold whatever the parameters say.
#include "harness/glsl/ports.glsl"
#include "kernels/pixel_commands/layout.h"
#include "harness/glsl/tiles.glsl"

PARAMS(CommandParams);

const uint kNoSurface = 0xffffffffu;     // of a pixel that nothing covers, or that another one's copy fills
const uint kWrongSurface = 0xfffffffeu;  // of a pixel whose surface index names none
const uint kUnlisted = 0xffffffffu;      // key of a surface without a visible shader or material

uvec2 extent() { return uvec2(params.width, params.height); }
uint shader_slots() { return min(params.shaders, kMaxShaders); }
uint wave_log2() { return clamp(params.wave_log2, kSmallestWaveLog2, kLargestWaveLog2); }
uint wave_size() { return 1u << wave_log2(); }
uint waves_per_group_log2() { return min(params.waves_per_group_log2, kCommandBuckets - 1u); }
uint capacity() { return params.waves << wave_log2(); }  // entries
uint waves_of(uint pixels) { return (pixels + wave_size() - 1u) >> wave_log2(); }
